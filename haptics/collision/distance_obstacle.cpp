#include "haptics/collision/distance_obstacle.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {

namespace {

// The gap at which a proxy is held, of the solid's size: steps of the function's own size must lead off it soon.
constexpr double kClearance = 1.0e-8;
// How far off the surface a way across it is gone, of its length.
constexpr double kLift = 0.25;
constexpr int kMostStraight = 32;  // steps before a way along the surface is tried
constexpr int kMostSteps = 256;
constexpr int kMostHalvings = 40;
// Nearer than this part of the level is met.
constexpr double kNear = 0.1;
// Of the gap at the start: a way along the surface comes no nearer to it.
constexpr double kNoDeeper = 0.9;
// A gradient shorter than this, of L, has no direction.
constexpr double kNoGradient = 1.0e-9;

}  // namespace

DistanceObstacle::DistanceObstacle(std::shared_ptr<const DistanceFunction> function,
                                   double ball_radius_m)
    : function_(std::move(function)),
      ball_radius_m_(ball_radius_m),
      per_value_m_(1.0 / function_->lipschitz()) {}

double DistanceObstacle::clearance_m() const noexcept {
    return kClearance * std::max(function_->radius_m(), ball_radius_m_);
}

DistanceObstacle::Seen DistanceObstacle::look(const Vector3& at_B) const noexcept {
    const DistanceFunction::Value seen = function_->at(at_B);
    const double slope = std::min(seen.gradient_B.norm() * per_value_m_, 1.0);
    const double rest_m = seen.value * per_value_m_ - ball_radius_m_;
    if (!(slope > kNoGradient)) {
        return {rest_m, rest_m, Vector3::UnitY()};
    }
    return {rest_m, rest_m / slope, seen.gradient_B.normalized()};
}

// How far along the way the gap stays above the level, 0 to 1; 2 when it does to the end.
double DistanceObstacle::trace(const Vector3& from_B, const Vector3& to_B, double level_m,
                               int most_steps) const noexcept {
    const Vector3 way = to_B - from_B;
    const double length_m = way.norm();
    double gone_m = 0.0;
    for (int i = 0; i < most_steps; ++i) {
        const Seen seen = look(from_B + gone_m / length_m * way);
        if (seen.gap_m <= (1.0 + kNear) * level_m) {
            break;
        }
        // From a gap down to the level: that part of what may be gone in all.
        gone_m += seen.free_m * (1.0 - level_m / seen.gap_m);
        if (gone_m >= length_m) {
            return 2.0;
        }
    }
    return gone_m / length_m;
}

CastHit DistanceObstacle::cast(const CastQuestion& question) noexcept {
    const Vector3 way = question.to_B - question.from_B;
    const Seen start = look(question.from_B);
    double level_m = question.level_m;
    if (start.gap_m <= level_m) {
        // In it already: out is free, in is not.
        if (start.normal_B.dot(way) < 0.0) {
            return {0.0, 0};
        }
        if (!(start.gap_m > 0.0)) {
            return cast_out(question, start.gap_m);
        }
    }
    level_m = std::min(level_m, kNoDeeper * start.gap_m);
    const double straight = trace(question.from_B, question.to_B, level_m, kMostStraight);
    if (straight > 1.0) {
        return {};
    }
    const Vector3 lift_B = kLift * way.norm() * start.normal_B;
    // Up is gone as down, from above: there the steps are long.
    if (trace(question.from_B + lift_B, question.from_B, level_m, kMostSteps) <= 1.0) {
        return {straight, 0};
    }
    const double across =
        trace(question.from_B + lift_B, question.to_B + lift_B, level_m, kMostSteps);
    if (across > 1.0 && trace(question.to_B + lift_B, question.to_B, level_m, kMostSteps) > 1.0) {
        return {};
    }
    return {std::max(straight, find_stop(question, lift_B, level_m, std::min(across, 1.0))), 0};
}

// Seen from its end, a way out must be free but for the depth that it comes from.
CastHit DistanceObstacle::cast_out(const CastQuestion& question, double gap_m) const noexcept {
    constexpr double kDepths = 4.0;  // oblique
    const double length_m = (question.to_B - question.from_B).norm();
    const double back = trace(question.to_B, question.from_B, question.level_m, kMostSteps);
    const bool is_out =
        (1.0 - std::min(back, 1.0)) * length_m <= kDepths * (question.level_m - gap_m);
    return is_out ? CastHit{} : CastHit{0.0, 0};
}

// The farthest place on the way that the lifted way is known to lead down to.
double DistanceObstacle::find_stop(const CastQuestion& question, const Vector3& lift_B,
                                   double level_m, double t_most) const noexcept {
    const Vector3 way = question.to_B - question.from_B;
    double below = 0.0;
    double above = t_most;
    for (int i = 0; i < kMostHalvings; ++i) {
        const double middle = 0.5 * (below + above);
        const double gap_m = look(question.from_B + middle * way).gap_m;
        (gap_m > (1.0 + kNear) * level_m ? below : above) = middle;
    }
    const Vector3 stop_B = question.from_B + below * way;
    return trace(stop_B + lift_B, stop_B, level_m, kMostSteps) > 1.0 ? below : 0.0;
}

Gap DistanceObstacle::find_gap(std::int32_t /*feature*/, const Vector3& at_B) const noexcept {
    const Seen seen = look(at_B);
    return {.normal_B = seen.normal_B, .gap_m = seen.gap_m};
}

std::int32_t DistanceObstacle::find_nearest(const Vector3& at_B, double level_m) const noexcept {
    return look(at_B).gap_m < level_m ? 0 : -1;
}

}  // namespace fulcrum
