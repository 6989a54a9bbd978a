#include "haptics/dynamics/integrator.h"

#include "tests/unit/haptics/dynamics/integrator_fixture.h"

#include <catch2/catch.hpp>

#include <array>
#include <limits>
#include <string>

using namespace fulcrum;
using namespace fulcrum::test;

namespace {

// 0.1 kg on 100 N/m, damping ratio 0.1: 5 Hz.
const PointSpringLoad kOscillator({.stiffness_N_per_m = 100.0, .damping_Ns_per_m = 0.632});

// x'' + 2 z w x' + w^2 x = 0 from x0 at rest.
double oscillator_m(double time_s, double start_m) {
    const double w = std::sqrt(100.0 / 0.1);
    const double decay = 0.632 / 0.2;
    const double ringing = std::sqrt(w * w - decay * decay);
    return start_m * std::exp(-decay * time_s) *
           (std::cos(ringing * time_s) + decay / ringing * std::sin(ringing * time_s));
}

double oscillator_error(const IntegratorSettings& settings, int n) {
    RigidState state;
    state.pose_W.position = {0.01, 0.0, 0.0};
    state = run(settings, kBlock, kOscillator, state, 0.35, n);
    return std::abs(state.pose_W.position.x() - oscillator_m(0.35, 0.01));
}

// The block on a coupling with a grip off its centre; the handle moves and turns evenly.
double coupling_error(const IntegratorSettings& settings, int n, const RigidState& converged) {
    ToolCouplingLoad load(make_critically_damped({}, kBlock.mass_kg, kBlock.moments_kg_m2),
                          {0.01, 0.0, 0.02});
    load.set_handle({Pose::at(Vector3::Zero()), {{0.1, 0.0, 0.05}, {0.0, 1.0, 2.0}}}, 0.0);
    const RigidState state = run(settings, kBlock, load, any_state(), 0.05, n);
    return n == 0 ? 0.0 : distance_m(state, converged, 0.03);
}

RigidState converged_coupling() {
    ToolCouplingLoad load(make_critically_damped({}, kBlock.mass_kg, kBlock.moments_kg_m2),
                          {0.01, 0.0, 0.02});
    load.set_handle({Pose::at(Vector3::Zero()), {{0.1, 0.0, 0.05}, {0.0, 1.0, 2.0}}}, 0.0);
    return run(settings_of(Integrator::runge_kutta_4), kBlock, load, any_state(), 0.05, 20000);
}

// Pressed on a plane by its weight and a spring, on three points, and never off it.
struct Pressed {
    std::array<PlaneContact, 3> contacts;
    PlaneContactsLoad contact{contacts};
    ConstantLoad press{{.force = {0.0, -3.0, 0.0}}};
    Loads<PlaneContactsLoad, ConstantLoad> load{contact, press};
    RigidState start;
    Pressed() {
        const std::array<Vector3, 3> feet{Vector3(0.03, -0.01, 0.0), Vector3(-0.02, -0.01, 0.025),
                                          Vector3(-0.02, -0.01, -0.025)};
        for (std::size_t i = 0; i < feet.size(); ++i) {
            contacts[i] = {.point_B = feet[i],
                           .plane_point_W = Vector3::Zero(),
                           .normal_W = Vector3::UnitY(),
                           .stiffness_N_per_m = 2000.0,
                           .damping_Ns_per_m = 3.0,
                           .damping_ramp_m = 0.0};
        }
        start.pose_W.position = {0.0, 0.0092, 0.0};
    }
};

}  // namespace

TEST_CASE("integrator: each converges to a damped oscillation in closed form at its order") {
    for (const Integrator integrator : kIntegrators) {
        CAPTURE(to_string(integrator));
        const auto error_of = [&](int n) { return oscillator_error(settings_of(integrator), n); };
        const int n = integrator == Integrator::runge_kutta_4 ? 60 : 600;
        CHECK(std::abs(measure_order(error_of, n) - theoretical_order(integrator)) < 0.1);
        CHECK(error_of(4 * n) < 1.0e-4);
    }
}

TEST_CASE("integrator: Verlet's order under a damper is that of the velocity it is given") {
    IntegratorSettings settings = settings_of(Integrator::verlet);
    const auto error_of = [&](int n) { return oscillator_error(settings, n); };
    settings.verlet_velocity = VerletVelocity::start_of_step;
    CHECK(std::abs(measure_order(error_of, 600) - 1.0) < 0.1);
    settings.verlet_velocity = VerletVelocity::predicted_midpoint;
    CHECK(std::abs(measure_order(error_of, 600) - 2.0) < 0.1);
}

