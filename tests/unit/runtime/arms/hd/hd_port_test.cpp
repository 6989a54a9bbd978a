#include "runtime/arms/hd/hd_port.h"

#include "runtime/arms/arm_device.h"
#include "runtime/arms/hd/hd_library.h"
#include "runtime/arms/hd/hd_trouble.h"
#include "tests/support/eventually.h"
#include "tests/support/maker_stand_in.h"
#include "tests/support/port_loop.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {
namespace {

using test_support::eventually;
using test_support::MakerStandIn;
using test_support::PortLoop;

std::unique_ptr<ArmPort> open_touch(const MakerStandIn& stand_in) {
    // The one before may be put away a moment later on a machine that is busy.
    auto port = open_hd({.library = stand_in.path()});
    REQUIRE(eventually([&] { return port || (port = open_hd({.library = stand_in.path()})); }));
    return std::move(*port);
}

// An arm that is pushed by 1 N to the right all the time.
struct PushedTouch {
    MakerStandIn stand_in{FULCRUM_HD_STAND_IN};
    ArmDevice device;
    PortLoop loop{device, [](const Vector3&) { return Vector3{1.0, 0.0, 0.0}; }};

    explicit PushedTouch(std::uint32_t calibration = 0) : device(open(calibration)) {
        if (calibration == 0) {
            REQUIRE(eventually([&] { return is_pushed(); }));
        }
    }
    [[nodiscard]] bool is_pushed() const {
        return loop.is_there() && stand_in.get("force", "x") == 1.0;
    }
    [[nodiscard]] bool is_let_go() const {
        return !loop.is_there() && stand_in.get("force", "x") == 0.0;
    }
    // In time; on a machine that is busy something else may be told between.
    [[nodiscard]] bool is_told(const std::string& sentence) {
        return eventually([&] { return device.port().take_notice() == sentence; });
    }

  private:
    [[nodiscard]] std::unique_ptr<ArmPort> open(std::uint32_t calibration) const {
        stand_in.set("calibration", calibration);
        return open_touch(stand_in);
    }
};

}  // namespace

TEST_CASE(
    "hd port: a wall along each axis, on each side, holds the hand where the springs balance") {
    // 300 N/m of a fingertip that wants to be at 2 cm, 500 N/m of a wall from 1 cm on: 300 (20 - x) = 500 (x - 10) mm.
    constexpr double kBalance_m = 0.01375;
    constexpr double kNear_m = 2.0e-4;
    const char* const axes[] = {"x", "y", "z"};
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {1.0, -1.0}) {
            INFO(axes[axis] << " " << side);
            const MakerStandIn stand_in(FULCRUM_HD_STAND_IN);
            ArmDevice device(open_touch(stand_in));
            const PortLoop loop(device, test_support::make_wall(axis, side * 0.01, 500.0));
            stand_in.set(axes[axis], side * 0.02);
            CHECK(eventually([&] {
                return std::abs(stand_in.get("at", axes[axis]) - side * kBalance_m) < kNear_m &&
                       stand_in.get("force", axes[axis]) * side < -1.5;
            }));
        }
    }
}

TEST_CASE(
    "hd port: what it says of itself is that of its arm, and its loop runs at the rate that was "
    "asked for") {
    const MakerStandIn stand_in(FULCRUM_HD_STAND_IN);
    const auto port = open_touch(stand_in);
    CHECK(port->traits().name == "Touch 50012345678");
    CHECK(port->traits().max_force_N == 3.3);
    CHECK(validate(port->sensor()));
    CHECK(port->facts()[0] == ArmFact{"hd library", stand_in.path()});
    CHECK(stand_in.get("rate") == 1000.0);
    CHECK(stand_in.get("priority") == 32767.0);
}

TEST_CASE(
    "hd port: a limit that cannot be, a library that is none and no arm are refused, and a good "
    "one is taken then") {
    CHECK_FALSE(open_hd({.library = "/none", .max_force_N = 10.5}));
    CHECK_FALSE(open_hd({.library = "/none"}));
    const MakerStandIn stand_in(FULCRUM_HD_STAND_IN);
    stand_in.set("no arm", 1.0);
    CHECK_FALSE(open_hd({.library = stand_in.path()}));
    stand_in.set("no arm", 0.0);
    CHECK(open_hd({.library = stand_in.path()}));
}

TEST_CASE("hd port: a program has one arm at a time") {
    const MakerStandIn stand_in(FULCRUM_HD_STAND_IN);
    {
        const auto port = open_touch(stand_in);
        const auto second = open_hd({.library = stand_in.path()});
        REQUIRE_FALSE(second);
        CHECK(second.error().message == "this program has an arm of OpenHaptics already");
    }
    CHECK(eventually([&] { return open_hd({.library = stand_in.path()}).has_value(); }));
}

TEST_CASE(
    "hd port: a pen that is not in its inkwell is asked for in words, and pushed only when it has "
    "been there") {
    PushedTouch pushed(hd_needs_person);
    CHECK(pushed.is_told(words_of_hd(hd_needs_person)));
    CHECK(pushed.is_let_go());
    pushed.stand_in.set("calibration", hd_needs_update);
    CHECK(eventually([&] { return pushed.is_pushed(); }));
    CHECK(pushed.stand_in.get("updates") == 1.0);
    CHECK(pushed.is_told(words_of_hd(hd_no_error)));
}

