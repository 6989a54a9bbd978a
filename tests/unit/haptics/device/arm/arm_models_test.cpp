#include "haptics/device/arm/arm_model.h"
#include "haptics/device/arm/arm_posture.h"
#include "haptics/device/arm/arm_reach.h"
#include "haptics/device/arm/barrett_wam.h"
#include "haptics/math/dense.h"
#include "haptics/math/plain_eigen.h"
#include "haptics/math/rotation.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/refused.h"
#include "tests/unit/haptics/device/arm/arm_fixture.h"
#include "tests/unit/haptics/device/arm/dense_joints.h"

#include <catch2/catch.hpp>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <string>

using namespace fulcrum;
using namespace fulcrum::arm_test;

namespace {

// What is done to a pendulum, and what the sentence says of it.
struct Spoiled {
    void (*spoil)(ArmModel& model);
    const char* told;
};

std::string complain(const ArmModel& model, const ArmWorkspace& workspace) {
    const auto reach = compute_reach(model, workspace);
    return reach ? std::string() : to_sentence(reach.error());
}

}  // namespace

TEST_CASE("arm model: arms that can be moved are accepted, rotors count by their ratio squared") {
    CHECK(validate(make_pendulum(1.0, 0.5)));
    CHECK(validate(make_barrett_wam()));
    CHECK(validate(make_free_wam()));
    ArmModel model = make_pendulum(1.0, 0.5);
    model.n = 2;
    model.motors[0].rotor_inertia_kg_m2 = 0.001;
    model.motors[1].rotor_inertia_kg_m2 = 0.002;
    model.transmission = JointMatrix(2, 2);
    model.transmission(0, 0) = model.transmission(1, 0) = 10.0;
    model.transmission(0, 1) = -5.0;
    model.transmission(1, 1) = 5.0;
    const JointMatrix inertia = compute_rotor_inertia(model);
    CHECK(inertia(0, 0) == Approx(0.3));
    CHECK(inertia(1, 1) == Approx(0.075));
    CHECK(inertia(0, 1) == Approx(0.05));
    CHECK(inertia(1, 0) == Approx(0.05));
}

TEST_CASE("arm model: what is no arm is refused, and said in a sentence") {
    const Spoiled arms[] = {
        {[](ArmModel& m) { m.n = 0; }, "0 joints"},
        {[](ArmModel& m) { m.n = kMostJoints + 1; }, "8 joints"},
        {[](ArmModel& m) { m.links[0].mass_kg = -1.0; }, "link 1"},
        {[](ArmModel& m) { m.links[0].mass_kg = 0.0; }, "neither mass"},
        {[](ArmModel& m) { m.links[0].alpha_rad = kNan; }, "alpha_rad"},
        {[](ArmModel& m) { m.links[0].high_rad = -51.0; }, "high_rad"},
        {[](ArmModel& m) { m.links[0].damping_Nms_per_rad = 0.0; }, "damping"},
        {[](ArmModel& m) { m.links[0].centre_m.x() = kNan; }, "centre"},
        {[](ArmModel& m) { m.links[0].inertia_kg_m2(0, 1) = 1.0; }, "symmetric"},
        {[](ArmModel& m) { m.links[0].inertia_kg_m2(0, 0) = -1.0; }, "negative eigenvalue"},
        {[](ArmModel& m) { m.motors[0].max_torque_Nm = 0.0; }, "motor 1"},
        {[](ArmModel& m) { m.transmission(0, 0) = 0.0; }, "transmission"},
        {[](ArmModel& m) { m.transmission = JointMatrix(2, 2); }, "transmission"},
        {[](ArmModel& m) { m.handle.orientation.coeffs().setZero(); }, "handle"},
        {[](ArmModel& m) { m.gravity_B.y() = kNan; }, "gravity"}};
    for (const Spoiled& arm : arms) {
        ArmModel model = make_pendulum(1.0, 0.5);
        arm.spoil(model);
        INFO(arm.told);
        CHECK(is_refused(validate(model), arm.told));
    }
    // A rotor alone is inertia enough.
    ArmModel rotor = make_pendulum(1.0, 0.5);
    rotor.links[0].mass_kg = 0.0;
    rotor.motors[0].rotor_inertia_kg_m2 = 0.1;
    CHECK(validate(rotor));
}

