#include "haptics/continuous/triangle_sweep.h"

#include "haptics/continuous/interval_sweep.h"

#include <cmath>
#include <limits>

namespace fulcrum {
namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();

struct Way {
    const InBetweenMotion& motion;
    const Triangle& fixed;
    const MovingTriangle& moving;
    SweepBounds bounds;
};

double find_highest(const Triangle& triangle, const Vector3& direction) noexcept {
    return std::max(
        {direction.dot(triangle[0]), direction.dot(triangle[1]), direction.dot(triangle[2])});
}

// The least root of g + rate s - q s^2 / 2, shortened; forever where there is none. g > 0, q >= 0.
double find_root(double g, double rate, double q) noexcept {
    constexpr double kShorter = 1.0 - 0x1.0p-30;
    const double root = std::sqrt(rate * rate + 2.0 * q * g);
    if (rate < 0.0) {
        return kShorter * 2.0 * g / (root - rate);
    }
    return q > 0.0 ? kShorter * (rate + root) / q : kForever;
}

// For how long after t the direction keeps all corners apart; 0 where it does not at t.
double find_free_time(const Way& way, const Vector3& direction, double t,
                      const SineCosine& turn) noexcept {
    const double angle = way.motion.angle_rad();
    const double slack_m = way.bounds.slack_m;
    const double highest_m = find_highest(way.fixed, direction);
    double free = kForever;
    for (const PointPath& corner : way.moving.corners) {
        const double apart_m =
            direction.dot(way.motion.find_place(corner, t, turn)) - highest_m - 2.0 * slack_m;
        const double g = apart_m - way.bounds.touch_m - 0.25 * way.bounds.tolerance_m;
        if (!(g > 0.0)) {
            return 0.0;
        }
        const double rate =
            direction.dot(way.motion.find_rate(corner, turn)) - 2.0 * (1.0 + angle) * slack_m;
        const double along_b = direction.dot(corner.b);
        const double along_c = direction.dot(corner.c);
        const double q =
            angle * angle * (std::sqrt(along_b * along_b + along_c * along_c) + slack_m);
        free = std::min(free, find_root(g, rate, q));
    }
    return free;
}

TriangleSweep tell_contact(const NearFeatures& near, double t, SweepOutcome outcome) noexcept {
    TriangleSweep told{.outcome = outcome};
    told.contact.time = t;
    told.contact.features = near;
    if (outcome == SweepOutcome::touching && near.distance_m > 0.0) {
        told.contact.normal_A = (near.on_moving - near.on_fixed) / near.distance_m;
    }
    return told;
}

// Is the direction between the middles enough for the whole way?
bool is_far_apart(const Way& way, double t, double t_end, const SineCosine& turn,
                  const Triangle& place) noexcept {
    const Vector3 between =
        place[0] + place[1] + place[2] - way.fixed[0] - way.fixed[1] - way.fixed[2];
    const double length = between.norm();
    return length > 0.0 && t + find_free_time(way, between / length, t, turn) > t_end;
}

// What is known at t: decided, or how long nothing touches (0: nobody knows).
struct Look {
    bool is_decided = false;
    TriangleSweep told{};
    double free = 0.0;
};

Look look_at(const Way& way, double t, bool is_begin, double t_end) noexcept {
    const SineCosine turn = way.motion.turn_at(t);
    const Triangle place = way.moving.find_place(way.motion, t, turn);
    if (is_begin && is_far_apart(way, t, t_end, turn, place)) {
        return {.is_decided = true};
    }
    const NearFeatures near = find_nearest_features(way.fixed, place);
    const bool is_near = near.distance_m <= way.bounds.most_m();
    Look look;
    if (!is_near) {
        look.free =
            find_free_time(way, (near.on_moving - near.on_fixed) / near.distance_m, t, turn);
    }
    if (look.free > 0.0) {
        return look;
    }
    const bool is_crossing =
        is_begin && (near.distance_m <= way.bounds.slack_m || do_cross(way.fixed, place));
    look.is_decided = is_near || is_crossing;
    look.told =
        tell_contact(near, t, is_crossing ? SweepOutcome::overlapping : SweepOutcome::touching);
    return look;
}

}  // namespace

TriangleSweep sweep_triangles(const InBetweenMotion& motion, const Triangle& fixed,
                              const MovingTriangle& moving, const SweepSettings& settings,
                              double t_begin, double t_end, const Vector3& hint_A) noexcept {
    if (!motion.is_valid() || !is_valid(settings) || !is_finite(fixed) || !is_finite(moving) ||
        !(t_begin >= 0.0 && t_begin <= t_end && t_end <= 1.0)) {
        return {.outcome = SweepOutcome::invalid};
    }
    const Way way{motion, fixed, moving,
                  SweepBounds::of(motion, moving.reach_m, find_reach_m(fixed), settings)};
    double t = t_begin;
    std::int32_t looks = 0;
    if (t + find_free_time(way, hint_A, t, motion.turn_at(t)) > t_end) {
        return {};
    }
    while (looks < kMostSweepLooks) {
        Look look = look_at(way, t, looks == 0, t_end);
        ++looks;
        if (look.is_decided) {
            look.told.looks = looks;
            return look.told;
        }
        if (!(look.free > 0.0)) {
            break;
        }
        t += look.free;
        if (t > t_end) {
            return {.looks = looks};
        }
    }
    TriangleSweep told = sweep_triangles_by_intervals(motion, fixed, moving, settings, t, t_end);
    told.looks += looks;
    told.by_intervals = true;
    return told;
}

TriangleSweep sweep_triangles(const InBetweenMotion& motion, const Triangle& fixed,
                              const MovingTriangle& moving, const SweepSettings& settings,
                              double t_begin, double t_end) noexcept {
    return sweep_triangles(motion, fixed, moving, settings, t_begin, t_end, Vector3::Zero());
}

}  // namespace fulcrum
