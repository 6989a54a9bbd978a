// What closed paths give a hand of effects that are no gradient, behind plan, passivity stage and gate as they ship. Without dampers, which
// would hide it.
#include "haptics/geometry/shape.h"
#include "haptics/math/rotation.h"
#include "haptics/surface/energy_loan.h"
#include "haptics/surface/materials.h"
#include "tests/support/closed_path.h"
#include "tests/support/sent_force.h"
#include "tests/support/touchable.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <numbers>

using namespace fulcrum;
using test::come_from_above;
using test::Given;
using test::go_round;
using test::make_arc;
using test::Path;
using test::SentForce;

namespace {

Material make_undamped() {
    Material material = *find_material("metal");
    material.friction = {};
    material.texture = {};
    material.transient = {};
    material.coupling = {.stiffness_N_per_m = 200.0, .damping_Ns_per_m = 0.0};
    return material;
}

// What the passivity stage forgets: its headroom in each of its memories; its brake takes up to as much again to come.
// 4.4 N times what the lean of a facet of a ball of 80 facets can do, 6.6 mm; and what of that fades.
constexpr double kLent_J = 0.03;
constexpr double kFade_W = kLent_J / kDebtMemory_s;
constexpr double kLeak_W = 2.0 * PassivitySettings{}.headroom_J / PassivitySettings{}.memory_s;

}  // namespace

TEST_CASE("sent energy: who goes round on a shaded facet for ever is given what is lent, once") {
    constexpr double kRadius_m = 0.1;
    const auto coarse = touchable(make_sphere(kRadius_m, 2));
    for (const double span_rad : {0.1, 0.3}) {
        for (int i = 0; i < 24; ++i) {
            const bool is_turned = i % 2 == 1;
            SentForce loop(test::make_touch_lesson(make_undamped(), true), coarse);
            const Path path = make_arc(kRadius_m, 0.27 * i, span_rad, is_turned ? 0.008 : 0.022,
                                       is_turned ? 0.022 : 0.008);
            come_from_above(loop, path);
            const Given given = go_round(loop, path, 0.25);
            INFO(span_rad << " rad from " << 0.27 * i << ": " << given.first_J << " J, then "
                          << given.last_J);
            const double forgiven_J = (kLeak_W + kFade_W) * given.took_s + kUnfelt_N * given.way_m;
            CHECK(given.first_J < kLent_J + forgiven_J);
            CHECK(given.last_J < forgiven_J);
        }
    }
}

// Turning moves its proxy by what is no work of the hand's spring; what falls off as it turns back pays for nothing.
TEST_CASE(
    "sent energy: a shaped cursor that turns to and fro on a shaded facet earns nothing by it") {
    constexpr double kRadius_m = 0.1;
    constexpr double kCursor_m = 0.005;
    const auto coarse = touchable(make_sphere(kRadius_m, 2));
    runtime::LessonDescription lesson = test::make_touch_lesson(make_undamped(), true);
    lesson.hand.proxy = ProxyKind::friction_cone;
    lesson.hand.cursor = CapsuleShape{kCursor_m, 0.03};
    const Vector3 axis = Vector3(0.3, 0.1, 1.0).normalized();
    for (const double phase_rad : {0.0, 1.5 * std::numbers::pi}) {
        const Path arc = make_arc(kRadius_m + kCursor_m, 0.27 * 4, 0.3, 0.022, 0.008);
        const Path path = [&](double share) {
            Pose pose_W = arc(share);
            pose_W.orientation =
                compute_exp(axis * (0.2 * std::sin(2.0 * std::numbers::pi * share + phase_rad)));
            return pose_W;
        };
        SentForce loop(lesson, coarse);
        come_from_above(loop, path);
        const Given given = go_round(loop, path, 0.25, 40);
        INFO(phase_rad << ": " << given.first_J << " J, then " << given.last_J);
        const double forgiven_J = (kLeak_W + kFade_W) * given.took_s + kUnfelt_N * given.way_m;
        CHECK(given.last_J < forgiven_J);
    }
}

