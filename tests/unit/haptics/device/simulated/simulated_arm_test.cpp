#include "haptics/device/simulated/simulated_arm.h"

#include "haptics/device/simulated/simulated_hand.h"
#include "haptics/math/rotation.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace fulcrum;

namespace {

constexpr double kDt_s = 0.001;
constexpr double kRounding = 1e-12;

HandTarget at(const Vector3& position_D) {
    HandTarget target;
    target.pose_D.position = position_D;
    return target;
}

Wrench push(double x_N) {
    return {Vector3(x_N, 0.0, 0.0), Vector3::Zero()};
}

// An arm with its target, and its clock.
struct Bench {
    explicit Bench(const SimulatedArmSettings& settings) : arm(settings, target) {
        REQUIRE(validate(settings));
        REQUIRE(arm.read(0.0, reading));
    }
    const DeviceReading& run(int n, double dt_s = kDt_s) {
        for (int i = 0; i < n; ++i) {
            now_s += dt_s;
            REQUIRE(arm.read(now_s, reading));
        }
        return reading;
    }

    LatestValue<HandTarget> target;
    SimulatedArm arm;
    DeviceReading reading;
    double now_s = 0.0;
};

SimulatedArmSettings free_arm(double mass_kg) {
    SimulatedArmSettings settings;
    settings.mass_kg = mass_kg;
    settings.human = kNobody;
    return settings;
}

}  // namespace

TEST_CASE("simulated arm: without a fault of its own it is the simulated hand") {
    SimulatedArmSettings settings;
    settings.mass_kg = 0.5;
    settings.human = {0.5, 20.0, 300.0};
    Bench bench(settings);
    LatestValue<HandTarget> target;
    SimulatedHand hand(SimulatedHandSettings{}, target);
    DeviceReading reading;
    REQUIRE(hand.read(0.0, reading));
    for (int k = 0; k < 1000; ++k) {
        HandTarget moving = at(Vector3(0.1 * std::sin(0.01 * k), 0.05, -0.0001 * k));
        moving.velocity_D = Vector3(std::cos(0.01 * k), 0.0, -0.1);
        moving.pose_D.orientation = compute_exp(Vector3(0.0, 0.001 * k, 0.0));
        moving.buttons = 3;
        bench.target.publish(moving);
        target.publish(moving);
        const Wrench wrench{Vector3(std::sin(0.03 * k), -2.0, 0.5), Vector3::Zero()};
        REQUIRE(bench.arm.write(bench.now_s, wrench));
        REQUIRE(hand.write(bench.now_s, wrench));
        bench.run(1);
        REQUIRE(hand.read(bench.now_s, reading));
        REQUIRE((bench.reading.pose_D.position - reading.pose_D.position).norm() < kRounding);
        REQUIRE((bench.arm.velocity_D() - hand.velocity_D()).norm() < 1e-10);
    }
    CHECK(bench.reading.buttons == 3);
    CHECK(bench.reading.pose_D.orientation.angularDistance(compute_exp(Vector3(0.0, 0.999, 0.0))) <
          kRounding);
}

TEST_CASE("simulated arm: let go, it decays by its own viscous friction in closed form") {
    SimulatedArmSettings settings = free_arm(0.05);
    settings.damping_Ns_per_m = 0.4;
    Bench bench(settings);
    REQUIRE(bench.arm.write(0.0, push(1.0)));
    bench.run(100);
    REQUIRE(bench.arm.write(bench.now_s, push(0.0)));
    const double v0 = bench.arm.velocity_D().x();
    CHECK(v0 == Approx(1.0 / 0.4 * (1.0 - std::exp(-0.4 / 0.05 * 0.1))));
    const double x0 = bench.arm.position_D().x();
    bench.run(250);
    CHECK(bench.arm.velocity_D().x() == Approx(v0 * std::exp(-0.4 / 0.05 * 0.25)));
    CHECK(bench.arm.position_D().x() - x0 ==
          Approx(v0 * 0.05 / 0.4 * (1.0 - std::exp(-0.4 / 0.05 * 0.25))));
}

TEST_CASE(
    "simulated arm: dry friction holds each axis by itself, and stops it after m v^2 / 2 f_c") {
    SimulatedArmSettings settings = free_arm(0.1);
    settings.dry_friction_N = 0.3;
    Bench bench(settings);
    REQUIRE(bench.arm.write(0.0, {Vector3(0.29, -0.8, 0.3), Vector3::Zero()}));
    bench.run(200);
    CHECK(bench.arm.position_D().x() == 0.0);
    CHECK(bench.arm.position_D().z() == 0.0);
    const double v = bench.arm.velocity_D().y();
    CHECK(v == Approx(-0.5 / 0.1 * 0.2));
    const double y = bench.arm.position_D().y();
    REQUIRE(bench.arm.write(bench.now_s, push(0.0)));
    bench.run(1000);
    CHECK(bench.arm.velocity_D().y() == 0.0);
    CHECK(bench.arm.position_D().y() - y == Approx(-0.1 * v * v / (2.0 * 0.3)).epsilon(1e-9));
}

TEST_CASE("simulated arm: a force acts exactly delay_s later, whatever part of a period that is") {
    for (const double delay_s : {0.0, 0.0001, 0.00055, 0.001, 0.0015, 0.0073, 0.02}) {
        for (const double dt_s : {0.00025, 0.001, 0.0013}) {
            SimulatedArmSettings settings = free_arm(1.0);
            settings.delay_s = delay_s;
            Bench bench(settings);
            bench.run(3, dt_s);
            const double written_s = bench.now_s;
            REQUIRE(bench.arm.write(written_s, push(2.0)));
            for (int k = 0; k < 200; ++k) {
                bench.run(1, dt_s);
                const double acting_s = std::max(bench.now_s - written_s - delay_s, 0.0);
                REQUIRE(bench.arm.position_D().x() == Approx(acting_s * acting_s).margin(1e-11));
            }
        }
    }
}

