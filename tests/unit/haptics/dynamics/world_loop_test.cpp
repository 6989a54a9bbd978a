#include "haptics/dynamics/world_loop.h"

#include "tests/support/bad_numbers.h"
#include "tests/unit/haptics/dynamics/world_fixture.h"

#include <catch2/catch.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>

using namespace fulcrum;

namespace {

using Kind = WorldCommand::Kind;

// A world loop with its channels, stepped by hand.
struct Loop {
    explicit Loop(std::int32_t solid = 1) : loop(make_world_plan(), {solid}, *channels, *haptics) {}

    std::unique_ptr<WorldChannels> channels = std::make_unique<WorldChannels>();
    std::unique_ptr<HapticChannels> haptics = std::make_unique<HapticChannels>();
    WorldLoop loop;

    [[nodiscard]] const WorldSnapshot& there() const { return loop.world().snapshot(); }
    [[nodiscard]] const BodyState& body(std::size_t index = 1) const {
        return there().bodies[index];
    }
    void tell(Kind kind, std::int32_t body, const Vector3& at_W = Vector3::Zero(),
              const Vector3& velocity_W = Vector3::Zero()) {
        channels->commands.push(make_command(kind, body, at_W, velocity_W));
    }
    void hold_tool(const HapticState& tool) { haptics->state_for_world.publish(tool); }
};

}  // namespace

TEST_CASE("world loop: commands go in, frames, snapshots and events come out, on the run's clock") {
    Loop world(2);
    world.hold_tool(tool_at({0.0, 0.3, 0.0}));
    world.tell(Kind::place, 2, {1.0, 1.0, 1.0});
    world.tell(Kind::drop, 1, {0.0, 0.5, 0.0});
    world.tell(Kind::drop, 99);
    double now_s = 7.0;
    WorldEvent event;
    while (!world.channels->events.pop(event) && now_s < 9.0) {
        world.loop.step(now_s);
        now_s += kDt_s;
    }
    CHECK(event.kind == WorldEvent::Kind::caught);
    CHECK(event.time_s == Approx(now_s - kDt_s));
    CHECK(world.loop.world().ignored_commands() == 1);
    REQUIRE(world.channels->snapshot.take());
    CHECK(world.channels->snapshot.value().time_s == Approx(now_s - kDt_s));
    CHECK(world.channels->snapshot.value().n_bodies == 3);
    REQUIRE(world.haptics->world.take());
    CHECK(world.haptics->world.value().stamp_s == Approx(now_s - kDt_s));
    CHECK(world.haptics->world.value().carried_force_W.y() == Approx(-0.6 * 9.81));
    CHECK(world.haptics->world.value().solid_poses_W[0].position == Vector3(1.0, 1.0, 1.0));
    world.loop.silence(now_s);
    REQUIRE(world.haptics->world.take());
    CHECK(world.haptics->world.value().carried_force_W.norm() == 0.0);
}

TEST_CASE("world loop: a first round is one period; pauses and times that are none move nothing") {
    Loop world;
    world.tell(Kind::drop, 1, {2.0, 5.0, 0.0});
    world.loop.step(7.0);
    // Semi-implicit Euler: one step of 2 ms is g dt^2, the next of 50 ms adds g (dt + 0.05) 0.05.
    double fallen_m = 9.81 * kDt_s * kDt_s;
    CHECK(world.body().pose_W.position.y() == Approx(5.0 - fallen_m).epsilon(1e-13));
    CHECK(world.there().time_s == Approx(7.0));
    world.loop.step(67.0);
    fallen_m += 9.81 * (kDt_s + 0.05) * 0.05;
    CHECK(world.body().pose_W.position.y() == Approx(5.0 - fallen_m).epsilon(1e-13));
    // Its clock has not stood still.
    CHECK(world.there().time_s == Approx(67.0));
    Loop other;
    other.tell(Kind::drop, 1, {2.0, 5.0, 0.0});
    other.loop.step(7.0);
    const Vector3 before_W = other.body().pose_W.position;
    (void)other.haptics->world.take();
    (void)other.channels->snapshot.take();
    for (const double bad_s : {kNan, kInfinity, -kInfinity}) {
        other.loop.step(bad_s);
        CHECK_FALSE(other.haptics->world.take());
        CHECK_FALSE(other.channels->snapshot.take());
    }
    other.loop.step(6.9);
    CHECK(other.body().pose_W.position == before_W);
    REQUIRE(other.channels->snapshot.take());
    CHECK(other.channels->snapshot.value().time_s == Approx(6.9));
    // And goes on from there.
    other.loop.step(6.9 + kDt_s);
    CHECK(other.body().pose_W.position.y() ==
          Approx(before_W.y() - 9.81 * 2.0 * kDt_s * kDt_s).epsilon(1e-13));
}