TEST_CASE("sent energy: a tool that goes round on a shaded facet is given what is lent, once") {
    constexpr double kRadius_m = 0.1;
    constexpr double kBall_m = 0.01;
    const auto coarse = touchable(make_sphere(kRadius_m, 2));
    runtime::LessonDescription lesson = test::make_touch_lesson(make_undamped(), true);
    lesson.hand.tool.emplace();
    lesson.hand.tool->shape = SphereShape{kBall_m};
    lesson.hand.tool->method = ToolMethod::god_object;
    lesson.hand.tool->stiffness_N_per_m = 200.0;
    // The ball alone, and held by a handle that swings about it.
    for (const double swing_rad : {0.0, 0.5}) {
        for (const int i : {0, 6}) {
            const Path arc = make_arc(kRadius_m + kBall_m, 0.27 * i, 0.1, 0.022, 0.008);
            const Path path = [&](double share) {
                Pose pose_W = arc(share);
                pose_W.orientation =
                    compute_exp({0.0, 0.0, swing_rad * std::sin(2.0 * std::numbers::pi * share)});
                return pose_W;
            };
            SentForce loop(lesson, coarse);
            come_from_above(loop, path);
            const Given given = go_round(loop, path, 0.25);
            INFO(swing_rad << " rad, from " << 0.27 * i << ": " << given.first_J << " J, then "
                           << given.last_J);
            const double forgiven_J = (kLeak_W + kFade_W) * given.took_s + kUnfelt_N * given.way_m;
            CHECK(given.first_J < kLent_J + forgiven_J);
            CHECK(given.last_J < forgiven_J);
        }
    }
}

TEST_CASE(
    "sent energy: a tool between two shaded balls is given what is lent, whichever presses more") {
    constexpr double kRadius_m = 0.1;
    constexpr double kBall_m = 0.01;
    constexpr double kBeside_m = 0.06;
    constexpr double kShakes_m = 1.0e-5;  // so that another presses most in each round
    const double ring_m =
        std::sqrt((kRadius_m + kBall_m) * (kRadius_m + kBall_m) - kBeside_m * kBeside_m);
    const auto coarse = touchable(make_sphere(kRadius_m, 2));
    runtime::LessonDescription lesson = test::make_touch_lesson(make_undamped(), true);
    lesson.bodies[0].position_W = Vector3(kBeside_m, 0.0, 0.0);
    lesson.bodies.push_back(lesson.bodies[0]);
    lesson.bodies[1].name = lesson.bodies[1].noun = "other";
    lesson.bodies[1].position_W = Vector3(-kBeside_m, 0.0, 0.0);
    lesson.hand.tool.emplace();
    lesson.hand.tool->shape = SphereShape{kBall_m};
    lesson.hand.tool->method = ToolMethod::god_object;
    lesson.hand.tool->stiffness_N_per_m = 200.0;
    const auto give = [&](double from_rad, double swing_m, double lent_share) {
        long n = 0;
        const Path path = [&, from_rad, swing_m](double share) {
            const double turn = 2.0 * std::numbers::pi * share;
            const double angle = from_rad + 0.15 * (1.0 - std::cos(turn));
            const double out_m = ring_m - 0.015 - swing_m * std::sin(turn);
            return Pose::at({++n % 2 == 0 ? -kShakes_m : kShakes_m, out_m * std::cos(angle),
                             out_m * std::sin(angle)});
        };
        SentForce loop(lesson, coarse,
                       [&](HapticPlan& plan) { plan.shading_loan.share = lent_share; });
        come_from_above(loop, path);
        return go_round(loop, path, 0.25);
    };
    for (const auto& [from_rad, swing_m] : {std::pair(0.0, -0.007), std::pair(0.81, 0.007)}) {
        const Given given = give(from_rad, swing_m, 1.0);
        // Of two balls what is lent is about twice that of one.
        const double forgiven_J =
            (kLeak_W + 2.0 * kFade_W) * given.took_s + kUnfelt_N * given.way_m;
        INFO("from " << from_rad << ": " << given.first_J << " J, then " << given.last_J);
        CHECK(given.last_J < forgiven_J);
        // Were all of it the scene's own it would be given for ever.
        CHECK(give(from_rad, swing_m, 100.0).last_J > 1.5 * forgiven_J);
    }
}

