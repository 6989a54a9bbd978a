#include "tests/support/bad_numbers.h"
#include "tests/unit/haptics/link/held_arm.h"
#include "tests/unit/haptics/loop/device_faults.h"

#include <catch2/catch.hpp>

#include <array>

using namespace fulcrum;
using test_link::Engaged;
using test_link::Held;
using test_link::kStep_s;

TEST_CASE("link: without a fresh command for 20 ms the arm fades, and comes back softly") {
    Engaged held;
    held.commands = false;  // killed, hung, or its cable pulled
    held.run(19);
    CHECK(held.felt_N() == Approx(3.0));
    held.run(2);
    CHECK(any(held.arm().faults & Fault::command_stale));
    held.run(100);
    CHECK(held.hand.written_D.force.norm() == 0.0);
    CHECK(held.arm().trips == 1);
    CHECK(held.arm().gone_after_s == Approx(0.12).margin(2e-3));
    // Commands again: no force before the program's own has been small.
    held.commands = true;
    held.run(50);
    CHECK(held.hand.written_D.force.norm() == 0.0);
    held.wrench = {};
    held.run(10);
    held.wrench.force.x() = 3.0;
    held.run(100);
    CHECK(held.felt_N() > 0.0);
    CHECK(held.felt_N() < 0.6);  // 5 N/s
}

