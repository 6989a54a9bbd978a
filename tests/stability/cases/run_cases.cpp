// Runs hard cases for ctest and for people.
//   run_cases                            all of them, as a table; fails when one does not hold
//   run_cases NAME                       one of them
//   run_cases --list-test-names-only     their names, and their number as exit status, as ctest's list asks for them
#include "tests/stability/cases/stability_case.h"

#include <algorithm>
#include <cstdio>
#include <string>
#include <string_view>

namespace {

using fulcrum::stability::all_cases;
using fulcrum::stability::CaseDescription;
using fulcrum::stability::Finding;

bool run_one(const CaseDescription& one) {
    const Finding finding = run_case(one);
    std::printf("%-44s %10.3g %10.3g %-6s %-4s %s%s%s\n", one.name.c_str(), finding.worst,
                finding.limit, one.unit.c_str(), finding.holds() ? "ok" : "BAD",
                one.measured.c_str(), finding.note.empty() ? "" : "; ", finding.note.c_str());
    std::fflush(stdout);
    return finding.holds();
}

// ctest hands names over as patterns: "\," for ",".
std::string without_backslashes(std::string_view pattern) {
    std::string name;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        i += pattern[i] == '\\' && i + 1 < pattern.size() ? 1 : 0;
        name += pattern[i];
    }
    return name;
}

}  // namespace

int main(int argc, char** argv) {
    const std::string wanted = argc > 1 ? without_backslashes(argv[1]) : "";
    if (wanted == "--list-test-names-only") {
        for (const CaseDescription& one : all_cases()) {
            std::puts(one.name.c_str());
        }
        return static_cast<int>(std::min<std::size_t>(all_cases().size(), 255));
    }
    std::printf("%-44s %10s %10s %-6s %-4s %s\n", "case", "worst", "limit", "unit", "", "measured");
    int n_run = 0;
    int n_bad = 0;
    for (const CaseDescription& one : all_cases()) {
        if (wanted.empty() || wanted == one.name) {
            ++n_run;
            n_bad += run_one(one) ? 0 : 1;
        }
    }
    if (n_run == 0) {
        std::printf("there is no case \"%s\"\n", wanted.c_str());
    }
    return n_run == 0 || n_bad > 0 ? 1 : 0;
}
