#include "haptics/device/stand_in/stand_in_device.h"

#include "haptics/loop/haptic_loop.h"
#include "haptics/math/rotation.h"
#include "tests/support/scripted_device.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace fulcrum;

namespace {

constexpr double kRound_s = 0.001;
const int kPatience = static_cast<int>(StandInDevice::kPatience_s / kRound_s);

// A scripted device that can be unplugged, and a mouse.
struct Desk {
    Desk() {
        auto made = std::make_unique<ScriptedDevice>();
        device = made.get();
        both = std::make_unique<StandInDevice>(
            std::move(made), std::make_unique<PointerDevice>(PointerSettings{}, target));
    }
    bool read() {
        now_s += kRound_s;
        reading = {};
        return both->read(now_s, reading);
    }
    // How many of n reads gave a pose.
    int read(int n) {
        int good = 0;
        for (int i = 0; i < n; ++i) {
            good += read() ? 1 : 0;
        }
        return good;
    }

    LatestValue<PointerTarget> target;
    ScriptedDevice* device = nullptr;
    std::unique_ptr<StandInDevice> both;
    DeviceReading reading{};
    double now_s = 0.0;
};

}  // namespace

TEST_CASE("stand-in: a device that is there is told and served as it is") {
    Desk desk;
    desk.device->pose_D = {Vector3(0.1, 0.2, 0.3), compute_exp(Vector3(0.0, 0.4, 0.0))};
    desk.device->buttons = 5;
    desk.target.publish({Vector3(-0.1, 0.0, 0.0), 2});
    REQUIRE(desk.read(10) == 10);
    CHECK(desk.reading.pose_D.position == Vector3(0.1, 0.2, 0.3));
    CHECK(desk.reading.buttons == 5);
    CHECK_FALSE(any(desk.reading.faults));
    CHECK_FALSE(desk.both->stands_in());
    const Wrench wrench{Vector3(1.0, 2.0, 3.0), Vector3(0.1, 0.0, 0.0)};
    CHECK(desk.both->write(desk.now_s, wrench));
    CHECK(desk.device->written_D.force == wrench.force);
    CHECK(desk.device->written_D.torque == wrench.torque);
    desk.device->takes_wrench = false;
    CHECK_FALSE(desk.both->write(desk.now_s, wrench));
}

TEST_CASE(
    "stand-in: what is gone for half a second is moved by the pointer from where it was, without "
    "force") {
    Desk desk;
    const Quaternion turned = compute_exp(Vector3(0.0, 0.4, 0.0));
    desk.device->pose_D = {Vector3(0.05, 0.02, 0.03), turned};
    desk.target.publish({Vector3(-0.1, 0.0, 0.0), 1});
    REQUIRE(desk.read());
    desk.device->gives_pose = false;
    // Nobody moves it first, and the loop knows that.
    CHECK(desk.read(kPatience - 2) == 0);
    CHECK_FALSE(desk.both->stands_in());
    while (!desk.read()) {
        REQUIRE(desk.now_s < 2.0);
    }
    CHECK(desk.both->stands_in());
    CHECK(any(desk.reading.faults & Fault::clutched));
    CHECK((desk.reading.pose_D.position - Vector3(0.05, 0.02, 0.03)).norm() < 0.004);
    CHECK(desk.reading.pose_D.orientation.isApprox(turned));
    // It goes on to where the mouse points, no faster than a hand.
    for (int i = 0; i < 500; ++i) {
        const Vector3 before_D = desk.reading.pose_D.position;
        REQUIRE(desk.read());
        REQUIRE_FALSE(any(desk.reading.faults));
        REQUIRE((desk.reading.pose_D.position - before_D).norm() <= 3.0 * kRound_s + 1e-12);
        REQUIRE(desk.reading.stamp_s == desk.now_s);
    }
    CHECK((desk.reading.pose_D.position - Vector3(-0.1, 0.0, 0.0)).norm() < 1e-6);
    CHECK(desk.reading.buttons == 1);
    CHECK(desk.both->write(desk.now_s, {Vector3(3.0, 0.0, 0.0), Vector3::Zero()}));
    CHECK(desk.device->written_D.force.isZero(0.0));
}

