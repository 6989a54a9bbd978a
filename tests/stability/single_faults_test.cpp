// Every single fault of the fault tree in docs/safety.md: those that the closed loop can have are broken here, each held to bounds of
// its own; the page's rows and figures are held against what is measured, and each other row has to name the test that shows it.
#include "tests/support/fault_kinds.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <vector>

using namespace fulcrum;
using namespace fulcrum::test_link;

namespace {

const std::filesystem::path kRoot = FULCRUM_SOURCE_DIR;

std::string read_text(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

// The table below this heading of docs/safety.md, its head and rule left out: a row's cells.
using Cells = std::vector<std::string>;
std::vector<Cells> read_table(const std::string& heading) {
    std::istringstream page(read_text(kRoot / "docs/safety.md"));
    std::vector<Cells> rows;
    std::string line;
    bool is_below = false;
    while (std::getline(page, line)) {
        if (is_below && line.starts_with('#')) {
            break;
        }
        is_below = is_below || line == heading;
        if (!is_below || !line.starts_with("| ")) {
            continue;
        }
        Cells cells;
        std::istringstream rest(line.substr(1));
        for (std::string cell; std::getline(rest, cell, '|');) {
            const auto from = cell.find_first_not_of(' ');
            const auto to = cell.find_last_not_of(' ');
            cells.push_back(from == std::string::npos ? "" : cell.substr(from, to - from + 1));
        }
        rows.push_back(cells);
    }
    REQUIRE(rows.size() > 2);
    // Head and rule.
    rows.erase(rows.begin(), rows.begin() + 2);
    return rows;
}

const std::vector<Cells>& fault_tree() {
    static const auto rows = read_table("## The fault tree");
    return rows;
}

// How the page writes a fault.
std::string written(Fault fault) {
    const std::map<Fault, std::string> names = {
        {Fault::device_read, "`device_read`"},         {Fault::device_stale, "`device_stale`"},
        {Fault::device_invalid, "`device_invalid`"},   {Fault::command_stale, "`command_stale`"},
        {Fault::command_invalid, "`command_invalid`"}, {Fault::emergency_stop, "`emergency_stop`"},
        {Fault::lesson_failed, "`lesson_failed`"},     {Fault::device_write, "`device_write`"},
        {Fault::hand_too_fast, "`hand_too_fast`"},     {Fault::clutched, "`clutched`"},
    };
    return names.at(fault);
}

// What would have been.
const FaultCourse& course_without() {
    static const FaultCourse course = [] {
        FaultKind nothing;
        nothing.happens = [](FaultBench&) {};
        return run_fault(nothing);
    }();
    return course;
}

// The name of the test that begins at `at`: literals that stand one behind the other are one.
std::string read_name(const std::string& text, std::size_t at) {
    std::string name;
    for (at = text.find_first_not_of(" \n", at); at < text.size() && text[at] == '"';
         at = text.find_first_not_of(" \n", at)) {
        const std::size_t end = text.find('"', at + 1);
        name += text.substr(at + 1, end - at - 1);
        at = end + 1;
    }
    return name;
}

// The names of all tests.
const std::vector<std::string>& all_tests() {
    static const std::vector<std::string> names = [] {
        const std::string kBegin = "TEST_CASE(";
        std::vector<std::string> all;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(kRoot / "tests")) {
            if (entry.path().extension() != ".cpp") {
                continue;
            }
            const std::string text = read_text(entry.path());
            for (std::size_t at = text.find(kBegin); at != std::string::npos;
                 at = text.find(kBegin, at)) {
                at += kBegin.size();
                all.push_back(read_name(text, at));
            }
        }
        return all;
    }();
    return names;
}

// A name may be cut short; "safety: …" means all that begin so.
bool is_test(const std::string& name) {
    const std::string kRest = " …";
    const std::string begin =
        name.ends_with(kRest) ? name.substr(0, name.size() - kRest.size()) : name;
    return std::any_of(all_tests().begin(), all_tests().end(),
                       [&](const std::string& test) { return test.starts_with(begin); });
}

// What stands between two of these letters, each time.
std::vector<std::string> between(const std::string& text, char letter) {
    std::vector<std::string> found;
    for (std::size_t from = text.find(letter); from != std::string::npos;) {
        const std::size_t to = text.find(letter, from + 1);
        if (to == std::string::npos) {
            break;
        }
        found.push_back(text.substr(from + 1, to - from - 1));
        from = text.find(letter, to + 1);
    }
    return found;
}

}  // namespace

TEST_CASE("single faults: the force that was held is there before, or nothing would be shown") {
    const FaultCourse& course = course_without();
    CHECK(course.before_N > 2.0);
    CHECK(course.end_N > 2.0);
    CHECK(course.who == Notices::nobody);
    CHECK(course.largest_step_N < 0.3);
}

