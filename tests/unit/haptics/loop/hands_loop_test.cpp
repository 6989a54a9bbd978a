#include "haptics/loop/hands_loop.h"

#include "tests/unit/haptics/loop/device_faults.h"
#include "tests/unit/haptics/loop/haptic_loop_fixture.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <vector>

using namespace fulcrum;

namespace {

constexpr double kPulled_N = 3.0;  // on each hand
const int kFade = static_cast<int>(SafetySettings{}.fade_s / kDt_s) + 2;

// Hands that hold a weight each, stepped in one round; the bench's own loops are stepped by nobody else.
struct TwoHands {
    explicit TwoHands(bool holds = true) : hands(std::array{in_round(first), in_round(second)}) {
        if (holds) {
            hold();
        }
    }
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
    void carry(double weight_N) {
        first.world.carried_force_W = second.world.carried_force_W = Vector3(0.0, -weight_N, 0.0);
    }
    void hold() {
        run(3000);
        carry(kPulled_N);
        run(1000);
        REQUIRE(first.written_N().norm() == Approx(kPulled_N));
        REQUIRE(second.written_N().norm() == Approx(kPulled_N));
    }
    [[nodiscard]] bool are_silent() const {
        return first.written_N().norm() == 0.0 && second.written_N().norm() == 0.0;
    }
    // Whether so many of the two gates are in this phase.
    [[nodiscard]] int count(GatePhase phase) const {
        return (first.state().gate == phase ? 1 : 0) + (second.state().gate == phase ? 1 : 0);
    }

    Bench first{make_weight_plan()};
    Bench second{make_weight_plan()};
    HandsLoop hands;
    double now_s = 0.0;
};

}  // namespace

TEST_CASE("hands: a round of several is, to the bit, what each would do alone") {
    TwoHands two(false);
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
        REQUIRE(two.first.state().tool_twist_W.linear == alone.state().tool_twist_W.linear);
        REQUIRE(two.first.state().faults == alone.state().faults);
    }
    CHECK(two.first.written_N().norm() > 1.9);
    CHECK(two.second.written_N().norm() == 0.0);
}

TEST_CASE("hands: a device that fails fades its own force, and the other feels nothing of it") {
    std::vector<DeviceFault> faults(std::begin(kDeviceFaults), std::end(kDeviceFaults));
    faults.push_back(
        {"takes no force", [](ScriptedDevice& d) { d.takes_wrench = false; }, Fault::device_write});
    for (const DeviceFault& fault : faults) {
        for (const bool first_fails : {true, false}) {
            CAPTURE(fault.name, first_fails);
            TwoHands two;
            Bench& failing = first_fails ? two.first : two.second;
            const Bench& other = first_fails ? two.second : two.first;
            fault.spoil(failing.device);
            bool is_told = false;
            for (int i = 0; i < kFade + 20; ++i) {
                two.run(1);
                is_told = is_told || failing.saw(fault.told);
                REQUIRE(other.written_N().norm() == Approx(kPulled_N));
                REQUIRE(other.state().gate == GatePhase::open);
            }
            CHECK(is_told);
            CHECK(failing.written_N().norm() == 0.0);
        }
    }
}

TEST_CASE("hands: an emergency stop, however short, stops all, and is lifted for all") {
    TwoHands two;
    two.first.channels->emergency_stop.tap();
    two.run(1);
    CHECK(two.count(GatePhase::stopped) == 2);
    two.run(kFade);
    CHECK(two.are_silent());
    // It stays, whatever time passes.
    two.run(2000);
    CHECK(two.count(GatePhase::stopped) == 2);
    two.carry(0.0);
    two.run(500);
    two.first.channels->rearm.store(true);
    two.run(100);
    CHECK(two.count(GatePhase::stopped) == 0);
    CHECK_FALSE(two.first.channels->rearm.load());
    CHECK_FALSE(two.second.channels->rearm.load());
}

TEST_CASE("hands: a stop that is held holds all steadily, and each hand tells whose it is") {
    const auto told = [](bool own, bool other) {
        return (own ? Fault::emergency_stop : Fault::none) |
               (other ? Fault::other_stopped : Fault::none);
    };
    // At either device, as its own arm's button, or at both.
    for (const auto& [at_first, at_second] :
         {std::pair{true, false}, {false, true}, {true, true}}) {
        CAPTURE(at_first, at_second);
        TwoHands two;
        if (at_first) {
            two.first.channels->emergency_stop.press();
        }
        if (at_second) {
            two.second.channels->emergency_stop.press();
        }
        two.run(2);
        CHECK(two.count(GatePhase::stopped) == 2);
        two.run(kFade);
        for (int i = 0; i < 1000; ++i) {
            // No key lifts it while it is held.
            two.first.channels->rearm.store(i == 500);
            two.run(1);
            REQUIRE(two.first.state().faults == told(at_first, at_second));
            REQUIRE(two.second.state().faults == told(at_second, at_first));
            REQUIRE(two.count(GatePhase::stopped) == 2);
            REQUIRE(two.are_silent());
        }
        // Let go, it is told no longer, and one lift frees both.
        two.first.channels->emergency_stop.release();
        two.second.channels->emergency_stop.release();
        two.run(2);
        CHECK(two.first.state().faults == Fault::none);
        CHECK(two.second.state().faults == Fault::none);
        two.first.channels->rearm.store(true);
        two.run(2);
        CHECK(two.count(GatePhase::waiting) == 2);
        two.carry(0.0);
        two.hold();
    }
}

TEST_CASE("hands: a hand's own fault stays told while another holds a stop") {
    for (const bool first_stops : {true, false}) {
        CAPTURE(first_stops);
        TwoHands two;
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

TEST_CASE("hands: a lesson that fails fades all, and comes back; silence leaves no force") {
    TwoHands two;
    two.first.channels->lesson_failed.store(true);
    two.run(kFade);
    CHECK(two.are_silent());
    two.first.channels->lesson_failed.store(false);
    two.carry(0.0);
    two.run(500);
    two.hold();
    two.first.channels->ended.store(true);
    two.run(kFade);
    CHECK(two.are_silent());
    TwoHands other;
    other.hands.silence(other.now_s);
    CHECK(other.are_silent());
}

TEST_CASE("hands: that no force is left is told once all have faded, and not while one has") {
    const auto is_told = [](const TwoHands& two) {
        return two.first.channels->emergency_stop.is_still();
    };
    for (const bool first_is_stopped : {true, false}) {
        CAPTURE(first_is_stopped);
        TwoHands two;
        CHECK_FALSE(is_told(two));
        (first_is_stopped ? two.first : two.second).channels->emergency_stop.press();
        int n_told = 0;
        for (int i = 0; i < kFade + 20; ++i) {
            two.run(1);
            n_told += is_told(two) ? 1 : 0;
            REQUIRE((!is_told(two) || two.are_silent()));
        }
        CHECK(n_told > 10);
    }
    // A device that takes no command may still push.
    TwoHands two;
    two.second.device.takes_wrench = false;
    two.first.channels->emergency_stop.press();
    two.run(kFade + 20);
    CHECK_FALSE(is_told(two));
    // What ended a force by another fault is no stop.
    TwoHands failed;
    failed.first.channels->lesson_failed.store(true);
    failed.run(kFade + 20);
    CHECK(failed.are_silent());
    CHECK_FALSE(is_told(failed));
}
