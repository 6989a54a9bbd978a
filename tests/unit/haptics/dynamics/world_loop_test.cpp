#include "haptics/dynamics/world_loop.h"

#include <catch2/catch.hpp>

#include <memory>

using namespace fulcrum;

namespace {

constexpr double kDt_s = 0.002;
using Kind = WorldCommand::Kind;

WorldPlan make_plan() {
    WorldPlan plan;
    plan.bodies = {{5.0, 4.0, 0.09, 0.0}, {0.2, 0.6, 0.04, 0.0}, {0.12, 0.4, 0.04, 0.0}};
    plan.catcher.present = true;
    plan.catcher.opening_radius_m = 0.1;
    plan.catcher.depth_m = 0.12;
    plan.catcher.capacity = 3;
    return plan;
}

WorldCommand make_command(Kind kind, std::int32_t body, const Vector3& position_W = Vector3::Zero(),
                          const Vector3& velocity_W = Vector3::Zero()) {
    return {kind, body, position_W, velocity_W};
}

HapticState tool_at(const Vector3& position_W) {
    HapticState tool;
    tool.tool_pose_W.position = position_W;
    tool.proxy_position_W = position_W;
    return tool;
}

}  // namespace

TEST_CASE("world loop: commands go in, frames, snapshots and events come out, on the run's clock") {
    auto channels = std::make_unique<WorldChannels>();
    auto haptics = std::make_unique<HapticChannels>();
    WorldLoop loop(make_plan(), {2}, *channels, *haptics);
    haptics->state_for_world.publish(tool_at(Vector3(0.0, 0.3, 0.0)));
    channels->commands.push(make_command(Kind::place, 2, Vector3(1.0, 1.0, 1.0)));
    channels->commands.push(make_command(Kind::drop, 1, Vector3(0.0, 0.5, 0.0)));
    channels->commands.push(make_command(Kind::drop, 99));
    double now_s = 7.0;
    WorldEvent event;
    while (!channels->events.pop(event) && now_s < 9.0) {
        loop.step(now_s);
        now_s += kDt_s;
    }
    CHECK(event.kind == WorldEvent::Kind::caught);
    CHECK(event.time_s == Approx(now_s - kDt_s));
    CHECK(loop.world().ignored_commands() == 1);
    REQUIRE(channels->snapshot.take());
    CHECK(channels->snapshot.value().time_s == Approx(now_s - kDt_s));
    CHECK(channels->snapshot.value().n_bodies == 3);
    REQUIRE(haptics->world.take());
    CHECK(haptics->world.value().stamp_s == Approx(now_s - kDt_s));
    CHECK(haptics->world.value().carried_force_W.y() == Approx(-0.6 * 9.81));
    CHECK(haptics->world.value().solid_poses_W[0].position == Vector3(1.0, 1.0, 1.0));
    loop.silence(now_s);
    REQUIRE(haptics->world.take());
    CHECK(haptics->world.value().carried_force_W.norm() == 0.0);
    // A long pause is no leap: the falling body moves by at most the longest step.
    channels->commands.push(make_command(Kind::drop, 0, Vector3(0.5, 5.0, 0.0)));
    loop.step(now_s);
    loop.step(now_s + 60.0);
    CHECK(loop.world().snapshot().bodies[0].pose_W.position.y() > 4.9);
}
