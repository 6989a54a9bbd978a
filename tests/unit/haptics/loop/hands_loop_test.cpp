#include "haptics/loop/hands_loop.h"

#include "tests/unit/haptics/loop/haptic_loop_fixture.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

using namespace fulcrum;

namespace {

constexpr double kPulled_N = 3.0;  // on each hand

// Hands that hold a weight each, stepped in one round; the bench's own loops are stepped by nobody else.
struct TwoHands {
    TwoHands() : hands(std::array{in_round(first), in_round(second)}) {}
    static HandInRound in_round(Bench& bench) { return {&bench.loop, bench.channels.get()}; }

    void run(int n) {
        for (int i = 0; i < n; ++i) {
            now_s += kDt_s;
            for (Bench* bench : {&first, &second}) {
                bench->command.stamp_s = bench->world.stamp_s = now_s;
                bench->channels->command.publish(bench->command);
                bench->channels->world.publish(bench->world);
            }
            hands.step(now_s);
        }
    }
    void hold() {
        run(3000);
        first.world.carried_force_W = second.world.carried_force_W = Vector3(0.0, -kPulled_N, 0.0);
        run(1000);
        REQUIRE(force_N(first) == Approx(kPulled_N));
        REQUIRE(force_N(second) == Approx(kPulled_N));
    }
    static double force_N(const Bench& bench) { return bench.written_N().norm(); }
    static GatePhase gate(const Bench& bench) { return bench.state().gate; }

    Bench first{make_weight_plan()};
    Bench second{make_weight_plan()};
    HandsLoop hands;
    double now_s = 0.0;
};

const int kFade = static_cast<int>(SafetySettings{}.fade_s / kDt_s) + 2;

// What goes wrong with a device, and what is noticed of it.
struct DeviceFault {
    const char* name;
    void (*spoil)(ScriptedDevice&);
    Fault told;
};
const DeviceFault kDeviceFaults[] = {
    {"gives no pose", [](ScriptedDevice& d) { d.gives_pose = false; }, Fault::device_read},
    {"gives no number",
     [](ScriptedDevice& d) { d.pose_D.position.x() = std::numeric_limits<double>::quiet_NaN(); },
     Fault::device_invalid},
    {"gives old poses", [](ScriptedDevice& d) { d.age_s = 0.5; }, Fault::device_stale},
    {"takes no force", [](ScriptedDevice& d) { d.takes_wrench = false; }, Fault::device_write}};

}  // namespace

TEST_CASE("hands: a round of several is, to the bit, what each would do alone") {
    TwoHands two;
    Bench alone(make_weight_plan());
    two.second.device.pose_D.position = Vector3(0.01, 0.0, 0.0);
    for (int k = 0; k < 4000; ++k) {
        const Vector3 place(0.03 * std::sin(0.004 * k), 0.0002 * (k % 50), 0.0);
        const Vector3 weight(0.0, k > 3000 ? -2.0 : 0.0, 0.0);
        two.first.device.pose_D.position = alone.device.pose_D.position = place;
        two.first.world.carried_force_W = alone.world.carried_force_W = weight;
        two.run(1);
        alone.run(1);
        REQUIRE(two.first.state().applied_W.force == alone.state().applied_W.force);
        REQUIRE(two.first.state().tool_twist_W.linear ==
                alone.state().tool_twist_W.linear);
        REQUIRE(two.first.state().faults == alone.state().faults);
    }
    CHECK(TwoHands::force_N(two.first) > 1.9);
    CHECK(TwoHands::force_N(two.second) == 0.0);
}

TEST_CASE("hands: a device that fails fades its own force, and the other feels nothing of it") {
    for (const DeviceFault& fault : kDeviceFaults) {
        for (const bool first_fails : {true, false}) {
            CAPTURE(fault.name, first_fails);
            TwoHands two;
            two.hold();
            Bench& failing = first_fails ? two.first : two.second;
            const Bench& other = first_fails ? two.second : two.first;
            fault.spoil(failing.device);
            bool is_told = false;
            for (int i = 0; i < kFade + 20; ++i) {
                two.run(1);
                is_told = is_told || any(failing.state().faults & fault.told);
                REQUIRE(TwoHands::force_N(other) == Approx(kPulled_N));
                REQUIRE(TwoHands::gate(other) == GatePhase::open);
            }
            CHECK(is_told);
            CHECK(TwoHands::force_N(failing) == 0.0);
        }
    }
}

TEST_CASE("hands: an emergency stop, however short, stops all, and is lifted for all") {
    TwoHands two;
    two.hold();
    two.first.channels->emergency_stop.press();
    two.first.channels->emergency_stop.release();
    two.run(1);
    CHECK(TwoHands::gate(two.first) == GatePhase::stopped);
    CHECK(TwoHands::gate(two.second) == GatePhase::stopped);
    two.run(kFade);
    CHECK(TwoHands::force_N(two.first) == 0.0);
    CHECK(TwoHands::force_N(two.second) == 0.0);
    // It stays, whatever time passes.
    two.run(2000);
    CHECK(TwoHands::gate(two.second) == GatePhase::stopped);
    two.first.world.carried_force_W = two.second.world.carried_force_W = Vector3::Zero();
    two.run(500);
    two.first.channels->rearm.store(true);
    two.run(100);
    CHECK(TwoHands::gate(two.first) != GatePhase::stopped);
    CHECK(TwoHands::gate(two.second) != GatePhase::stopped);
    CHECK_FALSE(two.first.channels->rearm.load());
    CHECK_FALSE(two.second.channels->rearm.load());
}

