// What all continuous collision is asked and answers: when do two things on their way first come nearer than `touch_m`?
//
// What is promised, of surfaces (nobody knows here what is inside), with the distance at time t called g(t):
//   free        g(t) > touch for all t of the way
//   touching    at `time`: g > touch before it, and touch < g <= touch + tolerance at it, so a body put there is still apart; or at 0, if 0 < g <= touch there
//   overlapping at the beginning of the way they have a point in common already, or are so near that nothing can tell
// So nothing is ever missed, and what is reported and was none came within the tolerance, but for one end: a search by intervals that would take more
// than kMostPieces pieces of time (interval_sweep.h) tells a contact where it has come to, nearer than the tolerance or not; too early, never too
// late. Both hold for real numbers, not for rounded ones; how, is shown in triangle_sweep.h and interval_sweep.h. Only `g <= touch + tolerance`
// asks, of triangles as thin as 1e-8 of their length, that the rounded distance is right.
// A tolerance is never taken smaller than 2^-38 of the lengths involved.
#pragma once

#include "haptics/continuous/in_between_motion.h"
#include "haptics/continuous/nearest_features.h"

#include <algorithm>
#include <cstdint>

namespace fulcrum {

struct SweepSettings {
    /// Surfaces nearer than this touch. 0 or more.
    double touch_m = 0.0;
    /// Above it, what may be taken for touching. Above 0; the god-object's default is a micrometre.
    double tolerance_m = 1.0e-6;
};

[[nodiscard]] inline bool is_valid(const SweepSettings& settings) noexcept {
    constexpr double kMost_m = InBetweenMotion::kLargest_m;
    return settings.touch_m >= 0.0 && settings.touch_m <= kMost_m && settings.tolerance_m > 0.0 &&
           settings.tolerance_m <= kMost_m;
}

enum class SweepOutcome : std::uint8_t {
    free,
    touching,
    overlapping,
    invalid  ///< a pose, corner or setting that is none: nothing was found out
};

/// Two triangles at their first contact. Frame A.
struct SweepContact {
    double time = 1.0;        ///< of the way, 0 to 1
    NearFeatures features{};  ///< with their nearest points, at that time
    Vector3 normal_A{
        Vector3::Zero()};  ///< unit, from the held one to the moving one; zero where they overlap
};

/// A triangle on its way.
struct MovingTriangle {
    std::array<PointPath, 3> corners;
    double reach_m = 0.0;  ///< from the pivot to the farthest corner; not-a-number where one is

    [[nodiscard]] static MovingTriangle of(const InBetweenMotion& motion,
                                           const Triangle& corners_B) noexcept {
        MovingTriangle made;
        for (std::size_t i = 0; i < 3; ++i) {
            made.corners[i] = motion.find_path(corners_B[i]);
            const double reach_m = motion.distance_to_pivot_m(corners_B[i]);
            made.reach_m = reach_m > made.reach_m || std::isnan(reach_m) ? reach_m : made.reach_m;
        }
        return made;
    }
    [[nodiscard]] Triangle find_place(const InBetweenMotion& motion, double t,
                                      const SineCosine& turn) const noexcept {
        return {motion.find_place(corners[0], t, turn), motion.find_place(corners[1], t, turn),
                motion.find_place(corners[2], t, turn)};
    }
};

[[nodiscard]] inline bool is_finite(const MovingTriangle& moving) noexcept {
    return moving.reach_m <= InBetweenMotion::kLargest_m;
}

/// Distances as they are compared: what rounding may take is added to what counts as touching.
struct SweepBounds {
    double touch_m = 0.0;
    double tolerance_m = 0.0;
    double slack_m = 0.0;   ///< one place's error: of a path, and of its evaluation
    double length_m = 0.0;  ///< none that goes into an evaluation is longer

    [[nodiscard]] static SweepBounds of(const InBetweenMotion& motion, double reach_m,
                                        double fixed_reach_m,
                                        const SweepSettings& settings) noexcept {
        constexpr double kLeastTolerance = 256.0;  // slacks: 2^-38 of the lengths
        SweepBounds bounds;
        bounds.slack_m = motion.find_slack_m(reach_m + fixed_reach_m);
        bounds.length_m = 0x1.0p+46 * bounds.slack_m;
        bounds.tolerance_m = std::max(settings.tolerance_m, kLeastTolerance * bounds.slack_m);
        // A direction's length, 1 but for rounding, is in it too.
        bounds.touch_m = settings.touch_m * (1.0 + 0x1.0p-48) + 4.0 * bounds.slack_m;
        return bounds;
    }
    [[nodiscard]] double most_m() const noexcept { return touch_m + tolerance_m; }
};

[[nodiscard]] inline double find_reach_m(const Triangle& corners) noexcept {
    return std::max({corners[0].norm(), corners[1].norm(), corners[2].norm()});
}
[[nodiscard]] inline bool is_finite(const Triangle& corners) noexcept {
    const double reach_m = find_reach_m(corners);
    return reach_m <= InBetweenMotion::kLargest_m && !std::isnan(corners[0].sum()) &&
           !std::isnan(corners[1].sum()) && !std::isnan(corners[2].sum());
}

/// What two triangles did.
struct TriangleSweep {
    SweepOutcome outcome = SweepOutcome::free;
    SweepContact contact{};
    /// How often places were looked at, for those who count.
    std::int32_t looks = 0;
    /// Was the faster finder unsure, so that intervals decided?
    bool by_intervals = false;
};

}  // namespace fulcrum
