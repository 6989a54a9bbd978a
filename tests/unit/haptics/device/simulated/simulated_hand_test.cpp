#include "haptics/device/simulated/simulated_hand.h"

#include "haptics/math/rotation.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace fulcrum;

namespace {

constexpr double kDt_s = 0.001;
constexpr double kRounding = 1e-9;

// A hand with its target, and its clock.
struct Bench {
    DeviceReading run(int n, double dt_s = kDt_s) {
        DeviceReading reading;
        for (int i = 0; i < n; ++i) {
            now_s += dt_s;
            REQUIRE(hand.read(now_s, reading));
        }
        return reading;
    }

    LatestValue<HandTarget> target;
    SimulatedHand hand{SimulatedHandSettings{}, target};
    double now_s = 0.0;
};

HandTarget at(const Vector3& position_D) {
    HandTarget target;
    target.pose_D.position = position_D;
    return target;
}

}  // namespace

TEST_CASE("simulated hand: goes to its target, and a force moves it by f / k") {
    Bench bench;
    bench.target.publish(at(Vector3(0.1, 0.2, -0.05)));
    CHECK((bench.run(2000).pose_D.position - Vector3(0.1, 0.2, -0.05)).norm() < 1e-6);
    CHECK(bench.hand.write(bench.now_s, {Vector3(0.0, -3.0, 0.0), Vector3::Zero()}));
    const DeviceReading loaded = bench.run(2000);
    CHECK((loaded.pose_D.position - Vector3(0.1, 0.2 - 3.0 / 300.0, -0.05)).norm() < 1e-6);
    CHECK(loaded.stamp_s == bench.now_s);
}

TEST_CASE("simulated hand: the way there does not depend on the time step") {
    Vector3 ends[3];
    int i = 0;
    for (const int n : {1, 10, 1000}) {
        Bench bench;
        DeviceReading reading;
        REQUIRE(bench.hand.read(0.0, reading));
        bench.target.publish(at(Vector3(0.1, 0.0, 0.0)));
        REQUIRE(bench.hand.write(0.0, {Vector3(0.0, 2.0, 0.0), Vector3::Zero()}));
        ends[i++] = bench.run(n, 0.1 / n).pose_D.position;
    }
    CHECK((ends[0] - ends[1]).norm() < kRounding);
    CHECK((ends[0] - ends[2]).norm() < kRounding);
    CHECK(ends[0].norm() > 0.01);
}

TEST_CASE("simulated hand: follows a moving target without lag when told its velocity") {
    Bench bench;
    double lag_m = 0.0;
    for (int k = 0; k < 3000; ++k) {
        HandTarget moving = at(Vector3(0.1 * (bench.now_s + kDt_s), 0.0, 0.0));
        moving.velocity_D = Vector3(0.1, 0.0, 0.0);
        bench.target.publish(moving);
        lag_m = moving.pose_D.position.x() - bench.run(1).pose_D.position.x();
    }
    CHECK(std::abs(lag_m) <
          0.1 * kDt_s);  // a step's way at most; without the velocity b v / k = 6.7 mm
    CHECK(bench.hand.velocity_D().x() ==
          Approx(0.1).epsilon(1e-4));  // the target steps, so it ripples
}

TEST_CASE("simulated hand: turns to its target, and a torque turns it by tau / k") {
    Bench bench;
    HandTarget turned;
    const Vector3 turn(0.3, -0.5, 0.2);
    turned.pose_D.orientation = compute_exp(turn);
    bench.target.publish(turned);
    const DeviceReading there = bench.run(3000);
    CHECK((compute_log(there.pose_D.orientation) - turn).norm() < 1e-6);
    CHECK(bench.hand.write(bench.now_s, {Vector3::Zero(), Vector3(0.0, 0.0, 0.3)}));
    const DeviceReading loaded = bench.run(3000);
    const Quaternion away = loaded.pose_D.orientation * turned.pose_D.orientation.conjugate();
    CHECK((compute_log(away) - Vector3(0.0, 0.0, 0.1)).norm() < 1e-6);
    CHECK(loaded.pose_D.orientation.coeffs().norm() == Approx(1.0).epsilon(1e-14));
}

TEST_CASE("simulated hand: turns like a damped oscillator in closed form, whatever the steps") {
    const SimulatedHandSettings settings;
    Bench bench;
    DeviceReading reading;
    REQUIRE(bench.hand.read(0.0, reading));
    HandTarget turned;
    turned.pose_D.orientation = compute_exp(Vector3(0.0, 0.0, 0.4));
    bench.target.publish(turned);
    // Underdamped: e = -0.4 e^(-at) (cos wt + a/w sin wt).
    const double a = 0.5 * settings.turn_damping_Nms_per_rad / settings.inertia_kg_m2;
    const double w = std::sqrt(settings.turn_stiffness_Nm_per_rad / settings.inertia_kg_m2 - a * a);
    double t_s = 0.0;
    for (int k = 0; k < 300; ++k) {
        t_s += k % 2 == 0 ? 0.001 : 0.0013;
        REQUIRE(bench.hand.read(t_s, reading));
        const double left = std::exp(-a * t_s) * (std::cos(w * t_s) + a / w * std::sin(w * t_s));
        REQUIRE(compute_log(reading.pose_D.orientation).z() ==
                Approx(0.4 * (1.0 - left)).margin(1e-9));
    }
}
