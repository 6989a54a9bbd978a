// What a benchmark found, ready to be written: every number in it was measured or computed in this run.
//
//   CostCurve   error against time, one point a setting of the knob: the Pareto front is drawn from it
//   LineChart   any y over x: boundaries, courses over time, growth
//   Sheet       a table of text and numbers
// Each becomes a CSV file, an SVG file (sheets have none) and a section of the HTML page.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <variant>
#include <vector>

namespace fulcrum::bench {

/// A value that could not be had: the run was unstable, or the peer has no such thing. Drawn as a gap, written as "".
inline constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

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
};

/// How a line is drawn.
enum class LineStyle : unsigned char { measured, theory, dots };

struct Line {
    std::string name;
    LineStyle style = LineStyle::measured;
    std::vector<double> x, y;  ///< of one length; kNone in y makes a gap
};

struct LineChart {
    std::string name, title;
    std::string work;
    std::string reference;  ///< what theory or peer stands beside it; may be empty
    std::string advice;
    Axis x, y;
    std::vector<Line> lines;  ///< a theory's line right after a measured one takes its colour
};

struct Sheet {
    std::string name, title;
    std::string work;
    std::string advice;
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;  ///< each as long as columns
};

using Exhibit = std::variant<CostCurve, LineChart, Sheet>;
using Report = std::vector<Exhibit>;

}  // namespace fulcrum::bench
