#include "tests/bench/harness/svg.h"

#include "tests/bench/harness/page.h"

#include <catch2/catch.hpp>

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

}  // namespace
}  // namespace fulcrum::bench
