// A virtual wall tried out in time, by the code that renders it: the simulated arm, a velocity estimator and the coupling's
// law, sampled at a fixed rate.
//
//   the wall fills x < 0; F = max(K d - B v, 0) while d = -x > 0 is seen (or, both ways, K d - B v always)
//   the hand starts at rest where it is put, and wants to be press_m inside the wall
// The trial is judged by the true position's swing, from its lowest to its highest, in two windows of a quarter of its time:
// the second quarter and the last. The wall is stable when the swing decays, to less than kStillDecays of what it was, or
// lies within kCalmSteps encoder steps. A growing vibration and one that neither grows nor decays (a limit cycle) are not.
#pragma once

#include "haptics/coupling/coupling_settings.h"
#include "haptics/coupling/velocity_estimator.h"
#include "haptics/device/simulated/simulated_arm.h"

namespace fulcrum::z_width {

inline constexpr double kStillDecays = 0.99;
inline constexpr double kCalmSteps =
    2.0;  ///< a quantised loop at rest may chatter between two neighbours

struct WallTrial {
    SimulatedArmSettings arm{};
    double rate_Hz = 1000.0;
    /// Its noise bound is the arm's resolution where that is not zero.
    VelocitySettings velocity{};
    double stiffness_N_per_m = 0.0;  ///< K
    double damping_Ns_per_m = 0.0;   ///< B, either sign
    bool both_ways = false;   ///< a spring about the surface instead of a surface that only pushes
    double start_m = -0.001;  ///< where the hand starts
    double press_m = 0.0;     ///< how deep in the wall the hand wants to be
    double seconds = 4.0;
};

struct WallCourse {
    double early_m = 0.0;   ///< swing in the second quarter
    double late_m = 0.0;    ///< swing in the last quarter
    double depth_m = 0.0;   ///< mean depth in the last quarter
    double force_N = 0.0;   ///< mean force on the hand in the last quarter
    double ripple_N = 0.0;  ///< from the smallest to the largest force in the last quarter
};

/// Runs it; the same trial gives the same bits.
[[nodiscard]] WallCourse run_wall_trial(const WallTrial& trial);
/// The verdict on a course of an arm with this encoder step (0 for none).
[[nodiscard]] bool is_stable(const WallCourse& course, double position_resolution_m);
/// Runs and judges.
[[nodiscard]] bool is_stable(const WallTrial& trial);

inline constexpr double kSoftest_N_per_m = 10.0;
inline constexpr double kStiffest_N_per_m = 1.0e6;
/// The stiffness up to which every wall tried is stable, from kSoftest_N_per_m on by steps of a tenth, then to a relative
/// `tolerance`; 0 when the softest is not.
[[nodiscard]] double find_largest_stiffness(WallTrial trial, double tolerance = 0.02);
/// Likewise the damping at the trial's stiffness, from 0.1 to 1000 Ns/m; 0 when 0.1 is not stable.
[[nodiscard]] double find_largest_damping(WallTrial trial, double tolerance = 0.02);

}  // namespace fulcrum::z_width
