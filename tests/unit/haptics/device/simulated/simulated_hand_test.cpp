#include "haptics/device/simulated/simulated_hand.h"

#include "haptics/math/rotation.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace fulcrum;

namespace {

constexpr double kDt_s = 0.001;
constexpr double kRounding = 1e-9;

// Reads the hand `n` times and gives where it ended.
DeviceReading read_on(SimulatedHand& hand, double& now_s, int n, double dt_s = kDt_s) {
    DeviceReading reading;
    for (int i = 0; i < n; ++i) {
        now_s += dt_s;
        REQUIRE(hand.read(now_s, reading));
    }
    return reading;
}

HandTarget at(const Vector3& position_D) {
    HandTarget target;
    target.pose_D.position = position_D;
    return target;
}

}  // namespace

TEST_CASE("simulated hand: goes to its target, and a force moves it by f / k") {
    const SimulatedHandSettings settings;
    LatestValue<HandTarget> target;
    SimulatedHand hand(settings, target);
    double now_s = 0.0;
    target.publish(at(Vector3(0.1, 0.2, -0.05)));
    CHECK((read_on(hand, now_s, 2000).pose_D.position - Vector3(0.1, 0.2, -0.05)).norm() < 1e-6);
    CHECK(hand.write(now_s, {Vector3(0.0, -3.0, 0.0), Vector3::Zero()}));
    const DeviceReading loaded = read_on(hand, now_s, 2000);
    CHECK((loaded.pose_D.position - Vector3(0.1, 0.2 - 3.0 / 300.0, -0.05)).norm() < 1e-6);
    CHECK(loaded.stamp_s == now_s);
}

TEST_CASE("simulated hand: the way there does not depend on the time step") {
    const SimulatedHandSettings settings;
    Vector3 ends[3];
    int i = 0;
    for (const int n : {1, 10, 1000}) {
        LatestValue<HandTarget> target;
        SimulatedHand hand(settings, target);
        DeviceReading reading;
        REQUIRE(hand.read(0.0, reading));
        target.publish(at(Vector3(0.1, 0.0, 0.0)));
        REQUIRE(hand.write(0.0, {Vector3(0.0, 2.0, 0.0), Vector3::Zero()}));
        double now_s = 0.0;
        ends[i++] = read_on(hand, now_s, n, 0.1 / n).pose_D.position;
    }
    CHECK((ends[0] - ends[1]).norm() < kRounding);
    CHECK((ends[0] - ends[2]).norm() < kRounding);
    CHECK(ends[0].norm() > 0.01);
}

TEST_CASE("simulated hand: follows a moving target without lag when told its velocity") {
    const SimulatedHandSettings settings;
    LatestValue<HandTarget> target;
    SimulatedHand hand(settings, target);
    double now_s = 0.0;
    double lag_m = 0.0;
    for (int k = 0; k < 3000; ++k) {
        HandTarget moving = at(Vector3(0.1 * (now_s + kDt_s), 0.0, 0.0));
        moving.velocity_D = Vector3(0.1, 0.0, 0.0);
        target.publish(moving);
        lag_m = moving.pose_D.position.x() - read_on(hand, now_s, 1).pose_D.position.x();
    }
    CHECK(std::abs(lag_m) <
          0.1 * kDt_s);  // a step's way at most; without the velocity b v / k = 6.7 mm
    CHECK(hand.velocity_D().x() == Approx(0.1).epsilon(1e-4));  // the target steps, so it ripples
}

TEST_CASE("simulated hand: turns to its target, and a torque turns it by tau / k") {
    const SimulatedHandSettings settings;
    LatestValue<HandTarget> target;
    SimulatedHand hand(settings, target);
    HandTarget turned;
    const Vector3 turn(0.3, -0.5, 0.2);
    turned.pose_D.orientation = compute_exp(turn);
    target.publish(turned);
    double now_s = 0.0;
    const DeviceReading there = read_on(hand, now_s, 3000);
    CHECK((compute_log(there.pose_D.orientation) - turn).norm() < 1e-6);
    CHECK(hand.write(now_s, {Vector3::Zero(), Vector3(0.0, 0.0, 0.3)}));
    const DeviceReading loaded = read_on(hand, now_s, 3000);
    const Quaternion away = loaded.pose_D.orientation * turned.pose_D.orientation.conjugate();
    CHECK((compute_log(away) - Vector3(0.0, 0.0, 0.1)).norm() < 1e-6);
    CHECK(loaded.pose_D.orientation.coeffs().norm() == Approx(1.0).epsilon(1e-14));
}

