#include "haptics/dynamics/world.h"

#include "haptics/math/rotation.h"
#include "tests/unit/haptics/dynamics/world_fixture.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace fulcrum;

namespace {

using Kind = WorldCommand::Kind;

}  // namespace

TEST_CASE(
    "world: a body dropped beside the bucket lands with the speed of its fall, bounces weakly and "
    "rests") {
    World world(make_world_plan());
    world.apply(make_command(Kind::drop, 1, Vector3(0.5, 1.04, 0.0)));
    CHECK(world.snapshot().bodies[1].where == BodyWhere::falling);
    const WorldEvent event = step_until_event(world, tool_at(Vector3(0.0, 0.3, 0.0)));
    CHECK(event.kind == WorldEvent::Kind::landed);
    CHECK(event.body == 1);
    // One metre of free fall; a step more or less.
    CHECK(event.speed_m_per_s == Approx(std::sqrt(2.0 * 9.81)).margin(9.81 * kDt_s));
    CHECK(event.time_s == Approx(std::sqrt(2.0 / 9.81)).margin(2.0 * kDt_s));
    for (int k = 0; k < 2000; ++k) {
        world.step(kDt_s, tool_at(Vector3(0.0, 0.3, 0.0)));
        REQUIRE(world.events().empty());
        REQUIRE(world.snapshot().bodies[1].pose_W.position.y() >= 0.04);
        REQUIRE(world.snapshot().bodies[1].pose_W.position.y() < 0.15);
    }
    CHECK(world.is_at_rest());
    CHECK(world.snapshot().bodies[1].where == BodyWhere::landed);
    CHECK(world.snapshot().bodies[1].pose_W.position.y() == 0.04);
    CHECK(world.snapshot().bodies[1].velocity_W.norm() == 0.0);
}

TEST_CASE(
    "world: a body over the bucket is caught, its felt weight is carried, and it glides to its "
    "place") {
    World world(make_world_plan());
    const HapticState tool = tool_at(Vector3(0.0, 0.3, 0.0));
    world.apply(make_command(Kind::drop, 1, Vector3(0.02, 0.8, 0.0)));
    CHECK(world.snapshot().carried_force_W.norm() == 0.0);
    const WorldEvent event = step_until_event(world, tool);
    CHECK(event.kind == WorldEvent::Kind::caught);
    CHECK(event.speed_m_per_s == Approx(std::sqrt(2.0 * 9.81 * 0.5)).margin(9.81 * kDt_s));
    CHECK(world.snapshot().bodies[1].where == BodyWhere::held);
    CHECK((world.snapshot().carried_force_W - Vector3(0.0, -0.6 * 9.81, 0.0)).norm() < 1e-12);
    Vector3 before = world.snapshot().bodies[1].pose_W.position;
    for (int k = 0; k < 1000; ++k) {
        world.step(kDt_s, tool);
        // A glide, no jump: never faster than the way over the glide's time.
        REQUIRE((world.snapshot().bodies[1].pose_W.position - before).norm() < 0.15 * kDt_s / 0.08);
        before = world.snapshot().bodies[1].pose_W.position;
    }
    CHECK(world.is_at_rest());
    CHECK(before.y() == Approx(0.3 - 0.12 + 0.04));
    CHECK(std::hypot(before.x(), before.z()) <= 0.1 - 0.04);
}

TEST_CASE("world: neither a very fast body nor a very fast bucket is missed, and the way decides") {
    for (const double speed_m_per_s : {1.0, 30.0, 300.0}) {
        // The body falls 0.6 m a step at 300 m/s and would be far below the bucket after it.
        World world(make_world_plan());
        const HapticState still = tool_at(Vector3(0.0, 5.0, 0.0));
        world.step(kDt_s, still);
        world.apply(make_command(Kind::drop, 1, Vector3(0.0, 5.31, 0.0),
                                 Vector3(0.0, -speed_m_per_s, 0.0)));
        CHECK(step_until_event(world, still, 400).kind == WorldEvent::Kind::caught);
        // The bucket is thrown up at the same speed past a body that hangs in the air; the catch is as fast.
        World other(make_world_plan());
        other.step(kDt_s, tool_at(Vector3(0.0, 4.7, 0.0)));
        other.apply(make_command(Kind::drop, 1, Vector3(0.0, 5.0, 0.0)));
        WorldEvent event;
        for (int k = 1; k < 1000 && event.body == kNoBody; ++k) {
            other.step(kDt_s, tool_at(Vector3(0.0, 4.7 + k * kDt_s * speed_m_per_s, 0.0)));
            event = other.events().empty() ? WorldEvent{} : other.events().front();
        }
        CHECK(event.kind == WorldEvent::Kind::caught);
        CHECK(event.speed_m_per_s == Approx(speed_m_per_s).margin(3.0));
    }
    // A bucket that sweeps sideways: where it is when the body passes its rim counts, not where the step ends. At half the
    // step the opening stands 0.5 m off.
    World world(make_world_plan());
    world.step(kDt_s, tool_at(Vector3(-1.0, 0.5, 0.0)));
    world.apply(make_command(Kind::drop, 1, Vector3(-0.5, 0.505, 0.0), Vector3(0.0, -5.0, 0.0)));
    world.step(kDt_s, tool_at(Vector3(0.0, 0.5, 0.0)));
    CHECK(world.snapshot().bodies[1].where == BodyWhere::held);
}

