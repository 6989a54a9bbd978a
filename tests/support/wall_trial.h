// A virtual wall tried out in time, by the code that renders it: the simulated arm, a velocity estimator and the coupling's
// law, sampled at a fixed rate.
//
//   the wall fills x < 0; F = max(K d - B v, 0) while d = -x > 0 is seen (or, both ways, K d - B v always)
//   the hand starts at rest where it is put, and wants to be press_m inside the wall
// It runs on until it is decided. Each window of half a second gives the true position's swing, from its lowest to its
// highest, and the ripple of the force that the wall asks for; d is a step of the encoder.
//   stable      two windows one after the other are calm: swing <= max(2 d, 10 nm), and
//               ripple <= d K + 0.52 N (a reading that goes between two neighbours), yet within what the motor has
//   stable      the loop was linear all the while (no steps, no dry friction, no release, no saturation, no adaptive
//               window) and the swing shrinks by a hundredth in two seconds: it will go on to nothing
//   unstable    the swing has not shrunk by a hundredth below what it was two seconds ago, or ever before that: it grows,
//               or it stands for ever as a limit cycle
//   unstable    after longest_s it is neither
#pragma once

#include "haptics/coupling/coupling_settings.h"
#include "haptics/coupling/velocity_estimator.h"
#include "haptics/device/simulated/simulated_arm.h"

#include <optional>
#include <vector>

namespace fulcrum::z_width {

inline constexpr double kWindow_s = 0.5;  ///< longer than a period of the slowest hand
inline constexpr double kStillDecays = 0.99;
inline constexpr double kCalmSteps =
    2.0;  ///< a quantised loop at rest may chatter between two neighbours
inline constexpr double kCalmAtLeast_m = 1.0e-8;  ///< far above rounding, far below any hand
/// From -0.26 to 0.26 N: what the dry friction of the desktop arm holds, so that a hand on the real one feels nothing.
inline constexpr double kCalmRipple_N = 0.52;

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
    double longest_s = 60.0;
};

/// A hand on the desktop arm comes from 10 mm above the wall and presses 4 mm into it. Without the arm's dry friction, which would hide
/// depth and vibration alike; and so strong that the wall, not the motor, sets the boundary.
[[nodiscard]] WallTrial make_tap(const HumanImpedance& human);

enum class WallVerdict : unsigned char { undecided, stable, unstable };

/// What one window saw.
struct WallWindow {
    double swing_m = 0.0;
    double ripple_N = 0.0;   ///< from the smallest to the largest force asked for
    double depth_m = 0.0;    ///< mean
    double force_N = 0.0;    ///< mean
    bool is_linear = false;  ///< nothing but springs and dampers acted
};

/// Judges windows as they come; the first, in which the hand arrives, counts for nothing.
class WallJudge {
  public:
    /// Calm is up to this swing and ripple.
    WallJudge(double calm_m, double calm_N) : calm_m_(calm_m), calm_N_(calm_N) {}
    /// Calm for this trial.
    explicit WallJudge(const WallTrial& trial);
    /// The verdict with the next window; `stable` and `unstable` are final.
    WallVerdict take(const WallWindow& window);

  private:
    double calm_m_, calm_N_;
    std::vector<WallWindow> windows_;
};

struct WallCourse {
    WallVerdict verdict = WallVerdict::undecided;
    WallWindow last;        ///< the window that decided
    double lasted_s = 0.0;  ///< until it was decided
    [[nodiscard]] bool is_stable() const { return verdict == WallVerdict::stable; }
};

/// Runs it until it is decided; the same trial gives the same bits.
[[nodiscard]] WallCourse run_wall_trial(const WallTrial& trial);

inline constexpr double kSoftest_N_per_m = 10.0;
inline constexpr double kStiffest_N_per_m = 1.0e6;
/// The stiffness up to which every wall tried is stable, from kSoftest_N_per_m on by steps of a tenth, then to a relative
/// `tolerance`; nothing when the softest is not, or when all are up to kStiffest_N_per_m.
[[nodiscard]] std::optional<double> find_largest_stiffness(WallTrial trial,
                                                           double tolerance = 0.02);
/// Likewise the damping at the trial's stiffness, from 0.1 to 1000 Ns/m.
[[nodiscard]] std::optional<double> find_largest_damping(WallTrial trial, double tolerance = 0.02);

}  // namespace fulcrum::z_width
