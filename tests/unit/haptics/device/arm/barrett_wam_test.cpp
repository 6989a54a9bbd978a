#include "haptics/device/arm/barrett_wam.h"

#include "haptics/math/dense.h"
#include "haptics/math/plain_eigen.h"
#include "tests/unit/haptics/device/arm/arm_fixture.h"
#include "tests/unit/haptics/device/arm/dense_joints.h"

#include <catch2/catch.hpp>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

using namespace fulcrum;
using namespace fulcrum::arm_test;

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

TEST_CASE("Barrett WAM: all of its links are bodies that can be") {
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
}

TEST_CASE("Barrett WAM: rotors at the joints are those that the maker gives") {
    const JointMatrix rotors = compute_rotor_inertia(make_barrett_wam());
    // AC-02: reflected to the output. For a differential it gives what one of two motors adds.
    CHECK(rotors(0, 0) == Approx(0.205190).epsilon(2e-4));
    CHECK(rotors(1, 1) == Approx(2.0 * 0.094428).epsilon(2e-4));
    CHECK(rotors(3, 3) == Approx(0.034628).epsilon(2e-4));
    CHECK(rotors(6, 6) == Approx(0.000318).epsilon(6e-3));
    CHECK(rotors(1, 2) == 0.0);
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

TEST_CASE("Barrett WAM: its home is far from every stop") {
    const ArmModel wam = make_barrett_wam();
    const JointVector home = make_wam_home();
    for (int i = 0; i < 7; ++i) {
        const ArmLink& link = wam.links[static_cast<std::size_t>(i)];
        CHECK(std::min(home(i) - link.low_rad, link.high_rad - home(i)) > 0.75);
    }
    const ArmPosture posture = posture_of(wam, home);
    CHECK((posture.handle_B.position - Vector3(0.513, -0.099, 0.348)).norm() < 0.001);
}
