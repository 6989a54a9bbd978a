#include "haptics/dynamics/world.h"

#include "haptics/math/rotation.h"
#include "tests/support/bad_numbers.h"
#include "tests/unit/haptics/dynamics/world_fixture.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace fulcrum;

namespace {

using Kind = WorldCommand::Kind;

}  // namespace

TEST_CASE("world: a body dropped beside the bucket lands as fast as it fell, bounces and rests") {
    ToldWorld world;
    world.drop(1, {0.5, 1.04, 0.0});
    CHECK(world.body().where == BodyWhere::falling);
    const WorldEvent event = world.run_to_event(tool_at({0.0, 0.3, 0.0}));
    CHECK(event.kind == WorldEvent::Kind::landed);
    CHECK(event.body == 1);
    // One metre of free fall; a step more or less.
    CHECK(event.speed_m_per_s == Approx(std::sqrt(2.0 * 9.81)).margin(9.81 * kDt_s));
    CHECK(event.time_s == Approx(std::sqrt(2.0 / 9.81)).margin(2.0 * kDt_s));
    for (int k = 0; k < 2000; ++k) {
        world.run(tool_at({0.0, 0.3, 0.0}));
        REQUIRE(world.events().empty());
        REQUIRE(world.at_W().y() >= 0.04);
        REQUIRE(world.at_W().y() < 0.15);
    }
    CHECK(world.is_at_rest());
    CHECK(world.body().where == BodyWhere::landed);
    CHECK(world.at_W().y() == 0.04);
    CHECK(world.body().velocity_W.norm() == 0.0);
}

TEST_CASE("world: a body over the bucket is caught, its felt weight carried, and it glides in") {
    ToldWorld world;
    const HapticState tool = tool_at({0.0, 0.3, 0.0});
    world.drop(1, {0.02, 0.8, 0.0});
    CHECK(world.snapshot().carried_force_W.norm() == 0.0);
    const WorldEvent event = world.run_to_event(tool);
    CHECK(event.kind == WorldEvent::Kind::caught);
    CHECK(event.speed_m_per_s == Approx(std::sqrt(2.0 * 9.81 * 0.5)).margin(9.81 * kDt_s));
    CHECK(world.body().where == BodyWhere::held);
    CHECK((world.snapshot().carried_force_W - Vector3(0.0, -0.6 * 9.81, 0.0)).norm() < 1e-12);
    Vector3 before = world.at_W();
    for (int k = 0; k < 1000; ++k) {
        world.run(tool);
        // A glide, no jump: never faster than the way over the glide's time.
        REQUIRE((world.at_W() - before).norm() < 0.15 * kDt_s / 0.08);
        before = world.at_W();
    }
    CHECK(world.is_at_rest());
    CHECK(before.y() == Approx(0.3 - 0.12 + 0.04));
    CHECK(std::hypot(before.x(), before.z()) <= 0.1 - 0.04);
}

TEST_CASE("world: neither a very fast body nor a very fast bucket is missed, and the way decides") {
    for (const double speed_m_per_s : {1.0, 30.0, 300.0}) {
        // The body falls 0.6 m a step at 300 m/s and would be far below the bucket after it.
        ToldWorld world;
        const HapticState still = tool_at({0.0, 5.0, 0.0});
        world.run(still);
        world.drop(1, {0.0, 5.31, 0.0}, {0.0, -speed_m_per_s, 0.0});
        CHECK(world.run_to_event(still, 400).kind == WorldEvent::Kind::caught);
        // The bucket is thrown up at the same speed past a body that hangs in the air; the catch is as fast.
        ToldWorld other;
        other.run(tool_at({0.0, 4.7, 0.0}));
        other.drop(1, {0.0, 5.0, 0.0});
        WorldEvent event;
        for (int k = 1; k < 1000 && event.body == kNoBody; ++k) {
            other.run(tool_at({0.0, 4.7 + k * kDt_s * speed_m_per_s, 0.0}));
            event = other.events().empty() ? WorldEvent{} : other.events().front();
        }
        CHECK(event.kind == WorldEvent::Kind::caught);
        CHECK(event.speed_m_per_s == Approx(speed_m_per_s).margin(3.0));
    }
    // A bucket that sweeps sideways: where it is when the body passes its rim counts, not where the step ends. At half the
    // step the opening stands 0.5 m off.
    ToldWorld world;
    world.run(tool_at({-1.0, 0.5, 0.0}));
    world.drop(1, {-0.5, 0.505, 0.0}, {0.0, -5.0, 0.0});
    world.run(tool_at({0.0, 0.5, 0.0}));
    CHECK(world.body().where == BodyWhere::held);
}