TEST_CASE("world loop: until the hand has a pose there is no bucket, at the origin or elsewhere") {
    Loop world;
    double now_s = 0.0;
    const auto step_for = [&](int n) {
        for (int k = 0; k < n; ++k) {
            world.loop.step(now_s += kDt_s);
        }
    };
    // Nothing heard: the body falls past the origin onto the ground.
    world.tell(Kind::drop, 1, {0.0, 0.2, 0.0});
    step_for(10);
    // A device that has given no pose yet: its state stands at the origin and says so in its faults.
    for (const Fault fault : {Fault::device_read, Fault::device_stale, Fault::device_invalid}) {
        HapticState unread;
        unread.faults = fault;
        world.hold_tool(unread);
        step_for(100);
    }
    CHECK(world.body().where == BodyWhere::landed);
    // The first pose makes no sweep from the origin: the body is above it there and below it here.
    world.tell(Kind::drop, 2, {0.0, 0.5, 0.0}, {0.0, 0.02, 0.0});
    step_for(1);
    world.hold_tool(tool_at({0.0, 1.0, 0.0}));
    step_for(1);
    CHECK(world.body(2).where == BodyWhere::falling);
    // From now on there is one, wherever the haptic loop says, also while the device is faulty.
    HapticState jumped = tool_at({0.5, 1.0, 0.0});
    jumped.faults = Fault::device_invalid;
    world.hold_tool(jumped);
    step_for(1);
    world.tell(Kind::drop, 2, {0.5, 1.1, 0.0});
    step_for(100);
    CHECK(world.body(2).where == BodyWhere::held);
}

namespace {

// What is told is what there is, of now.
void check_told(const Loop& world, double now_s) {
    const WorldSnapshot& there = world.there();
    REQUIRE(world.channels->snapshot.take());
    REQUIRE(world.haptics->world.take());
    const WorldSnapshot& told = world.channels->snapshot.value();
    const WorldFrame& frame = world.haptics->world.value();
    REQUIRE(told.time_s == there.time_s);
    REQUIRE(told.time_s == Approx(now_s).epsilon(1e-14));
    REQUIRE(told.n_bodies == there.n_bodies);
    REQUIRE(told.carried_force_W == there.carried_force_W);
    REQUIRE(frame.stamp_s == now_s);
    REQUIRE(frame.carried_force_W == there.carried_force_W);
    // What is hidden cannot be touched either.
    const bool hidden = there.bodies[1].where == BodyWhere::hidden;
    REQUIRE((frame.solid_poses_W[0].position == there.bodies[1].pose_W.position) == !hidden);
    REQUIRE((frame.solid_poses_W[0].position.norm() > 1e4) == hidden);
    for (std::size_t i = 0; i < 3; ++i) {
        REQUIRE(is_same(told.bodies[i], there.bodies[i]));
    }
}

}  // namespace

TEST_CASE("world loop: fall, landing, rest, a hold and a release are told at once and kept fresh") {
    Loop world;
    double now_s = 3.0;
    const auto step_for = [&](int n) {
        for (int k = 0; k < n; ++k) {
            world.loop.step(now_s += kDt_s);
            check_told(world, now_s);
        }
    };
    step_for(5);  // nothing has ever moved
    world.tell(Kind::drop, 1, {2.0, 0.4, 0.0});
    step_for(1000);
    REQUIRE(world.body().where == BodyWhere::landed);
    REQUIRE(world.loop.world().is_at_rest());
    const std::uint64_t at_rest = world.loop.world().revision();
    step_for(50);
    CHECK(world.loop.world().revision() == at_rest);
    // Moved while all rest.
    world.tell(Kind::place, 1, {1.0, 2.0, 3.0});
    step_for(5);
    CHECK(world.loop.world().revision() > at_rest);
    // Held by a hand that moves.
    world.tell(Kind::hold, 2);
    for (int k = 0; k < 20; ++k) {
        world.hold_tool(tool_at({0.01 * k, 0.3, 0.0}));
        step_for(1);
    }
    REQUIRE(world.there().carried_force_W.norm() > 0.0);
    world.tell(Kind::release, 0);
    step_for(5);
}

TEST_CASE("world loop: a silence leaves nothing behind that a later round would tell") {
    Loop world;
    world.hold_tool(tool_at({0.0, 0.3, 0.0}));
    double now_s = 3.0;
    world.tell(Kind::hold, 2);
    for (int k = 0; k < 300; ++k) {
        world.loop.step(now_s += kDt_s);
    }
    for (int n_silent = 1; n_silent <= 4; ++n_silent) {
        for (int k = 0; k < n_silent; ++k) {
            world.loop.silence(now_s += kDt_s);
            REQUIRE(world.haptics->world.take());
            REQUIRE(world.haptics->world.value().carried_force_W == Vector3::Zero());
            REQUIRE(world.haptics->world.value().stamp_s == now_s);
        }
        for (int k = 0; k < 4; ++k) {
            world.loop.step(now_s += kDt_s);
            check_told(world, now_s);
        }
    }
}
