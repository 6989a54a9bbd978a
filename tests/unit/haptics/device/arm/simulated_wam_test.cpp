#include "haptics/device/arm/simulated_wam.h"

#include "haptics/coupling/velocity_estimator.h"
#include "haptics/math/rotation.h"
#include "tests/unit/haptics/device/arm/wam_bench.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace fulcrum;
using namespace fulcrum::arm_test;

namespace {

// The elbow comes home last, against its joints' viscous friction: with a root of about 1/s.
constexpr int kUntilRest = 15000;

Wrench push(const Vector3& force) {
    return {force, Vector3::Zero()};
}

}  // namespace

TEST_CASE("simulated WAM: level at home, says what it can do, and goes where the hand wants") {
    Bench bench;
    const double step_m = bench.wam->traits().position_resolution_m;
    CHECK(bench.reading.pose_D.position.norm() < 3.0 * step_m);
    CHECK(bench.reading.pose_D.orientation.angularDistance(Quaternion::Identity()) < 1e-3);
    bench.run(2000);
    CHECK(bench.wam->compute_pose_D().position.norm() < 1e-4);
    CHECK(bench.wam->compute_velocity_D().linear.norm() == 0.0);
    Bench other;
    const DeviceTraits& traits = other.wam->traits();
    CHECK(traits.renders_force);
    CHECK(traits.name == "simulated WAM");
    CHECK(traits.max_force_N > 10.0);
    CHECK(traits.max_torque_Nm > 0.3);
    CHECK(traits.position_resolution_m > 0.0);
    CHECK(traits.damping_Ns_per_m > 0.0);
    CHECK(traits.mass_kg > 0.2);
    Bench third(make_smooth());
    const Vector3 place(0.06, -0.05, 0.08);
    const Vector3 turn(0.2, -0.3, 0.25);
    third.aim(place, turn);
    third.run(kUntilRest);
    CHECK((third.reading.pose_D.position - place).norm() < 1e-4);
    CHECK(compute_log(third.reading.pose_D.orientation * compute_exp(turn).conjugate()).norm() <
          1e-3);
}

TEST_CASE("simulated WAM: +Z is away from the base, +Y up, and so are the forces") {
    for (int axis = 0; axis < 3; ++axis) {
        Bench bench(make_smooth());
        REQUIRE(bench.wam->write(0.0, push(2.0 * Vector3::Unit(axis))));
        bench.run(kUntilRest);
        // The hand's spring, 300 N/m, holds 2 N; its turning is held by 3 Nm/rad and adds nothing to the place.
        const Vector3 expected = Vector3::Unit(axis) * (2.0 / 300.0);
        CHECK((bench.wam->compute_pose_D().position - expected).norm() < 1e-5);
    }
    Bench bench(make_smooth());
    const ArmPosture home = posture_of(bench.wam->model(), make_wam_home());
    bench.aim({0.05, 0.0, 0.1});
    bench.run(kUntilRest);
    const ArmPosture posture = posture_of(bench.wam->model(), bench.wam->state().angle_rad);
    CHECK((posture.handle_B.position - home.handle_B.position - Vector3(0.1, 0.05, 0.0)).norm() <
          1e-4);
}

TEST_CASE(
    "simulated WAM: a torque turns the handle on the hand's spring, friction hides a small force") {
    Bench bench(make_smooth());
    REQUIRE(bench.wam->write(0.0, {Vector3::Zero(), Vector3(0.0, 0.3, 0.0)}));
    bench.run(kUntilRest);
    CHECK((compute_log(bench.wam->compute_pose_D().orientation) - Vector3(0.0, 0.1, 0.0)).norm() <
          1e-4);
    Bench other;
    REQUIRE(other.wam->write(0.0, push({0.0, 0.1, 0.0})));
    other.run(1000);
    CHECK(other.wam->compute_pose_D().position.norm() < 1e-4);
    CHECK(other.wam->state().speed_rad_per_s.norm() == 0.0);
    REQUIRE(other.wam->write(other.now_s, push({0.0, 8.0, 0.0})));
    other.run(1000);
    CHECK(other.wam->compute_pose_D().position.y() > 0.01);
}

TEST_CASE("simulated WAM: what its traits promise it gives everywhere in its workspace") {
    Bench bench;
    std::mt19937 random(61);
    std::normal_distribution<double> normal;
    const auto direction = [&] {
        return Vector3(normal(random), normal(random), normal(random)).normalized();
    };
    const ArmWorkspace workspace{make_wam_home()};
    double farthest_m = 0.0;
    for (int place = 0; place < 60; ++place) {
        bench.aim(workspace.radius_m * direction(), workspace.tilt_rad * direction());
        bench.run(300);
        for (int k = 0; k < 100; ++k) {
            const Wrench full{bench.wam->traits().max_force_N * direction(),
                              bench.wam->traits().max_torque_Nm * direction()};
            REQUIRE(bench.wam->write(bench.now_s, full));
            bench.run(1);
            REQUIRE(bench.find_most_torque() <= 1.0 + 1e-12);
            REQUIRE(bench.wam->command().wrench_share == 1.0);
        }
        farthest_m = std::max(farthest_m, bench.reading.pose_D.position.norm());
        REQUIRE(bench.wam->write(bench.now_s, {}));
    }
    CHECK(farthest_m > 0.1);
}

