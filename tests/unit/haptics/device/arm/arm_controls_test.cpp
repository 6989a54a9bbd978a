#include "haptics/device/arm/arm_control.h"
#include "haptics/device/arm/stick_slip.h"
#include "haptics/math/plain_eigen.h"
#include "tests/unit/haptics/device/arm/arm_fixture.h"
#include "tests/unit/haptics/device/arm/dense_joints.h"

#include <catch2/catch.hpp>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

using namespace fulcrum;
using namespace fulcrum::arm_test;

namespace {

ArmControl make_control(const ArmModel& model, double posture_per_s = 0.0) {
    return ArmControl(model, {make_wam_home(), posture_per_s});
}

// Where the arm stands is what its encoders see.
ArmCommand step(ArmControl& control, const ArmModel& model, const JointVector& q,
                const JointVector& v, const Wrench& wrench_B) {
    return control.step(Place(model, q).posture, q, v, wrench_B);
}

double find_most(const ArmModel& model, const JointVector& motors) {
    double most = 0.0;
    for (int k = 0; k < model.n; ++k) {
        most = std::max(
            most, std::abs(motors(k)) / model.motors[static_cast<std::size_t>(k)].max_torque_Nm);
    }
    return most;
}

StickSlipProblem make_one(double push, double dry, double low, double high) {
    StickSlipProblem problem;
    problem.inertia = JointMatrix(1, 1);
    problem.inertia(0, 0) = 2.0;
    problem.push = make_joints({push});
    problem.dry = make_joints({dry});
    problem.low = make_joints({low});
    problem.high = make_joints({high});
    return problem;
}

double solve_one(const StickSlipProblem& problem) {
    JointHolds holds{};
    JointVector w;
    solve_stick_slip(problem, holds, w);
    return w(0);
}

// The function that is minimised.
double evaluate(const StickSlipProblem& problem, const JointVector& w) {
    return 0.5 * w.dot(multiply(problem.inertia, w)) - problem.push.dot(w) +
           problem.dry.dot(w.cwiseAbs());
}

StickSlipProblem draw_problem(std::mt19937& random, double spread) {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    StickSlipProblem problem;
    // Rows from a thin matrix: coupled as strongly as `spread` is small.
    Eigen::MatrixXd mixing(7, 7);
    for (int i = 0; i < 7; ++i) {
        mixing.col(i) = to_eigen(draw(random, 7, 1.0));
    }
    problem.inertia =
        to_joint_matrix(mixing * mixing.transpose() + spread * Eigen::MatrixXd::Identity(7, 7));
    problem.push = draw(random, 7, 3.0);
    problem.dry = draw(random, 7, 1.0);
    problem.low = -1.0 * draw(random, 7, 1.0).cwiseAbs();
    problem.high = draw(random, 7, 1.0).cwiseAbs();
    for (int i = 0; i < 7; ++i) {
        problem.dry(i) = std::max(problem.dry(i), 0.0);
        // Many joints stand at a stop, some have none near.
        problem.low(i) = unit(random) < 0.2 ? 0.0 : problem.low(i);
        problem.high(i) = unit(random) < 0.2 ? 0.0 : problem.high(i);
        problem.high(i) += unit(random) < 0.3 ? 100.0 : 0.0;
    }
    return problem;
}

}  // namespace

TEST_CASE("arm control: without a wrench it gives the weight's torque, so nothing moves") {
    const ArmModel wam = make_free_wam();
    ArmControl control = make_control(wam);
    const JointVector q = make_wam_home();
    const Place place(wam, q);
    const ArmCommand command = step(control, wam, q, JointVector::Zero(7), {});
    CHECK((command.torque_Nm - compute_weight_torque(wam, place.posture)).norm() < 1e-12);
    CHECK(command.wrench_share == 1.0);
}

TEST_CASE("arm control: the wrench does at the joints the work that it does at the handle") {
    const ArmModel wam = make_barrett_wam();
    ArmControl control = make_control(wam);
    std::mt19937 random(41);
    for (int k = 0; k < 200; ++k) {
        const JointVector q = make_wam_home() + draw(random, 7, 0.5);
        const JointVector v = draw(random, 7, 1.0);
        const Wrench wrench{draw_vector(random, 5.0), draw_vector(random, 0.1)};
        const Place place(wam, q);
        const ArmCommand command = step(control, wam, q, JointVector::Zero(7), wrench);
        REQUIRE(command.wrench_share == 1.0);
        const double joints_W =
            v.dot(command.torque_Nm - compute_weight_torque(wam, place.posture));
        const Vector6 motion = compute_motion_B(place.posture, v);
        REQUIRE(joints_W == Approx(stack(wrench).dot(motion)).margin(1e-10));
    }
}

