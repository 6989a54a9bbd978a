// A problem on which the five integrators are compared: `fulcrum bench integrators`.
#pragma once

#include "haptics/dynamics/integrator.h"
#include "tests/bench/harness/report.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace fulcrum::bench {

/// States are compared every so often; each step size that is tried divides it.
inline constexpr double kSample_s = 0.02;
/// The knob's values, finest first.
inline constexpr std::array<double, 7> kRates_Hz{4000.0, 2000.0, 1000.0, 500.0, 250.0, 100.0, 50.0};

struct IntegratorProblem {
    std::string name;  ///< of the curve
    std::string title;
    std::string work;
    std::string reference;
    std::string advice;
    Axis error;
    Inertia inertia;
    RigidState start{};
    const Load* load = nullptr;
    std::vector<RigidState> course{};  ///< as it should be, at kSample_s, 2 kSample_s, ...
    /// How wrong a state is against the course's, in the unit of `error`.
    std::function<double(const RigidState&, const RigidState&)> compute_error{};
    double rounding = 0.0;        ///< an error below this is rounding and shows no order
    double unstable_above = 0.0;  ///< an error above this is no error but a run out of bounds
};

/// Gives `problem` its course by RK4 at 64 kHz, and says as its reference how far that is from the same at 32 kHz.
void take_converged_course(IntegratorProblem& problem, int n_samples);

/// A point of these curves: time is that of a simulated second, that of a step stands in the last two columns.
[[nodiscard]] CostPoint make_integrator_point(const std::string& series, double rate_Hz,
                                              double error, const Cost& step,
                                              double theoretical_order = kNone,
                                              double solves_a_step = kNone);

[[nodiscard]] IntegratorProblem make_oscillator_problem();
[[nodiscard]] IntegratorProblem make_contact_problem();
[[nodiscard]] IntegratorProblem make_free_rotation_problem();
[[nodiscard]] IntegratorProblem make_tool_problem();

}  // namespace fulcrum::bench
