#include "haptics/device/arm/arm_motion.h"

#include "haptics/math/rotation.h"
#include "tests/unit/haptics/device/arm/arm_fixture.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace fulcrum;
using namespace fulcrum::arm_test;

namespace {

constexpr double kDt_s = 0.0005;

GripTarget at_handle(const ArmModel& model, const JointVector& q) {
    const ArmPosture posture = posture_of(model, q);
    return {posture.handle_B, Vector3::Zero()};
}

// Runs for `seconds` without torque.
void run(ArmMotion& motion, const GripTarget& target, double seconds, double dt_s,
         ArmState& state) {
    const JointVector none = JointVector::Zero(state.angle_rad.size());
    for (int k = 0; k < static_cast<int>(std::lround(seconds / dt_s)); ++k) {
        motion.step(none, target, dt_s, state);
    }
}

// A joint with inertia 0.5 kg m^2, without weight.
ArmModel make_wheel(double dry_Nm, double damping) {
    ArmModel model = make_pendulum(2.0, 0.5);
    model.gravity_B.setZero();
    model.links[0].dry_friction_Nm = dry_Nm;
    model.links[0].damping_Nms_per_rad = damping;
    return model;
}

JointVector one(double value) {
    return make_joints({value});
}

}  // namespace

TEST_CASE("arm motion: a pendulum swings widely in the period of the elliptic integral") {
    const double start_rad = 2.0;
    const double omega = std::sqrt(kGravity / 0.5);
    const double period_s = 4.0 / omega * std::comp_ellint_1(std::sin(0.5 * start_rad));
    double last_error_s = 0.0;
    for (const double dt_s : {0.002, 0.001, 0.0005}) {
        ArmMotion motion(make_pendulum(2.0, 0.5));
        motion.hold(kNoGrip);
        ArmState state = at_rest(one(start_rad));
        // The first return to the top of the swing: the velocity passes zero for the second time.
        double time_s = 0.0;
        int n_turns = 0;
        double returned_s = 0.0;
        while (n_turns < 2) {
            const double before = state.speed_rad_per_s(0);
            motion.step(one(0.0), {}, dt_s, state);
            time_s += dt_s;
            const double after = state.speed_rad_per_s(0);
            if (before * after < 0.0) {
                ++n_turns;
                returned_s = time_s - dt_s * after / (after - before);
            }
        }
        const double error_s = std::abs(returned_s - period_s);
        CHECK(error_s < 2e-5 * std::pow(dt_s / 0.0005, 2));
        // Second order: half the step, a quarter of the error.
        if (last_error_s > 0.0) {
            CHECK(last_error_s / error_s == Approx(4.0).epsilon(0.15));
        }
        last_error_s = error_s;
    }
}

TEST_CASE("arm motion: a spring hand moves a wheel as a damped oscillator in closed form") {
    // Small angles of a rod: m l^2 q'' = -l^2 (k q + b q').
    ArmModel model = make_wheel(0.0, 1e-9);
    model.handle = Pose::at(Vector3::Zero());
    ArmMotion motion(model);
    HandGrip grip = kNoGrip;
    grip.push = {1.0, 12.0, 300.0};
    grip.strongest_N = 1000.0;
    motion.hold(grip);
    ArmState state = at_rest(one(1e-4));
    GripTarget target = at_handle(model, one(0.0));
    const double mass_kg = 3.0;
    const double alpha = 12.0 / (2.0 * mass_kg);
    const double omega = std::sqrt(300.0 / mass_kg - alpha * alpha);
    for (int k = 1; k <= 1000; ++k) {
        motion.step(one(0.0), target, kDt_s, state);
        const double t = kDt_s * k;
        const double exact = 1e-4 * std::exp(-alpha * t) *
                             (std::cos(omega * t) + alpha / omega * std::sin(omega * t));
        REQUIRE(state.angle_rad(0) == Approx(exact).margin(6e-10));
    }
}

TEST_CASE("arm motion: the WAM's error falls with the square of the step") {
    const ArmModel wam = make_free_wam();
    const JointVector start = make_joints({0.3, 0.9, -0.4, 1.2, 0.5, -0.6, 0.8});
    const auto swing = [&](double dt_s) {
        ArmMotion motion(wam);
        motion.hold(HandGrip{});
        ArmState state = at_rest(start);
        GripTarget target = at_handle(wam, start);
        target.pose_B.position += Vector3(0.1, -0.05, 0.08);
        run(motion, target, 0.25, dt_s, state);
        return state.angle_rad;
    };
    const JointVector truth = swing(0.25 / 16384.0);
    const double coarse = (swing(0.25 / 256.0) - truth).norm();
    const double middle = (swing(0.25 / 512.0) - truth).norm();
    const double fine = (swing(0.25 / 1024.0) - truth).norm();
    CHECK(coarse / middle == Approx(4.0).epsilon(0.2));
    CHECK(middle / fine == Approx(4.0).epsilon(0.2));
    CHECK(middle < 1e-4);
}