TEST_CASE(
    "sent energy: who lifts off at a facet's corner and presses its middle again is given no "
    "more") {
    constexpr double kRadius_m = 0.1;
    const auto coarse = touchable(make_sphere(kRadius_m, 2));
    const auto corners = coarse->places_B(0);
    const Vector3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
    const Vector3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
    SentForce loop(test::make_touch_lesson(make_undamped(), true), coarse);
    constexpr double kDepth_m = 0.015;
    constexpr double kAbove_m = 0.001;
    const auto ease = [](double x) { return 0.5 - 0.5 * std::cos(std::numbers::pi * x); };
    const Path path = [&](double share) {
        double out = 0.0;
        double height_m = kAbove_m;
        if (share < 0.2) {
            height_m -= (kAbove_m + kDepth_m) * ease(share / 0.2);
        } else if (share < 0.5) {
            out = ease((share - 0.2) / 0.3);
            height_m = -kDepth_m;
        } else if (share < 0.7) {
            out = 1.0;
            height_m -= (kAbove_m + kDepth_m) * (1.0 - ease((share - 0.5) / 0.2));
        } else {
            out = 1.0 - ease((share - 0.7) / 0.3);
        }
        return Pose::at(middle + 0.85 * out * (corners[0] - middle) + height_m * normal);
    };
    loop.open_gate(path(0.0).position + 0.02 * normal);
    const Given given = go_round(loop, path, 0.5);
    INFO(given.first_J << " J, then " << given.last_J);
    CHECK(given.last_J < (kLeak_W + kFade_W) * given.took_s + kUnfelt_N * given.way_m);
}

TEST_CASE("sent energy: who presses a relief downhill for ever is given what it lends, once") {
    constexpr double kWave_m = 0.002;
    constexpr double kHalf_m = 5.25 * kWave_m;  // to where down turns to up
    constexpr double kPlate_m = 0.2;
    const auto plate = touchable(make_box(Vector3::Constant(kPlate_m)));
    for (const TextureLaw law :
         {TextureLaw::perturbed_normal, TextureLaw::lateral, TextureLaw::height_offset}) {
        Material material = make_undamped();
        material.coupling.stiffness_N_per_m = 500.0;
        material.texture = {.source = SineTexture{kWave_m, 0.0}, .law = law, .height_m = 2.0e-4};
        SentForce loop(test::make_touch_lesson(material, false), plate);
        constexpr double kDepth_m = 0.004;
        const Path path = [&](double share) {
            const double x_m = -kHalf_m * std::cos(2.0 * std::numbers::pi * share);
            const double uphill =
                (share < 0.5 ? 1.0 : -1.0) * std::cos(2.0 * std::numbers::pi * x_m / kWave_m);
            return Pose::at({x_m, 0.5 * kPlate_m - kDepth_m * (1.0 - 0.3 * uphill), 0.0});
        };
        loop.open_gate(path(0.0).position + 0.01 * Vector3::UnitY());
        for (double above_m = 0.01; above_m > 0.0; above_m -= 1.0e-5) {
            (void)loop.step(path(0.0).position + above_m * Vector3::UnitY());
        }
        const Given given = go_round(loop, path, 0.5);
        INFO("law " << static_cast<int>(law) << ": " << given.first_J << " J, then "
                    << given.last_J);
        CHECK(given.last_J < kLeak_W * given.took_s);
    }
}

TEST_CASE(
    "sent energy: a tap that rings gives back no more than its share of what the handle brought") {
    constexpr double kBlock_m = 0.2;
    constexpr double kSwing_m = 0.008;
    constexpr double kRound_s = 0.25;
    const auto block = touchable(make_box(Vector3::Constant(kBlock_m)));
    const double speed_m_per_s = kSwing_m * 2.0 * std::numbers::pi / kRound_s;
    for (const char* name : {"metal", "glass", "wood", "rock", "rubber"}) {
        Material material = make_undamped();
        material.coupling.stiffness_N_per_m = 500.0;
        const Path path = [&](double share) {
            return Pose::at(
                {0.0, 0.5 * kBlock_m + kSwing_m * std::cos(2.0 * std::numbers::pi * share), 0.0});
        };
        const auto tap = [&] {
            SentForce loop(test::make_touch_lesson(material, false), block);
            loop.open_gate(path(0.0).position);
            return go_round(loop, path, kRound_s);
        };
        const Given silent = tap();
        material.transient = find_material(name)->transient;
        const Given ringing = tap();
        const double brought_J = 0.5 * kHandleMass_kg * speed_m_per_s * speed_m_per_s;
        const double taps = ringing.took_s / kRound_s;
        INFO(name << ": " << silent.last_J << " J without, " << ringing.last_J << " with");
        CHECK(ringing.last_J - silent.last_J <
              material.transient.energy_share * brought_J * taps + kLeak_W * ringing.took_s);
    }
}
