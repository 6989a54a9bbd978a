// A hard case with a number that says whether it stayed stable. One file under tests/stability/cases holds a few that
// register themselves; ctest runs each as a test of its own, `fulcrum bench stability` prints them all as a table.
//
//   Finding press_corner() { ...; return {worst_mm, 1.0e-9}; }
//   const HardCase kCorner{{"corner", "the proxy rests in a corner of three planes", "distance from the true corner", "m",
//                           press_corner}};
#pragma once

#include <cmath>
#include <exception>
#include <functional>
#include <string>
#include <vector>

namespace fulcrum::stability {

/// The worst that was seen, and what it must not pass: it holds when worst <= limit (NaN does not).
struct Finding {
    double worst;
    double limit;
    std::string note;  ///< a few words for the table, such as where the worst was; may be empty
    [[nodiscard]] bool holds() const { return worst <= limit; }
    /// Keeps the worse with its note; no number stays.
    void take(double value, const std::string& words) {
        if (!std::isnan(worst) && !(value <= worst)) {
            worst = value;
            note = words;
        }
    }
};

/// The larger of two; NaN is worse than anything, and stays.
[[nodiscard]] inline double worse(double a, double b) {
    return std::isnan(a) || a > b ? a : b;
}

/// Numbers in words for a note, as std::printf writes them; 255 letters at most.
[[gnu::format(printf, 1, 2)]] [[nodiscard]] std::string describe(const char* format, ...);

struct CaseDescription {
    std::string name;      ///< unique: "corner of three planes"
    std::string what;      ///< one sentence
    std::string measured;  ///< what the number is: "distance from the true corner"
    std::string unit;
    std::function<Finding()> run;  ///< deterministic: fixed seeds, no clock; a few seconds at most
};

/// Runs it. A case that throws does not hold, and the others still run: its worst is no number, its note what it threw.
[[nodiscard]] inline Finding run_case(const CaseDescription& one) {
    try {
        return one.run();
    } catch (const std::exception& error) {
        const double nan = std::nan("");
        return {nan, nan, std::string("could not be run: ") + error.what()};
    }
}

/// Adds to the list while the program starts.
struct HardCase {
    explicit HardCase(CaseDescription description);
};

/// All of them, by name.
[[nodiscard]] const std::vector<CaseDescription>& all_cases();

}  // namespace fulcrum::stability
