#include "runtime/arms/dhd/dhd_port.h"

#include "runtime/arms/arm_device.h"
#include "runtime/arms/dhd/dhd_trouble.h"
#include "tests/support/eventually.h"
#include "tests/support/maker_stand_in.h"
#include "tests/support/port_loop.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {
namespace {

using test_support::eventually;
using test_support::MakerStandIn;
using test_support::PortLoop;

std::unique_ptr<ArmPort> open_stand_in(const MakerStandIn& stand_in) {
    auto port = open_dhd({.library = stand_in.path()});
    REQUIRE(port);
    return std::move(*port);
}

PortLoop::Law always(const Vector3& force_D) {
    return [=](const Vector3&) { return force_D; };
}

// An arm that is pushed by 1 N to the right all the time.
struct Pushed {
    MakerStandIn stand_in{FULCRUM_DHD_STAND_IN};
    ArmDevice device{open_stand_in(stand_in)};
    PortLoop loop{device, always({1.0, 0.0, 0.0})};

    // On a machine that is busy the thread itself may be 20 ms late: the watchdog has a test of its own.
    Pushed() {
        stand_in.set("watchdog", 0);
        REQUIRE(eventually([&] { return is_pushed(); }));
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
};

}  // namespace

TEST_CASE(
    "dhd port: a wall along each axis, on each side, holds the hand where the springs balance") {
    // 300 N/m of a fingertip that wants to be at 2 cm, 500 N/m of a wall from 1 cm on: 300 (20 - x) = 500 (x - 10) mm.
    constexpr double kBalance_m = 0.01375;
    constexpr double kNear_m = 2.0e-4;
    const char* const axes[] = {"x", "y", "z"};
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {1.0, -1.0}) {
            INFO(axes[axis] << " " << side);
            const MakerStandIn stand_in(FULCRUM_DHD_STAND_IN);
            ArmDevice device(open_stand_in(stand_in));
            stand_in.set("watchdog", 0);
            const PortLoop loop(device, test_support::make_wall(axis, side * 0.01, 500.0));
            stand_in.set(axes[axis], side * 0.02);
            CHECK(eventually([&] {
                return std::abs(stand_in.get("at", axes[axis]) - side * kBalance_m) < kNear_m &&
                       stand_in.get("force", axes[axis]) * side < -1.5;
            }));
        }
    }
}

TEST_CASE("dhd port: traits are those of the model, within our own limits") {
    const MakerStandIn stand_in(FULCRUM_DHD_STAND_IN);
    const auto port = open_stand_in(stand_in);
    CHECK(port->traits().name == "omega.3 4711");
    CHECK(port->traits().renders_force);
    CHECK(port->traits().max_force_N == 10.0);
    CHECK(port->traits().max_torque_Nm == 0.0);
    CHECK(port->traits().reach_m == Vector3{0.075, 0.075, 0.075});
    CHECK(port->traits().mass_kg == 0.19);
    CHECK(stand_in.get("most force") == 10.0);
    CHECK(validate(port->sensor()));
    CHECK(port->facts()[1] == ArmFact{"dhd version", "3.17.5"});
    CHECK(port->facts()[2] == ArmFact{"dhd watchdog", "20 ms"});

    const MakerStandIn nameless(FULCRUM_DHD_STAND_IN);
    nameless.set("tells no number", 1.0);
    CHECK(open_stand_in(nameless)->traits().name == "omega.3");

    const MakerStandIn sigma(FULCRUM_DHD_STAND_IN);
    sigma.set("type", 104);
    sigma.set("active wrist", 1.0);
    const auto gentle =
        open_dhd({.library = sigma.path(), .max_force_N = 2.0, .max_torque_Nm = 0.1});
    REQUIRE(gentle);
    CHECK((*gentle)->traits().max_force_N == 2.0);
    CHECK((*gentle)->traits().max_torque_Nm == 0.1);
}

TEST_CASE("dhd port: limits that cannot be are refused before anything is loaded") {
    CHECK_FALSE(open_dhd({.library = "/none", .max_force_N = 10.5}));
    const auto refused = open_dhd({.library = "/none", .max_torque_Nm = -1.0});
    REQUIRE_FALSE(refused);
    CHECK(refused.error().message.find("max_torque_Nm") != std::string::npos);
}

TEST_CASE("dhd port: without an arm it says what to look at") {
    const MakerStandIn stand_in(FULCRUM_DHD_STAND_IN);
    stand_in.set("unplugged", 1.0);
    const auto port = open_dhd({.library = stand_in.path()});
    REQUIRE_FALSE(port);
    CHECK(port.error().message == "no arm of Force Dimension answers (no device found)");
    CHECK(port.error().what_to_do.find("USB cable") != std::string::npos);
}