TEST_CASE("world: a tilted, turned bucket catches along its own axis and carries the body round") {
    ToldWorld world(make_weightless_plan());
    HapticState tool = tool_at({0.0, 1.0, 0.0});
    tool.tool_pose_W.orientation =
        compute_exp(Vector3(0.0, 0.0, -1.5707963267948966));  // opening towards +x
    world.run(tool);
    world.drop(1, {0.2, 1.0, 0.0}, {-2.0, 0.0, 0.0});
    CHECK(world.run_to_event(tool).kind == WorldEvent::Kind::caught);
    world.run(tool, 1000);
    const Pose& before = world.body().pose_W;
    CHECK(before.position.x() == Approx(-0.08));
    const Vector3 offset_T = tool.tool_pose_W.inverse() * before.position;
    tool.tool_pose_W = {Vector3(0.3, 1.2, 0.1), compute_exp(Vector3(0.4, 0.0, 0.1))};
    tool.proxy_position_W = tool.tool_pose_W.position;
    world.run(tool);
    CHECK((world.at_W() - tool.tool_pose_W * offset_T).norm() < 1e-12);
}

TEST_CASE("world: several held bodies lie beside or upon each other, never within") {
    WorldPlan plan = make_world_plan();
    plan.bodies.assign(6, {0.2, 0.5, 0.04, 0.0});
    ToldWorld world(plan);
    for (std::int32_t i = 0; i < 6; ++i) {
        world.hold(i);
    }
    world.run(tool_at({0.0, 1.0, 0.0}));
    CHECK(world.n_held() == 6);
    CHECK(world.snapshot().carried_force_W.y() == Approx(-6 * 0.5 * 9.81));
    for (std::size_t i = 0; i < 6; ++i) {
        const Vector3& a = world.at_W(i);
        CHECK(a.y() >= 1.0 - 0.12 + 0.04 - 1e-12);
        CHECK(std::hypot(a.x(), a.z()) <= 0.1 - 0.04 + 1e-12);
        for (std::size_t j = 0; j < i; ++j) {
            CHECK((a - world.at_W(j)).norm() >= 0.08 - 1e-9);
        }
    }
}

TEST_CASE("world: hold, release, hide, place and drop again") {
    ToldWorld world;
    const HapticState tool = tool_at({0.0, 0.4, 0.0});
    world.run(tool);
    world.hold(0);
    CHECK(world.body(0).where == BodyWhere::held);
    CHECK(world.snapshot().carried_force_W.y() == Approx(-4.0 * 9.81));
    world.hold(0);
    world.hold(2);
    CHECK(world.snapshot().carried_force_W.y() == Approx(-4.4 * 9.81));
    world.tell(Kind::release, kNoBody);
    CHECK(world.snapshot().carried_force_W.norm() == 0.0);
    CHECK(world.body(0).where == BodyWhere::hidden);
    CHECK(world.body(2).where == BodyWhere::hidden);
    world.tell(Kind::place, 2, {1.0, 2.0, 3.0});
    world.run(tool, 100);
    CHECK(world.body(2).where == BodyWhere::placed);
    CHECK(world.at_W(2) == Vector3(1.0, 2.0, 3.0));
    world.hold(2);
    world.drop(2, {1.0, 2.0, 3.0});
    CHECK(world.snapshot().carried_force_W.norm() == 0.0);
    CHECK_FALSE(world.is_at_rest());
    world.tell(Kind::hide, 2);
    CHECK(world.is_at_rest());
    CHECK(world.ignored_commands() == 0);
}

