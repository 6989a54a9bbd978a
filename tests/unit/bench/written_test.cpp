#include "tests/bench/harness/csv.h"
#include "tests/bench/harness/must.h"
#include "tests/bench/harness/options.h"
#include "tests/bench/harness/report.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace fulcrum::bench {
namespace {

const Environment kEnvironment{"abc123", "GNU 12.2", "a processor", "fulcrum bench x",
                               "2026-01-31"};

CostCurve make_curve() {
    CostCurve curve;
    curve.name = "wall";
    curve.title = "A wall, \"stiff\"";
    curve.work = "pressing, a second long";
    curve.reference = "analytic: F = k d";
    curve.advice = "choose the middle";
    curve.knob = {"step", "s", true};
    curve.error = {"force error", "N", true};
    curve.extras = {{"order", "", false}, {"lag", "ms", false}};
    curve.default_series = "RK4, classical";
    curve.default_knob = 0.001;
    curve.time_is_per = "simulated second";
    curve.points = {{"RK4, classical", 0.001, 1.25e-9, {0.5, 0.75, 96}, {3.98, kNone}},
                    {"Euler \"e\"", 0.002, kNone, {0.25, kNone, 0}, {kNone, 2.0}}};
    return curve;
}

const std::vector<std::string> kKnown{"integrators-free", "integrators-wall", "stability"};

Expected<BenchOptions> parse(const std::vector<std::string>& words) {
    return parse_bench_options(words, kKnown);
}

TEST_CASE("csv: a cost curve comes back as it went out") {
    const CostCurve out = make_curve();
    const auto read = read_csv(to_csv(out, kEnvironment), "wall.csv");
    REQUIRE(read);
    const auto& in = std::get<CostCurve>(*read);
    CHECK(in.name == out.name);
    CHECK(in.title == out.title);
    CHECK(in.work == out.work);
    CHECK(in.reference == out.reference);
    CHECK(in.advice == out.advice);
    CHECK(in.knob.name == "step");
    CHECK(in.knob.unit == "s");
    CHECK(in.knob.logarithmic);
    CHECK(in.extras.size() == 2);
    CHECK_FALSE(in.extras[1].logarithmic);
    CHECK(in.extras[1].unit == "ms");
    CHECK(in.default_series == out.default_series);
    CHECK(in.default_knob == 0.001);
    CHECK(in.time_is_per == "simulated second");
    REQUIRE(in.points.size() == 2);
    CHECK(in.points[0].series == "RK4, classical");
    CHECK(in.points[0].error == 1.25e-9);
    CHECK(in.points[0].cost.p99_us == 0.75);
    CHECK(in.points[0].cost.bytes == 96);
    CHECK(in.points[0].extras[0] == 3.98);
    CHECK(std::isnan(in.points[0].extras[1]));
    CHECK(in.points[1].series == "Euler \"e\"");
    CHECK(std::isnan(in.points[1].error));
    CHECK(std::isnan(in.points[1].cost.p99_us));
}

TEST_CASE("csv: lines come back with their styles and gaps") {
    LineChart out;
    out.name = "map";
    out.title = "Map";
    out.x = {"damping", "Ns/m", false};
    out.y = {"stiffness", "N/m", true};
    out.lines = {{"measured, 1 kHz", LineStyle::measured, {1, 2, 3}, {10, kNone, 30}},
                 {"theory", LineStyle::theory, {1, 3}, {11, 33}},
                 {"dots", LineStyle::dots, {2}, {5}}};
    const auto read = read_csv(to_csv(out, kEnvironment), "map.csv");
    REQUIRE(read);
    const auto& in = std::get<LineChart>(*read);
    REQUIRE(in.lines.size() == 3);
    CHECK(in.lines[0].name == "measured, 1 kHz");
    CHECK(in.lines[0].x == std::vector<double>{1, 2, 3});
    CHECK(std::isnan(in.lines[0].y[1]));
    CHECK(in.lines[1].style == LineStyle::theory);
    CHECK(in.lines[2].style == LineStyle::dots);
    CHECK(in.y.logarithmic);
}

TEST_CASE("csv: a sheet comes back, line ends in cells too") {
    const Sheet out{"cases",  "Cases",           "work",
                    "advice", {"case", "worst"}, {{"a,b", "1"}, {"two\nlines", "2"}}};
    const auto read = read_csv(to_csv(out, kEnvironment), "cases.csv");
    REQUIRE(read);
    const auto& in = std::get<Sheet>(*read);
    CHECK(in.columns == out.columns);
    CHECK(in.rows == out.rows);
}

TEST_CASE("csv: the head says where the figures came from") {
    const std::string text = to_csv(make_curve(), kEnvironment);
    for (const char* line : {"# commit: abc123\n", "# compiler: GNU 12.2\n", "# cpu: a processor\n",
                             "# command: fulcrum bench x\n"}) {
        CHECK(text.find(line) != std::string::npos);
    }
}

TEST_CASE("csv: what is no figure's file is refused with its name") {
    for (const char* text : {"", "a,b\n1,2\n", "# kind: cake\na\n", "# kind: cost\n# name: x\n",
                             "# kind: lines\nline,x,y\nonly,two\n"}) {
        const auto read = read_csv(text, "bad.csv");
        REQUIRE_FALSE(read);
        CHECK(read.error().where == "bad.csv");
        CHECK_FALSE(read.error().what_to_do.empty());
    }
}

TEST_CASE("csv: a file that was saved with other line ends reads the same") {
    std::string text;
    for (const char c : to_csv(make_curve(), kEnvironment)) {
        text += c == '\n' ? "\r\n" : std::string(1, c);
    }
    const auto read = read_csv(text, "wall.csv");
    REQUIRE(read);
    CHECK(std::get<CostCurve>(*read).default_series == make_curve().default_series);
    CHECK(std::get<CostCurve>(*read).points.size() == 2);
}

TEST_CASE("csv: sizes that no memory has are none") {
    for (const char* bytes : {"1e300", "-5", "nan", "inf", "x"}) {
        const std::string text =
            std::string("# kind: cost\ns,k,e,m,p,b\na,1,1,1,1,") + bytes + "\n";
        const auto read = read_csv(text, "x.csv");
        REQUIRE(read);
        CHECK(std::get<CostCurve>(*read).points[0].cost.bytes == 0);
    }
}

TEST_CASE("csv: numbers are short, and none where there is none") {
    CHECK(to_text(0.25) == "0.25");
    CHECK(to_text(1.2e-9) == "1.2e-09");
    CHECK(to_text(kNone).empty());
    CHECK(to_text(HUGE_VAL).empty());
}

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

TEST_CASE("report: lines are traced over numbers, and drawn through the rows that are theirs") {
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

TEST_CASE("bench options: a name, the first part of several names, or none for all") {
    CHECK(parse({})->names.empty());
    CHECK(parse({"stability"})->names == std::vector<std::string>{"stability"});
    CHECK(parse({"integrators", "--quick"})->names ==
          std::vector<std::string>{"integrators-free", "integrators-wall"});
    CHECK(parse({"integrators", "--quick"})->quick);
}

TEST_CASE("bench options: out, mesh and draw take their values") {
    const auto options = parse({"--out", "there", "--draw", "a.csv", "--draw", "b.csv", "--mesh",
                                "bunny.obj", "--tool", "teapot.glb", "--text", "learners.tsv"});
    REQUIRE(options);
    CHECK(options->mesh == "bunny.obj");
    CHECK(options->tool == "teapot.glb");
    CHECK(options->text == "learners.tsv");
    CHECK(options->out == "there");
    CHECK(options->draw == std::vector<std::string>{"a.csv", "b.csv"});
}

TEST_CASE("bench options: what is not known is refused in a sentence that helps") {
    const auto unknown = parse({"stabilty"});
    REQUIRE_FALSE(unknown);
    CHECK(unknown.error().what_to_do.find("stability") != std::string::npos);
    CHECK_FALSE(parse({"integ"}));
    CHECK_FALSE(parse({"--fast"}));
    CHECK_FALSE(parse({"--out"}));
    CHECK_FALSE(parse({"--mesh"}));
    CHECK_FALSE(parse({"--tool"}));
    CHECK_FALSE(parse({"--text"}));
}

}  // namespace
}  // namespace fulcrum::bench
