#include "haptics/loop/touch_motion.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace fulcrum;

namespace {

constexpr double kDt_s = 0.001;

HapticPlan make_plan(std::size_t n = 1) {
    HapticPlan plan;
    plan.solids.resize(n);
    plan.solids[0].surface.audible = true;
    return plan;
}

// A floor of solid 0 that is touched, or not.
struct Floor {
    explicit Floor(const HapticPlan& plan) : motion(plan), poses(plan.solids.size()) {}

    void step(const Vector3& proxy_W, const Vector3& velocity_W, bool touched) {
        const TouchForce touch{.solid = 0, .normal_W = normal_W, .depth_m = 0.001};
        motion.step(std::span(&touch, touched ? 1U : 0U), poses, {proxy_W, velocity_W, kDt_s});
    }

    TouchMotion motion;
    std::vector<Pose> poses;
    Vector3 normal_W = Vector3::UnitY();
};

}  // namespace

TEST_CASE("touch motion: it is there where a solid has a texture or a transient or is heard") {
    HapticPlan plan;
    plan.solids.resize(2);
    CHECK_FALSE(TouchMotion::is_needed(plan));
    plan.solids[1].surface.audible = true;
    CHECK(TouchMotion::is_needed(plan));
    plan.solids[1].surface = {};
    plan.solids[1].surface.texture.source = SineTexture{};
    CHECK(TouchMotion::is_needed(plan));
    plan.solids[1].surface = {};
    plan.solids[1].surface.transient.kind = TransientKind::fixed_pulse;
    CHECK(TouchMotion::is_needed(plan));
    plan.solids[1].surface = {};
    plan.solids[1].surface.shading.on = true;
    CHECK_FALSE(TouchMotion::is_needed(plan));
}

TEST_CASE("touch motion: a tap is told once, with the speed along the normal") {
    Floor floor(make_plan());
    const Vector3 velocity(0.3, -0.2, 0.0);
    for (int k = 0; k < 10; ++k) {
        floor.step(Vector3(0, 0.01, 0), velocity, false);
        CHECK(floor.motion.tap().solid == kNoBody);
    }
    floor.step(Vector3::Zero(), velocity, true);
    CHECK(floor.motion.tap().solid == 0);
    CHECK(floor.motion.tap().speed_m_per_s == Approx(0.2));
    floor.step(Vector3::Zero(), velocity, true);
    CHECK(floor.motion.tap().solid == kNoBody);
    // Another plane of the same solid is no tap.
    floor.normal_W = -Vector3::UnitX();
    floor.step(Vector3::Zero(), velocity, true);
    CHECK(floor.motion.tap().solid == kNoBody);
}

TEST_CASE("touch motion: a hand laid on, or leaving, does not tap; nor a plate that goes with it") {
    Floor floor(make_plan());
    floor.step(Vector3::Zero(), Vector3(0.5, -0.9 * kSlowestTap_m_per_s, 0.0), true);
    CHECK(floor.motion.tap().solid == kNoBody);
    floor.step(Vector3::Zero(), Vector3(0, -1, 0), false);
    floor.step(Vector3::Zero(), Vector3(0, 1, 0), true);
    CHECK(floor.motion.tap().solid == kNoBody);
    // The plate comes up at 0.3 m/s to a hand that rests, and to one that goes up as fast.
    for (const auto& [hand_m_per_s, speed] : {std::pair{0.0, 0.3}, {0.3, 0.0}}) {
        Floor plate(make_plan());
        for (int k = 0; k < 20; ++k) {
            plate.poses[0].position.y() = 0.3 * kDt_s * k;
            plate.step(Vector3(0, 0.1, 0), Vector3(0, hand_m_per_s, 0), k == 19);
        }
        CHECK(plate.motion.tap().speed_m_per_s == Approx(speed).margin(1.0e-9));
    }
}

TEST_CASE("touch motion: the stroke is the way of the contact on the body, wherever that goes") {
    Floor floor(make_plan());
    // The body moves and turns; the contact goes 0.2 mm a round along its own x.
    for (int k = 0; k < 60; ++k) {
        floor.poses[0] = {Vector3(0.01 * k, 0.0, 0.0),
                          Quaternion(AngleAxis(0.02 * k, Vector3::UnitY()))};
        floor.step(floor.poses[0] * Vector3(2.0e-4 * k, 0.0, 0.003), Vector3::Zero(), true);
    }
    const TouchedPlace& place = floor.motion.place(0);
    CHECK((place.place_B - Vector3(2.0e-4 * 59, 0.0, 0.003)).norm() < 1.0e-12);
    CHECK((place.stroke_B - Vector3(2.0e-4, 0.0, 0.0)).norm() < 1.0e-7);
    CHECK(place.slip_m_per_s == Approx(0.2).epsilon(1.0e-3));
    CHECK(place.view == 1);
    floor.step(Vector3::Zero(), Vector3::Zero(), false);
    CHECK_FALSE(floor.motion.place(0).touched);
}

TEST_CASE("touch motion: a touch begins with the hand's velocity along the surface") {
    Floor floor(make_plan());
    floor.step(Vector3::Zero(), Vector3(0.4, -0.1, 0.2), true);
    CHECK((floor.motion.place(0).stroke_B - Vector3(4.0e-4, 0.0, 2.0e-4)).norm() < 1.0e-15);
    // Steps of an encoder are evened out over four rounds.
    floor.step(Vector3(0.004, 0, 0), Vector3::Zero(), true);
    CHECK(floor.motion.place(0).stroke_B.x() == Approx(4.0e-4 + (0.004 - 4.0e-4) / 4.0));
}

TEST_CASE("touch motion: a round cursor touches at its skin") {
    HapticPlan plan = make_plan();
    plan.proxy.cursor = SphereShape{0.02};
    Floor floor(plan);
    floor.step(Vector3(0.0, 0.02, 0.0), Vector3::Zero(), true);
    CHECK(floor.motion.place(0).place_B.norm() < 1.0e-15);
}

TEST_CASE("touch motion: the hand has jumped, and nothing was touched before") {
    Floor floor(make_plan());
    floor.step(Vector3::Zero(), Vector3(0, -0.1, 0), true);
    floor.motion.forget();
    CHECK_FALSE(floor.motion.place(0).touched);
    floor.step(Vector3::Zero(), Vector3(0, -0.1, 0), true);
    CHECK(floor.motion.tap().solid == 0);
    CHECK(floor.motion.memory_bytes() > sizeof(TouchMotion));
}
