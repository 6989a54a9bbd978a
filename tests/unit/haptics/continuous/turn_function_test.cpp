#include "haptics/continuous/turn_function.h"

#include "tests/support/continuous_trial.h"

#include <catch2/catch.hpp>

namespace fulcrum {
namespace {

struct Named {
    FeaturePair pair;
    std::uint8_t i;
    std::uint8_t j;
};

// Redon's equation as it stands, from corners at t.
double find_height(const Named& named, const Triangle& fixed, const Triangle& moving) {
    const auto normal = [](const Triangle& t) { return Vector3((t[1] - t[0]).cross(t[2] - t[0])); };
    if (named.pair == FeaturePair::face_vertex) {
        return normal(fixed).dot(moving[named.j] - fixed[0]);
    }
    if (named.pair == FeaturePair::vertex_face) {
        return normal(moving).dot(fixed[named.i] - moving[0]);
    }
    const Vector3 held = fixed[(named.i + 1U) % 3U] - fixed[named.i];
    const Vector3 edge = moving[(named.j + 1U) % 3U] - moving[named.j];
    return held.cross(edge).dot(moving[named.j] - fixed[named.i]);
}

TEST_CASE("turn function: it holds the heights of all fifteen contacts and their rates") {
    Random random(1);
    for (int trial = 0; trial < 400; ++trial) {
        const TrianglePair pair =
            trial % 4 == 0 ? draw_hard_pair(random, trial / 4 % kHardPairs) : draw_pair(random);
        const InBetweenMotion motion = pair.motion();
        const MovingTriangle moving = MovingTriangle::of(motion, pair.moving_B);
        const SweepBounds bounds =
            SweepBounds::of(motion, moving.reach_m, find_reach_m(pair.fixed_A), {});
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
                return find_height(named, pair.fixed_A,
                                   moving.find_place(motion, at, motion.turn_at(at)));
            };
            const double size = bounds.length_m * bounds.length_m * bounds.length_m;
            const Interval times = Interval::between(t, std::min(1.0, t + 1.0e-3));
            const Interval here = f.find_value(Interval::at(t), motion.turn_over(Interval::at(t)));
            CAPTURE(trial, k, t);
            REQUIRE(here.lower <= height(t) + 1.0e-13 * size);
            REQUIRE(here.upper >= height(t) - 1.0e-13 * size);
            REQUIRE(here.upper - here.lower <= 1.0e-11 * size);
            const Interval over = f.find_value(times, motion.turn_over(times));
            REQUIRE(over.lower <= height(times.upper) + 1.0e-13 * size);
            REQUIRE(over.upper >= height(times.upper) - 1.0e-13 * size);
            // The mean value theorem, with the rate over all of the time.
            const Interval rate = f.find_rate(times, motion.turn_over(times));
            const Interval risen = here + rate * Interval::at(times.upper - t);
            REQUIRE(risen.lower <= height(times.upper) + 1.0e-13 * size);
            REQUIRE(risen.upper >= height(times.upper) - 1.0e-13 * size);
            REQUIRE(rate.upper - rate.lower <= 0.1 * size);
            // A metre more of distance is at most so much.
            REQUIRE(std::abs(height(t)) <=
                    f.per_m * (bounds.length_m + pair.fixed_A[0].norm()) * 2.0 + 1.0e-12 * size);
        }
    }
}

}  // namespace
}  // namespace fulcrum
