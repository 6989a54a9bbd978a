#include "tests/bench/harness/page.h"
#include "tests/bench/harness/pareto.h"
#include "tests/bench/harness/scale.h"
#include "tests/bench/harness/svg.h"

#include <catch2/catch.hpp>

#include <limits>
#include <string>

namespace fulcrum::bench {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
        ++n;
    }
    return n;
}

CostCurve make_curve() {
    CostCurve curve;
    curve.name = "a-curve";
    curve.title = "Error & time <1>";
    curve.knob = {"step", "ms", false};
    curve.error = {"error", "N", true};
    curve.advice = "take the second";
    curve.default_series = "A";
    curve.default_knob = 2;
    curve.points = {{"A", 1, 1.0, {1.0, 2.0, 8}, {}},
                    {"A", 2, 0.1, {2.0, 3.0, 8}, {}},
                    {"B", 1, kNone, {0.5, 0.6, 8}, {}},
                    {"B", 2, 5.0, {4.0, 5.0, 8}, {}}};
    return curve;
}

Extent extent_of(std::initializer_list<double> values, bool logarithmic) {
    Extent extent;
    for (const double v : values) {
        extent.add(v, logarithmic);
    }
    return extent;
}

CostPoint point(double time_us, double error) {
    return {"s", 0.0, error, {time_us, time_us, 0}, {}};
}

TEST_CASE("svg: each point has a mark, what is unstable a cross, the default a ring") {
    const std::string svg = draw_svg(make_curve());
    CHECK(count(svg, "<title>A, step 1 ms: error 1 N") == 1);
    CHECK(count(svg, "<title>A, step 2 ms: error 0.1 N") == 1);
    CHECK(count(svg, "unstable, 0.5") == 1);
    CHECK(count(svg, ">default</text>") == 1);
    CHECK(svg.find("Error &amp; time &lt;1&gt;") != std::string::npos);
    CHECK(svg.find("nan") == std::string::npos);
    CHECK(count(svg, "<svg") == 1);
    CHECK(count(svg, "</svg>") == 1);
}

TEST_CASE("svg: a more exact point lies lower, a slower one further right") {
    // The ring stands where the default is; with the other default it must move down and to the right.
    CostCurve curve = make_curve();
    const auto ring_of = [](const std::string& svg) {
        const std::size_t r = svg.find("r=\"9\"");
        const std::size_t start = svg.rfind("cx=\"", r);
        const std::size_t cy = svg.find("cy=\"", start);
        return std::pair(std::stod(svg.substr(start + 4)), std::stod(svg.substr(cy + 4)));
    };
    const auto exact = ring_of(draw_svg(curve));
    curve.default_knob = 1;
    const auto rough = ring_of(draw_svg(curve));
    CHECK(exact.first > rough.first);
    CHECK(exact.second > rough.second);
}

TEST_CASE("svg: theory is dashed, and a gap breaks a line in two") {
    LineChart chart;
    chart.name = "c";
    chart.x = {"x", "", false};
    chart.y = {"y", "", false};
    chart.lines = {{"m", LineStyle::measured, {0, 1, 2, 3, 4}, {1, 2, kNone, 3, 4}},
                   {"t", LineStyle::theory, {0, 4}, {1, 4}}};
    const std::string svg = draw_svg(chart);
    CHECK(count(svg, "stroke-dasharray=\"7 4\"") == 2);  // the line and its legend
    CHECK(count(svg, "<polyline") == 5);                 // two halves, theory, two in the legend
}

TEST_CASE("svg: a sheet has no picture") {
    CHECK(draw_svg(Sheet{}).empty());
}

TEST_CASE("page: it holds every exhibit and asks for nothing from elsewhere") {
    const Report report{make_curve(), Sheet{"s", "A <sheet>", "w", "a", {"c"}, {{"1 & 2"}}}};
    const std::string page =
        make_page(report, {"c0", "g++", "cpu", "fulcrum bench", "day"}, {"A peer took part."});
    CHECK(page.find("id=\"a-curve\"") != std::string::npos);
    CHECK(page.find("A &lt;sheet&gt;") != std::string::npos);
    CHECK(page.find("1 &amp; 2") != std::string::npos);
    CHECK(page.find("take the second") != std::string::npos);
    CHECK(page.find("lies on the Pareto front") != std::string::npos);
    CHECK(page.find("A peer took part.") != std::string::npos);
    for (const char* outside : {"src=", "href=\"http", "@import", "<script", "url("}) {
        CHECK(page.find(outside) == std::string::npos);
    }
}

TEST_CASE("page: it says when the default is not the best choice") {
    CostCurve curve = make_curve();
    curve.default_series = "B";
    const std::string page = make_page({curve}, {}, {});
    CHECK(page.find("is not on the Pareto front: 2 settings") != std::string::npos);
}