TEST_CASE("Barrett WAM: it stands straight up at zero, as the maker draws it") {
    const ArmPosture posture = posture_of(make_barrett_wam(0.0), JointVector::Zero(7));
    // Upper arm 0.55 m, forearm 0.3 m, wrist to the tool plate 0.0609 m; the elbow 45 mm ahead.
    CHECK((posture.handle_B.position - Vector3(0.0, 0.0, 0.9109)).norm() < 1e-12);
    CHECK((posture.origin_B[3] - Vector3(0.045, 0.0, 0.55)).norm() < 1e-12);
    CHECK((posture.axis_B(6) - Vector3::UnitZ()).norm() < 1e-12);
}

TEST_CASE(
    "Barrett WAM: the second joint forward leans it ahead, the fourth bends the elbow ahead") {
    const ArmModel wam = make_barrett_wam();
    JointVector q = JointVector::Zero(7);
    q(1) = 0.5;
    ArmPosture posture = posture_of(wam, q);
    CHECK(posture.handle_B.position.x() == Approx(0.9909 * std::sin(0.5)));
    q = make_joints({0.0, 0.0, 0.0, 1.5707963267948966, 0.0, 0.0, 0.0});
    posture = posture_of(wam, q);
    CHECK(posture.handle_B.position.x() == Approx(0.045 + 0.4409));
    CHECK(posture.handle_B.position.z() == Approx(0.55 + 0.045));
}

TEST_CASE("Barrett WAM: links that can be, the maker's rotors, and a home far from every stop") {
    const ArmModel wam = make_barrett_wam();
    double mass_kg = 0.0;
    for (const ArmLink& link : wam.links) {
        mass_kg += link.mass_kg;
        const Vector3 principal = compute_symmetric_axes(link.inertia_kg_m2).values;
        // No body's largest moment is above the sum of the others.
        CHECK(principal.x() > 0.0);
        CHECK(principal.z() < principal.x() + principal.y());
    }
    CHECK(mass_kg == Approx(19.4583).epsilon(1e-4));
    const JointMatrix rotors = compute_rotor_inertia(make_barrett_wam());
    // AC-02: reflected to the output. For a differential it gives what one of two motors adds.
    CHECK(rotors(0, 0) == Approx(0.205190).epsilon(2e-4));
    CHECK(rotors(1, 1) == Approx(2.0 * 0.094428).epsilon(2e-4));
    CHECK(rotors(3, 3) == Approx(0.034628).epsilon(2e-4));
    CHECK(rotors(6, 6) == Approx(0.000318).epsilon(6e-3));
    CHECK(rotors(1, 2) == 0.0);
    const JointVector home = make_wam_home();
    for (int i = 0; i < 7; ++i) {
        const ArmLink& link = wam.links[static_cast<std::size_t>(i)];
        CHECK(std::min(home(i) - link.low_rad, link.high_rad - home(i)) > 0.75);
    }
    const ArmPosture posture = posture_of(wam, home);
    CHECK((posture.handle_B.position - Vector3(0.513, -0.099, 0.348)).norm() < 0.001);
}