TEST_CASE(
    "hd port: each error is told, gives no force meanwhile, and is told again when it is over") {
    PushedTouch pushed;
    for (const std::uint32_t code : {hd_too_much_force, hd_too_fast, hd_bad_configuration}) {
        pushed.stand_in.set("raise", code);
        CHECK(pushed.is_told(words_of_hd(code)));
        CHECK(pushed.is_told(words_of_hd(hd_no_error)));
        CHECK(eventually([&] { return pushed.is_pushed(); }));
    }
}

TEST_CASE(
    "hd port: a loop of the library's that stands still leaves ours with an old pose, is told, and "
    "goes on") {
    PushedTouch pushed;
    (void)pushed.loop.take_oldest_s();
    pushed.stand_in.set("stalled", 1.0);
    CHECK(pushed.is_told(words_of_hd(kHdStandsStill)));
    // What the loop fades at: haptics/link/PROTOCOL.md.
    CHECK(eventually([&] { return pushed.loop.take_oldest_s() > kArmSilence_s; }));
    pushed.stand_in.set("stalled", 0.0);
    CHECK(pushed.is_told(words_of_hd(hd_no_error)));
    CHECK(eventually(
        [&] { return pushed.is_pushed() && pushed.loop.take_oldest_s() < kArmSilence_s; }));
}

TEST_CASE("hd port: a call that hangs for 50 ms leaves our loop with an old pose") {
    PushedTouch pushed;
    (void)pushed.loop.take_oldest_s();
    CHECK(eventually([&] {
        pushed.stand_in.set("hang s", 0.05);
        return pushed.loop.take_oldest_s() > kArmSilence_s;
    }));
    pushed.stand_in.set("hang s", 0.0);
    CHECK(eventually([&] { return pushed.is_pushed(); }));
}

TEST_CASE(
    "hd port: a loop of ours that says nothing is no force, though the library's goes on; then it "
    "is felt again") {
    PushedTouch pushed;
    pushed.loop.be_silent(true);
    CHECK(eventually([&] { return pushed.stand_in.get("force", "x") == 0.0; }));
    CHECK(pushed.loop.is_there());
    pushed.loop.be_silent(false);
    CHECK(eventually([&] { return pushed.is_pushed(); }));
}

TEST_CASE("hd port: stopped it is without force, its loop has ended, and it is closed") {
    const MakerStandIn stand_in(FULCRUM_HD_STAND_IN);
    {
        ArmDevice device(open_touch(stand_in));
        const PortLoop loop(device, [](const Vector3&) { return Vector3{1.0, 0.0, 0.0}; });
        REQUIRE(eventually([&] { return stand_in.get("force", "x") == 1.0; }));
    }
    CHECK(stand_in.get("force output") == 0.0);
    CHECK(stand_in.get("unscheduled") == 1.0);
    CHECK(stand_in.get("scheduler") == 0.0);
    CHECK(stand_in.get("open") == 0.0);
    CHECK(stand_in.get("force", "x") == 0.0);
}

TEST_CASE("hd port: an arm whose loop never runs is refused, and put away") {
    const MakerStandIn stand_in(FULCRUM_HD_STAND_IN);
    stand_in.set("stalled", 1.0);
    const auto port = open_hd({.library = stand_in.path()});
    REQUIRE_FALSE(port);
    CHECK(port.error().message.find("its loop does not run") != std::string::npos);
    CHECK(stand_in.get("open") == 0.0);
    stand_in.set("stalled", 0.0);
    CHECK(eventually([&] { return open_hd({.library = stand_in.path()}).has_value(); }));
}

TEST_CASE(
    "hd port: whoever stops one that hangs does not wait for it; it ends without force when the "
    "call does") {
    const MakerStandIn stand_in(FULCRUM_HD_STAND_IN);
    auto port = open_touch(stand_in);
    stand_in.set("hang s", 2.0 * kHdFarewell_s);
    // It is caught in the call once it took the order to hang.
    REQUIRE(eventually([&] { return stand_in.get("hang s") == 0.0; }));
    port.reset();
    CHECK(stand_in.get("open") == 1.0);
    CHECK(eventually([&] { return stand_in.get("open") == 0.0; }));
    CHECK(stand_in.get("force output") == 0.0);
    CHECK(eventually([&] { return open_hd({.library = stand_in.path()}).has_value(); }));
}

TEST_CASE(
    "hd port: in a library that lets go while it is in a call the call's end finds what it needs, "
    "and no other arm is opened before") {
    const MakerStandIn stand_in(FULCRUM_HD_STAND_IN);
    stand_in.set("unschedules at once", 1.0);
    auto port = open_touch(stand_in);
    stand_in.set("hang s", 1.0);
    REQUIRE(eventually([&] { return stand_in.get("hang s") == 0.0; }));
    port.reset();
    // Closed, and a tick of it still hangs: nothing is waited for, nor taken from under it.
    REQUIRE(eventually([&] { return stand_in.get("open") == 0.0; }));
    if (stand_in.get("ended") == 0.0) {
        CHECK_FALSE(open_hd({.library = stand_in.path()}));
    }
    CHECK(eventually([&] { return stand_in.get("ended") == 1.0; }));
    CHECK(stand_in.get("force", "x") == 0.0);
    CHECK(eventually([&] { return open_hd({.library = stand_in.path()}).has_value(); }));
}

}  // namespace fulcrum::runtime
