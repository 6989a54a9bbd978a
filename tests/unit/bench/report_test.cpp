#include "tests/bench/harness/report.h"

#include "tests/bench/harness/must.h"

#include <catch2/catch.hpp>

namespace fulcrum::bench {
namespace {

TEST_CASE("report: a cell is text as it is, a number to six digits, a whole one in full") {
    Sheet sheet{"s", "S", "w", "a", {"text", "number", "none", "whole", "size"}};
    sheet.add({"a, b", 1.0 / 3.0, kNone, 1234567, std::size_t{7}});
    CHECK(sheet.rows ==
          std::vector<std::vector<std::string>>{{"a, b", "0.333333", "", "1234567", "7"}});
}

TEST_CASE("report: numbers are rounded to so many digits, and zero has no sign") {
    CHECK(rounded(2.345678, 2) == 2.35);
    CHECK(rounded(-12.5, 0) == -13.0);
    CHECK(to_text(rounded(-0.001, 2)) == "0");
}

TEST_CASE(
    "report: lines are traced over numbers and drawn through those rows that belong to them") {
    LineChart chart;
    chart.trace("squares", LineStyle::theory, {1.0, 2.0, 4.0}, [](double x) { return x * x; });
    chart.draw(
        "even", std::vector<int>{1, 2, 3, 4}, [](int n) { return n % 2 == 0; },
        [](int n) { return 1.0 * n; }, [](int n) { return 10.0 * n; });
    REQUIRE(chart.lines.size() == 2);
    CHECK(chart.lines[0].style == LineStyle::theory);
    CHECK(chart.lines[0].y == std::vector<double>{1.0, 4.0, 16.0});
    CHECK(find_power(chart.lines[0]) == Approx(2.0));
    CHECK(chart.lines[1].x == std::vector<double>{2.0, 4.0});
    CHECK(chart.lines[1].y == std::vector<double>{20.0, 40.0});
}

TEST_CASE("must: what is there is handed on, what is not ends the benchmark with its sentence") {
    CHECK(must(Expected<int>(7)) == 7);
    CHECK_THROWS_WITH(must(Expected<int>(fail("it is gone", "a.obj", "look elsewhere"))),
                      "a.obj: it is gone; look elsewhere.");
}

}  // namespace
}  // namespace fulcrum::bench
