#include "haptics/device/fitted/axis_order.h"
#include "haptics/device/fitted/fitted_device.h"
#include "haptics/loop/haptic_loop.h"
#include "haptics/loop/safety.h"
#include "haptics/math/rotation.h"
#include "tests/support/scripted_device.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <string>
#include <vector>

using namespace fulcrum;

namespace {

constexpr double kRounding = 1e-12;

std::vector<std::string> all_orders() {
    std::vector<std::string> orders;
    std::string letters = "xyz";
    do {
        for (int signs = 0; signs < 8; ++signs) {
            std::string words;
            for (int i = 0; i < 3; ++i) {
                words += i > 0 ? "," : "";
                words += (signs >> i & 1) != 0 ? "-" : "";
                words += letters[static_cast<std::size_t>(i)];
            }
            orders.push_back(words);
        }
    } while (std::next_permutation(letters.begin(), letters.end()));
    return orders;
}

constexpr double kStep_s = 0.001;
constexpr int kClutch = 3;
constexpr std::uint32_t kClutchBit = 4;

struct Fitted {
    explicit Fitted(const DeviceFit& fit) {
        auto inner = std::make_unique<ScriptedDevice>();
        arm = inner.get();
        device = std::make_unique<FittedDevice>(fit, std::move(inner));
    }
    DeviceReading read(double now_s = 0.0) const {
        DeviceReading reading;
        REQUIRE(device->read(now_s, reading));
        return reading;
    }
    ScriptedDevice* arm = nullptr;
    std::unique_ptr<FittedDevice> device;
};

// A spring of 200 N/m at the middle, felt through the loop.
struct Pulled {
    explicit Pulled(double scale = 1.0) : fitted({.clutch_button = kClutch}) {
        HapticPlan plan;
        FieldPlan spring;
        spring.kind = FieldKind::spring;
        spring.stiffness_N_per_m = 200.0 / scale;
        plan.workspace.scale = scale;
        plan.fields.push_back(spring);
        REQUIRE(validate(plan));
        loop = std::make_unique<HapticLoop>(plan, *fitted.device, *channels);
    }
    // One round with the arm there; the largest change of the force is kept.
    void step(const Vector3& place_A, bool clutch) {
        now_s += kStep_s;
        ForceCommand command;
        command.stamp_s = now_s;
        command.lesson_alive = true;
        channels->command.publish(command);
        fitted.arm->pose_D = Pose::at(place_A);
        fitted.arm->buttons = clutch ? kClutchBit : 0;
        const Vector3 before_N = fitted.arm->written_D.force;
        const Vector3 place_W = loop->state().tool_pose_W.position;
        loop->step(now_s);
        largest_step_N = std::max(largest_step_N, (fitted.arm->written_D.force - before_N).norm());
        largest_jump_m =
            std::max(largest_jump_m, (loop->state().tool_pose_W.position - place_W).norm());
    }
    [[nodiscard]] double force_N() const { return fitted.arm->written_D.force.norm(); }

    Fitted fitted;
    std::unique_ptr<HapticChannels> channels = std::make_unique<HapticChannels>();
    std::unique_ptr<HapticLoop> loop;
    double now_s = 0.0;
    double largest_step_N = 0.0;
    double largest_jump_m = 0.0;
};

}  // namespace

// Signed permutations, all 48 of them: power stays, turns stay turns, and what is none is refused.

TEST_CASE("axis order: each of the 48 is read, says itself again and is another") {
    std::set<std::string> seen;
    for (const std::string& words : all_orders()) {
        const auto order = AxisOrder::read(words);
        REQUIRE(order);
        CHECK(order->text() == words);
        CHECK((order->matrix() * order->matrix().transpose() - Matrix3::Identity()).norm() == 0.0);
        seen.insert(order->text());
    }
    CHECK(seen.size() == 48);
    CHECK(AxisOrder{}.text() == "x,y,z");
    CHECK(AxisOrder::read("+x,+y,+z")->is_plain());
}

TEST_CASE("axis order: what the person's right is stands first") {
    const auto order = AxisOrder::read("-z,y,x");
    REQUIRE(order);
    CHECK(order->turn(Vector3(1.0, 2.0, 3.0)) == Vector3(-3.0, 2.0, 1.0));
    CHECK(order->turn_back({{-3.0, 2.0, 1.0}, Vector3::Zero()}).force == Vector3(1.0, 2.0, 3.0));
}