TEST_CASE("simulated WAM: a wrench beyond the motors is scaled as a whole") {
    Bench bench;
    REQUIRE(bench.wam->write(0.0, push({300.0, 0.0, -400.0})));
    bench.run(1);
    CHECK(bench.wam->command().wrench_share < 0.5);
    CHECK(bench.find_most_torque() == Approx(1.0));
    REQUIRE(bench.wam->write(bench.now_s, push({1e308, 1e308, 1e308})));
    bench.run(20);
    CHECK(bench.find_most_torque() <= 1.0 + 1e-12);
    CHECK(is_finite(bench.reading.pose_D));
}

TEST_CASE("simulated WAM: a wrench acts delay_s later, in its order") {
    SimulatedWamSettings settings = make_smooth();
    settings.delay_s = 0.0025;
    Bench bench(settings);
    REQUIRE(bench.wam->write(0.0, push({0.0, 5.0, 0.0})));
    bench.run(2);
    CHECK(bench.wam->compute_velocity_D().linear.norm() < 1e-6);
    REQUIRE(bench.wam->write(bench.now_s, push({0.0, -5.0, 0.0})));
    bench.run(1);
    CHECK(bench.wam->compute_velocity_D().linear.y() > 1e-4);
    const double up = bench.wam->compute_velocity_D().linear.y();
    bench.run(1);
    CHECK(bench.wam->compute_velocity_D().linear.y() > up);
    bench.run(4);
    CHECK(bench.wam->compute_velocity_D().linear.y() < up);
    for (std::size_t i = 0; i < SimulatedWam::kMostPending; ++i) {
        REQUIRE(bench.wam->write(bench.now_s, push({1.0, 0.0, 0.0})));
    }
    CHECK_FALSE(bench.wam->write(bench.now_s, push({1.0, 0.0, 0.0})));
}

TEST_CASE(
    "simulated WAM: a target that cannot be used leaves the last; a long pause moves it a little") {
    Bench bench;
    bench.aim({0.1, 0.0, 0.0});
    bench.run(10);
    bench.aim({0.0, std::numeric_limits<double>::quiet_NaN(), 0.0});
    CHECK(bench.run(3000).pose_D.position.x() == Approx(0.1).margin(0.01));
    bench.aim(Vector3::Zero());
    CHECK(bench.wam->read(bench.now_s + 1.0e6, bench.reading));
    CHECK(bench.reading.pose_D.position.x() > 0.01);
}

TEST_CASE("simulated WAM: targets at the end of numbers pull it about, but break nothing") {
    Bench bench;
    std::mt19937 random(62);
    std::normal_distribution<double> normal;
    const auto any = [&] { return Vector3(normal(random), normal(random), normal(random)); };
    for (int k = 0; k < 400; ++k) {
        HandTarget wanted;
        wanted.pose_D.position = any() * (k % 5 == 0 ? 1e307 : 3.0);
        wanted.velocity_D = any() * (k % 7 == 0 ? 1e307 : 1.0);
        wanted.pose_D.orientation = compute_exp(any());
        bench.target.publish(wanted);
        (void)bench.wam->write(bench.now_s, {10.0 * any(), any()});
        bench.run(50);
        REQUIRE(is_finite(bench.reading.pose_D));
        REQUIRE(bench.find_most_torque() <= 1.0 + 1e-12);
        for (int i = 0; i < 7; ++i) {
            const ArmLink& link = bench.wam->model().links[static_cast<std::size_t>(i)];
            REQUIRE(bench.wam->state().angle_rad(i) >= link.low_rad);
            REQUIRE(bench.wam->state().angle_rad(i) <= link.high_rad);
        }
        // A hand of 200 N, and the dampers: no faster than a thrown arm.
        REQUIRE(bench.wam->state().speed_rad_per_s.cwiseAbs().maxCoeff() < 2000.0);
    }
    // And it comes back, though perhaps with another bend of the wrist, as far as the stops of that allow.
    bench.aim(Vector3::Zero());
    REQUIRE(bench.wam->write(bench.now_s, {}));
    bench.run(8000);
    CHECK(bench.reading.pose_D.position.norm() < 0.2);
    CHECK(bench.wam->state().speed_rad_per_s.cwiseAbs().maxCoeff() < 0.02);
}