TEST_CASE("hands: a stop at any device is a stop of all, and no key lifts it while it is held") {
    TwoHands two;
    two.hold();
    two.second.channels->emergency_stop.press();  // as its own arm's button
    two.run(2);
    CHECK(TwoHands::gate(two.first) == GatePhase::stopped);
    CHECK(TwoHands::gate(two.second) == GatePhase::stopped);
    two.run(kFade);
    CHECK(TwoHands::force_N(two.first) == 0.0);
    CHECK(TwoHands::force_N(two.second) == 0.0);
    two.first.channels->rearm.store(true);
    two.run(100);
    CHECK(TwoHands::gate(two.first) == GatePhase::stopped);
    CHECK(TwoHands::gate(two.second) == GatePhase::stopped);
    two.second.channels->emergency_stop.release();
    two.first.channels->rearm.store(true);
    two.run(100);
    CHECK(TwoHands::gate(two.first) != GatePhase::stopped);
    CHECK(TwoHands::gate(two.second) != GatePhase::stopped);
}

TEST_CASE("hands: a stop that is held holds all steadily, and each hand tells whose it is") {
    struct Held {
        bool first;
        bool second;
    };
    for (const Held held : {Held{true, false}, Held{false, true}, Held{true, true}}) {
        CAPTURE(held.first, held.second);
        TwoHands two;
        two.hold();
        const auto press = [](Bench& bench, bool is_held) {
            if (is_held) {
                bench.channels->emergency_stop.press();
            }
        };
        press(two.first, held.first);
        press(two.second, held.second);
        const auto told = [](bool own, bool other) {
            return (own ? Fault::emergency_stop : Fault::none) |
                   (other ? Fault::other_stopped : Fault::none);
        };
        two.run(kFade + 2);
        for (int i = 0; i < 1000; ++i) {
            two.run(1);
            REQUIRE(two.first.state().faults == told(held.first, held.second));
            REQUIRE(two.second.state().faults == told(held.second, held.first));
            REQUIRE(TwoHands::gate(two.first) == GatePhase::stopped);
            REQUIRE(TwoHands::gate(two.second) == GatePhase::stopped);
            REQUIRE(TwoHands::force_N(two.first) == 0.0);
            REQUIRE(TwoHands::force_N(two.second) == 0.0);
        }
        // Let go, it is told no longer, and one lift frees both.
        two.first.channels->emergency_stop.release();
        two.second.channels->emergency_stop.release();
        two.run(2);
        CHECK(two.first.state().faults == Fault::none);
        CHECK(two.second.state().faults == Fault::none);
        two.first.channels->rearm.store(true);
        two.run(2);
        CHECK(TwoHands::gate(two.first) == GatePhase::waiting);
        CHECK(TwoHands::gate(two.second) == GatePhase::waiting);
        two.first.world.carried_force_W = two.second.world.carried_force_W = Vector3::Zero();
        two.hold();
    }
}

TEST_CASE("hands: a hand's own fault stays told while another holds a stop") {
    for (const bool first_stops : {true, false}) {
        CAPTURE(first_stops);
        TwoHands two;
        two.hold();
        Bench& stopping = first_stops ? two.first : two.second;
        Bench& failing = first_stops ? two.second : two.first;
        stopping.channels->emergency_stop.press();
        failing.device.gives_pose = false;
        two.run(2);
        for (int i = 0; i < 1000; ++i) {
            two.run(1);
            REQUIRE(stopping.state().faults == Fault::emergency_stop);
            REQUIRE(failing.state().faults == (Fault::device_read | Fault::other_stopped));
        }
    }
}

TEST_CASE("hands: a lesson that fails or is left fades all, and comes back to all") {
    TwoHands two;
    two.hold();
    two.first.channels->lesson_failed.store(true);
    two.run(kFade);
    CHECK(TwoHands::force_N(two.first) == 0.0);
    CHECK(TwoHands::force_N(two.second) == 0.0);
    two.first.channels->lesson_failed.store(false);
    two.first.world.carried_force_W = two.second.world.carried_force_W = Vector3::Zero();
    two.run(500);
    two.hold();
    two.first.channels->ended.store(true);
    two.run(kFade);
    CHECK(TwoHands::force_N(two.first) == 0.0);
    CHECK(TwoHands::force_N(two.second) == 0.0);
}

TEST_CASE("hands: silence leaves every device without force") {
    TwoHands two;
    two.hold();
    two.hands.silence(two.now_s);
    CHECK(TwoHands::force_N(two.first) == 0.0);
    CHECK(TwoHands::force_N(two.second) == 0.0);
}