// v_D = A v_A and w_D of the turned pose; the hand's power must be the same in both frames, mirrors included.
TEST_CASE("axis order: the power of force and torque is the same at the arm and in the scene") {
    const Vector3 velocity_A(0.3, -0.2, 0.5);
    const Vector3 turning_A(0.7, 0.4, -0.9);
    const Wrench felt_D{{1.0, -2.0, 0.5}, {0.1, 0.02, -0.07}};
    const Quaternion before_A = compute_exp(Vector3(0.2, -0.5, 0.3));
    constexpr double kStep_s = 1e-6;
    constexpr double kDifference = 1e-6;  // of a quotient over that step
    const Quaternion after_A = compute_exp(Vector3(turning_A * kStep_s)) * before_A;
    for (const std::string& words : all_orders()) {
        const AxisOrder order = *AxisOrder::read(words);
        const Wrench given_A = order.turn_back(felt_D);
        CHECK(given_A.force.norm() == Approx(felt_D.force.norm()).epsilon(kRounding));
        CHECK(given_A.torque.norm() == Approx(felt_D.torque.norm()).epsilon(kRounding));
        CHECK(given_A.force.dot(velocity_A) ==
              Approx(felt_D.force.dot(order.turn(velocity_A))).margin(kRounding));
        const Vector3 turning_D =
            compute_log(order.turn(after_A) * order.turn(before_A).conjugate()) / kStep_s;
        CHECK(given_A.torque.dot(turning_A) ==
              Approx(felt_D.torque.dot(turning_D)).margin(kDifference));
        // A turned pose is the turned vector's: A (R v) = R' (A v).
        const Vector3 v(0.4, 1.0, -2.0);
        CHECK((order.turn(Vector3(before_A * v)) - order.turn(before_A) * order.turn(v)).norm() <
              kRounding);
    }
}

TEST_CASE("axis order: a matrix is one when it is a signed permutation, and else none") {
    for (const std::string& words : all_orders()) {
        CHECK(AxisOrder::of(AxisOrder::read(words)->matrix())->text() == words);
    }
    CHECK_FALSE(AxisOrder::of(Matrix3::Zero()));
    CHECK_FALSE(AxisOrder::of(0.5 * Matrix3::Identity()));
    CHECK_FALSE(AxisOrder::of(Matrix3::Ones()));
    Matrix3 twice = Matrix3::Identity();
    twice.row(1) = twice.row(0);
    CHECK_FALSE(AxisOrder::of(twice));
    CHECK_FALSE(AxisOrder::of(Matrix3::Constant(std::nan(""))));
}

TEST_CASE("axis order: what is none is refused, with how one is written") {
    for (const char* words : {"", "x", "x,y", "x,y,z,", "x,y,z,x", "x,x,z", "x,y,w", "--x,y,z",
                              "x y z", "X,y,z", ",,", "-,y,z", "x,y,-"}) {
        const auto order = AxisOrder::read(words);
        CAPTURE(words);
        REQUIRE_FALSE(order);
        CHECK(to_sentence(order.error()).find("-x,y,z") != std::string::npos);
    }
}

// A device before a person: middle, axes, buttons, and the clutch, alone and through the whole loop.

TEST_CASE("fitted device: p_D = A (p_A - m), forces go back by A^T") {
    const Fitted fitted({.axes = *AxisOrder::read("-x,z,y"), .middle_A = {0.1, 0.2, 0.3}});
    fitted.arm->pose_D = Pose::at({0.4, 0.6, 0.8});
    const DeviceReading reading = fitted.read();
    CHECK((reading.pose_D.position - Vector3(-0.3, 0.5, 0.4)).norm() < kRounding);
    REQUIRE(fitted.device->write(0.0, {{1.0, 2.0, 3.0}, Vector3::Zero()}));
    CHECK((fitted.arm->written_D.force - Vector3(-1.0, 3.0, 2.0)).norm() < kRounding);
    CHECK(fitted.device->traits().max_force_N == fitted.arm->traits_.max_force_N);
}