TEST_CASE("Barrett WAM: the motors carry it in every posture") {
    const ArmModel wam = make_barrett_wam();
    const Eigen::MatrixXd motor_per_joint = to_eigen(wam.transmission).transpose().inverse();
    std::mt19937 random(21);
    std::uniform_real_distribution<double> any(0.0, 1.0);
    for (int k = 0; k < 2000; ++k) {
        JointVector q(7);
        for (int i = 0; i < 7; ++i) {
            const ArmLink& link = wam.links[static_cast<std::size_t>(i)];
            q(i) = link.low_rad + any(random) * (link.high_rad - link.low_rad);
        }
        const Eigen::VectorXd torque =
            motor_per_joint * to_eigen(compute_weight_torque(wam, Place(wam, q).posture));
        for (int i = 0; i < 7; ++i) {
            REQUIRE(std::abs(torque(i)) <
                    0.6 * wam.motors[static_cast<std::size_t>(i)].max_torque_Nm);
        }
    }
}

TEST_CASE("arm posture: two links in a plane are where sines and cosines put them") {
    ArmModel model = make_pendulum(1.0, 0.5);
    model.n = 2;
    model.links[1] = model.links[0];
    model.links[1].a_m = 0.3;
    model.transmission = JointMatrix::Identity(2, 2);
    const JointVector q = make_joints({0.4, -1.1});
    const ArmPosture posture = posture_of(model, q);
    const Vector3 expected(0.5 * std::cos(0.4) + 0.3 * std::cos(-0.7),
                           0.5 * std::sin(0.4) + 0.3 * std::sin(-0.7), 0.0);
    CHECK((posture.handle_B.position - expected).norm() < 1e-15);
    CHECK(posture.handle_B.orientation.angularDistance(compute_exp(Vector3(0.0, 0.0, -0.7))) <
          1e-12);
    CHECK(posture.jacobian_B(0, 0) == Approx(-expected.y()));
    CHECK(posture.jacobian_B(1, 1) == Approx(0.3 * std::cos(-0.7)));
}

TEST_CASE("arm posture: the Jacobian is the handle's derivative, by differences") {
    std::mt19937 random(1);
    const ArmModel wam = make_barrett_wam();
    constexpr double kStep_rad = 1e-6;  // truncation 1e-12, rounding 1e-10
    for (int k = 0; k < 100; ++k) {
        const JointVector q = draw(random, 7, 2.5);
        const ArmPosture posture = posture_of(wam, q);
        for (int i = 0; i < 7; ++i) {
            JointVector on = q;
            on(i) += kStep_rad;
            JointVector back = q;
            back(i) -= kStep_rad;
            const ArmPosture ahead = posture_of(wam, on);
            const ArmPosture behind = posture_of(wam, back);
            const Vector3 linear =
                (ahead.handle_B.position - behind.handle_B.position) / (2.0 * kStep_rad);
            const Vector3 turning =
                compute_log(ahead.handle_B.orientation * behind.handle_B.orientation.conjugate()) /
                (2.0 * kStep_rad);
            REQUIRE((posture.jacobian_B.col(i).head<3>() - linear).norm() < 1e-9);
            REQUIRE((posture.jacobian_B.col(i).tail<3>() - turning).norm() < 1e-9);
        }
    }
}

TEST_CASE("arm posture: every link's frame is a rotation, whatever the angles") {
    std::mt19937 random(2);
    const ArmModel wam = make_barrett_wam();
    for (int k = 0; k < 100; ++k) {
        const ArmPosture posture = posture_of(wam, draw(random, 7, 50.0));
        for (const Matrix3& turn : posture.turn_B) {
            REQUIRE((turn * turn.transpose() - Matrix3::Identity()).norm() < 1e-13);
            REQUIRE(turn.determinant() == Approx(1.0));
        }
    }
}

TEST_CASE("arm reach: what the WAM promises can be used, without weight as its motors can") {
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
    beyond(1) = kNan;
    CHECK(complain(wam, {beyond}).find("angle 2") != std::string::npos);
    // A single joint moves no handle freely.
    CHECK(complain(make_pendulum(1.0, 0.5), {JointVector::Zero(1)}).find("cannot reach") !=
          std::string::npos);
    ArmModel weak = wam;
    weak.motors[3].max_torque_Nm = 0.1;
    CHECK(complain(weak, {make_wam_home()}).find("own weight") != std::string::npos);
}
