#include "tests/bench/harness/svg.h"

#include "tests/bench/harness/canvas.h"
#include "tests/bench/harness/csv.h"
#include "tests/bench/harness/pareto.h"

#include <algorithm>
#include <cmath>

namespace fulcrum::bench {
namespace {

std::string with_unit(double value, const Axis& axis) {
    return to_text(value) + (axis.unit.empty() ? "" : " " + axis.unit);
}

// Which settings of which series, in the order in which the series come first.
std::vector<std::string> series_of(const CostCurve& curve) {
    std::vector<std::string> names;
    for (const CostPoint& p : curve.points) {
        if (std::ranges::find(names, p.series) == names.end()) {
            names.push_back(p.series);
        }
    }
    return names;
}

std::string hint_of(const CostCurve& curve, const CostPoint& p) {
    const std::string error = std::isfinite(p.error)
                                  ? curve.error.name + " " + with_unit(p.error, curve.error)
                                  : "unstable";
    return p.series + ", " + curve.knob.name + " " + with_unit(p.knob, curve.knob) + ": " + error +
           ", " + to_text(p.cost.median_us) + " µs (99 %: " + to_text(p.cost.p99_us) + ")";
}

void draw_front(Canvas& canvas, const CostCurve& curve) {
    std::vector<Spot> steps;
    for (const std::size_t i : find_pareto_front(curve.points)) {
        const CostPoint& p = curve.points[i];
        const Spot at = canvas.spot(p.cost.median_us, p.error);
        if (!steps.empty()) {
            steps.push_back({at.x, steps.back().y});
        }
        steps.push_back(at);
    }
    canvas.band(steps);
    for (const std::size_t i : find_pareto_front(curve.points)) {
        const CostPoint& p = curve.points[i];
        canvas.word(canvas.spot(p.cost.median_us, p.error), to_text(p.knob));
    }
}

void draw_series(Canvas& canvas, const CostCurve& curve, const std::string& name,
                 std::size_t index) {
    std::vector<Spot> way;
    for (const CostPoint& p : curve.points) {
        if (p.series != name || !std::isfinite(p.cost.median_us)) {
            continue;
        }
        if (!std::isfinite(p.error)) {
            Spot at = canvas.spot(p.cost.median_us, 1.0);
            at.y = Frame::kTop + 6.0;
            canvas.cross(at, index, hint_of(curve, p));
            continue;
        }
        const Spot at = canvas.spot(p.cost.median_us, p.error);
        if (std::isfinite(p.cost.p99_us)) {
            canvas.hair(at, canvas.spot(p.cost.p99_us, p.error), index);
        }
        canvas.mark(at, index, hint_of(curve, p));
        way.push_back(at);
    }
    canvas.line(way, index, false);
}

std::string draw(const CostCurve& curve) {
    Extent x_extent;
    Extent y_extent;
    for (const CostPoint& p : curve.points) {
        x_extent.add(p.cost.median_us, true);
        y_extent.add(p.error, curve.error.logarithmic);
    }
    const Axis time{"median time a " + curve.time_is_per, "µs", true};
    Canvas canvas(curve.title, time, curve.error, x_extent, y_extent);
    draw_front(canvas, curve);
    const std::vector<std::string> names = series_of(curve);
    for (std::size_t i = 0; i < names.size(); ++i) {
        draw_series(canvas, curve, names[i], i);
        canvas.legend(i, names[i], LineStyle::measured);
    }
    const std::size_t chosen = find_default(curve);
    if (chosen < curve.points.size() && std::isfinite(curve.points[chosen].error)) {
        const CostPoint& p = curve.points[chosen];
        canvas.ring(canvas.spot(p.cost.median_us, p.error), "default");
    }
    canvas.legend_note("grey: none is faster and better;");
    canvas.legend_note("numbers: " + curve.knob.name +
                       (curve.knob.unit.empty() ? "" : ", " + curve.knob.unit));
    const bool some_exact =
        curve.error.logarithmic &&
        std::ranges::any_of(curve.points, [](const CostPoint& p) { return p.error == 0.0; });
    if (some_exact) {
        canvas.legend_note("on the lower edge: exact");
    }
    const bool some_unstable = std::ranges::any_of(
        curve.points, [](const CostPoint& p) { return !std::isfinite(p.error); });
    if (some_unstable) {
        canvas.legend_note("× above: unstable");
    }
    return canvas.finish();
}

// Many points are marked here and there only: enough to tell the lines apart without their colours.
void draw_line(Canvas& canvas, const LineChart& chart, const Line& line, std::size_t look) {
    constexpr std::size_t kFewPoints = 60;
    constexpr std::size_t kMarks = 14;
    const std::size_t count = std::min(line.x.size(), line.y.size());
    const bool dots = line.style == LineStyle::dots;
    const std::size_t every = dots || count <= kFewPoints ? 1 : count / kMarks;
    std::vector<Spot> way;
    for (std::size_t i = 0; i < count; ++i) {
        if (!std::isfinite(line.y[i])) {
            canvas.line(way, look, line.style == LineStyle::theory);
            way.clear();
            continue;
        }
        way.push_back(canvas.spot(line.x[i], line.y[i]));
        // Each line begins its marks elsewhere, so that they don't cover each other.
        if (line.style != LineStyle::theory && (i + look * every / 4) % every == 0) {
            canvas.mark(way.back(), look,
                        line.name + ": " + with_unit(line.x[i], chart.x) + ", " +
                            with_unit(line.y[i], chart.y));
        }
    }
    if (!dots) {
        canvas.line(way, look, line.style == LineStyle::theory);
    }
}

std::string draw(const LineChart& chart) {
    Extent x_extent;
    Extent y_extent;
    for (const Line& line : chart.lines) {
        for (std::size_t i = 0; i < std::min(line.x.size(), line.y.size()); ++i) {
            if (std::isfinite(line.y[i])) {
                x_extent.add(line.x[i], chart.x.logarithmic);
                y_extent.add(line.y[i], chart.y.logarithmic);
            }
        }
    }
    Canvas canvas(chart.title, chart.x, chart.y, x_extent, y_extent);
    std::size_t look = 0;
    for (std::size_t k = 0; k < chart.lines.size(); ++k) {
        const Line& line = chart.lines[k];
        // Theory looks like what it stands beside.
        const bool beside = line.style == LineStyle::theory && k > 0 &&
                            chart.lines[k - 1].style == LineStyle::measured;
        look += k > 0 && !beside ? 1U : 0U;
        draw_line(canvas, chart, line, look);
        canvas.legend(look, line.name, line.style);
    }
    return canvas.finish();
}

std::string draw(const Sheet& /*sheet*/) {
    return {};
}

}  // namespace

std::string draw_svg(const Exhibit& exhibit) {
    return std::visit([](const auto& e) { return draw(e); }, exhibit);
}

}  // namespace fulcrum::bench
