#include "haptics/continuous/turn_function.h"

#include "tests/support/continuous_trial.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace fulcrum {
namespace {

struct Named {
    FeaturePair pair;
    std::uint8_t i;
    std::uint8_t j;
};

using LongVector = Matrix<long double, 3, 1>;
using LongTriangle = std::array<LongVector, 3>;

// Where the corners' paths are at t, in eleven binary digits more than the bounds have: a path's vectors are what they are.
LongTriangle find_long_place(const InBetweenMotion& motion, const MovingTriangle& moving,
                             double t) {
    const long double angle = static_cast<long double>(t) * motion.angle_rad();
    LongTriangle place;
    for (std::size_t i = 0; i < 3; ++i) {
        const PointPath& path = moving.corners[i];
        place[i] = path.a.cast<long double>() +
                   static_cast<long double>(t) * motion.travel_A().cast<long double>() +
                   std::cos(angle) * path.b.cast<long double>() +
                   std::sin(angle) * path.c.cast<long double>();
    }
    return place;
}

LongVector find_normal(const LongTriangle& t) {
    return (t[1] - t[0]).cross(t[2] - t[0]);
}

// Redon's equation as it stands, from corners at t.
long double find_height(const Named& named, const LongTriangle& fixed, const LongTriangle& moving) {
    const auto normal = find_normal;
    if (named.pair == FeaturePair::face_vertex) {
        return normal(fixed).dot(moving[named.j] - fixed[0]);
    }
    if (named.pair == FeaturePair::vertex_face) {
        return normal(moving).dot(fixed[named.i] - moving[0]);
    }
    const LongVector held = fixed[(named.i + 1U) % 3U] - fixed[named.i];
    const LongVector edge = moving[(named.j + 1U) % 3U] - moving[named.j];
    return held.cross(edge).dot(moving[named.j] - fixed[named.i]);
}

// What a metre makes of it at most: the length of the normal, of two edges that of both.
long double find_per_m(const Named& named, const LongTriangle& fixed, const LongTriangle& moving) {
    if (named.pair == FeaturePair::face_vertex) {
        return find_normal(fixed).norm();
    }
    if (named.pair == FeaturePair::vertex_face) {
        return find_normal(moving).norm();
    }
    return (fixed[(named.i + 1U) % 3U] - fixed[named.i]).norm() *
           (moving[(named.j + 1U) % 3U] - moving[named.j]).norm();
}

bool holds(const Interval& interval, long double exact) {
    return static_cast<long double>(interval.lower) <= exact &&
           exact <= static_cast<long double>(interval.upper);
}

TEST_CASE(
    "turn function: it holds the heights of all fifteen contacts and their rates, without a "
    "margin, "
    "and how far a metre goes") {
    Random random(1);
    for (int trial = 0; trial < 400; ++trial) {
        const TrianglePair pair =
            trial % 4 == 0 ? draw_hard_pair(random, trial / 4 % kHardPairs) : draw_pair(random);
        const InBetweenMotion motion = pair.motion();
        const MovingTriangle moving = MovingTriangle::of(motion, pair.moving_B);
        const SweepBounds bounds =
            SweepBounds::of(motion, moving.reach_m, find_reach_m(pair.fixed_A), {});
        const LongTriangle fixed{pair.fixed_A[0].cast<long double>(),
                                 pair.fixed_A[1].cast<long double>(),
                                 pair.fixed_A[2].cast<long double>()};
        for (std::uint8_t k = 0; k < 15; ++k) {
            const Named named =
                k < 3   ? Named{FeaturePair::face_vertex, 0, k}
                : k < 6 ? Named{FeaturePair::vertex_face, static_cast<std::uint8_t>(k - 3), 0}
                        : Named{FeaturePair::edge_edge, static_cast<std::uint8_t>((k - 6) / 3),
                                static_cast<std::uint8_t>((k - 6) % 3)};
            const TurnFunction f = make_turn_function(motion, pair.fixed_A, moving, named.pair,
                                                      named.i, named.j, bounds);
            const double t = 0.5 + 0.499 * random.uniform();
            const auto height = [&](double at) {
                return find_height(named, fixed, find_long_place(motion, moving, at));
            };
            const double size = bounds.length_m * bounds.length_m * bounds.length_m;
            const Interval times = Interval::between(t, std::min(1.0, t + 1.0e-3));
            const Interval here = f.find_value(Interval::at(t), motion.turn_over(Interval::at(t)));
            CAPTURE(trial, k, t);
            REQUIRE(holds(here, height(t)));
            REQUIRE(here.upper - here.lower <= 1.0e-11 * size);
            const Interval over = f.find_value(times, motion.turn_over(times));
            REQUIRE(holds(over, height(times.upper)));
            // The mean value theorem, with the rate over all of the time.
            const Interval rate = f.find_rate(times, motion.turn_over(times));
            const Interval passed = Interval::at(times.upper) - Interval::at(t);
            REQUIRE(holds(here + rate * passed, height(times.upper)));
            REQUIRE(rate.upper - rate.lower <= 0.1 * size);
            // A metre more of distance is at most so much, and no bound is far above it.
            const long double per_m =
                find_per_m(named, fixed, find_long_place(motion, moving, 0.0));
            REQUIRE(static_cast<long double>(f.per_m) >= per_m);
            REQUIRE(static_cast<long double>(f.per_m) <=
                    per_m + 1.0e-12L * bounds.length_m * bounds.length_m);
        }
    }
}

}  // namespace
}  // namespace fulcrum