TEST_CASE("arm motion: without friction the WAM keeps its energy for ten seconds of free fall") {
    ArmModel wam = make_free_wam();
    // The last joint turns some fifty times: farther than stops may be.
    for (ArmLink& link : wam.links) {
        link.low_rad = -1.0e4;
        link.high_rad = 1.0e4;
    }
    ArmMotion motion(wam);
    motion.hold(kNoGrip);
    const JointVector start = make_joints({0.0, 1.0, 0.3, 0.8, -0.5, 0.6, 0.0});
    ArmState state = at_rest(start);
    const double before_J = motion.compute_energy_J(state);
    double worst_J = 0.0;
    double most_rad_per_s = 0.0;
    for (int k = 0; k < 20000; ++k) {
        motion.step(JointVector::Zero(7), {}, kDt_s, state);
        worst_J = std::max(worst_J, std::abs(motion.compute_energy_J(state) - before_J));
        most_rad_per_s = std::max(most_rad_per_s, state.speed_rad_per_s.cwiseAbs().maxCoeff());
    }
    INFO("worst drift " << worst_J << " J, fastest joint " << most_rad_per_s << " rad/s");
    // It tumbles; its weight has tens of joules to give.
    CHECK(most_rad_per_s > 10.0);
    CHECK(worst_J < 2.0e-3);
}

TEST_CASE("arm motion: what a held arm loses is what friction and the hand's damper took") {
    ArmModel wam = make_barrett_wam();
    wam.gravity_B.setZero();
    ArmMotion motion(wam);
    HandGrip grip;
    grip.strongest_N = 1000.0;
    grip.strongest_Nm = 100.0;
    motion.hold(grip);
    const JointVector home = make_wam_home();
    GripTarget target = at_handle(wam, home);
    target.pose_B.position += Vector3(0.1, 0.1, -0.05);
    target.pose_B.orientation = compute_exp(Vector3(0.3, 0.2, -0.4)) * target.pose_B.orientation;
    ArmState state = at_rest(home);
    const auto energy_J = [&] {
        return motion.compute_energy_J(state) + motion.compute_grip_energy_J(state, target);
    };
    const double start_J = energy_J();
    double before_J = start_J;
    double lost_J = 0.0;
    constexpr double kShort_s = 0.0001;
    for (int k = 0; k < 10000; ++k) {
        const ArmState last = state;
        motion.step(JointVector::Zero(7), target, kShort_s, state);
        const JointVector mean = 0.5 * (last.speed_rad_per_s + state.speed_rad_per_s);
        const ArmPosture posture = posture_of(wam, 0.5 * (last.angle_rad + state.angle_rad));
        const Vector6 hand = compute_motion_B(posture, mean);
        double power_W = grip.push.damping_Ns_per_m * hand.head<3>().squaredNorm() +
                         grip.turn_damping_Nms_per_rad * hand.tail<3>().squaredNorm();
        for (int i = 0; i < 7; ++i) {
            const ArmLink& link = wam.links[static_cast<std::size_t>(i)];
            power_W += link.damping_Nms_per_rad * mean(i) * mean(i) +
                       link.dry_friction_Nm * std::abs(mean(i));
        }
        lost_J += kShort_s * power_W;
        // It never gains: a ten-thousandth of a millijoule is what the rule leaves in a step.
        REQUIRE(energy_J() <= before_J + 1e-7);
        before_J = energy_J();
    }
    CHECK(start_J - before_J > 1.0);
    CHECK(lost_J == Approx(start_J - before_J).epsilon(2e-3));
}

TEST_CASE(
    "arm motion: dry friction holds exactly what it can, and stops a wheel after I v^2 / 2 f") {
    const ArmModel wheel = make_wheel(0.4, 1e-9);
    ArmMotion motion(wheel);
    motion.hold(kNoGrip);
    ArmState state = at_rest(one(0.2));
    for (int k = 0; k < 1000; ++k) {
        motion.step(one(k % 2 == 0 ? 0.399 : -0.399), {}, kDt_s, state);
    }
    CHECK(state.angle_rad(0) == 0.2);
    CHECK(state.speed_rad_per_s(0) == 0.0);
    // 0.6 Nm beyond friction for half a second.
    for (int k = 0; k < 1000; ++k) {
        motion.step(one(1.0), {}, kDt_s, state);
    }
    const double speed = state.speed_rad_per_s(0);
    CHECK(speed == Approx(0.6 / 0.5 * 0.5));
    const double angle = state.angle_rad(0);
    run(motion, {}, 2.0, kDt_s, state);
    CHECK(state.speed_rad_per_s(0) == 0.0);
    CHECK(state.holds[0] == JointHold::stuck);
    // The step in which it stops is known to within itself.
    CHECK(state.angle_rad(0) - angle == Approx(0.5 * speed * speed / 0.8).margin(speed * kDt_s));
}