TEST_CASE("world: a frame tells which solids were put elsewhere, and not which moved there") {
    ToldWorld world;
    const std::array<std::int32_t, 2> solids{0, 2};
    const auto count = [&](std::size_t solid) {
        return world.make_frame(0.0, solids).solid_placements[solid];
    };
    CHECK(count(0) == 0);
    world.tell(Kind::place, 0, {1.0, 2.0, 3.0});
    CHECK(count(0) == 1);
    CHECK(count(1) == 0);
    world.tell(Kind::place, 0, {1.0, 2.0, 3.0});
    world.tell(Kind::hide, 0);
    CHECK(count(0) == 3);
    world.drop(2, {1.0, 2.0, 3.0});
    CHECK(count(1) == 1);
    world.run(tool_at({0.0, 0.4, 0.0}), 100);
    CHECK(count(1) == 1);  // it falls
    world.hold(2);
    CHECK(count(1) == 2);
    world.tell(Kind::release, kNoBody);
    CHECK(count(1) == 3);
    CHECK(count(0) == 3);
}

TEST_CASE("world: bad commands and steps are ignored, the commands counted") {
    ToldWorld world;
    world.drop(-1);
    world.drop(3);
    world.hold(1000000);
    world.drop(1, {kNan, 0, 0});
    world.drop(1, Vector3::Zero(), Vector3(0, kInfinity, 0));
    world.tell(Kind::place, 1, {0, 1e9, 0});
    world.tell(static_cast<Kind>(77), 1);
    CHECK(world.ignored_commands() == 7);
    CHECK(world.is_at_rest());
    world.drop(1, {0.0, 1.0, 0.0});
    const Vector3 before = world.at_W();
    world.step(kNan, HapticState{});
    world.step(-1.0, HapticState{});
    world.step(0.0, HapticState{});
    CHECK(world.at_W() == before);
    // A tool that is nowhere catches nothing and leaves the bodies finite.
    for (int k = 0; k < 1000; ++k) {
        world.run(tool_at({kNan, kNan, kNan}));
        REQUIRE(is_finite(world.body().pose_W));
    }
    CHECK(world.body().where == BodyWhere::landed);
    // Held bodies stay where the tool last was.
    world.run(tool_at({0.0, 1.0, 0.0}));
    world.hold(2);
    world.run(tool_at({kNan, 0.0, 0.0}));
    CHECK(world.at_W(2).y() == Approx(1.0 - 0.12 + 0.04));
}

TEST_CASE("world: the same commands, the same bits; a full bucket catches and holds nothing more") {
    const auto play = [] {
        ToldWorld world;
        for (int k = 0; k < 800; ++k) {
            if (k % 200 == 10) {
                world.drop(k / 200 % 3, Vector3(0.01 * k / 200, 1.0, 0.02));
            }
            world.run(tool_at(Vector3(0.03 * std::sin(0.01 * k), 0.3, 0.0)));
        }
        return world.snapshot();
    };
    const WorldSnapshot first = play();
    const WorldSnapshot again = play();
    CHECK(first.time_s == again.time_s);
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(is_same(first.bodies[i], again.bodies[i]));
    }
    WorldPlan plan = make_world_plan();
    plan.catcher.capacity = 1;
    ToldWorld world(plan);
    world.run(tool_at({0.0, 0.5, 0.0}));
    world.drop(1, {-0.02, 0.6, 0.0});
    world.drop(2, {0.02, 0.6, 0.0});
    world.run(tool_at({0.0, 0.5, 0.0}), 300);
    CHECK(world.n_held() == 1);
    CHECK(world.snapshot().carried_force_W.y() == Approx(-0.6 * 9.81));
    const std::uint64_t ignored = world.ignored_commands();
    world.hold(0);
    CHECK(world.n_held() == 1);
    CHECK(world.ignored_commands() == ignored + 1);
    world.tell(Kind::release, 0);
    world.hold(0);
    CHECK(world.n_held() == 1);
}
