#include "haptics/device/arm/arm_reach.h"

#include "haptics/math/plain_eigen.h"
#include "tests/unit/haptics/device/arm/arm_fixture.h"
#include "tests/unit/haptics/device/arm/dense_joints.h"

#include <catch2/catch.hpp>

#include <Eigen/Cholesky>
#include <limits>
#include <string>

using namespace fulcrum;
using namespace fulcrum::arm_test;

namespace {

std::string complain(const ArmModel& model, const ArmWorkspace& workspace) {
    const auto reach = compute_reach(model, workspace);
    return reach ? std::string() : to_sentence(reach.error());
}

}  // namespace

TEST_CASE("arm reach: what the WAM promises is what a pupil can use") {
    const auto reach = compute_reach(make_barrett_wam(), {make_wam_home()});
    REQUIRE(reach);
    CAPTURE(reach->force_N, reach->torque_Nm, reach->damping_Ns_per_m, reach->mass_kg,
            reach->step_m);
    CHECK(reach->force_N > 10.0);
    CHECK(reach->torque_Nm > 0.3);
    // The last motor's half, through its ratio, is more than all may have.
    CHECK(reach->torque_Nm < 0.5 * 0.091 * 14.93);
    CHECK(reach->mass_kg == Approx(0.35).epsilon(0.05));
    CHECK(reach->step_m > 2.0 * 3.14159 / 4096.0 / 42.0 * 0.5);
    CHECK(reach->step_m < 1e-4);
}

TEST_CASE("arm reach: without weight the promise is proportional to the motors") {
    ArmModel wam = make_barrett_wam();
    wam.gravity_B.setZero();
    const auto whole = compute_reach(wam, {make_wam_home()});
    for (ArmMotor& motor : wam.motors) {
        motor.max_torque_Nm *= 0.25;
    }
    const auto quarter = compute_reach(wam, {make_wam_home()});
    REQUIRE(whole);
    REQUIRE(quarter);
    CHECK(quarter->force_N == Approx(0.25 * whole->force_N));
    CHECK(quarter->torque_Nm == Approx(0.25 * whole->torque_Nm));
    CHECK(quarter->mass_kg == whole->mass_kg);
    CHECK(quarter->damping_Ns_per_m == whole->damping_Ns_per_m);
}

TEST_CASE("arm reach: a larger workspace promises less") {
    const ArmModel wam = make_barrett_wam();
    const auto narrow = compute_reach(wam, {make_wam_home(), 0.05, 0.1});
    const auto wide = compute_reach(wam, {make_wam_home(), 0.12, 0.5});
    REQUIRE(narrow);
    REQUIRE(wide);
    CHECK(wide->force_N < narrow->force_N);
    CHECK(wide->torque_Nm <= narrow->torque_Nm);
    CHECK(wide->damping_Ns_per_m < narrow->damping_Ns_per_m);
    CHECK(wide->step_m > narrow->step_m);
}

TEST_CASE("arm reach: no way of moving the handle at home loses less than the damping says") {
    const ArmModel wam = make_barrett_wam();
    const auto reach = compute_reach(wam, {make_wam_home()});
    REQUIRE(reach);
    const Place home(wam, make_wam_home());
    std::mt19937 random(51);
    for (int k = 0; k < 2000; ++k) {
        const JointVector v = draw(random, 7, 1.0);
        const double speed = compute_motion_B(home.posture, v).head<3>().norm();
        double power_W = 0.0;
        for (int i = 0; i < 7; ++i) {
            power_W += wam.links[static_cast<std::size_t>(i)].damping_Nms_per_rad * v(i) * v(i);
        }
        REQUIRE(power_W >= reach->damping_Ns_per_m * speed * speed);
    }
    // And it says something: the least lossy joint motion of a level push is not far above it.
    CHECK(reach->damping_Ns_per_m > 0.1);
}

TEST_CASE("arm reach: the felt mass is the mean answer to a force") {
    const ArmModel wam = make_barrett_wam();
    const auto reach = compute_reach(wam, {make_wam_home()});
    REQUIRE(reach);
    const Place home(wam, make_wam_home());
    double mobility = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        const Vector3 force = Vector3::Unit(axis);
        const Eigen::MatrixXd rows = to_eigen(home.posture.jacobian_B).topRows<3>();
        const Eigen::VectorXd torque = rows.transpose() * to_eigen(force);
        const Eigen::VectorXd a = to_eigen(home.inertia()).llt().solve(torque);
        mobility += (rows * a).dot(to_eigen(force)) / 3.0;
    }
    CHECK(reach->mass_kg == Approx(1.0 / mobility));
}

TEST_CASE("arm reach: a workspace that the arm does not have is refused with a way out") {
    const ArmModel wam = make_barrett_wam();
    CHECK(complain(wam, {make_wam_home(), 0.5, 0.5}).find("cannot reach") != std::string::npos);
    CHECK(complain(wam, {make_wam_home(), 0.6, 0.5}).find("radius_m") != std::string::npos);
    CHECK(complain(wam, {make_wam_home(), 0.12, 2.0}).find("tilt_rad") != std::string::npos);
    CHECK(complain(wam, {JointVector::Zero(3)}).find("3 angles") != std::string::npos);
    JointVector beyond = make_wam_home();
    beyond(1) = 2.1;
    CHECK(complain(wam, {beyond}).find("angle 2") != std::string::npos);
    beyond(1) = std::numeric_limits<double>::quiet_NaN();
    CHECK(complain(wam, {beyond}).find("angle 2") != std::string::npos);
    // A single joint moves no handle freely.
    CHECK(complain(make_pendulum(1.0, 0.5), {JointVector::Zero(1)}).find("cannot reach") !=
          std::string::npos);
    ArmModel weak = wam;
    weak.motors[3].max_torque_Nm = 0.1;
    CHECK(complain(weak, {make_wam_home()}).find("own weight") != std::string::npos);
}