namespace {

void check_notice(const FaultKind& kind, const FaultCourse& course) {
    CHECK(course.who == kind.who);
    if (kind.who == Notices::nobody) {
        return;
    }
    CHECK(any(course.notice & kind.notice));
    CHECK(1e3 * course.notice_s <= kind.notice_ms + 0.1);
    // And as the fault tree says.
    const auto row = std::find_if(fault_tree().begin(), fault_tree().end(),
                                  [&](const Cells& cells) { return cells[0] == kind.row; });
    REQUIRE(row != fault_tree().end());
    INFO((*row)[1] << "; " << (*row)[2]);
    CHECK((*row)[1].find(written(kind.notice)) != std::string::npos);
    const auto digit = (*row)[2].find_first_of("0123456789");
    REQUIRE(digit != std::string::npos);
    constexpr double kRounds_ms = 2.0;  // of both sides
    CHECK(1e3 * course.notice_s <= std::atof((*row)[2].c_str() + digit) + kRounds_ms);
}

void check_bounds(const FaultKind& kind, const FaultCourse& course) {
    CHECK(course.before_N == course_without().before_N);
    CHECK(course.peak_N <= kind.most_N);
    CHECK(course.largest_step_N <= kind.most_step_N);
    CHECK(course.given_J <= kind.most_J);
    if (kind.gone_ms > 0.0) {
        CHECK(1e3 * course.gone_s <= kind.gone_ms + 0.1);
        CHECK(course.end_N == 0.0);
    } else if (kind.gone_ms == 0.0) {
        CHECK(course.end_N == Approx(course_without().end_N).epsilon(0.2));
    } else {
        CHECK(course.end_N > 1.0);
    }
}

// A row of the page's figures.
void check_figures(const Cells& row, const FaultKind& kind, const FaultCourse& course) {
    // What another compiler's rounding may change, and what is rounded in the page.
    constexpr double kForce_N = 0.06;
    constexpr double kStep_N = 0.02;
    constexpr double kTime_ms = 2.0;
    REQUIRE(row.size() == 7);
    CHECK(row[0] == kind.name);
    CHECK(row[1] == name_of(course.who));
    const auto number = [&](std::size_t cell) { return std::atof(row[cell].c_str()); };
    CHECK((course.who == Notices::nobody
               ? row[2] == "-"
               : std::abs(number(2) - 1e3 * course.notice_s) <= kTime_ms));
    CHECK(number(3) == Approx(course.peak_N).margin(kForce_N));
    CHECK(number(4) == Approx(course.largest_step_N).margin(kStep_N));
    CHECK(number(5) == Approx(1e3 * course.given_J).epsilon(0.1).margin(1.0));
    CHECK((std::isfinite(course.gone_s) ? std::abs(number(6) - 1e3 * course.gone_s) <= kTime_ms
                                        : row[6] == "stays"));
}

}  // namespace

TEST_CASE("single faults: each is noticed, keeps its own bounds, and is gone as the page says") {
    const auto figures = read_table("## Measured");
    const std::vector<FaultKind> kinds = all_faults();
    REQUIRE(figures.size() == kinds.size());
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const FaultKind& kind = kinds[i];
        const FaultCourse course = run_fault(kind);
        INFO(kind.name << ": noticed by " << name_of(course.who) << ", fault "
                       << static_cast<unsigned>(course.notice) << ", after "
                       << 1e3 * course.notice_s << " ms; before " << course.before_N
                       << " N, then at most " << course.peak_N << " N, steps of "
                       << course.largest_step_N << " N, " << course.given_J << " J, gone after "
                       << 1e3 * course.gone_s << " ms, at the end " << course.end_N << " N");
        check_notice(kind, course);
        check_bounds(kind, course);
        check_figures(figures[i], kind, course);
    }
}

namespace {

// How many tests a cell names, by their names or as scripts; each has to be there.
std::size_t count_shown(const std::string& cell) {
    const auto names = between(cell, '"');
    for (const std::string& name : names) {
        INFO(name);
        CHECK(name.size() > 8);
        CHECK(is_test(name));
    }
    const auto scripts = between(cell, '`');
    for (const std::string& script : scripts) {
        INFO(script);
        CHECK(std::filesystem::exists(kRoot / script));
    }
    return names.size() + scripts.size();
}

}  // namespace

TEST_CASE("single faults: the fault tree's rows are these, or name another test that is there") {
    std::vector<std::string> shown;
    for (const FaultKind& kind : all_faults()) {
        if (shown.empty() || shown.back() != kind.row) {
            shown.push_back(kind.row);
        }
    }
    std::vector<std::string> promised;
    for (const Cells& row : fault_tree()) {
        REQUIRE(row.size() == 5);
        INFO(row[0]);
        const std::size_t n_named = count_shown(row[4]);
        if (row[4].find("single faults") != std::string::npos) {
            promised.push_back(row[0]);
        } else {
            CHECK(n_named > 0);
        }
    }
    CHECK(promised == shown);
}

TEST_CASE("single faults: every limit of the page names tests that are there") {
    for (const Cells& row : read_table("## Limits")) {
        REQUIRE(row.size() == 5);
        INFO(row[0]);
        CHECK(count_shown(row[4]) > 0);
    }
}