TEST_CASE(
    "stand-in: what is plugged in again has the hand at once, and no force before none was asked "
    "for") {
    Desk desk;
    REQUIRE(desk.read());
    desk.device->gives_pose = false;
    desk.target.publish({Vector3(0.1, 0.0, 0.0), 0});
    desk.read(2 * kPatience);
    REQUIRE(desk.both->stands_in());
    desk.device->gives_pose = true;
    desk.device->pose_D.position = {0.0, 0.07, 0.0};
    REQUIRE(desk.read());
    CHECK_FALSE(desk.both->stands_in());
    CHECK(desk.reading.pose_D.position == Vector3(0.0, 0.07, 0.0));
    CHECK(any(desk.reading.faults & Fault::clutched));
    REQUIRE(desk.read());
    CHECK_FALSE(any(desk.reading.faults));
    // A gate that fades what the pointer would have felt.
    for (double force_N = 3.0; force_N > 0.5; force_N -= 0.5) {
        CHECK(desk.both->write(desk.now_s, {Vector3(force_N, 0.0, 0.0), Vector3::Zero()}));
        CHECK(desk.device->written_D.force.isZero(0.0));
    }
    // Torque alone is some too.
    (void)desk.both->write(desk.now_s, {Vector3::Zero(), Vector3(0.1, 0.0, 0.0)});
    CHECK(desk.device->written_D.torque.isZero(0.0));
    (void)desk.both->write(desk.now_s, {});
    (void)desk.both->write(desk.now_s, {Vector3(0.5, 0.0, 0.0), Vector3::Zero()});
    CHECK(desk.device->written_D.force.x() == 0.5);
}

TEST_CASE(
    "stand-in: a device that stutters is not given up, and one that never was there is nobody's") {
    Desk desk;
    desk.target.publish({});
    desk.device->gives_pose = false;
    CHECK(desk.read(3 * kPatience) == 0);
    CHECK_FALSE(desk.both->stands_in());
    desk.device->gives_pose = true;
    for (int i = 0; i < 20; ++i) {
        desk.device->gives_pose = i % 2 == 0;
        desk.read(kPatience / 2);
        CHECK_FALSE(desk.both->stands_in());
    }
}

TEST_CASE(
    "stand-in: through a loop the force fades, stays away from the device, and comes back softly") {
    Desk desk;
    HapticPlan plan;
    plan.expects_lesson = false;
    plan.fields = {FieldPlan{FieldKind::spring, Vector3::Zero(), 50.0}};
    auto channels = std::make_unique<HapticChannels>();
    HapticLoop loop(plan, *desk.both, *channels);
    double most_step_N = 0.0;
    const auto run = [&](int n, double most_N) {
        for (int i = 0; i < n; ++i) {
            const double before_N = desk.device->written_D.force.norm();
            loop.step(desk.now_s += kRound_s);
            const double now_N = desk.device->written_D.force.norm();
            most_step_N = std::max(most_step_N, now_N - before_N);
            REQUIRE(now_N <= most_N);
        }
    };
    const auto go_to = [&](double x_m, double most_N) {
        for (int i = 0; i < 200; ++i) {
            desk.device->pose_D.position.x() +=
                (x_m - desk.device->pose_D.position.x()) / (200 - i);
            run(1, most_N);
        }
    };
    run(3000, 5.0);
    go_to(0.05, 5.0);
    run(1000, 5.0);
    REQUIRE(desk.device->written_D.force.norm() == Approx(2.5).epsilon(1e-6));
    desk.device->gives_pose = false;
    run(110, 2.5 + 1e-9);
    CHECK(desk.device->written_D.force.isZero(0.0));
    // The mouse goes on to the middle, where the gate opens, and far out.
    desk.target.publish({Vector3::Zero(), 0});
    run(2000, 0.0);
    REQUIRE(desk.both->stands_in());
    desk.target.publish({Vector3(0.06, 0.0, 0.0), 0});
    run(4000, 0.0);
    CHECK(loop.state().applied_W.force.norm() > 2.0);  // what is seen and heard instead
    // Plugged in while that is asked for.
    desk.device->gives_pose = true;
    most_step_N = 0.0;
    run(500, 0.0);
    go_to(0.0, 0.2);  // where the gate calls it calm
    run(20, 0.2);
    go_to(0.05, 1.3);
    run(10, 1.3);  // 5 N/s
    CHECK(desk.device->written_D.force.norm() > 0.5);
    CHECK(most_step_N <= 0.0051);
}
