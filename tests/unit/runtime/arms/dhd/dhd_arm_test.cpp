#include "runtime/arms/dhd/dhd_arm.h"

#include "tests/support/maker_stand_in.h"

#include <catch2/catch.hpp>

#include <functional>

namespace fulcrum::runtime {
namespace {

constexpr double kTiny = 1.0e-12;
constexpr unsigned short kSerial = 4711;

// An arm that was begun; time is the test's, but for the stand-in's own watchdog, which is off.
struct Begun {
    test_support::MakerStandIn stand_in{FULCRUM_DHD_STAND_IN};
    DhdFunctions use = load_dhd(stand_in.path())->use;
    DhdArm arm{use, static_cast<char>(use.open()), kSerial,
               DeviceTraits{.name = "held", .renders_force = true, .max_force_N = 5.0}};
    double now_s = 100.0;
    int begun_watchdog = 0;

    Begun() {
        REQUIRE(arm.begin());
        begun_watchdog = static_cast<int>(stand_in.get("watchdog"));
        stand_in.set("watchdog", 0);
    }
    // One round of 1 ms in which a force is ordered.
    ArmSample round(const Vector3& force_D = {1.0, 0.0, 0.0}) {
        now_s += 0.001;
        const ArmSample sample = arm.read(now_s);
        arm.feel({.force = force_D});
        return sample;
    }
    // Rounds until it is there, or is not; how many that took, -1: too many.
    int rounds_until(bool is_there) {
        for (int n = 1; n < 3000; ++n) {
            if (round().is_there == is_there) {
                return n;
            }
        }
        return -1;
    }
};

}  // namespace

TEST_CASE("dhd arm: it begins with its own limits, its weight carried, and a watchdog of 20 ms") {
    Begun begun;
    CHECK(begun.stand_in.get("most force") == 5.0);
    CHECK(begun.stand_in.get("carried") == 1.0);
    CHECK(begun.stand_in.get("force on") == 1.0);
    CHECK(begun.begun_watchdog * kDhdTick_s == Approx(0.02));
    CHECK(begun.arm.is_watched());
}

TEST_CASE(
    "dhd arm: without a watchdog, which would take its force away where the library hangs, it "
    "gives 1 N") {
    test_support::MakerStandIn stand_in{FULCRUM_DHD_STAND_IN};
    DhdFunctions use = load_dhd(stand_in.path())->use;
    use.set_watchdog = nullptr;
    DhdArm arm{use, static_cast<char>(use.open()), kSerial,
               DeviceTraits{.name = "held", .renders_force = true, .max_force_N = 5.0}};
    REQUIRE(arm.begin());
    CHECK_FALSE(arm.is_watched());
    CHECK(arm.traits().max_force_N == kDhdUnwatched_N);
    CHECK(stand_in.get("most force") == kDhdUnwatched_N);
    (void)arm.read(100.0);
    arm.feel({.force = {3.0, 0.0, 0.0}});
    CHECK(stand_in.get("force", "x") == Approx(kDhdUnwatched_N));
}

TEST_CASE("dhd arm: away from the person is -z, right +x, up +y, for places and forces") {
    Begun begun;
    begun.stand_in.set("watchdog", 0);
    begun.stand_in.set("x", 0.01);
    begun.stand_in.set("y", 0.02);
    begun.stand_in.set("z", -0.03);
    (void)begun.round({1.0, -2.0, 3.0});
    // The stand-in turns them by itself, out of the maker's frame.
    CHECK(begun.stand_in.get("force", "x") == 1.0);
    CHECK(begun.stand_in.get("force", "y") == -2.0);
    CHECK(begun.stand_in.get("force", "z") == 3.0);
    CHECK(begun.stand_in.get("torque") == 0.0);
    const Vector3 told = begun.round({}).pose_D.position;
    CHECK(told.x() == begun.stand_in.get("at", "x"));
    CHECK(told.y() == begun.stand_in.get("at", "y"));
    CHECK(told.z() == begun.stand_in.get("at", "z"));
}

TEST_CASE(
    "dhd arm: a turn about the maker's upward axis is one about +y, of length 1 though the matrix "
    "is skew") {
    Begun begun;
    begun.stand_in.set("turn", 0.6);
    begun.stand_in.set("skew", 1.0e-3);
    begun.stand_in.set("buttons", 5);
    const ArmSample sample = begun.round();
    REQUIRE(sample.is_there);
    CHECK(std::abs(sample.pose_D.orientation.norm() - 1.0) < kTiny);
    CHECK(sample.pose_D.orientation.angularDistance(Quaternion(AngleAxis(0.6, Vector3::UnitY()))) <
          2.0e-3);
    CHECK(sample.buttons == 5);
    CHECK(sample.stamp_s == begun.now_s);
}

TEST_CASE("dhd arm: no more than its limit is ordered, and no torque of a wrist without motors") {
    Begun begun;
    (void)begun.arm.read(begun.now_s);
    begun.arm.feel({.force = {0.0, 30.0, -40.0}, .torque = {1.0, 1.0, 1.0}});
    CHECK(begun.stand_in.get("force", "y") == Approx(3.0));
    CHECK(begun.stand_in.get("force", "z") == Approx(-4.0));
    CHECK(begun.stand_in.get("torque") == 0.0);
}

TEST_CASE("dhd arm: what is no pose is none, and nothing is ordered until one comes") {
    for (const auto& [what, value] :
         {std::pair{"no number", 1.0}, {"far away", 1.0}, {"skew", 0.3}}) {
        INFO(what);
        Begun begun;
        REQUIRE(begun.round().is_there);
        begun.stand_in.set(what, value);
        begun.stand_in.set("asked", 0.0);
        const ArmSample sample = begun.round();
        CHECK_FALSE(sample.is_there);
        CHECK(is_finite(sample.pose_D));
        CHECK(begun.arm.trouble() == DhdTrouble::no_number);
        CHECK(begun.stand_in.get("asked") == 0.0);
        begun.stand_in.set(what, 0.0);
        CHECK(begun.round().is_there);
        CHECK(begun.arm.trouble() == DhdTrouble::none);
        CHECK(begun.stand_in.get("asked") == 1.0);
    }
}

TEST_CASE("dhd arm: results of 1 and 2 are good") {
    Begun begun;
    begun.stand_in.set("paced", 2);
    CHECK(begun.round().is_there);
}

TEST_CASE(
    "dhd arm: a brake of its own ends force and pose within ten rounds, and is over by itself "
    "after a rest") {
    for (const int cause : {2, 3}) {
        INFO(cause);
        Begun begun;
        REQUIRE(begun.round().is_there);
        begun.stand_in.set("brake for", cause);
        begun.stand_in.set("asked", 0.0);
        const int seen = begun.rounds_until(false);
        CHECK(seen >= 1);
        CHECK(seen <= kDhdStatusEvery);
        CHECK(begun.arm.trouble() == trouble_of_cause(cause));
        const double asked = begun.stand_in.get("asked");
        CHECK(asked < kDhdStatusEvery);
        const int rested = begun.rounds_until(true);
        CHECK(rested >= static_cast<int>(kDhdRest_s / 0.001));
        CHECK(rested <= static_cast<int>(kDhdRest_s / 0.001) + 3 * kDhdStatusEvery);
        // Nothing but the round in which it came back.
        CHECK(begun.stand_in.get("asked") == asked + 1.0);
        CHECK(begun.stand_in.get("switched on") == 2.0);
    }
}

TEST_CASE("dhd arm: a brake that somebody must let go stays until then") {
    for (const int cause : {1, 4, 5, 6, 0}) {
        INFO(cause);
        Begun begun;
        begun.stand_in.set("brake for", cause);
        CHECK(begun.rounds_until(false) > 0);
        CHECK(begun.rounds_until(true) == -1);
        CHECK(begun.stand_in.get("switched on") == 1.0);
        // Its button.
        begun.stand_in.set("force on", 1.0);
        begun.stand_in.set("brake", 0.0);
        CHECK(begun.rounds_until(true) > 0);
    }
}

TEST_CASE("dhd arm: a brake that does not go is not fought more than twice a second") {
    Begun begun;
    begun.stand_in.set("stays braked", 1.0);
    begun.stand_in.set("brake for", 2);
    CHECK(begun.rounds_until(false) > 0);
    CHECK(begun.rounds_until(true) == -1);
    const double tries = begun.stand_in.get("switched on") - 1.0;
    CHECK(tries >= 4.0);
    CHECK(tries <= 6.0);
}

TEST_CASE(
    "dhd arm: a force that is off is a brake without one, and a brake is one without a force that "
    "is off") {
    Begun begun;
    begun.stand_in.set("force on", 0.0);
    CHECK(begun.rounds_until(false) <= kDhdStatusEvery);
    begun.stand_in.set("force on", 1.0);
    CHECK(begun.rounds_until(true) <= kDhdStatusEvery);
    begun.stand_in.set("brake", 1.0);
    CHECK(begun.rounds_until(false) <= kDhdStatusEvery);
}

TEST_CASE("dhd arm: an error that it reports, and an order that does not get through, are faults") {
    Begun begun;
    begun.stand_in.set("error", 1.0);
    CHECK(begun.rounds_until(false) <= kDhdStatusEvery);
    CHECK(begun.arm.trouble() == DhdTrouble::fault);
    begun.stand_in.set("error", 0.0);
    CHECK(begun.rounds_until(true) <= kDhdStatusEvery);
    begun.stand_in.set("deaf", 1.0);
    CHECK(begun.rounds_until(false) <= 2);
    CHECK(begun.arm.trouble() == DhdTrouble::call_failed);
}

TEST_CASE(
    "dhd arm: plugged in again it goes on, if it is the same and knows its zero; nothing moves "
    "it") {
    Begun begun;
    REQUIRE(begun.round().is_there);
    begun.stand_in.set("unplugged", 1.0);
    CHECK(begun.rounds_until(false) == 1);
    CHECK(begun.arm.trouble() == DhdTrouble::call_failed);
    CHECK(begun.rounds_until(true) == -1);

    begun.stand_in.set("serial", 4712);
    begun.stand_in.set("unplugged", 0.0);
    CHECK(begun.rounds_until(true) == -1);
    CHECK(begun.arm.trouble() == DhdTrouble::another_arm);

    begun.stand_in.set("serial", 0.0);
    begun.stand_in.set("knows no zero", 1.0);
    CHECK(begun.rounds_until(true) == -1);
    CHECK(begun.arm.trouble() == DhdTrouble::not_initialised);
    CHECK(begun.stand_in.get("moved by itself") == 0.0);

    begun.stand_in.set("knows no zero", 0.0);
    CHECK(begun.rounds_until(true) > 0);
    CHECK(begun.stand_in.get("switched on") == 2.0);
    CHECK(begun.stand_in.get("watchdog") == kDhdWatchdogTicks);
}

TEST_CASE("dhd arm: at its end it is without force and closed, once") {
    Begun begun;
    (void)begun.round();
    begun.arm.end();
    begun.arm.end();
    CHECK(begun.stand_in.get("force", "x") == 0.0);
    CHECK(begun.stand_in.get("force on") == 0.0);
    CHECK(begun.stand_in.get("closed") == 1.0);
}

}  // namespace fulcrum::runtime
