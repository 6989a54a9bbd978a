// A hand that slides below a surface, and how far what it feels is from the truth: shared by the god-object and its peers.
#pragma once

#include "haptics/coupling/coupling_settings.h"
#include "haptics/math/spatial.h"
#include "tests/bench/harness/report.h"

#include <functional>
#include <string>
#include <vector>

namespace fulcrum::bench {

inline constexpr double kRadius_m = 0.1;  ///< of the ball, and of a ring's tube
inline constexpr double kDepth_m = 0.02 * kRadius_m;
inline constexpr double kStiffness_N_per_m = CouplingSettings{}.stiffness_N_per_m;
inline constexpr double kForce_N = kStiffness_N_per_m * kDepth_m;

/// The ball's frequencies (20 f^2 triangles each) in a long and in a quick run.
[[nodiscard]] std::vector<int> ball_frequencies(bool quick);

/// A hand kDepth_m below the true surface, and that surface's normal there.
struct Pressed {
    Vector3 hand_W;
    Vector3 normal_W;
};
using Course = std::vector<Pressed>;

/// Over the whole ball at 4 radii a second, 1 kHz.
[[nodiscard]] Course wander_on_ball(int n_steps);

/// What one step gave: newtons, the unit normal of what is touched, and whether anything is.
struct Felt {
    Vector3 force_N;
    Vector3 normal_W;
    bool touches;
};

/// Plays the course for its errors, begins it anew with `restart`, and plays it for its time, warmed up.
[[nodiscard]] CostPoint measure_felt(
    const std::string& series, double n_triangles, const Course& course, std::size_t bytes,
    const std::function<Felt(const Vector3&)>& feel, const std::function<void()>& restart = [] {});

/// The columns of errors beyond the curve's own, and two for orders of convergence, which are left empty here.
[[nodiscard]] std::vector<Axis> surface_columns();

}  // namespace fulcrum::bench
