#include "haptics/dynamics/integrator.h"

#include "tests/support/bad_numbers.h"
#include "tests/support/refused.h"
#include "tests/unit/haptics/dynamics/integrator_fixture.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <string>

using namespace fulcrum;
using namespace fulcrum::test;

namespace {

// A problem whose end is known, and how finely it is stepped.
struct Problem {
    const Load& load;
    RigidState start, end;
    double duration_s;
    double reach_m;            // of the point whose error counts
    std::array<int, 3> steps;  // by methods of order 1, 2 and 4
    double order_within = 0.15;
    int finer = 2;  // so many times as many steps leave less than `most_m`
    double most_m = 1.0e-4;
};

void check_order(const Problem& problem) {
    for (const Integrator integrator : kIntegrators) {
        CAPTURE(to_string(integrator));
        const auto error_of = [&](int n) {
            const RigidState end = run(settings_of(integrator), kBlock, problem.load, problem.start,
                                       problem.duration_s, n);
            return distance_m(end, problem.end, problem.reach_m);
        };
        const double order = theoretical_order(integrator);
        const int n = problem.steps[order == 1.0 ? 0 : order == 2.0 ? 1 : 2];
        CHECK(std::abs(measure_order(error_of, n) - order) < problem.order_within);
        CHECK(error_of(problem.finer * n) < problem.most_m);
    }
}

// The same, its end by RK4 in so many steps.
RigidState converge(const Load& load, const RigidState& start, double duration_s, int n) {
    return run(settings_of(Integrator::runge_kutta_4), kBlock, load, start, duration_s, n);
}

// 0.1 kg on 100 N/m, damping ratio 0.1: 5 Hz. x'' + 2 z w x' + w^2 x = 0 from x0 at rest.
const PointSpringLoad kOscillator({.stiffness_N_per_m = 100.0, .damping_Ns_per_m = 0.632});

Problem make_oscillation() {
    constexpr double kTime_s = 0.35;
    const double w = std::sqrt(100.0 / 0.1);
    const double decay = 0.632 / 0.2;
    const double ringing = std::sqrt(w * w - decay * decay);
    Problem problem{kOscillator, {}, {}, kTime_s, 0.0, {600, 600, 60}, 0.1, 4, 1.0e-4};
    problem.start.pose_W.position.x() = 0.01;
    problem.end.pose_W.position.x() =
        0.01 * std::exp(-decay * kTime_s) *
        (std::cos(ringing * kTime_s) + decay / ringing * std::sin(ringing * kTime_s));
    return problem;
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

TEST_CASE("integrator: each converges at its order") {
    SECTION("to a damped oscillation in closed form") {
        check_order(make_oscillation());
    }
    SECTION("to torque-free rotation about the middle axis") {
        // Into the first somersault. (At its end RK4's leading error cancels, and it looks like order 5.)
        FreeRotation exact(kBlock.moments_kg_m2, 10.0, 0.999);
        const double duration_s = 0.45 * exact.somersault_s();
        check_order({Loads<>(),
                     exact.compute_state(0.0),
                     exact.compute_state(duration_s),
                     duration_s,
                     1.0,
                     {40000, 2000, 200},
                     0.15,
                     2,
                     0.02});
    }
    SECTION("on a coupling, with a grip off its centre, to a handle that moves and turns evenly") {
        ToolCouplingLoad load(make_critically_damped({}, kBlock.mass_kg, kBlock.moments_kg_m2),
                              {0.01, 0.0, 0.02});
        load.set_handle({Pose::at(Vector3::Zero()), {{0.1, 0.0, 0.05}, {0.0, 1.0, 2.0}}}, 0.0);
        check_order({load,
                     any_state(),
                     converge(load, any_state(), 0.05, 20000),
                     0.05,
                     0.03,
                     {1000, 1000, 200}});
    }
    SECTION("in a stiff contact that is not left") {
        const Pressed pressed;
        check_order({pressed.load,
                     pressed.start,
                     converge(pressed.load, pressed.start, 0.03, 30000),
                     0.03,
                     0.03,
                     {2000, 2000, 200}});
    }
}

TEST_CASE("integrator: Verlet's order under a damper is that of the velocity it is given") {
    const Problem problem = make_oscillation();
    for (const bool at_start : {true, false}) {
        IntegratorSettings settings = settings_of(Integrator::verlet);
        settings.verlet_velocity =
            at_start ? VerletVelocity::start_of_step : VerletVelocity::predicted_midpoint;
        const auto error_of = [&](int n) {
            return distance_m(
                run(settings, kBlock, kOscillator, problem.start, problem.duration_s, n),
                problem.end, 0.0);
        };
        CHECK(std::abs(measure_order(error_of, 600) - (at_start ? 1.0 : 2.0)) < 0.1);
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

TEST_CASE("integrator: a free spin keeps its energy with Verlet and RK4, backward Euler loses it") {
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

TEST_CASE("integrator: an undamped spring keeps its energy with the symplectic ones alone") {
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

TEST_CASE("integrator: a step of no length, or of what is not finite, changes nothing") {
    const PointSpringLoad spring({.stiffness_N_per_m = 100.0, .damping_Ns_per_m = 1.0});
    for (const Integrator integrator : kIntegrators) {
        CAPTURE(to_string(integrator));
        RigidState state = any_state();
        CHECK(step_rigid_body(settings_of(integrator), kBlock, spring, 0.0, 0.0, state).moved());
        CHECK(distance_m(state, any_state(), 1.0) < 1.0e-12);
        CHECK((state.velocity_W.linear - any_state().velocity_W.linear).norm() < 1.0e-12);
        CHECK((state.velocity_W.angular - any_state().velocity_W.angular).norm() < 1.0e-12);
    }
    const ConstantLoad broken({.force = {0.0, kNan, 0.0}});
    const ConstantLoad endless({.torque = {0.0, 0.0, kInfinity}});
    for (const Integrator integrator : kIntegrators) {
        CAPTURE(to_string(integrator));
        const auto step = [&](const Load& load, RigidState& state) {
            return step_rigid_body(settings_of(integrator), kBlock, load, 0.0, 0.001, state);
        };
        for (const ConstantLoad* load : {&broken, &endless}) {
            RigidState state = any_state();
            const StepResult result = step(*load, state);
            CHECK(result.status == StepStatus::not_finite);
            CHECK_FALSE(result.moved());
            CHECK(distance_m(state, any_state(), 1.0) == 0.0);
            CHECK(state.velocity_W.linear == any_state().velocity_W.linear);
            CHECK(state.velocity_W.angular == any_state().velocity_W.angular);
        }
        RigidState lost = any_state();
        lost.velocity_W.angular.y() = kNan;
        CHECK(step(Loads<>(), lost).status == StepStatus::not_finite);
    }
}

// A torque about a fixed axis that follows time alone: t^3, which four stages integrate exactly (Simpson's rule).
class TimedTorque final : public Load {
  public:
    void add_wrench(const RigidState& /*state*/, double time_s,
                    Wrench& wrench) const noexcept override {
        wrench.force.x() += time_s * time_s * time_s;
        wrench.torque.z() += 1.0e-4 * time_s * time_s;
    }
    void add_linearised_wrench(const RigidState& state, double time_s, Wrench& wrench,
                               WrenchJacobian& /*jacobian*/) const noexcept override {
        add_wrench(state, time_s, wrench);
    }
};

TEST_CASE("RK4: exact for forces cubic in time, for even spins, and for free turns") {
    RigidState state;
    step_rigid_body(settings_of(Integrator::runge_kutta_4), kBlock, TimedTorque(), 1.0, 0.5, state);
    // The integral of t^3 from 1 to 1.5 over the mass; the torque's turns about z alone.
    CHECK(state.velocity_W.linear.x() ==
          Approx((std::pow(1.5, 4) - 1.0) / 4.0 / kBlock.mass_kg).epsilon(1e-12));
    CHECK(
        state.velocity_W.angular.z() ==
        Approx(1.0e-4 * (std::pow(1.5, 3) - 1.0) / 3.0 / kBlock.moments_kg_m2.z()).epsilon(1e-12));
    state = RigidState();
    state.velocity_W.angular = {0.0, 0.0, 40.0};
    step_rigid_body(settings_of(Integrator::runge_kutta_4), kBlock, Loads<>(), 0.0, 0.1, state);
    CHECK(compute_angle_rad(state.pose_W.orientation, compute_exp({0.0, 0.0, 4.0})) < 1.0e-12);
    FreeRotation exact(kBlock.moments_kg_m2, 10.0, 0.9);
    const RigidState start = exact.compute_state(0.0);
    const RigidState end = exact.compute_state(1.0);
    const RigidState turned =
        run(settings_of(Integrator::runge_kutta_4), kBlock, Loads<>(), start, 1.0, 1000);
    CHECK(compute_angle_rad(turned.pose_W.orientation, end.pose_W.orientation) < 1.0e-8);
    CHECK((turned.velocity_W.angular - end.velocity_W.angular).norm() < 1.0e-7);
}

TEST_CASE("integrator settings: known by their names; what is out of range is refused") {
    for (const Integrator integrator : kIntegrators) {
        const auto found = find_integrator(to_string(integrator));
        REQUIRE(found);
        CHECK(*found == integrator);
    }
    CHECK(to_string(Integrator::runge_kutta_4) == "RK4");
    CHECK(is_refused(find_integrator("leapfrog"), "leapfrog"));
    CHECK(is_refused(find_integrator("leapfrog"), "backward Euler"));
    using S = IntegratorSettings;
    CHECK(S{}.integrator == Integrator::backward_euler);
    check_refused(S{}, {{&S::least_way_m, -1.0e-9},
                        {&S::least_turn_rad, 0.1},
                        {&S::newton_iterations, 0},
                        {&S::newton_iterations, 101},
                        {&S::newton_tolerance_m_per_s, 0.0},
                        {&S::newton_tolerance_rad_per_s, 2.0},
                        {&S::newton_tolerance_rad_per_s, kNan}});
    CHECK(validate(Inertia{}));
    CHECK(validate(make_box_inertia(0.1, {0.02, 0.03, 0.0})));
    CHECK(validate(make_ball_inertia(0.01, 0.03)));
    using I = Inertia;
    check_refused(I{0.1, {1e-5, 1e-5, 1e-5}},
                  {{&I::mass_kg, 0.0},
                   {&I::mass_kg, kInfinity},
                   [](I& inertia) { inertia.moments_kg_m2.z() = 0.0; },
                   [](I& inertia) { inertia.moments_kg_m2.z() = 2.1e-5; },
                   [](I& inertia) { inertia.moments_kg_m2.y() = kNan; }});
}
