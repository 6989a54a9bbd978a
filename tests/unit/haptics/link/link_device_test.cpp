#include "haptics/device/simulated/simulated_arm.h"
#include "haptics/loop/haptic_loop.h"
#include "haptics/math/rotation.h"
#include "tests/unit/haptics/link/held_arm.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdint>
#include <memory>

using namespace fulcrum;
using test_link::Engaged;
using test_link::Held;
using test_link::kStep_s;

TEST_CASE("link: an arm says what it is, gives its poses and takes wrenches") {
    DeviceTraits traits = ScriptedDevice().traits_;
    traits.mass_kg = 0.25;
    Held held({}, {}, {}, traits);
    held.hand.pose_D.position = {0.01, 0.02, 0.03};
    held.hand.buttons = 3;
    CHECK_FALSE(held.gives_pose);
    held.engage();
    CHECK(held.pair.device.traits().name == "scripted device");
    CHECK(held.pair.device.traits().renders_force);
    CHECK(held.pair.device.traits().mass_kg == 0.25);
    // Its own 100 N, cut to the server's limit.
    CHECK(held.pair.device.traits().max_force_N == 10.0);
    CHECK(held.reading.pose_D.position == Vector3(0.01, 0.02, 0.03));
    CHECK(held.reading.buttons == 3);
    CHECK(held.pair.device.status().sessions == 1);
    CHECK(held.arm().held);
}

TEST_CASE("link: poses come once a round with a stamp that goes on evenly, whatever the delay") {
    for (const double delay_s : {0.0, 0.004, 0.03, 0.08}) {
        Held held({.delay_s = delay_s});
        REQUIRE(held.pair.link());
        held.run(1000);
        for (int i = 0; i < 200; ++i) {
            const double before_s = held.reading.stamp_s;
            held.run(1);
            REQUIRE(held.gives_pose);
            REQUIRE(held.reading.stamp_s - before_s == Approx(kStep_s).epsilon(1e-6));
            REQUIRE(held.pair.now_s - held.reading.stamp_s <= 1.1e-3);
            REQUIRE(held.reading.stamp_s <= held.pair.now_s);
        }
        CHECK(held.pair.device.status().round_trip_s == Approx(2.0 * delay_s).margin(2.1e-3));
        // Both are stepped with the same clock here: what is delay is not taken for another zero.
        CHECK(held.pair.device.status().offset_s == Approx(0.0).margin(1.1e-3));
    }
}

TEST_CASE("link: with a lost link both sides begin anew, under other numbers") {
    Engaged held;
    held.pair.tap.cut = true;
    held.run(700);
    CHECK_FALSE(held.gives_pose);
    CHECK_FALSE(held.takes);
    CHECK_FALSE(held.arm().held);
    CHECK(held.hand.written_D.force.norm() == 0.0);
    held.pair.tap.cut = false;
    held.wrench = {};
    held.run(200);
    CHECK(held.gives_pose);
    CHECK(held.pair.device.status().sessions == 2);
    CHECK(held.arm().sessions == 2);
    held.wrench.force.x() = 3.0;
    held.run(3000);
    CHECK(held.felt_N() == Approx(3.0));
}

TEST_CASE("link: an arm that starts again is found again, another one is not taken for it") {
    ScriptedDevice hand;
    MemoryChannel channel;
    test_link::HmacSeal seal;
    test_link::CountedNumbers program_numbers(1), arm_numbers(5000);
    LinkDevice device({}, channel.end(0), seal, program_numbers);
    double now_s = 0.0;
    std::uint64_t lives = 0;
    for (const double mass_kg : {0.1, 0.1, 0.1, 0.3}) {
        hand.traits_.mass_kg = mass_kg;
        ArmServer server({}, hand, channel.end(1), seal, arm_numbers);
        DeviceReading reading;
        bool reads = false;
        for (int i = 0; i < 1000; ++i) {
            now_s += kStep_s;
            server.step(now_s);
            reads = device.read(now_s, reading);
            (void)device.write(now_s, {});
        }
        const bool is_same = mass_kg == 0.1;
        CAPTURE(mass_kg);
        CHECK(reads == is_same);
        CHECK(device.status().changed == !is_same);
        CHECK(server.status().held == is_same);
        CHECK((!is_same || device.status().sessions == ++lives));
    }
}

