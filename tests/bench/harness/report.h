// What a benchmark found, ready to be written: every number in it was measured or computed in this run.
//
//   CostCurve   error against time, one point a setting of the knob: the Pareto front is drawn from it
//   LineChart   any y over x: boundaries, courses over time, growth
//   Sheet       a table of text and numbers
// Each becomes a CSV file, an SVG file (sheets have none) and a section of the HTML page.
#pragma once

#include <cmath>
#include <concepts>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace fulcrum::bench {

/// A value that could not be had: the run was unstable, or the peer has no such thing. Drawn as a gap, written as "".
inline constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// A number as short as it is exact to six digits: "0.25", "1.2e-09"; "" when it is not finite.
[[nodiscard]] std::string to_text(double value);

/// To so many digits behind the point, and never "-0".
[[nodiscard]] inline double rounded(double value, int digits) {
    const double scale = std::pow(10.0, digits);
    return std::round(scale * value) / scale + 0.0;
}

/// What one step costs.
struct Cost {
    double median_us = kNone;
    double p99_us = kNone;
    std::size_t bytes = 0;  ///< of state that the approximation needs; 0: none beyond the stack
};

/// An axis or a column.
struct Axis {
    std::string name;  ///< "force error"
    std::string unit;  ///< "N"; empty for a pure number
    bool logarithmic = false;
};

/// One setting of the knob.
struct CostPoint {
    std::string series;    ///< which method: "RK4"
    double knob = kNone;   ///< in the unit of CostCurve::knob
    double error = kNone;  ///< in the unit of CostCurve::error; kNone where it was unstable
    Cost cost{};
    std::vector<double> extras;  ///< one a column of CostCurve::extras, in that order
};

/// A knob's curve of error against time.
struct CostCurve {
    std::string name;       ///< file stem: "integrators-oscillator"
    std::string title;      ///< "Integrators on an oscillator"
    std::string work;       ///< what was computed, one sentence
    std::string reference;  ///< what the error is against: "analytic: ..." or "converged: ..."
    std::string advice;     ///< one sentence: what to choose when
    Axis knob;
    Axis error;
    std::vector<Axis> extras;
    std::string
        default_series;  ///< what is taken when nobody chooses, by the program or, where `work` says so, by the
                         ///< library alone; must be among the points
    double default_knob = kNone;
    std::vector<CostPoint> points;
    /// What a point's time is for: "step" (default) or another word such as "simulated second".
    std::string time_is_per = "step";

    void add(const std::string& series, double of_knob, double of_error, const Cost& cost,
             std::vector<double> of_extras = {}) {
        points.push_back({series, of_knob, of_error, cost, std::move(of_extras)});
    }
};

/// How a line is drawn.
enum class LineStyle : unsigned char { measured, theory, dots };

struct Line {
    std::string name;
    LineStyle style = LineStyle::measured;
    std::vector<double> x{}, y{};  ///< of one length; kNone in y makes a gap

    void add(double at_x, double at_y) {
        x.push_back(at_x);
        y.push_back(at_y);
    }
};

/// p of y ~ x^p, between the line's first and last point.
[[nodiscard]] inline double find_power(const Line& line) {
    return std::log(line.y.back() / line.y.front()) / std::log(line.x.back() / line.x.front());
}

struct LineChart {
    std::string name, title;
    std::string work;
    std::string reference;  ///< what theory or peer stands beside it; may be empty
    std::string advice;
    Axis x, y;
    std::vector<Line> lines;  ///< a theory's line right after a measured one takes its colour

    /// A line of `y(x)`.
    template <class Y>
    void trace(const std::string& line, LineStyle style, const std::vector<double>& xs, Y of) {
        Line traced{line, style};
        for (const double at_x : xs) {
            traced.add(at_x, of(at_x));
        }
        lines.push_back(std::move(traced));
    }
    /// A line through those of `rows` that belong to it: what `x` and `y` tell of each.
    template <class Rows, class Belongs, class X, class Y>
    void draw(const std::string& line, const Rows& rows, Belongs belongs, X of_x, Y of_y) {
        Line drawn{line};
        for (const auto& row : rows) {
            if (belongs(row)) {
                drawn.add(of_x(row), of_y(row));
            }
        }
        lines.push_back(std::move(drawn));
    }
};

/// A sheet's cell: text as it is, a number as `to_text` writes it, a whole one in full.
struct Cell : std::string {
    Cell(std::string text) : std::string(std::move(text)) {}
    Cell(const char* text) : std::string(text) {}
    Cell(std::string_view text) : std::string(text) {}
    Cell(double number) : std::string(to_text(number)) {}
    Cell(std::integral auto number) : std::string(std::to_string(number)) {}
};

struct Sheet {
    std::string name, title;
    std::string work;
    std::string advice;
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows{};  ///< each as long as columns

    void add(std::initializer_list<Cell> cells) { rows.emplace_back(cells.begin(), cells.end()); }
};

using Exhibit = std::variant<CostCurve, LineChart, Sheet>;
using Report = std::vector<Exhibit>;

}  // namespace fulcrum::bench
