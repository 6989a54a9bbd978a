// What closed paths give a hand of effects that are no gradient, behind plan, passivity stage and gate as they ship. Without dampers, which
// would hide it.
#include "haptics/geometry/shape.h"
#include "haptics/math/rotation.h"
#include "haptics/surface/energy_loan.h"
#include "haptics/surface/materials.h"
#include "tests/support/sent_force.h"
#include "tests/support/touchable.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <numbers>

using namespace fulcrum;
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

// A closed path: where the hand is at a share of it.
using Path = std::function<Pose(double share)>;

struct Given {
    double first_J = 0.0;  // in the first rounds
    double last_J = 0.0;   // in as many later ones
    double took_s = 0.0;   // the later ones
    double way_m = 0.0;    // in them
};

// Round and round; the gate is open and the hand is on the path.
Given go_round(SentForce& loop, const Path& path, double round_s) {
    constexpr int kRounds = 20;
    Given given;
    Pose before_W = path(0.0);
    Wrench before = loop.step(before_W);
    const double step = 1.0 / (round_s * loop.plan().rate_hz);
    for (int round = 0; round < 2 * kRounds; ++round) {
        for (double share = step; share < 1.0; share += step) {
            const Pose hand_W = path(share);
            const Vector3 shift_W = hand_W.position - before_W.position;
            const Vector3 turn_W =
                compute_log(hand_W.orientation * before_W.orientation.conjugate());
            const double work_J = before.force.dot(shift_W) + before.torque.dot(turn_W);
            (round < kRounds ? given.first_J : given.last_J) += work_J;
            given.way_m += round < kRounds ? 0.0 : shift_W.norm() + kUnfeltAt_m * turn_W.norm();
            before = loop.step(hand_W);
            before_W = hand_W;
        }
    }
    given.took_s = kRounds * round_s;
    return given;
}

// From outside a ball about the origin to where the path begins.
void come_from_above(SentForce& loop, const Path& path) {
    Pose pose_W = path(0.0);
    const Vector3 begin_W = pose_W.position;
    loop.open_gate(1.2 * begin_W);
    for (double share = 1.2; share > 1.0; share -= 1.0e-4) {
        pose_W.position = share * begin_W;
        (void)loop.step(pose_W);
    }
}

// There and back along an arc of a ball, deeper on the way there.
Path make_arc(double radius_m, double from_rad, double span_rad, double deep_m, double shallow_m) {
    static const Vector3 kAlong = Vector3(0.8, 0.1, -0.59).normalized();
    static const Vector3 kAcross = kAlong.cross(Vector3(0.2, 1.0, 0.4)).normalized();
    return [=](double share) {
        const double turn = 2.0 * std::numbers::pi * share;
        const double angle = from_rad + 0.5 * span_rad * (1.0 - std::cos(turn));
        const double depth_m =
            0.5 * (deep_m + shallow_m) + 0.5 * (deep_m - shallow_m) * std::sin(turn);
        return Pose::at((radius_m - depth_m) *
                        (std::cos(angle) * kAlong + std::sin(angle) * kAcross));
    };
}

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
        for (int i = 0; i < 8; ++i) {
            const bool is_turned = i % 2 == 1;
            const Path arc = make_arc(kRadius_m + kBall_m, 0.27 * i, 0.1, is_turned ? 0.008 : 0.022,
                                      is_turned ? 0.022 : 0.008);
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