TEST_CASE("fitted device: while the clutch is held the hand stays, and goes on from there") {
    const Fitted fitted({.axes = *AxisOrder::read("z,y,-x"), .clutch_button = kClutch});
    const Quaternion turned = compute_exp(Vector3(0.1, 0.3, -0.2));
    fitted.arm->pose_D = {{0.05, 0.0, 0.0}, turned};
    const Pose before = fitted.read().pose_D;
    // Held: wherever the arm goes and turns.
    fitted.arm->buttons = kClutchBit | 1U;
    for (int i = 0; i < 50; ++i) {
        const DeviceReading held = fitted.read();
        CHECK((held.pose_D.position - before.position).norm() < kRounding);
        CHECK(held.pose_D.orientation.angularDistance(before.orientation) < 1e-7);
        CHECK(any(held.faults & Fault::clutched));
        CHECK(held.buttons == 1U);
        fitted.arm->pose_D.position += Vector3(-0.002, 0.001, 0.0005);
        fitted.arm->pose_D.orientation =
            compute_exp(Vector3(0.0, 0.01, 0.0)) * fitted.arm->pose_D.orientation;
    }
    // Let go: from there on, by the same way as the arm.
    fitted.arm->buttons = 0;
    const DeviceReading released = fitted.read();
    CHECK(released.faults == Fault::none);
    CHECK((released.pose_D.position - before.position).norm() < kRounding);
    CHECK(released.pose_D.orientation.angularDistance(before.orientation) < 1e-7);
    fitted.arm->pose_D.position += Vector3(0.01, 0.02, 0.03);
    fitted.arm->pose_D.orientation =
        compute_exp(Vector3(0.2, 0.0, 0.0)) * fitted.arm->pose_D.orientation;
    const DeviceReading after = fitted.read();
    CHECK((after.pose_D.position - before.position - Vector3(0.03, 0.02, -0.01)).norm() <
          kRounding);
    // A turn about the arm's x is one about the person's -z, whatever the clutch has turned before.
    const Vector3 turn = compute_log(after.pose_D.orientation * before.orientation.conjugate());
    CHECK((turn - Vector3(0.0, 0.0, -0.2)).norm() < 1e-9);
}

TEST_CASE("fitted device: a left hand's buttons change places; what is no reading is told on") {
    const Fitted left({.clutch_button = 2, .left_handed = true});
    left.arm->buttons = 2U;
    DeviceReading reading = left.read();
    CHECK(reading.buttons == 1U);
    CHECK(reading.faults == Fault::none);
    left.arm->buttons = 1U | 8U;
    reading = left.read();
    CHECK(reading.buttons == 8U);
    CHECK(any(reading.faults & Fault::clutched));
    const Fitted right({.clutch_button = 2});
    right.arm->buttons = 3U;
    CHECK(right.read().buttons == 1U);
    const Fitted fitted({.clutch_button = kClutch});
    fitted.arm->pose_D = Pose::at({0.1, 0.0, 0.0});
    (void)fitted.read();
    fitted.arm->buttons = kClutchBit;
    (void)fitted.read();
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
        fitted.arm->pose_D = Pose::at({bad, 0.0, 0.0});
        CHECK_FALSE(is_reading(fitted.read()));
    }
    fitted.arm->gives_pose = false;
    DeviceReading none;
    CHECK_FALSE(fitted.device->read(0.0, none));
    fitted.arm->gives_pose = true;
    fitted.arm->pose_D = Pose::at({-0.3, 0.0, 0.0});
    fitted.arm->buttons = 0;
    CHECK((fitted.read().pose_D.position - Vector3(0.1, 0.0, 0.0)).norm() < kRounding);
    // A wrench that is none is the device's to refuse.
    fitted.arm->takes_wrench = false;
    CHECK_FALSE(fitted.device->write(0.0, {}));
}