TEST_CASE("dhd port: an arm moves by itself where a person allowed it, and only then") {
    const MakerStandIn stand_in(FULCRUM_DHD_STAND_IN);
    stand_in.set("knows no zero", 1.0);
    const auto refused = open_dhd({.library = stand_in.path()});
    REQUIRE_FALSE(refused);
    CHECK(refused.error().message.find("does not know where its zero is") != std::string::npos);
    CHECK(refused.error().what_to_do.find(kInitialiseOption) != std::string::npos);
    CHECK(stand_in.get("moved by itself") == 0.0);
    CHECK(stand_in.get("force on") == 0.0);
    CHECK(stand_in.get("open") == 0.0);

    stand_in.set("finds no zero", 1.0);
    const auto failed = open_dhd({.library = stand_in.path(), .may_initialise = true});
    REQUIRE_FALSE(failed);
    CHECK(failed.error().message.find("did not find its zero") != std::string::npos);

    stand_in.set("finds no zero", 0.0);
    CHECK(open_dhd({.library = stand_in.path(), .may_initialise = true}));
    CHECK(stand_in.get("moved by itself") == 2.0);
    CHECK(stand_in.get("regulation stopped") == 1.0);
}

TEST_CASE(
    "dhd port: each brake and fault is told, gives no force meanwhile, and is told again when it "
    "is over") {
    Pushed pushed;
    pushed.stand_in.set("brake for", 2);
    CHECK(pushed.is_told(words_of(DhdTrouble::too_fast)));
    CHECK(pushed.is_told(words_of(DhdTrouble::none)));
    CHECK(eventually([&] { return pushed.is_pushed(); }));

    pushed.stand_in.set("no number", 1.0);
    CHECK(pushed.is_told(words_of(DhdTrouble::no_number)));
    CHECK(eventually([&] { return pushed.is_let_go(); }));
    pushed.stand_in.set("no number", 0.0);
    CHECK(eventually([&] { return pushed.is_pushed(); }));
    CHECK(pushed.is_told(words_of(DhdTrouble::none)));

    pushed.stand_in.set("unplugged", 1.0);
    CHECK(pushed.is_told(words_of(DhdTrouble::call_failed)));
    CHECK(eventually([&] { return !pushed.loop.is_there(); }));
    pushed.stand_in.set("unplugged", 0.0);
    CHECK(eventually([&] { return pushed.is_pushed(); }));
}

TEST_CASE(
    "dhd port: a call that hangs leaves the loop with an old pose, and the arm takes its force "
    "away itself") {
    Pushed pushed;
    (void)pushed.loop.take_oldest_s();
    pushed.stand_in.set("watchdog", 160);
    // What the loop fades at: haptics/link/PROTOCOL.md.
    CHECK(eventually([&] {
        pushed.stand_in.set("hang s", 0.05);
        return pushed.loop.take_oldest_s() > kArmSilence_s;
    }));
    CHECK(pushed.is_told(words_of(DhdTrouble::watchdog)));
    pushed.stand_in.set("hang s", 0.0);
    pushed.stand_in.set("watchdog", 0);
    CHECK(eventually([&] { return pushed.is_pushed(); }));
}

TEST_CASE(
    "dhd port: a loop that says nothing is no force, though the thread goes on; then it is felt "
    "again") {
    Pushed pushed;
    pushed.loop.be_silent(true);
    CHECK(eventually([&] { return pushed.stand_in.get("force", "x") == 0.0; }));
    CHECK(pushed.loop.is_there());
    const double orders = pushed.stand_in.get("orders");
    // Its weight is carried by orders alone.
    CHECK(eventually([&] { return pushed.stand_in.get("orders") > orders + 20.0; }));
    pushed.loop.be_silent(false);
    CHECK(eventually([&] { return pushed.is_pushed(); }));
}

TEST_CASE("dhd port: stopped it is without force and closed, and nothing is ordered any more") {
    const MakerStandIn stand_in(FULCRUM_DHD_STAND_IN);
    {
        ArmDevice device(open_stand_in(stand_in));
        stand_in.set("watchdog", 0);
        const PortLoop loop(device, always({1.0, 0.0, 0.0}));
        REQUIRE(eventually([&] { return stand_in.get("force", "x") == 1.0; }));
    }
    CHECK(stand_in.get("force", "x") == 0.0);
    CHECK(stand_in.get("force on") == 0.0);
    CHECK(stand_in.get("open") == 0.0);
}

TEST_CASE(
    "dhd port: whoever stops one that hangs does not wait for it; it ends without force when the "
    "call does") {
    const MakerStandIn stand_in(FULCRUM_DHD_STAND_IN);
    auto port = open_stand_in(stand_in);
    stand_in.set("watchdog", 0);
    REQUIRE(eventually([&] { return stand_in.get("orders") > 3.0; }));
    stand_in.set("hang s", 2.0 * kDhdFarewell_s);
    // It is caught in the call once it took the order to hang.
    REQUIRE(eventually([&] { return stand_in.get("hang s") == 0.0; }));
    port.reset();
    CHECK(stand_in.get("closed") == 0.0);
    CHECK(eventually([&] { return stand_in.get("closed") == 1.0; }));
    CHECK(stand_in.get("force on") == 0.0);
}

}  // namespace fulcrum::runtime
