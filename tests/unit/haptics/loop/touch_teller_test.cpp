#include "haptics/loop/touch_teller.h"

#include <catch2/catch.hpp>

#include <memory>

using namespace fulcrum;

namespace {

HapticPlan make_plan() {
    HapticPlan plan;
    plan.solids.resize(3);
    plan.solids[0].surface.audible = true;
    plan.solids[2].surface.audible = true;
    return plan;
}

}  // namespace

TEST_CASE("touch teller: the audible solid that is pressed most, once a round, and its end once") {
    const HapticPlan plan = make_plan();
    CHECK(TouchTeller::is_needed(plan));
    CHECK_FALSE(TouchTeller::is_needed(HapticPlan{}));
    const auto ring = std::make_unique<TouchRing>();
    TouchTeller teller(plan, *ring);
    TouchMotion motion(plan);
    const std::array<Pose, 3> poses{};
    TouchSample sample;
    const auto round = [&](std::span<const TouchForce> touches, double x) {
        motion.step(touches, poses, {Vector3(x, 0.0, 0.02), Vector3(0.1, -0.3, 0.0), 0.001});
        teller.step(touches, motion, nullptr, 1.5 + x);
    };
    round({}, 0.0);
    CHECK_FALSE(ring->pop(sample));
    const std::array<TouchForce, 3> touches{TouchForce{0, Vector3::UnitY(), 0.001, 500.0},
                                            TouchForce{1, Vector3::UnitY(), 0.009, 500.0},
                                            TouchForce{2, Vector3::UnitY(), 0.002, 400.0}};
    round(touches, 0.25);
    REQUIRE(ring->pop(sample));
    CHECK(sample.solid == 2);
    CHECK(sample.time_s == 1.75);
    CHECK(sample.u_m == 0.25F);
    CHECK(sample.v_m == 0.02F);
    CHECK(sample.normal_force_N == Approx(0.8F));
    CHECK(sample.slip_speed_m_per_s == Approx(0.1F));
    CHECK(sample.texture_height_m == 0.0F);
    // Both begin in this round, equally fast: the first is told of.
    CHECK(sample.impact_speed_m_per_s == 0.0F);
    round({touches.data(), 1}, 0.25);
    REQUIRE(ring->pop(sample));
    CHECK(sample.solid == 0);
    // Touched by what is not heard: the end is told once.
    round({touches.data() + 1, 1}, 0.25);
    REQUIRE(ring->pop(sample));
    CHECK(sample.solid == kNoBody);
    round({}, 0.25);
    CHECK_FALSE(ring->pop(sample));
    round({touches.data(), 1}, 0.25);
    REQUIRE(ring->pop(sample));
    CHECK(sample.impact_speed_m_per_s == Approx(0.3F));
}