TEST_CASE("link: a pose that is late or missing is the loop's stale pose") {
    Engaged held;
    held.pair.tap.cut = true;
    held.run(25);
    CHECK(held.gives_pose);  // the newest there is, with its own time
    CHECK(held.pair.now_s - held.reading.stamp_s > 0.02);
}

TEST_CASE("link: an arm that has shut its gate while a force is asked for is told to the loop") {
    Engaged held;
    // Only the way to the arm is cut: poses go on.
    held.commands = false;
    held.run(40);
    held.commands = true;
    held.run(200);
    CHECK(held.arm().gate == GatePhase::waiting);
    CHECK(any(held.reading.faults & Fault::command_stale));
    held.wrench = {};
    held.run(200);
    CHECK_FALSE(any(held.reading.faults));
}

TEST_CASE("link: lost and late packets are no fault of the loop, whatever the clock's digits") {
    for (const LinkFaults& faults :
         {LinkFaults{}, LinkFaults{.loss = 0.05, .burst = 3}, LinkFaults{.jitter_s = 0.003}}) {
        SimulatedArmSettings settings;
        LatestValue<HandTarget> target;
        target.publish({});
        SimulatedArm arm(settings, target);
        test_link::LinkPair pair(arm, faults);
        REQUIRE(pair.link(2.0));
        HapticPlan plan;
        plan.expects_lesson = false;
        const auto channels = std::make_unique<HapticChannels>();
        HapticLoop loop(plan, pair.device, *channels);
        std::int64_t now_ns = 987'654'321 + static_cast<std::int64_t>(pair.now_s * 1e9);
        int n_faults = 0;
        for (int i = 0; i < 10'000; ++i) {
            now_ns += 1'000'037;
            const double now_s = static_cast<double>(now_ns) * 1e-9;
            target.publish({.pose_D = Pose::at({0.02 * std::sin(5.0 * now_s), 0.0, 0.0})});
            loop.step(now_s);
            n_faults += i > 1000 && any(loop.state().faults) ? 1 : 0;
            REQUIRE(loop.state().tool_twist_W.linear.norm() < 2.0);
            pair.server.step(now_s + 0.0005);
        }
        CHECK(n_faults == 0);
    }
}

TEST_CASE("link: poses of one time have one stamp, so that no velocity is without bound") {
    Engaged held;
    const double since_s = held.reading.stamp_s;
    held.hand.age_s = 0.0;
    double last_s = since_s;
    int n_same = 0;
    for (int i = 0; i < 30; ++i) {
        held.hand.age_s += 0.001;  // its clock stands still
        held.hand.pose_D.position.x() += 1e-5;
        held.run(1);
        const double step_s = held.reading.stamp_s - last_s;
        REQUIRE((step_s == 0.0 || step_s > 1e-4));
        n_same += step_s == 0.0 ? 1 : 0;
        last_s = held.reading.stamp_s;
    }
    CHECK(n_same >= 25);
}

TEST_CASE("link: a way that takes longer than a hand can be served over gives no pose") {
    Held held({.delay_s = 0.15});
    (void)held.pair.link();
    held.run(3000);
    CHECK(held.pair.device.status().round_trip_s > 0.25);
    CHECK_FALSE(held.gives_pose);
    CHECK(held.n_poses == 0);
}

