#include "haptics/device/arm/arm_dynamics.h"

#include "haptics/math/plain_eigen.h"
#include "haptics/math/rotation.h"
#include "tests/unit/haptics/device/arm/arm_fixture.h"
#include "tests/unit/haptics/device/arm/articulated_body.h"
#include "tests/unit/haptics/device/arm/dense_joints.h"

#include <catch2/catch.hpp>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>

using namespace fulcrum;
using namespace fulcrum::arm_test;

namespace {

constexpr HeldMass kHeld{0.8, 0.003};

// Half the sum of m c'^2 + omega . I omega, with the velocities of every link from two postures a little apart.
double compute_energy_by_differences(const ArmModel& model, const JointVector& q,
                                     const JointVector& v) {
    constexpr double kDt_s = 1e-6;
    const ArmPosture ahead = posture_of(model, q + kDt_s * v);
    const ArmPosture behind = posture_of(model, q - kDt_s * v);
    const ArmPosture middle = posture_of(model, q);
    double energy_J = 0.0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(model.n); ++i) {
        const ArmLink& link = model.links[i];
        const auto centre = [&](const ArmPosture& at) {
            return Vector3(at.origin_B[i + 1] + at.turn_B[i + 1] * link.centre_m);
        };
        const Vector3 linear = (centre(ahead) - centre(behind)) / (2.0 * kDt_s);
        const Vector3 omega = compute_log(Quaternion(Matrix3(ahead.turn_B[i + 1] *
                                                             behind.turn_B[i + 1].transpose()))) /
                              (2.0 * kDt_s);
        const Vector3 omega_own = middle.turn_B[i + 1].transpose() * omega;
        energy_J += 0.5 * link.mass_kg * linear.squaredNorm() +
                    0.5 * omega_own.dot(link.inertia_kg_m2 * omega_own);
    }
    const JointVector handle = v;
    const Vector3 held_linear =
        (ahead.handle_B.position - behind.handle_B.position) / (2.0 * kDt_s);
    const Vector3 held_omega =
        compute_log(ahead.handle_B.orientation * behind.handle_B.orientation.conjugate()) /
        (2.0 * kDt_s);
    energy_J += 0.5 * kHeld.mass_kg * held_linear.squaredNorm() +
                0.5 * kHeld.inertia_kg_m2 * held_omega.squaredNorm();
    return energy_J + 0.5 * handle.dot(multiply(compute_rotor_inertia(model), handle));
}

}  // namespace

TEST_CASE("arm dynamics: a pendulum has the inertia and the weight of the textbook") {
    const ArmModel model = make_pendulum(2.0, 0.5);
    const JointVector q = make_joints({0.3});
    const Place place(model, q);
    CHECK(place.inertia()(0, 0) == Approx(2.0 * 0.25));
    CHECK(compute_weight_torque(model, place.posture)(0) ==
          Approx(2.0 * kGravity * 0.5 * std::sin(0.3)));
    const JointVector v = make_joints({3.0});
    CHECK(compute_motion_torque(place.posture, place.bodies, v)(0) == Approx(0.0).margin(1e-14));
    // What is held has no weight, but mass.
    const Place held(model, q, {1.0, 0.01});
    CHECK(held.inertia()(0, 0) == Approx(3.0 * 0.25 + 0.01));
}

TEST_CASE("arm dynamics: two links have the centrifugal torque of the textbook") {
    // Two point masses on rods: h = m2 l1 l2 sin q2; c = (-h (2 v1 v2 + v2^2), h v1^2).
    ArmModel model = make_pendulum(1.0, 0.5);
    model.n = 2;
    model.links[1] = model.links[0];
    model.links[1].a_m = 0.3;
    model.links[1].mass_kg = 0.7;
    model.transmission = JointMatrix::Identity(2, 2);
    const JointVector q = make_joints({0.2, 0.9});
    const JointVector v = make_joints({1.3, -0.4});
    const Place place(model, q);
    const double h = 0.7 * 0.5 * 0.3 * std::sin(0.9);
    const JointVector c = compute_motion_torque(place.posture, place.bodies, v);
    CHECK(c(0) == Approx(-h * (2.0 * 1.3 * -0.4 + 0.16)));
    CHECK(c(1) == Approx(h * 1.69));
    CHECK(place.inertia()(0, 1) == Approx(0.7 * (0.09 + 0.5 * 0.3 * std::cos(0.9))));
}