TEST_CASE(
    "arm control: no motor gives more than it can, and a wrench too large keeps its direction") {
    const ArmModel wam = make_barrett_wam();
    ArmControl control = make_control(wam, 3.0);
    std::mt19937 random(42);
    int n_scaled = 0;
    for (int k = 0; k < 2000; ++k) {
        const JointVector q = draw(random, 7, 2.0);
        const double size = std::pow(10.0, (k % 7) - 1);
        const Wrench wrench{draw_vector(random, size), draw_vector(random, size)};
        const ArmCommand command = step(control, wam, q, draw(random, 7, 3.0), wrench);
        const JointVector motors = control.compute_motor_torque(command.torque_Nm);
        REQUIRE(find_most(wam, motors) <= 1.0 + 1e-12);
        if (command.wrench_share < 1.0) {
            ++n_scaled;
            // One motor is at its end, and nothing is left for the posture that would need more of it.
            const Place place(wam, q);
            const JointVector given =
                compute_weight_torque(wam, place.posture) +
                command.wrench_share * to_joints(to_eigen(place.posture.jacobian_B).transpose() *
                                                 to_eigen(stack(wrench)));
            REQUIRE(find_most(wam, control.compute_motor_torque(given)) == Approx(1.0));
        }
    }
    CHECK(n_scaled > 500);
}

TEST_CASE("arm control: a share is the room over what is asked, whichever way") {
    const ArmModel model = make_pendulum(1.0, 0.5);  // one motor, 1 Nm
    const ArmControl control(model, {JointVector::Zero(1), 0.0});
    const auto share = [&](double given, double more) {
        return control.compute_share(make_joints({given}), make_joints({more}));
    };
    CHECK(share(0.0, 0.5) == 1.0);
    CHECK(share(0.0, 2.0) == 0.5);
    CHECK(share(0.6, 0.8) == Approx(0.5));
    CHECK(share(0.6, -3.2) == Approx(0.5));
    CHECK(share(1.0, 0.1) == 0.0);
    CHECK(share(1.5, 0.1) == 0.0);
    CHECK(share(1.0, 0.0) == 1.0);
}

TEST_CASE("arm control: bringing the elbow home does not accelerate the handle") {
    const ArmModel wam = make_barrett_wam();
    ArmControl control = make_control(wam, 3.0);
    std::mt19937 random(43);
    for (int k = 0; k < 200; ++k) {
        const JointVector q = make_wam_home() + draw(random, 7, 0.4);
        const JointVector v = draw(random, 7, 0.2);
        const Place place(wam, q);
        const ArmCommand command = step(control, wam, q, v, {});
        REQUIRE(command.posture_share == 1.0);
        const JointVector posture = command.torque_Nm - compute_weight_torque(wam, place.posture);
        const JointVector accelerated =
            to_joints(to_eigen(place.inertia()).llt().solve(to_eigen(posture)));
        const JointVector wanted = -9.0 * (q - make_wam_home()) - 6.0 * v;
        const Vector6 felt = compute_motion_B(place.posture, accelerated);
        const Vector6 unheld = compute_motion_B(place.posture, wanted);
        // The inverse is damped by a millionth of what a kilogram would need.
        REQUIRE(felt.norm() < 1e-4 * unheld.norm());
        REQUIRE(accelerated.norm() > 1e-3 * wanted.norm());
    }
}

TEST_CASE("arm control: singular postures are like any other to it") {
    const ArmModel wam = make_barrett_wam();
    ArmControl control = make_control(wam, 3.0);
    const JointVector straight = JointVector::Zero(7);
    const ArmPosture posture = posture_of(wam, straight);
    REQUIRE(Eigen::FullPivLU<Eigen::MatrixXd>(to_eigen(posture.jacobian_B)).rank() < 6);
    const ArmCommand command = step(control, wam, straight, make_joints({1, 1, 1, 1, 1, 1, 1}),
                                    {Vector3(3.0, 3.0, 3.0), Vector3::Zero()});
    CHECK(command.torque_Nm.allFinite());
    CHECK(find_most(wam, control.compute_motor_torque(command.torque_Nm)) <= 1.0 + 1e-12);
    // A force along the straight arm is carried by its links: only those joints that it passes by feel it.
    ArmControl still = make_control(wam);
    const JointVector pushed =
        step(still, wam, straight, JointVector::Zero(7), {Vector3(0.0, 0.0, 5.0), Vector3::Zero()})
            .torque_Nm -
        compute_weight_torque(wam, posture);
    CHECK(std::abs(pushed(0)) < 1e-12);
    CHECK(std::abs(pushed(1)) < 1e-12);
}