TEST_CASE("integrator: each converges to torque-free rotation about the middle axis at its order") {
    // Into the first somersault. (At its end RK4's leading error cancels, and it looks like order 5.)
    FreeRotation exact(kBlock.moments_kg_m2, 10.0, 0.999);
    const double duration_s = 0.45 * exact.somersault_s();
    const RigidState start = exact.compute_state(0.0);
    const RigidState end = exact.compute_state(duration_s);
    for (const Integrator integrator : kIntegrators) {
        CAPTURE(to_string(integrator));
        const auto error_of = [&](int n) {
            return compute_angle_rad(
                run(settings_of(integrator), kBlock, Loads<>(), start, duration_s, n)
                    .pose_W.orientation,
                end.pose_W.orientation);
        };
        const double order = theoretical_order(integrator);
        const int n = order == 1.0 ? 40000 : order == 2.0 ? 2000 : 200;
        CHECK(std::abs(measure_order(error_of, n) - order) < 0.15);
        CHECK(error_of(2 * n) < 0.02);
    }
}

TEST_CASE("integrator: each converges on a coupling to a moving handle at its order") {
    const RigidState converged = converged_coupling();
    for (const Integrator integrator : kIntegrators) {
        CAPTURE(to_string(integrator));
        const auto error_of = [&](int n) {
            return coupling_error(settings_of(integrator), n, converged);
        };
        const double order = theoretical_order(integrator);
        CHECK(std::abs(measure_order(error_of, order == 4.0 ? 200 : 1000) - order) < 0.15);
        CHECK(error_of(2000) < 1.0e-4);
    }
}

TEST_CASE("integrator: each converges in a stiff contact that is not left at its order") {
    const Pressed pressed;
    const RigidState converged = run(settings_of(Integrator::runge_kutta_4), kBlock, pressed.load,
                                     pressed.start, 0.03, 30000);
    for (const Integrator integrator : kIntegrators) {
        CAPTURE(to_string(integrator));
        const auto error_of = [&](int n) {
            return distance_m(
                run(settings_of(integrator), kBlock, pressed.load, pressed.start, 0.03, n),
                converged, 0.03);
        };
        const double order = theoretical_order(integrator);
        CHECK(std::abs(measure_order(error_of, order == 4.0 ? 200 : 2000) - order) < 0.15);
    }
}

TEST_CASE("integrator: without torque angular momentum stays, with every one of them") {
    const Vector3 before = compute_angular_momentum_W(kBlock, any_state());
    for (const Integrator integrator : kIntegrators) {
        CAPTURE(to_string(integrator));
        const RigidState state =
            run(settings_of(integrator), kBlock, Loads<>(), any_state(), 10.0, 10000);
        // 1e4 roundings of 1e-16; backward Euler stops at its tolerance of 1e-12 rad/s a step.
        CHECK((compute_angular_momentum_W(kBlock, state) - before).norm() < 1.0e-9 * before.norm());
        CHECK(std::abs(state.pose_W.orientation.norm() - 1.0) < 1.0e-14);
        CHECK((state.velocity_W.linear - any_state().velocity_W.linear).norm() < 1.0e-12);
    }
}

TEST_CASE(
    "integrator: a free spin keeps its energy with Verlet and RK4 and loses it with backward "
    "Euler") {
    FreeRotation exact(kBlock.moments_kg_m2, 10.0, 0.999);
    const RigidState start = exact.compute_state(0.0);
    const double energy_J = compute_kinetic_energy_J(kBlock, start);
    const auto change = [&](Integrator integrator) {
        const RigidState end = run(settings_of(integrator), kBlock, Loads<>(), start, 60.0, 60000);
        return compute_kinetic_energy_J(kBlock, end) / energy_J - 1.0;
    };
    CHECK(std::abs(change(Integrator::verlet)) < 1.0e-5);
    CHECK(std::abs(change(Integrator::runge_kutta_4)) < 1.0e-6);
    CHECK(change(Integrator::explicit_euler) > 1.0e-3);
    CHECK(change(Integrator::backward_euler) < -1.0e-3);
    // The least energy that this angular momentum can have: about the axis of the largest moment.
    const double least =
        std::pow(exact.angular_momentum(), 2) / (2.0 * kBlock.moments_kg_m2.maxCoeff() * energy_J);
    CHECK(1.0 + change(Integrator::backward_euler) >= least * (1.0 - 1.0e-9));
}