TEST_CASE("scale: a decade is as long as the next, and y may run upwards") {
    const Scale scale(extent_of({1e-6, 1e3}, true), true, 400.0, 40.0);
    const double decade = scale.place(1.0) - scale.place(10.0);
    CHECK(decade > 0.0);
    CHECK(scale.place(1e-5) - scale.place(1e-4) == Approx(decade));
    CHECK(scale.place(1e-6) <= 400.0);
    CHECK(scale.place(1e3) >= 40.0);
}

TEST_CASE("scale: what lies outside or has no logarithm lies on the nearer end") {
    const Scale scale(extent_of({1.0, 100.0}, true), true, 0.0, 10.0);
    CHECK(scale.place(0.0) == 0.0);
    CHECK(scale.place(-5.0) == 0.0);
    CHECK(scale.place(1e9) == 10.0);
}

TEST_CASE("scale: ticks are round, inside, and few") {
    const Scale linear(extent_of({0.0, 0.73}, false), false, 0.0, 100.0);
    const auto ticks = linear.ticks();
    REQUIRE(ticks.size() >= 3);
    CHECK(ticks.size() <= 9);
    CHECK(ticks.front() == 0.0);
    CHECK(ticks[1] == Approx(0.2));
    const Scale decades(extent_of({1e-12, 1e3}, true), true, 0.0, 100.0);
    CHECK(decades.ticks().size() <= 10);
    const Scale narrow(extent_of({1.0, 9.0}, true), true, 0.0, 100.0);
    CHECK(narrow.ticks().size() >= 3);
}

TEST_CASE("scale: one value, or none, still makes an axis") {
    for (const bool logarithmic : {false, true}) {
        const Scale one(extent_of({5.0}, logarithmic), logarithmic, 0.0, 100.0);
        CHECK(one.place(5.0) > 10.0);
        CHECK(one.place(5.0) < 99.9);
        const Scale none(Extent{}, logarithmic, 0.0, 100.0);
        CHECK_FALSE(none.ticks().empty());
    }
}

TEST_CASE("scale: an extent takes in numbers only") {
    Extent extent;
    extent.add(std::numeric_limits<double>::quiet_NaN(), false);
    extent.add(std::numeric_limits<double>::infinity(), false);
    extent.add(-1.0, true);
    CHECK(extent.empty());
    extent.add(-1.0, false);
    CHECK(extent.low() == -1.0);
}

TEST_CASE("pareto: only what nothing beats stays, from the fastest on") {
    const std::vector<CostPoint> points{point(4, 1),     point(1, 8), point(2, 8),      point(2, 3),
                                        point(3, kNone), point(8, 1), point(kNone, 0.1)};
    CHECK(find_pareto_front(points) == std::vector<std::size_t>{1, 3, 0});
}

TEST_CASE("pareto: of two alike one stays, and of nothing nothing") {
    CHECK(find_pareto_front({point(1, 1), point(1, 1)}).size() == 1);
    CHECK(find_pareto_front({}).empty());
}

TEST_CASE("pareto: no point of the front is beaten, and every other one is", "[property]") {
    std::vector<CostPoint> points;
    for (int i = 0; i < 200; ++i) {
        points.push_back(point(1 + (i * 37) % 101, 1 + (i * 61) % 89));
    }
    const auto front = find_pareto_front(points);
    const auto beats = [&](const CostPoint& a, const CostPoint& b) {
        return a.error <= b.error && a.cost.median_us <= b.cost.median_us &&
               (a.error < b.error || a.cost.median_us < b.cost.median_us);
    };
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool in_front = std::find(front.begin(), front.end(), i) != front.end();
        const bool beaten = std::any_of(points.begin(), points.end(),
                                        [&](const CostPoint& p) { return beats(p, points[i]); });
        CHECK((!in_front || !beaten));
        // One of several alike stands for all.
        const bool stands_in = std::any_of(front.begin(), front.end(), [&](std::size_t k) {
            return points[k].error == points[i].error &&
                   points[k].cost.median_us == points[i].cost.median_us;
        });
        CHECK((in_front || beaten || stands_in));
    }
}

TEST_CASE("pareto: the default is found by its series and its knob") {
    CostCurve curve;
    curve.points = {{"a", 1, 0, {}, {}}, {"b", 1, 0, {}, {}}, {"b", 2, 0, {}, {}}};
    curve.default_series = "b";
    curve.default_knob = 2;
    CHECK(find_default(curve) == 2);
    curve.default_knob = 3;
    CHECK(find_default(curve) == 3);
}

}  // namespace
}  // namespace fulcrum::bench