TEST_CASE("link: a second program is told that the arm is taken, and disturbs nobody") {
    Engaged held;
    // It speaks to the same arm from elsewhere.
    class Elsewhere final : public Datagrams {
      public:
        explicit Elsewhere(Datagrams& inner) : inner_(inner) {}
        bool send(double now_s, const PeerAddress& to,
                  std::span<const std::byte> packet) noexcept override {
            return inner_.send(now_s, to, packet);
        }
        std::size_t receive(double, std::span<std::byte>, PeerAddress&) noexcept override {
            return 0;
        }

      private:
        Datagrams& inner_;
    };
    Elsewhere line(held.pair.channel.end(0));
    test_link::CountedNumbers numbers(77'000);
    LinkDevice second({}, line, held.pair.seal, numbers);
    for (int i = 0; i < 500; ++i) {
        DeviceReading reading;
        CHECK_FALSE(second.read(held.pair.now_s, reading));
        CHECK_FALSE(second.write(held.pair.now_s, {{-3.0, 0.0, 0.0}, Vector3::Zero()}));
        held.run(1);
        REQUIRE(held.felt_N() == Approx(3.0));
    }
    CHECK(held.arm().sessions == 1);
}

TEST_CASE("link: a bye frees the arm for the next") {
    Engaged held;
    held.send(test_link::make_numbered(PacketKind::bye, {1000, 2000, 1'000'000}));
    held.commands = false;
    held.run(1);
    CHECK_FALSE(held.arm().held);
}

TEST_CASE("link: the least of program, run, arm's settings and arm holds, of torques too") {
    struct Most {
        double N, Nm;
    };
    struct Limits {
        const char* who;
        Most program, run, settings, arm, felt;
    };
    const ScriptedDevice scripted;
    const Most any{scripted.traits_.max_force_N, scripted.traits_.max_torque_Nm};
    const Most open{10.0, 1.0};
    const Most untold{0.0, 0.0};  // by a run that says nothing of its limits
    for (const Limits& limits : {Limits{"program", {3.0, 0.1}, untold, open, any, {3.0, 0.1}},
                                 Limits{"run", open, {1.5, 0.1}, open, any, {1.5, 0.1}},
                                 Limits{"settings", open, untold, {1.5, 0.05}, any, {1.5, 0.05}},
                                 Limits{"arm", open, untold, open, {2.0, 0.05}, {2.0, 0.05}}}) {
        CAPTURE(limits.who);
        DeviceTraits traits = scripted.traits_;
        traits.max_force_N = limits.arm.N;
        traits.max_torque_Nm = limits.arm.Nm;
        ArmServerSettings server;
        server.safety.max_force_N = limits.settings.N;
        server.safety.max_torque_Nm = limits.settings.Nm;
        Held held({}, server, {.max_force_N = limits.program.N, .max_torque_Nm = limits.program.Nm},
                  traits);
        if (limits.run.N > 0.0) {
            held.pair.device.tell_limits(
                {.max_force_N = limits.run.N, .max_torque_Nm = limits.run.Nm});
        }
        REQUIRE(held.pair.link());
        held.run(200);
        held.wrench = {Vector3(9.0, 0.0, 0.0), Vector3(0.0, 0.9, 0.0)};
        held.run(6000);
        CHECK(held.felt_N() == Approx(limits.felt.N).epsilon(1e-9));
        CHECK(held.hand.written_D.torque.y() == Approx(limits.felt.Nm).epsilon(1e-9));
    }
}

TEST_CASE(
    "link: but for transients force and torque change no faster than the slew of either side") {
    // What changes by more in a round than this is too fast.
    const auto find_largest = [](double own_N_per_s, double told_N_per_s, double told_N,
                                 double told_Nm) {
        ArmServerSettings own;
        own.safety.max_slew_N_per_s = own_N_per_s;
        own.safety.max_transient_N = 0.0;
        Held held(
            {}, own,
            {.max_force_N = told_N, .max_torque_Nm = told_Nm, .max_slew_N_per_s = told_N_per_s});
        held.engage();
        Wrench largest{};
        for (int i = 0; i < 400; ++i) {
            const Wrench before = held.hand.written_D;
            const double way = i < 200 ? -1.0 : 1.0;
            held.wrench = {Vector3(3.0 * way, 0.0, 0.0), Vector3(0.0, 0.1 * way, 0.0)};
            held.run(1);
            largest.force.x() =
                std::max(largest.force.x(), (held.hand.written_D.force - before.force).norm());
            largest.torque.x() =
                std::max(largest.torque.x(), (held.hand.written_D.torque - before.torque).norm());
        }
        CHECK(held.felt_N() == Approx(3.0));
        CHECK(held.hand.written_D.torque.y() == Approx(0.1));
        return largest;
    };
    const Wrench told = find_largest(5000.0, 100.0, 4.0, 0.2);
    CHECK(told.force.x() == Approx(100.0 * kStep_s));
    CHECK(told.torque.x() == Approx(100.0 * kStep_s * 0.2 / 4.0));
    const Wrench own = find_largest(50.0, 1000.0, 4.0, 0.8);
    CHECK(own.force.x() == Approx(50.0 * kStep_s));
    CHECK(own.torque.x() == Approx(50.0 * kStep_s * 1.0 / 10.0));
}

TEST_CASE("link: stop at the arm fades, is told to the program, and stays until it is lifted") {
    Engaged held;
    held.pair.server.stop();
    CHECK(held.run_to_gate(1) == GatePhase::stopped);
    held.run(1);
    CHECK(any(held.reading.faults & Fault::emergency_stop));
    held.run(110);
    CHECK(held.hand.written_D.force.norm() == 0.0);
    held.wrench = {};
    held.run(1000);
    held.wrench.force.x() = 3.0;
    held.run(1000);
    CHECK(held.hand.written_D.force.norm() == 0.0);
    held.wrench = {};
    held.pair.server.rearm();
    held.run(100);
    CHECK_FALSE(any(held.reading.faults & Fault::emergency_stop));
    held.wrench.force.x() = 3.0;
    held.run(3000);
    CHECK(held.felt_N() == Approx(3.0));
}

TEST_CASE("link: a stop at the arm that comes while an earlier one is being lifted stays") {
    Engaged held;
    held.pair.server.stop();
    held.run(5);
    held.pair.server.rearm();
    held.run(5);
    REQUIRE(held.hand.written_D.force.norm() > 0.0);  // it still fades
    held.pair.server.stop();
    held.pair.server.stop_switch().release();
    held.wrench = {};
    CHECK(held.run_to_gate(1000) == GatePhase::stopped);
    held.pair.server.rearm();
    CHECK(held.run_to_gate(10) != GatePhase::stopped);
}

TEST_CASE(
    "link: the arm trusts its own sensors no more than commands, and a thrown hand feels nothing") {
    for (const DeviceFault& fault : kDeviceFaults) {
        CAPTURE(fault.name);
        Engaged held;
        fault.spoil(held.hand);
        held.run(1);
        CHECK(held.arm().trips == 1);
        held.run(101);
        CHECK(held.hand.written_D.force.norm() == 0.0);
    }
    Engaged fast;
    for (int i = 0; i < 200; ++i) {
        fast.hand.pose_D.position.x() += 0.004;  // 4 m/s
        fast.run(1);
    }
    CHECK(fast.arm().trips == 1);
    CHECK(fast.hand.written_D.force.norm() == 0.0);
}

TEST_CASE("link: silence leaves the arm without force and says bye") {
    Engaged held;
    held.pair.server.silence(held.pair.now_s);
    CHECK(held.hand.written_D.force.norm() == 0.0);
    held.serves = false;
    held.run(2);
    CHECK_FALSE(held.gives_pose);
    // Nobody holds it any more.
    held.serves = true;
    held.commands = false;
    held.run(1);
    CHECK_FALSE(held.arm().held);
}

TEST_CASE("link: one old hello, again and again, gets few answers and keeps nobody out") {
    Held held;
    bool linked = false;
    const auto flood = [&](int n, bool greets) {
        for (int i = 0; i < n && !linked; ++i) {
            for (int k = 0; k < 20; ++k) {
                held.send(test_link::make_hello());
            }
            held.pair.now_s += kStep_s;
            held.pair.server.step(held.pair.now_s);
            if (greets) {
                linked =
                    held.pair.device.greet(held.pair.now_s) && held.pair.device.status().linked;
                (void)held.pair.device.write(held.pair.now_s, {});
            }
        }
    };
    flood(200, false);
    CHECK(held.arm().counts.sent <= 11);
    CHECK_FALSE(held.arm().held);
    flood(1000, true);
    CHECK(linked);
}

TEST_CASE("link: settings out of range are refused") {
    CHECK(validate(LinkDeviceSettings{}));
    CHECK(validate(ArmServerSettings{}));
    CHECK_FALSE(validate(LinkDeviceSettings{.max_force_N = 11.0}));
    CHECK_FALSE(validate(LinkDeviceSettings{.lost_after_s = kNan}));
    CHECK_FALSE(validate(LinkDeviceSettings{.most_round_trip_s = 0.0}));
    CHECK_FALSE(validate(ArmServerSettings{.rate_Hz = 100.0}));
    CHECK_FALSE(validate(ArmServerSettings{.handle_mass_kg = 0.0}));
    ArmServerSettings settings;
    settings.safety.fade_s = kNan;
    CHECK_FALSE(validate(settings));
    settings = {};
    settings.reach_m.y() = -1.0;
    CHECK_FALSE(validate(settings));
}

TEST_CASE("link: a flood of packets that nobody takes holds up no step; a longer one gets a fade") {
    Engaged held;
    const std::array<std::byte, 40> noise{};
    const auto foreign = [&] { return held.refused(Refusal::foreign); };
    const auto before = foreign();
    for (int i = 0; i < 4000; ++i) {
        held.pair.channel.end(0).send(held.pair.now_s, {}, noise);
    }
    held.run(1);
    CHECK(foreign() - before <= static_cast<std::uint64_t>(LinkPost::kMostAtOnce));
    // The rest is looked at in the rounds that follow; meanwhile good packets wait behind it.
    held.run(30);
    CHECK(foreign() - before == 4000);
    CHECK(held.hand.written_D.force.norm() <= 3.0);
}

// What the arm's side must not be talked out of: late commands, whoever gives them out; limits; its own stop.

TEST_CASE("link: good commands that somebody held back are stale, and hold the arm no longer") {
    for (const int every : {1, 50}) {
        CAPTURE(every);
        Engaged held;
        // They are kept on their way for 60 ms, then given out in order, quickly or slowly; nothing else comes.
        held.pair.tap.keeps = held.pair.tap.cut = true;
        held.run(60);
        const auto kept = held.pair.tap.sent;
        REQUIRE(kept.size() >= 50);
        held.commands = false;
        for (std::size_t i = 0; i < 30; ++i) {
            held.pair.channel.end(0).send(held.pair.now_s, {}, kept[i]);
            for (int k = 0; k < every; ++k) {
                held.run(1);
                REQUIRE(any(held.arm().faults & Fault::command_stale));
            }
        }
        held.run(every == 1 ? 600 : 0);
        CHECK(held.hand.written_D.force.norm() == 0.0);
        CHECK_FALSE(held.arm().held);
    }
}

TEST_CASE("link: a stop at the arm that is lifted while it fades fades on") {
    Engaged held;
    held.pair.server.stop();
    held.run(5);
    held.pair.server.rearm();
    double before_N = held.felt_N();
    for (int i = 0; i < 90; ++i) {
        held.run(1);
        const double now_N = held.felt_N();
        REQUIRE(before_N - now_N == Approx(0.03).epsilon(0.01));  // 3 N in 100 ms
        before_N = now_N;
    }
    held.run(20);
    CHECK(held.arm().gate == GatePhase::waiting);
}

TEST_CASE("link: a command counts from the holder's session to this one alone") {
    Engaged held;
    struct Wrong {
        std::uint64_t sender, receiver;
    };
    // Another program that has heard the arm's number; the holder, in an earlier session of the arm's; nobody in particular.
    std::uint64_t strangers = held.refused(Refusal::stranger);
    for (const Wrong& wrong : {Wrong{4242, 2000}, Wrong{1000, 1999}, Wrong{1000, 0}}) {
        LinkPacket packet =
            test_link::make_numbered(PacketKind::command, {wrong.sender, wrong.receiver, 1'000'000},
                                     LinkPost::to_ns(held.pair.now_s));
        packet.command.wrench_D.force.x() = -3.0;
        packet.command.max_force_N = 10.0;
        packet.command.max_slew_N_per_s = 500.0;
        held.send(packet);
        held.run(3);
        CHECK(held.felt_N() == Approx(3.0));
        CHECK(held.refused(Refusal::stranger) == ++strangers);
    }
}