TEST_CASE("simulated hand: an encoder shows whole steps only") {
    SimulatedHandSettings settings;
    settings.position_resolution_m = 0.001;
    LatestValue<HandTarget> target;
    SimulatedHand hand(settings, target);
    target.publish(at(Vector3(0.02, 0.013, 0.0)));
    double now_s = 0.0;
    for (int k = 0; k < 500; ++k) {
        const Vector3 steps = read_on(hand, now_s, 1).pose_D.position / 0.001;
        REQUIRE((steps - Vector3(steps.cwiseRound())).norm() < kRounding);
    }
    CHECK(hand.traits().position_resolution_m == 0.001);
}

TEST_CASE("simulated hand: what is not finite is refused and forgotten") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const SimulatedHandSettings settings;
    LatestValue<HandTarget> target;
    SimulatedHand hand(settings, target);
    double now_s = 0.0;
    CHECK_FALSE(hand.write(now_s, {Vector3(nan, 0.0, 0.0), Vector3::Zero()}));
    target.publish(at(Vector3(nan, 0.0, 0.0)));
    CHECK(read_on(hand, now_s, 100).pose_D.position.norm() == 0.0);
    HandTarget no_turn;
    no_turn.pose_D.orientation.coeffs().setZero();
    target.publish(no_turn);
    CHECK(is_finite(read_on(hand, now_s, 100).pose_D));
    target.publish(at(Vector3(0.1, 0.0, 0.0)));
    CHECK(read_on(hand, now_s, 3000).pose_D.position.x() == Approx(0.1));
}

TEST_CASE("simulated hand: reset puts it back, and the same input moves it to the same bits") {
    const SimulatedHandSettings settings;
    LatestValue<HandTarget> target;
    SimulatedHand hand(settings, target);
    target.publish(at(Vector3(0.03, -0.07, 0.11)));
    double now_s = 0.0;
    const Vector3 first = read_on(hand, now_s, 777).pose_D.position;
    hand.reset();
    now_s = 0.0;
    const Vector3 again = read_on(hand, now_s, 777).pose_D.position;
    CHECK(first == again);
    CHECK(first.norm() > 0.05);
}

TEST_CASE("simulated hand: turns like a damped oscillator in closed form, whatever the steps") {
    const SimulatedHandSettings settings;
    LatestValue<HandTarget> target;
    SimulatedHand hand(settings, target);
    DeviceReading reading;
    REQUIRE(hand.read(0.0, reading));
    HandTarget turned;
    turned.pose_D.orientation = compute_exp(Vector3(0.0, 0.0, 0.4));
    target.publish(turned);
    // Underdamped: e = -0.4 e^(-at) (cos wt + a/w sin wt).
    const double a = 0.5 * settings.turn_damping_Nms_per_rad / settings.inertia_kg_m2;
    const double w = std::sqrt(settings.turn_stiffness_Nm_per_rad / settings.inertia_kg_m2 - a * a);
    double t_s = 0.0;
    for (int k = 0; k < 300; ++k) {
        t_s += k % 2 == 0 ? 0.001 : 0.0013;
        REQUIRE(hand.read(t_s, reading));
        const double left = std::exp(-a * t_s) * (std::cos(w * t_s) + a / w * std::sin(w * t_s));
        REQUIRE(compute_log(reading.pose_D.orientation).z() ==
                Approx(0.4 * (1.0 - left)).margin(1e-9));
    }
}

TEST_CASE("simulated hand: what the encoder shows is half a step from the truth at most") {
    SimulatedHandSettings settings;
    LatestValue<HandTarget> target;
    LatestValue<HandTarget> same_target;
    SimulatedHand exact(settings, target);
    settings.position_resolution_m = 0.001;
    SimulatedHand counted(settings, same_target);
    target.publish(at(Vector3(0.2, -0.13, 0.0)));
    same_target.publish(at(Vector3(0.2, -0.13, 0.0)));
    double now_s = 0.0;
    double same_now_s = 0.0;
    for (int k = 0; k < 1000; ++k) {
        const Vector3 difference = read_on(exact, now_s, 1).pose_D.position -
                                   read_on(counted, same_now_s, 1).pose_D.position;
        REQUIRE(difference.cwiseAbs().maxCoeff() <= 0.0005 + kRounding);
    }
}

TEST_CASE("simulated hand: a time that is no number moves nothing, first or later") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    LatestValue<HandTarget> target;
    SimulatedHand hand(SimulatedHandSettings{}, target);
    target.publish(at(Vector3(0.1, 0.0, 0.0)));
    DeviceReading reading;
    CHECK(hand.read(nan, reading));
    double now_s = 0.0;
    CHECK(read_on(hand, now_s, 1000).pose_D.position.x() == Approx(0.1).epsilon(1e-3));
    for (const double bad_s : {nan, std::numeric_limits<double>::infinity()}) {
        CHECK(hand.read(bad_s, reading));
        CHECK(is_finite(reading.pose_D));
    }
    target.publish(at(Vector3::Zero()));
    CHECK(std::abs(read_on(hand, now_s, 1000).pose_D.position.x()) < 1e-3);
}