TEST_CASE("arm dynamics: recursive Newton-Euler, composite bodies and articulated bodies agree") {
    std::mt19937 random(3);
    ArmModel wam = make_barrett_wam();
    // The articulated bodies know no coupled rotors.
    wam.motors[5].rotor_inertia_kg_m2 = wam.motors[4].rotor_inertia_kg_m2;
    for (int k = 0; k < 200; ++k) {
        const JointVector q = draw(random, 7, 3.0);
        const JointVector v = draw(random, 7, 5.0);
        const JointVector a = draw(random, 7, 20.0);
        const Place place(wam, q);
        const JointVector weight = compute_weight_torque(wam, place.posture);
        const JointVector torque =
            compute_inverse_dynamics(place.posture, place.bodies, place.rotors, v, a) + weight;
        const double size = torque.norm();
        const JointVector composite = multiply(place.inertia(), a) +
                                      compute_motion_torque(place.posture, place.bodies, v) +
                                      weight;
        REQUIRE((composite - torque).norm() < 1e-12 * size);
        const JointVector again = run_articulated_body(wam, q, v, torque);
        REQUIRE((again - a).norm() < 1e-10 * (a.norm() + size));
        const JointVector left =
            torque - compute_motion_torque(place.posture, place.bodies, v) - weight;
        const JointVector solved = to_joints(to_eigen(place.inertia()).llt().solve(to_eigen(left)));
        REQUIRE((solved - again).norm() < 1e-10 * (a.norm() + size));
    }
}

TEST_CASE(
    "arm dynamics: the joint-space inertia is symmetric, positive definite, and the energy's") {
    std::mt19937 random(4);
    const ArmModel wam = make_barrett_wam();
    for (int k = 0; k < 200; ++k) {
        const JointVector q = draw(random, 7, 3.0);
        const JointVector v = draw(random, 7, 2.0);
        const Place place(wam, q, kHeld);
        const Eigen::MatrixXd inertia = to_eigen(place.inertia());
        REQUIRE((inertia - inertia.transpose()).norm() == 0.0);
        REQUIRE(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(inertia).eigenvalues().minCoeff() >
                1e-4);
        // Differences of postures lose half the digits.
        REQUIRE(0.5 * v.dot(multiply(place.inertia(), v)) ==
                Approx(compute_energy_by_differences(wam, q, v)).epsilon(1e-7));
    }
}

TEST_CASE("arm dynamics: the Coriolis torque has Christoffel's symbols of the inertia") {
    std::mt19937 random(5);
    const ArmModel wam = make_barrett_wam();
    constexpr double kStep_rad = 1e-5;
    for (int k = 0; k < 20; ++k) {
        const JointVector q = draw(random, 7, 2.5);
        const JointVector v = draw(random, 7, 2.0);
        std::array<Eigen::MatrixXd, 7> slope;
        for (int i = 0; i < 7; ++i) {
            JointVector on = q;
            on(i) += kStep_rad;
            JointVector back = q;
            back(i) -= kStep_rad;
            slope[static_cast<std::size_t>(i)] = (to_eigen(Place(wam, on, kHeld).inertia()) -
                                                  to_eigen(Place(wam, back, kHeld).inertia())) /
                                                 (2.0 * kStep_rad);
        }
        JointVector expected(7);
        for (int i = 0; i < 7; ++i) {
            const JointVector changed = to_joints(slope[static_cast<std::size_t>(i)] * to_eigen(v));
            expected += v(i) * changed;
            expected(i) -= 0.5 * v.dot(changed);
        }
        const Place place(wam, q, kHeld);
        REQUIRE((compute_motion_torque(place.posture, place.bodies, v) - expected).norm() <
                1e-7 * (1.0 + expected.norm()));
    }
}

TEST_CASE("arm dynamics: the weight's torque is the slope of the weight's energy") {
    std::mt19937 random(6);
    const ArmModel wam = make_barrett_wam();
    const ArmMotion motion(wam);
    constexpr double kStep_rad = 1e-5;
    for (int k = 0; k < 50; ++k) {
        const JointVector q = draw(random, 7, 2.5);
        const JointVector torque = compute_weight_torque(wam, Place(wam, q).posture);
        for (int i = 0; i < 7; ++i) {
            JointVector on = q;
            on(i) += kStep_rad;
            JointVector back = q;
            back(i) -= kStep_rad;
            const double slope =
                (motion.compute_energy_J(at_rest(on)) - motion.compute_energy_J(at_rest(back))) /
                (2.0 * kStep_rad);
            REQUIRE(torque(i) == Approx(slope).margin(1e-7));
        }
    }
}