TEST_CASE(
    "simulated WAM: pulled out straight it rests there, and comes to rest again when led back") {
    Bench bench(make_smooth());
    bench.aim({0.0, 0.3, 2.0});
    bench.run(4000);
    const JointVector& q = bench.wam->state().angle_rad;
    CHECK(std::abs(q(3)) < 0.4);  // the elbow is nearly straight, or at its own straightest
    CHECK(bench.wam->state().speed_rad_per_s.cwiseAbs().maxCoeff() < 0.05);
    REQUIRE(bench.wam->write(bench.now_s, {Vector3(5.0, 5.0, 5.0), Vector3(0.1, 0.1, 0.1)}));
    bench.run(2000);
    CHECK(is_finite(bench.reading.pose_D));
    REQUIRE(bench.wam->write(bench.now_s, {}));
    // The wrist may have gone through its straight posture to the other side, where a stop ends its way.
    bench.aim(Vector3::Zero());
    bench.run(6000);
    CHECK(bench.wam->compute_pose_D().position.norm() < 0.15);
    CHECK(bench.wam->state().speed_rad_per_s.cwiseAbs().maxCoeff() < 0.01);
}

TEST_CASE("simulated WAM: the elbow comes home under a still handle; let go it floats") {
    SimulatedWamSettings settings = make_smooth();
    settings.grip.push.stiffness_N_per_m = 5000.0;
    settings.grip.turn_stiffness_Nm_per_rad = 50.0;
    settings.grip.turn_damping_Nms_per_rad = 1.0;
    Bench bench(settings);
    // Led about in a circle and back to where it began.
    for (int k = 0; k < 3000; ++k) {
        const double angle = 6.283185307179586 * k / 3000.0;
        bench.aim({0.1 * std::sin(angle), 0.1 * (std::cos(angle) - 1.0), 0.0});
        bench.run(1);
    }
    bench.aim(Vector3::Zero());
    bench.run(6000);
    CHECK((bench.wam->state().angle_rad - make_wam_home()).cwiseAbs().maxCoeff() < 1e-3);
    Bench bench_again;
    bench_again.aim({0.05, 0.05, 0.0});
    bench_again.run(2000);
    bench_again.wam->take_hold(kNoGrip);
    bench_again.run(500);
    const Vector3 left = bench_again.wam->compute_pose_D().position;
    bench_again.run(2000);
    CHECK((bench_again.wam->compute_pose_D().position - left).norm() < 0.005);
    bench_again.wam->take_hold(HandGrip{});
    bench_again.aim(Vector3::Zero());
    bench_again.run(3000);
    CHECK(bench_again.wam->compute_pose_D().position.norm() < 0.02);
}

TEST_CASE("simulated WAM: the reading goes in whole counts of the motors") {
    Bench bench;
    bench.aim({0.02, -0.013, 0.01});
    const double step_m = bench.wam->traits().position_resolution_m;
    int n_moved = 0;
    for (int k = 0; k < 500; ++k) {
        const Vector3 before = bench.reading.pose_D.position;
        bench.run(1);
        // Seven motors, each half a count off.
        REQUIRE((bench.reading.pose_D.position - bench.wam->compute_pose_D().position).norm() <
                3.5 * step_m);
        n_moved += bench.reading.pose_D.position != before;
    }
    CHECK(n_moved > 50);
    // At rest the counts rest.
    bench.run(2000);
    const Vector3 rest = bench.reading.pose_D.position;
    CHECK(bench.run(100).pose_D.position == rest);
}

TEST_CASE("simulated WAM: a virtual wall of 2 kN/m stands against the hand without a buzz") {
    Bench bench;
    VelocitySettings how;
    how.noise_bound_m = bench.wam->traits().position_resolution_m;
    VelocityEstimator estimator(how);
    // The hand wants to be 30 mm behind a wall at the home height: 300 N/m against 2000.
    bench.aim({0.0, -0.03, 0.0});
    double low_m = 1.0;
    double high_m = -1.0;
    double least_N = 1e3;
    double most_N = 0.0;
    for (int k = 0; k < 4000; ++k) {
        bench.run(1);
        const double height_m = bench.reading.pose_D.position.y();
        const double speed = estimator.step(bench.reading.pose_D.position, bench.now_s).y();
        const double force_N =
            height_m < 0.0 ? std::max(-2000.0 * height_m - 5.0 * speed, 0.0) : 0.0;
        REQUIRE(bench.wam->write(bench.now_s, push({0.0, force_N, 0.0})));
        if (k >= 3000) {
            low_m = std::min(low_m, height_m);
            high_m = std::max(high_m, height_m);
            least_N = std::min(least_N, force_N);
            most_N = std::max(most_N, force_N);
        }
    }
    CHECK(high_m - low_m <= 2.0 * bench.wam->traits().position_resolution_m);
    // 300 N/m against 2000: 7.8 N, and what dry friction holds.
    CHECK(most_N < 9.5);
    CHECK(most_N > 6.0);
    CHECK(most_N - least_N < 0.5);
    CHECK(-low_m == Approx(most_N / 2000.0).epsilon(0.1));
}