TEST_CASE("link: a way that becomes too long is told, and so is one that is quick again") {
    Engaged held;
    const auto told = [&] { return held.pair.device.status().too_long; };
    // One slow exchange is nothing.
    held.pair.faulty.set({.delay_s = 0.2});
    held.run(300);
    held.pair.faulty.set({});
    held.run(1000);
    REQUIRE_FALSE(told());
    held.wrench = {};
    held.run(500);
    // The force goes at once; why, is known when new exchanges have come.
    held.pair.faulty.set({.delay_s = 0.2});
    held.run(4000);
    CHECK(told());
    held.run(2000);
    CHECK(told());
    CHECK(held.hand.written_D.force.norm() == 0.0);
    held.pair.faulty.set({});
    held.run(400);
    CHECK(told());
    held.run(1600);
    CHECK_FALSE(told());
    // Near the limit it is none.
    held.pair.faulty.set({.delay_s = 0.12});
    held.run(10'000);
    CHECK_FALSE(told());
}

TEST_CASE("link: an arm that says that it moves and tells one place has a frozen sensor") {
    for (const double speed_m_per_s : {0.0, 0.04, 0.06}) {
        CAPTURE(speed_m_per_s);
        Engaged held;
        held.serves = false;
        int told_at = -1;
        for (int i = 0; i < 200; ++i) {
            LinkPacket packet = test_link::make_numbered(
                PacketKind::state, {2000, 1000, 1'000'000ULL + static_cast<unsigned>(i)},
                LinkPost::to_ns(held.pair.now_s));
            packet.state.measured_ns = packet.head.sent_ns;
            packet.state.pose_D.position = {0.1, 0.0, 0.0};
            packet.state.twist_D.linear = {0.0, speed_m_per_s, 0.0};
            packet.state.gate = GatePhase::open;
            held.send(packet, 1);
            held.run(1);
            REQUIRE(held.gives_pose);
            const bool is_told = any(held.reading.faults & Fault::device_stale);
            told_at = is_told && told_at < 0 && i > 0 ? i : told_at;
        }
        CHECK((speed_m_per_s > 0.05 ? told_at >= 50 && told_at <= 53 : told_at < 0));
    }
}

TEST_CASE("link: a pose that was overtaken on its way is not taken for the newest") {
    Held held({.jitter_s = 0.01, .reorder = 0.5, .seed = 3});
    REQUIRE(held.pair.link());
    double before_m = -1.0;
    for (int i = 0; i < 3000; ++i) {
        held.hand.pose_D.position.x() += 1.0e-5;
        held.run(1);
        if (held.gives_pose) {
            REQUIRE(held.reading.pose_D.position.x() >= before_m);
            before_m = held.reading.pose_D.position.x();
        }
    }
    CHECK(before_m > 0.0);
}

TEST_CASE("link: nothing is measured after it is heard of, whatever an arm says of its clock") {
    Held held;
    REQUIRE(held.pair.link());
    held.run(200);
    for (int i = 0; i < 19; ++i) {
        held.hand.age_s -= 0.001;  // its sensor's clock runs twice as fast
        held.run(1);
        REQUIRE(held.gives_pose);
        REQUIRE(held.reading.stamp_s <= held.pair.now_s);
    }
    for (int i = 0; i < 20; ++i) {
        held.hand.age_s = i % 2 == 0 ? 0.019 : -0.019;
        held.run(1);
        REQUIRE(held.reading.stamp_s <= held.pair.now_s);
    }
}

TEST_CASE("link: a wrench that is no number is not sent") {
    Engaged held;
    held.pair.tap.keeps = true;
    for (const double bad : {std::nan(""), HUGE_VAL}) {
        CHECK_FALSE(held.pair.device.write(held.pair.now_s + kStep_s,
                                           {Vector3(0.0, bad, 0.0), Vector3::Zero()}));
        CHECK_FALSE(held.pair.device.write(held.pair.now_s + kStep_s,
                                           {Vector3::Zero(), Vector3(bad, 0.0, 0.0)}));
    }
    CHECK(held.pair.tap.sent.empty());
}

TEST_CASE("link: what the scene takes by a torque that nobody has put in turns its hand aside") {
    // The arm gives no torque, so its hand pays nothing; the scene asks for one against the turning.
    Held held({}, {.safety = {.max_torque_Nm = 0.0}});
    REQUIRE(held.pair.link());
    held.run(200);
    held.wrench.torque = {0.1, 0.0, 0.0};
    for (int i = 0; i < 300; ++i) {
        held.hand.pose_D.orientation =
            compute_exp(Vector3(-1.0e-3, 0.0, 0.0)) * held.hand.pose_D.orientation;
        held.run(1);
    }
    const Quaternion aside =
        held.reading.pose_D.orientation * held.hand.pose_D.orientation.conjugate();
    const Vector3 turned = compute_log(aside);
    CHECK(turned.x() > 0.05);
    CHECK(turned.x() <= 0.5 + 1.0e-9);
    CHECK(std::hypot(turned.y(), turned.z()) < 1.0e-6);
}