TEST_CASE("fitted device: one that is to give no force gives none, whatever is written") {
    const Fitted fitted({.axes = *AxisOrder::read("y,x,z")});
    CHECK(fitted.device->traits().renders_force);
    REQUIRE(fitted.device->write(0.0, {{1.0, 0.0, 0.0}, {0.0, 0.1, 0.0}}));
    CHECK(fitted.arm->written_D.force.y() == 1.0);
    fitted.device->give_no_force();
    REQUIRE(fitted.device->write(0.0, {{1.0, 2.0, 3.0}, {0.1, 0.1, 0.1}}));
    CHECK(fitted.arm->written_D.force.isZero(0.0));
    CHECK(fitted.arm->written_D.torque.isZero(0.0));
    CHECK_FALSE(fitted.device->traits().renders_force);
    CHECK(fitted.device->traits().max_force_N == 0.0);
    // It still tells where it is.
    fitted.arm->pose_D = Pose::at({0.1, 0.0, 0.0});
    CHECK(fitted.read().pose_D.position.y() == 0.1);
}

TEST_CASE(
    "fitted device: one of unknown strength is written a part of each wrench, until all of it") {
    const Fitted fitted({.axes = *AxisOrder::read("y,x,z")});
    const Wrench asked{{1.0, 2.0, 3.0}, {0.1, 0.2, 0.3}};
    fitted.device->give_part(0.25);
    REQUIRE(fitted.device->write(0.0, asked));
    CHECK((fitted.arm->written_D.force - Vector3(0.5, 0.25, 0.75)).norm() < kRounding);
    CHECK(fitted.arm->written_D.torque.norm() == Approx(0.25 * asked.torque.norm()));
    fitted.device->give_part(1.0);
    REQUIRE(fitted.device->write(0.0, asked));
    CHECK(fitted.arm->written_D.force.norm() == Approx(asked.force.norm()));
    for (const double bad : {-0.1, 1.1, std::nan("")}) {
        fitted.device->give_part(bad);
        REQUIRE(fitted.device->write(0.0, asked));
        CHECK(fitted.arm->written_D.force.isZero(0.0));
    }
    // One that is to give none stays without.
    fitted.device->give_no_force();
    fitted.device->give_part(1.0);
    REQUIRE(fitted.device->write(0.0, asked));
    CHECK(fitted.arm->written_D.force.isZero(0.0));
}

TEST_CASE(
    "fitted device: the clutch fades the force, keeps it away and lets it come softly; nothing "
    "jumps") {
    const SafetySettings safety;
    for (const double scale : {1.0, 3.0}) {
        Pulled pulled(scale);
        // The gate opens where nothing is felt, then the hand is drawn out to 2 N.
        for (int i = 0; i < 3000; ++i) {
            pulled.step(Vector3::Zero(), false);
        }
        for (int i = 1; i <= 500; ++i) {
            pulled.step({0.01 * i / 500.0, 0.0, 0.0}, false);
        }
        // The same spring in the hand at every scale.
        CHECK(pulled.force_N() == Approx(2.0).epsilon(1e-3));
        pulled.largest_step_N = 0.0;
        pulled.largest_jump_m = 0.0;
        // Clutched: gone within the fade, and the arm goes home freely.
        for (int i = 0; i < 500; ++i) {
            pulled.step({0.01 - 0.03 * i / 500.0, 0.0, 0.0}, true);
            if (kStep_s * i > safety.fade_s + kStep_s) {
                CHECK(pulled.force_N() == 0.0);
            }
        }
        CHECK(pulled.loop->state().gate == GatePhase::waiting);
        CHECK(pulled.largest_jump_m < 1e-9);
        // Let go with 2 N asked for: nothing comes before the hand has rested.
        for (int i = 0; i < 499; ++i) {
            pulled.step({-0.02, 0.0, 0.0}, false);
            CHECK(pulled.force_N() == 0.0);
        }
        CHECK(pulled.loop->state().tool_pose_W.position.x() == Approx(0.01 * scale));
        for (int i = 0; i < 1000; ++i) {
            pulled.step({-0.02 - 0.01 * i / 1000.0, 0.0, 0.0}, false);
        }
        // And softly then.
        const double before_N = pulled.force_N();
        pulled.largest_step_N = std::max(pulled.largest_step_N, before_N);
        for (int i = 0; i < 100; ++i) {
            pulled.step({-0.03 + 0.02 * i / 100.0, 0.0, 0.0}, false);
        }
        CHECK(pulled.force_N() > 0.1);
        CHECK(pulled.force_N() <= before_N + safety.soft_start_N_per_s * 0.1 + 1e-9);
        CHECK(pulled.largest_step_N <= safety.max_slew_N_per_s * kStep_s + kRounding);
    }
}