TEST_CASE("arm motion: viscous friction alone decays in closed form") {
    ArmMotion motion(make_wheel(0.0, 0.8));
    motion.hold(kNoGrip);
    ArmState state = at_rest(one(0.0));
    state.speed_rad_per_s(0) = 3.0;
    run(motion, {}, 0.5, kDt_s, state);
    CHECK(state.speed_rad_per_s(0) == Approx(3.0 * std::exp(-0.8 / 0.5 * 0.5)).epsilon(1e-6));
}

TEST_CASE("arm motion: a joint that meets its stop stops dead at it and stays while it is pushed") {
    ArmModel wheel = make_wheel(0.0, 1e-9);
    wheel.links[0].high_rad = 1.0;
    ArmMotion motion(wheel);
    motion.hold(kNoGrip);
    ArmState state = at_rest(one(0.0));
    state.speed_rad_per_s(0) = 40.0;
    const double energy_J = motion.compute_energy_J(state);
    for (int k = 0; k < 200; ++k) {
        motion.step(one(1000.0), {}, kDt_s, state);
        REQUIRE(state.angle_rad(0) <= 1.0);
        REQUIRE(state.speed_rad_per_s(0) >= 0.0);
    }
    CHECK(state.angle_rad(0) == 1.0);
    CHECK(state.speed_rad_per_s(0) == 0.0);
    CHECK(motion.compute_energy_J(state) < energy_J);
    // It comes off at once.
    motion.step(one(-1.0), {}, kDt_s, state);
    CHECK(state.speed_rad_per_s(0) < 0.0);
}

TEST_CASE("arm motion: no stop of the WAM is passed, however hard it is thrown about") {
    const ArmModel wam = make_barrett_wam();
    ArmMotion motion(wam);
    HandGrip strong;
    strong.push = {5.0, 100.0, 1.0e5};
    strong.strongest_N = 1000.0;
    strong.turn_stiffness_Nm_per_rad = 100.0;
    strong.strongest_Nm = 100.0;
    std::mt19937 random(31);
    std::uniform_real_distribution<double> any(-3.0, 3.0);
    ArmState state = at_rest(make_wam_home());
    GripTarget target = at_handle(wam, state.angle_rad);
    int n_at_stop = 0;
    for (int k = 0; k < 40000; ++k) {
        if (k % 100 == 0) {
            motion.hold(k % 700 == 0 ? kNoGrip : strong);
            target.pose_B.position = Vector3(any(random), any(random), any(random));
            target.pose_B.orientation =
                compute_exp(Vector3(any(random), any(random), any(random)) * 0.5);
            target.velocity_B = Vector3(any(random), any(random), any(random)) * 10.0;
        }
        motion.step(draw(random, 7, 50.0), target, kDt_s, state);
        for (int i = 0; i < 7; ++i) {
            const ArmLink& link = wam.links[static_cast<std::size_t>(i)];
            REQUIRE(state.angle_rad(i) >= link.low_rad);
            REQUIRE(state.angle_rad(i) <= link.high_rad);
            n_at_stop += state.angle_rad(i) == link.low_rad || state.angle_rad(i) == link.high_rad;
        }
        REQUIRE(state.speed_rad_per_s.allFinite());
    }
    CHECK(n_at_stop > 1000);
}

TEST_CASE("arm motion: the stiffest hand at the longest step stays where it wants to be") {
    const ArmModel wam = make_barrett_wam();
    for (const double damping : {0.0, 100.0, 1000.0}) {
        ArmMotion motion(wam);
        HandGrip grip;
        grip.push = {0.0, damping, 1.0e5};
        grip.turn_stiffness_Nm_per_rad = 100.0;
        grip.turn_damping_Nms_per_rad = 1.0;
        motion.hold(grip);
        ArmState state = at_rest(make_wam_home());
        const GripTarget target = at_handle(wam, state.angle_rad);
        run(motion, target, 4.0, 0.002, state);
        const ArmPosture posture = posture_of(wam, state.angle_rad);
        // It carries the arm's weight, some 30 N there.
        CHECK((posture.handle_B.position - target.pose_B.position).norm() < 1e-3);
        CHECK(state.speed_rad_per_s.cwiseAbs().maxCoeff() < 1e-3);
    }
}

TEST_CASE("arm motion: a far target pulls no harder than the hand can") {
    ArmModel wheel = make_wheel(0.0, 1e-9);
    ArmMotion motion(wheel);
    HandGrip grip = kNoGrip;
    grip.push.stiffness_N_per_m = 1000.0;
    grip.strongest_N = 4.0;
    motion.hold(grip);
    ArmState state = at_rest(one(0.0));
    // Across the rod: 4 N at 0.5 m on 0.5 kg m^2.
    const GripTarget target{Pose::at(Vector3(0.5, 100.0, 0.0)), Vector3::Zero()};
    motion.step(one(0.0), target, kDt_s, state);
    CHECK(state.speed_rad_per_s(0) == Approx(4.0 * 0.5 / 0.5 * kDt_s).epsilon(1e-4));
}