TEST_CASE("simulated arm: forces on their way arrive in their order, each for its time") {
    SimulatedArmSettings settings = free_arm(1.0);
    settings.delay_s = 0.0025;
    Bench bench(settings);
    // A pulse of 1 N for one period, and back: velocity 0.001 while it lasts, then none.
    REQUIRE(bench.arm.write(0.0, push(1.0)));
    bench.run(1);
    REQUIRE(bench.arm.write(bench.now_s, push(-1.0)));
    bench.run(1);
    REQUIRE(bench.arm.write(bench.now_s, push(0.0)));
    CHECK(bench.arm.force_D().norm() == 0.0);
    bench.run(1);  // 3 ms: the first for half a period
    CHECK(bench.arm.force_D().x() == 1.0);
    CHECK(bench.arm.velocity_D().x() == Approx(0.0005));
    bench.run(1);
    CHECK(bench.arm.force_D().x() == -1.0);
    CHECK(bench.arm.velocity_D().x() == Approx(0.0005));
    bench.run(1);
    CHECK(bench.arm.velocity_D().x() == Approx(0.0).margin(kRounding));
    CHECK(bench.arm.position_D().x() == Approx(1.0e-6));
}

TEST_CASE("simulated arm: no more forces on their way than it keeps, none longer than it may be") {
    SimulatedArmSettings settings = free_arm(1.0);
    settings.delay_s = 0.02;
    Bench bench(settings);
    for (std::size_t i = 0; i < SimulatedArm::kMostPending; ++i) {
        REQUIRE(bench.arm.write(0.0, push(1.0)));
    }
    CHECK_FALSE(bench.arm.write(0.0, push(1.0)));
    bench.run(25);
    CHECK(bench.arm.write(bench.now_s, push(1.0)));
    // At 5 kHz the longest delay fits.
    SimulatedArm fast(settings, bench.target);
    DeviceReading reading;
    for (int k = 0; k < 1000; ++k) {
        REQUIRE(fast.read(0.0002 * k, reading));
        REQUIRE(fast.write(0.0002 * k, push(0.1)));
    }
    settings = free_arm(1.0);
    settings.max_force_N = 5.0;
    settings.damping_Ns_per_m = 0.5;
    Bench other(settings);
    CHECK(other.arm.traits().max_force_N == 5.0);
    CHECK(other.arm.traits().damping_Ns_per_m == 0.5);
    CHECK(other.arm.write(0.0, {Vector3(30.0, 0.0, -40.0), Vector3::Zero()}));
    CHECK((other.arm.force_D() - Vector3(3.0, 0.0, -4.0)).norm() < kRounding);
    CHECK(other.arm.write(0.0, {Vector3(0.0, 4.9, 0.0), Vector3::Zero()}));
    CHECK(other.arm.force_D().y() == 4.9);
    CHECK(other.arm.write(0.0, push(1e308)));
    CHECK(other.arm.force_D().x() == Approx(5.0));
    CHECK_FALSE(other.arm.write(0.0, push(std::numeric_limits<double>::quiet_NaN())));
    CHECK(other.arm.force_D().norm() == 0.0);
}

TEST_CASE("simulated arm: what a passive wall and a still hand do never adds energy") {
    // Between two writes the arm's energy falls short of what the force gave it, whatever its faults.
    SimulatedArmSettings settings = make_desktop_arm();
    settings.human = kFingertip;
    settings.delay_s = 0.0004;
    Bench bench(settings);
    const double mass_kg = settings.mass_kg + settings.human.mass_kg;
    const auto energy_J = [&] {
        return 0.5 * mass_kg * bench.arm.velocity_D().squaredNorm() +
               0.5 * settings.human.stiffness_N_per_m * bench.arm.position_D().squaredNorm();
    };
    for (int k = 0; k < 5000; ++k) {
        const double force_N = k % 40 < 20 ? 3.0 * std::sin(0.7 * k) : 0.0;
        REQUIRE(bench.arm.write(bench.now_s, push(force_N)));
        for (const double part_s : {0.0004, 0.0006}) {
            const double before_J = energy_J();
            const double x_m = bench.arm.position_D().x();
            const double acting_N = bench.arm.force_D().x();
            bench.run(1, part_s);
            // The new force takes effect at the end of the first part.
            REQUIRE(energy_J() <= before_J + acting_N * (bench.arm.position_D().x() - x_m) + 1e-12);
        }
    }
}

TEST_CASE("simulated arm: another hand takes it where it is; let go it flies on") {
    SimulatedArmSettings settings;
    settings.mass_kg = 0.1;
    settings.human = {0.0, 0.0, 100.0};
    settings.start_D = Vector3(0.05, 0.0, 0.0);
    Bench bench(settings);
    bench.target.publish(at(Vector3::Zero()));
    bench.run(30);
    const double x = bench.arm.position_D().x();
    const double v = bench.arm.velocity_D().x();
    CHECK(x == Approx(0.05 * std::cos(std::sqrt(1000.0) * 0.03)));
    bench.arm.take_hold(kNobody);
    CHECK(bench.arm.position_D().x() == x);
    bench.run(100);
    CHECK(bench.arm.velocity_D().x() == Approx(v));
    CHECK(bench.arm.position_D().x() == Approx(x + 0.1 * v));
    bench.arm.take_hold(kPosture);
    bench.run(3000);
    CHECK(bench.arm.position_D().norm() < 1e-6);
}