TEST_CASE(
    "integrator: an undamped spring keeps its energy with the symplectic ones, gains with "
    "explicit, loses with backward Euler") {
    const PointSpringLoad spring({.stiffness_N_per_m = 100.0});
    RigidState start;
    start.pose_W.position = {0.01, 0.0, 0.0};
    const auto energy_J = [](const RigidState& state) {
        return compute_kinetic_energy_J(kBlock, state) + 50.0 * state.pose_W.position.squaredNorm();
    };
    // The worst over the last 1000 of 1e5 steps, relative.
    const auto worst = [&](Integrator integrator) {
        RigidState state = run(settings_of(integrator), kBlock, spring, start, 99.0, 99000);
        double change = 0.0;
        for (int i = 0; i < 1000; ++i) {
            step_rigid_body(settings_of(integrator), kBlock, spring, 0.0, 0.001, state);
            const double now = energy_J(state) / energy_J(start) - 1.0;
            change = std::abs(now) > std::abs(change) ? now : change;
        }
        return change;
    };
    // Bounded by h w / 2 and (h w)^2 / 8 for ever, h w = 0.0316.
    CHECK(std::abs(worst(Integrator::semi_implicit_euler)) < 0.033);
    CHECK(std::abs(worst(Integrator::verlet)) < 2.6e-4);
    CHECK(std::abs(worst(Integrator::runge_kutta_4)) < 1.0e-4);
    CHECK(worst(Integrator::explicit_euler) > 1.0e3);
    CHECK(worst(Integrator::backward_euler) < -0.999);
}

TEST_CASE("integrator: Verlet retraces its way when velocities are turned round") {
    const PointSpringLoad spring(
        {.point_B = {0.02, 0.01, 0.0}, .anchor_W = {0.0, 0.03, 0.01}, .stiffness_N_per_m = 100.0});
    const IntegratorSettings settings = settings_of(Integrator::verlet);
    RigidState state = run(settings, kBlock, spring, any_state(), 1.0, 500);
    state.velocity_W.linear *= -1.0;
    state.velocity_W.angular *= -1.0;
    state = run(settings, kBlock, spring, state, 1.0, 500);
    CHECK(distance_m(state, any_state(), 0.03) < 1.0e-10);
}

TEST_CASE("integrator: Verlet turns a body with two equal moments freely as it does, in one step") {
    // R(t) = exp(t L / I) R(0) exp(t (1/I_3 - 1/I) L_3 e_3): it goes round L, and about itself.
    for (const double about : {1.0e-7, 4.0e-5}) {
        const Inertia top{0.1, {3.0e-5, about, 3.0e-5}};
        RigidState state = any_state();
        state.velocity_W.angular = state.pose_W.orientation * Vector3(15.0, 40.0, -20.0);
        const Vector3 momentum = compute_angular_momentum_W(top, state);
        const double energy_J = compute_kinetic_energy_J(top, state);
        const double dt_s = 0.02;
        const Quaternion expected =
            compute_exp(dt_s / 3.0e-5 * momentum) * state.pose_W.orientation *
            compute_exp(Vector3(0.0, dt_s * 40.0 * (1.0 - about / 3.0e-5), 0.0));
        step_rigid_body(settings_of(Integrator::verlet), top, Loads<>(), 0.0, dt_s, state);
        CHECK(compute_angle_rad(state.pose_W.orientation, expected) < 1.0e-12);
        CHECK(compute_kinetic_energy_J(top, state) == Approx(energy_J).epsilon(1.0e-12));
    }
}

TEST_CASE("integrator: a step of no length changes nothing") {
    const PointSpringLoad spring({.stiffness_N_per_m = 100.0, .damping_Ns_per_m = 1.0});
    for (const Integrator integrator : kIntegrators) {
        CAPTURE(to_string(integrator));
        RigidState state = any_state();
        CHECK(step_rigid_body(settings_of(integrator), kBlock, spring, 0.0, 0.0, state).moved());
        CHECK(distance_m(state, any_state(), 1.0) < 1.0e-12);
        CHECK((state.velocity_W.linear - any_state().velocity_W.linear).norm() < 1.0e-12);
        CHECK((state.velocity_W.angular - any_state().velocity_W.angular).norm() < 1.0e-12);
    }
}

TEST_CASE("integrator: what is not finite is refused and the state stays as it was") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const ConstantLoad broken({.force = {0.0, nan, 0.0}});
    const ConstantLoad endless({.torque = {0.0, 0.0, std::numeric_limits<double>::infinity()}});
    for (const Integrator integrator : kIntegrators) {
        CAPTURE(to_string(integrator));
        for (const Load* load :
             {static_cast<const Load*>(&broken), static_cast<const Load*>(&endless)}) {
            RigidState state = any_state();
            const StepResult result =
                step_rigid_body(settings_of(integrator), kBlock, *load, 0.0, 0.001, state);
            CHECK(result.status == StepStatus::not_finite);
            CHECK_FALSE(result.moved());
            CHECK(distance_m(state, any_state(), 1.0) == 0.0);
            CHECK(state.velocity_W.linear == any_state().velocity_W.linear);
            CHECK(state.velocity_W.angular == any_state().velocity_W.angular);
        }
        RigidState lost = any_state();
        lost.velocity_W.angular.y() = nan;
        CHECK(
            step_rigid_body(settings_of(integrator), kBlock, Loads<>(), 0.0, 0.001, lost).status ==
            StepStatus::not_finite);
    }
}