TEST_CASE("world: a tilted, turned bucket catches along its own axis and carries the body round") {
    WorldPlan plan = make_world_plan();
    plan.gravity_W.setZero();
    World world(plan);
    HapticState tool = tool_at(Vector3(0.0, 1.0, 0.0));
    tool.tool_pose_W.orientation =
        compute_exp(Vector3(0.0, 0.0, -1.5707963267948966));  // opening towards +x
    world.step(kDt_s, tool);
    world.apply(make_command(Kind::drop, 1, Vector3(0.2, 1.0, 0.0), Vector3(-2.0, 0.0, 0.0)));
    CHECK(step_until_event(world, tool).kind == WorldEvent::Kind::caught);
    for (int k = 0; k < 1000; ++k) {
        world.step(kDt_s, tool);
    }
    const Pose& before = world.snapshot().bodies[1].pose_W;
    CHECK(before.position.x() == Approx(-0.08));
    const Vector3 offset_T = tool.tool_pose_W.inverse() * before.position;
    tool.tool_pose_W = {Vector3(0.3, 1.2, 0.1), compute_exp(Vector3(0.4, 0.0, 0.1))};
    tool.proxy_position_W = tool.tool_pose_W.position;
    world.step(kDt_s, tool);
    CHECK((world.snapshot().bodies[1].pose_W.position - tool.tool_pose_W * offset_T).norm() <
          1e-12);
}

TEST_CASE("world: several held bodies lie beside or upon each other, never within") {
    WorldPlan plan = make_world_plan();
    plan.bodies.assign(6, {0.2, 0.5, 0.04, 0.0});
    World world(plan);
    for (std::int32_t i = 0; i < 6; ++i) {
        world.apply(make_command(Kind::hold, i));
    }
    world.step(kDt_s, tool_at(Vector3(0.0, 1.0, 0.0)));
    CHECK(world.n_held() == 6);
    CHECK(world.snapshot().carried_force_W.y() == Approx(-6 * 0.5 * 9.81));
    for (std::size_t i = 0; i < 6; ++i) {
        const Vector3& a = world.snapshot().bodies[i].pose_W.position;
        CHECK(a.y() >= 1.0 - 0.12 + 0.04 - 1e-12);
        CHECK(std::hypot(a.x(), a.z()) <= 0.1 - 0.04 + 1e-12);
        for (std::size_t j = 0; j < i; ++j) {
            CHECK((a - world.snapshot().bodies[j].pose_W.position).norm() >= 0.08 - 1e-9);
        }
    }
}

TEST_CASE("world: hold, release, hide, place and drop again") {
    World world(make_world_plan());
    const HapticState tool = tool_at(Vector3(0.0, 0.4, 0.0));
    world.step(kDt_s, tool);
    world.apply(make_command(Kind::hold, 0));
    CHECK(world.snapshot().bodies[0].where == BodyWhere::held);
    CHECK(world.snapshot().carried_force_W.y() == Approx(-4.0 * 9.81));
    world.apply(make_command(Kind::hold, 0));
    world.apply(make_command(Kind::hold, 2));
    CHECK(world.snapshot().carried_force_W.y() == Approx(-4.4 * 9.81));
    world.apply(make_command(Kind::release, kNoBody));
    CHECK(world.snapshot().carried_force_W.norm() == 0.0);
    CHECK(world.snapshot().bodies[0].where == BodyWhere::hidden);
    CHECK(world.snapshot().bodies[2].where == BodyWhere::hidden);
    world.apply(make_command(Kind::place, 2, Vector3(1.0, 2.0, 3.0)));
    for (int k = 0; k < 100; ++k) {
        world.step(kDt_s, tool);
    }
    CHECK(world.snapshot().bodies[2].where == BodyWhere::placed);
    CHECK(world.snapshot().bodies[2].pose_W.position == Vector3(1.0, 2.0, 3.0));
    world.apply(make_command(Kind::hold, 2));
    world.apply(make_command(Kind::drop, 2, Vector3(1.0, 2.0, 3.0)));
    CHECK(world.snapshot().carried_force_W.norm() == 0.0);
    CHECK_FALSE(world.is_at_rest());
    world.apply(make_command(Kind::hide, 2));
    CHECK(world.is_at_rest());
    CHECK(world.ignored_commands() == 0);
}