TEST_CASE("arm control: an arm too heavy for its motors gets what they have") {
    ArmModel wam = make_barrett_wam();
    wam.links[3].mass_kg = 200.0;
    ArmControl control = make_control(wam, 3.0);
    const ArmCommand command = step(control, wam, make_wam_home(), JointVector::Zero(7),
                                    {Vector3::Ones(), Vector3::Zero()});
    CHECK(find_most(wam, control.compute_motor_torque(command.torque_Nm)) <= 1.0 + 1e-12);
}

TEST_CASE("stick-slip: one joint sticks, slides and stops as friction says") {
    CHECK(solve_one(make_one(0.9, 1.0, -5.0, 5.0)) == 0.0);
    CHECK(solve_one(make_one(-1.0, 1.0, -5.0, 5.0)) == 0.0);
    CHECK(solve_one(make_one(3.0, 1.0, -5.0, 5.0)) == Approx(1.0));
    CHECK(solve_one(make_one(-3.0, 1.0, -5.0, 5.0)) == Approx(-1.0));
    CHECK(solve_one(make_one(30.0, 1.0, -5.0, 5.0)) == 5.0);
    CHECK(solve_one(make_one(30.0, 1.0, -5.0, 0.0)) == 0.0);
    CHECK(solve_one(make_one(-30.0, 1.0, -5.0, 0.0)) == -5.0);
    CHECK(solve_one(make_one(-3.0, 1.0, 0.0, 0.0)) == 0.0);
    CHECK(solve_one(make_one(3.0, 0.0, -5.0, 5.0)) == Approx(1.5));
}

TEST_CASE("stick-slip: the optimum is found from any sets, and nothing near it is lower") {
    std::mt19937 random(11);
    std::uniform_int_distribution<int> any_hold(0, 4);
    for (int k = 0; k < 2000; ++k) {
        const StickSlipProblem problem = draw_problem(random, 0.1);
        JointHolds holds{};
        for (JointHold& hold : holds) {
            hold = static_cast<JointHold>(any_hold(random));
        }
        JointVector w;
        solve_stick_slip(problem, holds, w);
        for (int i = 0; i < 7; ++i) {
            REQUIRE(w(i) >= problem.low(i));
            REQUIRE(w(i) <= problem.high(i));
        }
        REQUIRE(compute_stick_slip_residual(problem, w) < 1e-10);
        const double least = evaluate(problem, w);
        for (int trial = 0; trial < 20; ++trial) {
            JointVector other = w + draw(random, 7, 0.1);
            for (int i = 0; i < 7; ++i) {
                other(i) = std::clamp(other(i), problem.low(i), problem.high(i));
            }
            REQUIRE(evaluate(problem, other) >= least - 1e-12);
        }
    }
}

TEST_CASE("stick-slip: sets that were found hold again; sweeps find what sets prove") {
    std::mt19937 random(12);
    for (int k = 0; k < 500; ++k) {
        const StickSlipProblem problem = draw_problem(random, 0.1);
        JointHolds holds{};
        JointVector first;
        const bool swept = solve_stick_slip(problem, holds, first).sweeps > 0;
        JointVector settled;
        JointHolds kept = holds;
        const StickSlipCount count = solve_stick_slip(problem, kept, settled);
        // What was swept for stands at zero or at a stop; of which of the two a try may tell better.
        REQUIRE(count.tries <= (swept ? 2 : 1));
        REQUIRE(count.sweeps == 0);
        REQUIRE((settled - first).norm() < 1e-9);
    }
    // Sets that cycle are rare; many draws make sure that some are met.
    random = std::mt19937(13);
    int n_swept = 0;
    for (int k = 0; k < 20000; ++k) {
        const StickSlipProblem problem = draw_problem(random, 0.02);
        JointHolds holds{};
        JointVector w;
        const StickSlipCount count = solve_stick_slip(problem, holds, w);
        if (count.sweeps > 0) {
            ++n_swept;
            REQUIRE(compute_stick_slip_residual(problem, w) < 1e-9);
        }
    }
    CHECK(n_swept > 0);
}
