#include "haptics/continuous/interval_sweep.h"

#include "haptics/continuous/triangle_sweep.h"
#include "tests/support/way_judge.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

namespace fulcrum {
namespace {

constexpr double kRounding_m =
    1.0e-11;  // of places a thousand metres away; those near by are a thousandth of it

TEST_CASE("interval sweep: the judge finds nothing missed, and nothing farther apart than told") {
    Random random(1);
    for (int i = 0; i < 600; ++i) {
        const SweepSettings settings{.touch_m = i % 4 < 2 ? 0.0 : 1.0e-4, .tolerance_m = 1.0e-6};
        const TrianglePair pair =
            i % 2 == 0 ? draw_pair(random) : draw_hard_pair(random, i / 2 % kHardPairs);
        const InBetweenMotion motion = pair.motion();
        const TriangleSweep told = sweep_triangles_by_intervals(
            motion, pair.fixed_A, MovingTriangle::of(motion, pair.moving_B), settings);
        const Verdict verdict = judge(pair, told, settings, kRounding_m);
        CAPTURE(i, static_cast<int>(told.outcome), told.contact.time);
        REQUIRE_FALSE(verdict.is_missed);
        REQUIRE_FALSE(verdict.is_early);
    }
}

TEST_CASE("interval sweep: the faster finder agrees with it") {
    Random random(2);
    const SweepSettings settings;
    int n_touching = 0;
    for (int i = 0; i < 6000; ++i) {
        const TrianglePair pair =
            i % 3 != 0 ? draw_pair(random) : draw_hard_pair(random, i / 3 % kHardPairs);
        const InBetweenMotion motion = pair.motion();
        const MovingTriangle moving = MovingTriangle::of(motion, pair.moving_B);
        const TriangleSweep slow =
            sweep_triangles_by_intervals(motion, pair.fixed_A, moving, settings);
        const TriangleSweep fast = sweep_triangles(motion, pair.fixed_A, moving, settings);
        CAPTURE(i, slow.contact.time, fast.contact.time);
        const bool both_overlap =
            slow.outcome == SweepOutcome::overlapping && fast.outcome == SweepOutcome::overlapping;
        if (both_overlap ||
            (slow.outcome == SweepOutcome::free && fast.outcome == SweepOutcome::free)) {
            continue;
        }
        ++n_touching;
        // Where one is free, the other may only have come within the tolerance.
        for (const TriangleSweep* told : {&slow, &fast}) {
            if (told->outcome == SweepOutcome::touching) {
                REQUIRE(told->contact.features.distance_m <=
                        settings.tolerance_m * (1.0 + 1.0e-6) + kRounding_m);
            }
        }
        // Neither is after what the other has found to be as near as rounding can tell.
        if (slow.outcome == SweepOutcome::free || fast.outcome == SweepOutcome::free) {
            const TriangleSweep& told = slow.outcome == SweepOutcome::free ? fast : slow;
            REQUIRE(told.outcome == SweepOutcome::touching);
            continue;
        }
        const double earlier = std::min(slow.contact.time, fast.contact.time);
        const double later = std::max(slow.contact.time, fast.contact.time);
        for (int k = 0; k < 8; ++k) {
            const double t = earlier + (later - earlier) * k / 8.0;
            REQUIRE((t == later ||
                     !do_cross(pair.fixed_A, moving.find_place(motion, t, motion.turn_at(t)))));
        }
    }
    CHECK(n_touching > 800);
}

TEST_CASE("interval sweep: a long graze takes few pieces; what is none is refused") {
    Random random(3);
    const TrianglePair pair = draw_pair(random);
    const InBetweenMotion motion = pair.motion();
    const MovingTriangle moving = MovingTriangle::of(motion, pair.moving_B);
    const double none = std::numeric_limits<double>::quiet_NaN();
    Triangle bad = pair.fixed_A;
    bad[1].y() = none;
    CHECK(sweep_triangles_by_intervals(motion, bad, moving, {}).outcome == SweepOutcome::invalid);
    CHECK(sweep_triangles_by_intervals(motion, pair.fixed_A, moving, {0.0, 0.0}).outcome ==
          SweepOutcome::invalid);
    CHECK(sweep_triangles_by_intervals(motion, pair.fixed_A, moving, {}, 0.7, 0.3).outcome ==
          SweepOutcome::invalid);
    // A corner that goes round over a face, ten tolerances above it: the heights tell at once.
    const Triangle face{Vector3(-2.0, 0.0, -2.0), Vector3(2.0, 0.0, -2.0), Vector3(0.0, 0.0, 3.0)};
    const Triangle corner{Vector3(1.0, 0.0, 0.0), Vector3(1.2, 1.0, 0.0), Vector3(1.2, 1.0, 0.2)};
    const InBetweenMotion turn(
        Pose::at({0.0, 1.0e-9, 0.0}),
        {Vector3(0.0, 1.0e-9, 0.0), Quaternion(AngleAxis(3.0, Vector3::UnitY()))});
    const TriangleSweep told =
        sweep_triangles_by_intervals(turn, face, MovingTriangle::of(turn, corner), {0.0, 1.0e-10});
    CHECK(told.outcome == SweepOutcome::free);
    CHECK(told.looks < 100);
}

}  // namespace
}  // namespace fulcrum