TEST_CASE("world: a frame tells which solids were put elsewhere, and not which moved there") {
    World world(make_world_plan());
    const std::array<std::int32_t, 2> solids{0, 2};
    const auto count = [&](std::size_t solid) {
        return world.make_frame(0.0, solids).solid_placements[solid];
    };
    CHECK(count(0) == 0);
    world.apply(make_command(Kind::place, 0, Vector3(1.0, 2.0, 3.0)));
    CHECK(count(0) == 1);
    CHECK(count(1) == 0);
    world.apply(make_command(Kind::place, 0, Vector3(1.0, 2.0, 3.0)));
    world.apply(make_command(Kind::hide, 0));
    CHECK(count(0) == 3);
    world.apply(make_command(Kind::drop, 2, Vector3(1.0, 2.0, 3.0)));
    CHECK(count(1) == 1);
    for (int k = 0; k < 100; ++k) {
        world.step(kDt_s, tool_at(Vector3(0.0, 0.4, 0.0)));
    }
    CHECK(count(1) == 1);  // it falls
    world.apply(make_command(Kind::hold, 2));
    CHECK(count(1) == 2);
    world.apply(make_command(Kind::release, kNoBody));
    CHECK(count(1) == 3);
    CHECK(count(0) == 3);
}

TEST_CASE("world: bad commands and steps are ignored, the commands counted") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    World world(make_world_plan());
    world.apply(make_command(Kind::drop, -1));
    world.apply(make_command(Kind::drop, 3));
    world.apply(make_command(Kind::hold, 1000000));
    world.apply(make_command(Kind::drop, 1, Vector3(nan, 0, 0)));
    world.apply(make_command(Kind::drop, 1, Vector3::Zero(),
                             Vector3(0, std::numeric_limits<double>::infinity(), 0)));
    world.apply(make_command(Kind::place, 1, Vector3(0, 1e9, 0)));
    world.apply(make_command(static_cast<Kind>(77), 1));
    CHECK(world.ignored_commands() == 7);
    CHECK(world.is_at_rest());
    world.apply(make_command(Kind::drop, 1, Vector3(0.0, 1.0, 0.0)));
    const Vector3 before = world.snapshot().bodies[1].pose_W.position;
    world.step(nan, HapticState{});
    world.step(-1.0, HapticState{});
    world.step(0.0, HapticState{});
    CHECK(world.snapshot().bodies[1].pose_W.position == before);
    // A tool that is nowhere catches nothing and leaves the bodies finite.
    for (int k = 0; k < 1000; ++k) {
        world.step(kDt_s, tool_at(Vector3(nan, nan, nan)));
        REQUIRE(is_finite(world.snapshot().bodies[1].pose_W));
    }
    CHECK(world.snapshot().bodies[1].where == BodyWhere::landed);
    // Held bodies stay where the tool last was.
    world.step(kDt_s, tool_at(Vector3(0.0, 1.0, 0.0)));
    world.apply(make_command(Kind::hold, 2));
    world.step(kDt_s, tool_at(Vector3(nan, 0.0, 0.0)));
    CHECK(world.snapshot().bodies[2].pose_W.position.y() == Approx(1.0 - 0.12 + 0.04));
}

TEST_CASE("world: the same commands and hand give the same bits") {
    const auto play = [] {
        World world(make_world_plan());
        for (int k = 0; k < 800; ++k) {
            if (k % 200 == 10) {
                world.apply(
                    make_command(Kind::drop, k / 200 % 3, Vector3(0.01 * k / 200, 1.0, 0.02)));
            }
            world.step(kDt_s, tool_at(Vector3(0.03 * std::sin(0.01 * k), 0.3, 0.0)));
        }
        return world.snapshot();
    };
    const WorldSnapshot first = play();
    const WorldSnapshot again = play();
    CHECK(first.time_s == again.time_s);
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(first.bodies[i].where == again.bodies[i].where);
        CHECK(first.bodies[i].pose_W.position == again.bodies[i].pose_W.position);
        CHECK(first.bodies[i].pose_W.orientation.coeffs() ==
              again.bodies[i].pose_W.orientation.coeffs());
    }
}

TEST_CASE("world: a full bucket catches and holds nothing more, also when two arrive in one step") {
    WorldPlan plan = make_world_plan();
    plan.catcher.capacity = 1;
    World world(plan);
    world.step(kDt_s, tool_at(Vector3(0.0, 0.5, 0.0)));
    world.apply(make_command(Kind::drop, 1, Vector3(-0.02, 0.6, 0.0)));
    world.apply(make_command(Kind::drop, 2, Vector3(0.02, 0.6, 0.0)));
    for (int k = 0; k < 300; ++k) {
        world.step(kDt_s, tool_at(Vector3(0.0, 0.5, 0.0)));
    }
    CHECK(world.n_held() == 1);
    CHECK(world.snapshot().carried_force_W.y() == Approx(-0.6 * 9.81));
    const std::uint64_t ignored = world.ignored_commands();
    world.apply(make_command(Kind::hold, 0));
    CHECK(world.n_held() == 1);
    CHECK(world.ignored_commands() == ignored + 1);
    world.apply(make_command(Kind::release, 0));
    world.apply(make_command(Kind::hold, 0));
    CHECK(world.n_held() == 1);
}
