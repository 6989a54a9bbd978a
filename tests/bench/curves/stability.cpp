// The hard cases as a table: what `ctest -L stability` judges, with the numbers.
#include "tests/bench/harness/curve.h"
#include "tests/stability/cases/stability_case.h"

namespace fulcrum::bench {
namespace {

Report run_stability(Run& run) {
    Sheet sheet{
        "stability",
        "Hard cases",
        "Each case is run whole, in a quick run every eighth; the number is the worst that was "
        "seen, and the case holds when it "
        "does not pass the limit.",
        "A case that does not hold is a defect: ctest -L stability fails with the same numbers.",
        {"case", "measured", "worst", "limit", "unit", "holds", "note"}};
    const auto& cases = stability::all_cases();
    for (std::size_t i = 0; i < cases.size(); i += run.pick(std::size_t{1}, std::size_t{8})) {
        run.progress(i, cases.size(), cases[i].name);
        const stability::Finding finding = stability::run_case(cases[i]);
        sheet.add({cases[i].name, cases[i].measured, finding.worst, finding.limit, cases[i].unit,
                   finding.holds() ? "yes" : "NO", finding.note});
    }
    return {sheet};
}

const Registration kStability{
    {"stability", "the hard cases, each with its worst value and its limit", run_stability}};

}  // namespace
}  // namespace fulcrum::bench
