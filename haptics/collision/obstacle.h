// A solid as a cursor meets it: how far they are apart, and where on its way the cursor comes too near.
//
// The cursor is a convex shape that goes its ways without turning, a ball unless something else is said. A solid is made of features,
// each convex (a triangle, or the whole shape), so the gap between cursor and feature
//   f(x) = distance(feature, cursor at x)
// is a convex function of the cursor's place x, with the gradient n: the direction from the feature to the cursor. Hence
//   - all places y with n . (y - x) >= -f(x) are free of the feature, and so is all of a segment that both ends are free by one n;
//   - Newton's method on f along a segment never steps past the first place where f falls to a level, and is fast.
// A feature may have an inside, where f is negative; a triangle has none: both its faces are solid.
// Between its ways the cursor may turn, and come elsewhere with that. Let n be the direction of the feature's gap where it was, and
//   g = least n . c - greatest n . p,    c in the cursor turned and come there, p in the feature
// Where g >= 0 one plane across n kept them apart before and does so now: out along n, turned there, and back again is a way without a
// meeting, whatever the turn. So a cursor that has turned is met where g falls below the level.
//
// Thread: haptic loop. Cost: a feature some tens of nanoseconds; no allocation after construction.
// Source: the inner half-space and linear casting as in G. van den Bergen 2004, Ray casting against general convex objects with
// application to continuous collision detection.
#pragma once

#include "haptics/math/spatial.h"

#include <cstdint>
#include <span>

namespace fulcrum {

/// How far a feature is from the cursor.
struct Gap {
    Vector3 normal_B{Vector3::UnitY()};  ///< unit, from the feature to the cursor
    double gap_m = 0.0;                  ///< negative inside
    /// How the surface of all places that touch the feature bends away from the cursor here: the inverse of its radius, 0 where flat.
    double curvature_per_m = 0.0;
    /// Unit, the direction in which it does not bend; zero when it bends alike in all.
    Vector3 straight_B{Vector3::Zero()};
};

/// The first meeting on a way, at from + t (to - from).
struct CastHit {
    double t = 2.0;             ///< 0 to 1; 2 when there is none
    std::int32_t feature = -1;  ///< which of the obstacle's; 0 where it has one alone

    [[nodiscard]] bool found() const noexcept { return t <= 1.0; }
};

/// How a way is asked about.
struct CastQuestion {
    Vector3 from_B;
    Vector3 to_B;
    double level_m = 0.0;  ///< the gap that counts as met; above 0
    double reach_m =
        0.0;  ///< how far the cursor is likely to go in the next steps: for what to remember
    /// Unit normals of planes that the way does not sink through: a feature below one of them is not met.
    std::span<const Vector3> normals_B{};
};

/// The clearance where distances are right to rounding, of the size of what touches.
inline constexpr double kExactClearance = 1.0e-10;

class Obstacle {
  public:
    Obstacle() = default;
    Obstacle(const Obstacle&) = delete;
    Obstacle& operator=(const Obstacle&) = delete;
    virtual ~Obstacle() = default;

    /// The first place on the way where a feature's gap falls to the level, or is below it and falls. Ways are finite.
    [[nodiscard]] virtual CastHit cast(const CastQuestion& question) noexcept = 0;
    /// The gap of one feature; of a cursor that has turned g, with its n, where it turned at the place.
    [[nodiscard]] virtual Gap find_gap(std::int32_t feature,
                                       const Vector3& at_B) const noexcept = 0;
    /// The feature with the least gap, if that is below `level_m`; -1 when all are further.
    [[nodiscard]] virtual std::int32_t find_nearest(const Vector3& at_B,
                                                    double level_m) const noexcept = 0;
    /// How far the cursor can go from `at_B` along `direction_B`, in the plane across a bent feature's normal, until another part of the
    /// solid is nearest to it.
    [[nodiscard]] virtual double find_bend(std::int32_t feature, const Vector3& at_B,
                                           const Vector3& direction_B) const noexcept = 0;
    /// Says how the cursor is turned, as seen from the body (R_CB). True where it has turned since it was last kept: a ball never has.
    virtual bool turn(const Matrix3& /*turn_CB*/) noexcept { return false; }
    /// The cursor is where it could go, turned so.
    virtual void keep_turn() noexcept {}
    /// A sphere round all places where the cursor touches the solid.
    [[nodiscard]] virtual Vector3 centre_B() const noexcept = 0;
    [[nodiscard]] virtual double radius_m() const noexcept = 0;
    /// The gap at which a proxy is held, above 0: far above rounding, far below what can be felt.
    [[nodiscard]] virtual double clearance_m() const noexcept = 0;
};

/// `Obstacle::cast` for one feature: find_gap(place) tells its gap. Returns t, or 2 when the way is free.
template <class FindGap>
[[nodiscard]] double cast_convex(const CastQuestion& question, FindGap&& find_gap) noexcept {
    constexpr int kMostSteps =
        64;  // halving steps where it grazes; the last place is free in any case
    constexpr double kNear = 0.1;  // of the level: near enough to it
    const Vector3 way = question.to_B - question.from_B;
    double t = 0.0;
    for (int i = 0; i < kMostSteps; ++i) {
        const Gap gap = find_gap(Vector3(question.from_B + t * way));
        const double fall = -gap.normal_B.dot(way);
        const double rest = gap.gap_m - question.level_m;
        if (!(fall > 0.0) || rest >= fall * (1.0 - t)) {
            return 2.0;
        }
        if (rest <= kNear * question.level_m) {
            return t;
        }
        t += rest / fall;
    }
    return t;
}

}  // namespace fulcrum
