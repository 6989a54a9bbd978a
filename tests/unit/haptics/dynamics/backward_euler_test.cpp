#include "haptics/dynamics/integrator.h"
#include "tests/unit/haptics/dynamics/integrator_fixture.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

using namespace fulcrum;
using namespace fulcrum::test;

namespace {

// What backward Euler's equations leave over after a step that began at `time_s`, in m/s and rad/s.
double residual(const Inertia& inertia, const Load& load, double time_s, double dt_s,
                const RigidState& before, const RigidState& after) {
    Wrench wrench;
    load.add_wrench(after, time_s + dt_s, wrench);
    const Vector3 force = inertia.mass_kg * (after.velocity_W.linear - before.velocity_W.linear) -
                          dt_s * wrench.force;
    const Vector3 torque = compute_angular_momentum_W(inertia, after) -
                           compute_angular_momentum_W(inertia, before) - dt_s * wrench.torque;
    const Vector3 place =
        after.pose_W.position - before.pose_W.position - dt_s * after.velocity_W.linear;
    const double turn =
        compute_angle_rad(after.pose_W.orientation,
                          compute_exp(dt_s * after.velocity_W.angular) * before.pose_W.orientation);
    return std::max({force.norm() / inertia.mass_kg,
                     torque.norm() / inertia.moments_kg_m2.minCoeff(), place.norm() / dt_s,
                     turn / dt_s});
}

ToolCouplingLoad stretched_coupling() {
    ToolCouplingLoad load(ToolCouplingSettings{}, {0.01, -0.02, 0.005});
    load.set_handle({{{0.05, 0.02, -0.03}, compute_exp({0.5, 1.0, -0.7})}, {}}, 0.0);
    return load;
}

PlaneContact lean(double side, double z_m) {
    return {.point_B = {0.03 * side, -0.01, z_m},
            .plane_point_W = {0.0, -0.02, 0.0},
            .normal_W = Vector3(0.6 * side, 0.8, 0.0),
            .stiffness_N_per_m = 1.0e4,
            .damping_Ns_per_m = 5.0,
            .damping_ramp_m = 1.0e-4};
}
const std::array<PlaneContact, 2> kWedge{lean(1.0, 0.0), lean(-1.0, 0.01)};

// Steps on from a time, and sees the equations solved in each.
void check_solved(const Load& load, double start_s, double dt_s) {
    CAPTURE(dt_s);
    RigidState state = any_state();
    for (int i = 0; i < 20; ++i) {
        const double time_s = start_s + i * dt_s;
        const RigidState before = state;
        REQUIRE(step_rigid_body(settings_of(Integrator::backward_euler), kBlock, load, time_s, dt_s,
                                state)
                    .status == StepStatus::done);
        // The tolerance, and places and turns rounded to 1e-16 and divided by the step.
        CHECK(residual(kBlock, load, time_s, dt_s, before, state) < 1.0e-9);
    }
}

// A stiff floor under a weight, by a place that is known to a nanometre only; counts how often it is asked.
// NOLINTNEXTLINE(cppcoreguidelines-virtual-class-destructor): never deleted as a Load
class BlurredFloor final : public Load {
  public:
    static constexpr double kBlur_m = 1.0e-9;
    static constexpr double kStiffness_N_per_m = 1.0e8;
    // Ten and a half nanometres: at no place that is known it is held.
    static constexpr double kWeight_N = 1.05;

    void add_wrench(const RigidState& state, double /*time_s*/,
                    Wrench& wrench) const noexcept override {
        ++n_asked_;
        const double depth_m = -kBlur_m * std::round(state.pose_W.position.y() / kBlur_m);
        wrench.force.y() += kStiffness_N_per_m * std::max(0.0, depth_m) - kWeight_N;
    }
    void add_linearised_wrench(const RigidState& state, double time_s, Wrench& wrench,
                               WrenchJacobian& jacobian) const noexcept override {
        add_wrench(state, time_s, wrench);
        jacobian.pose(1, 1) -= state.pose_W.position.y() < 0.0 ? kStiffness_N_per_m : 0.0;
    }
    [[nodiscard]] int take_count() noexcept { return std::exchange(n_asked_, 0); }

  private:
    mutable int n_asked_ = 0;
};

}  // namespace

TEST_CASE("backward Euler: the step solves the implicit equations, from 0.25 to 20 ms") {
    const ToolCouplingLoad coupling = stretched_coupling();
    const PlaneContactsLoad contacts(kWedge);
    for (const double dt_s : {0.00025, 0.001, 0.004, 0.02}) {
        check_solved(Loads(coupling, contacts), 0.0, dt_s);
    }
    // A handle that moves on is asked where it is at the end of the step.
    ToolCouplingLoad moving = stretched_coupling();
    moving.set_handle({{{0.05, 0.02, -0.03}, compute_exp({0.5, 1.0, -0.7})},
                       {{0.4, -0.3, 0.2}, {2.0, -1.0, 3.0}}},
                      0.5);
    check_solved(moving, 0.52, 0.001);
}

TEST_CASE("backward Euler: a load too small for one step's tolerance moves the body all the same") {
    constexpr double kPush_m_per_s2 = 1.0e-7;
    constexpr double kTurn_rad_per_s2 = 1.0e-6;
    constexpr double kStep_s = 0.001;
    constexpr int kSteps = 100000;
    const IntegratorSettings settings;
    REQUIRE(kStep_s * kPush_m_per_s2 < settings.newton_tolerance_m_per_s);
    REQUIRE(kStep_s * kTurn_rad_per_s2 < settings.newton_tolerance_rad_per_s);
    const ConstantLoad load({{0.0, kBlock.mass_kg * kPush_m_per_s2, 0.0},
                             {0.0, 0.0, kBlock.moments_kg_m2.z() * kTurn_rad_per_s2}});
    RigidState state;
    for (int i = 0; i < kSteps; ++i) {
        REQUIRE(step_rigid_body(settings, kBlock, load, i * kStep_s, kStep_s, state).status ==
                StepStatus::done);
    }
    const double took_s = kSteps * kStep_s;
    CHECK(state.velocity_W.linear.y() == Approx(kPush_m_per_s2 * took_s).epsilon(1e-9));
    CHECK(state.velocity_W.angular.z() == Approx(kTurn_rad_per_s2 * took_s).epsilon(1e-9));
}

TEST_CASE("backward Euler: Newton converges quadratically, so a smooth step takes a few solves") {
    const ToolCouplingLoad coupling = stretched_coupling();
    RigidState state = any_state();
    const StepResult result = step_rigid_body(settings_of(Integrator::backward_euler), kBlock,
                                              coupling, 0.0, 0.001, state);
    CHECK(result.status == StepStatus::done);
    CHECK(result.n_solves <= 4);
    // The size of what is left after one, two and three solves: each about the square of the last.
    std::array<double, 3> left{};
    for (int n = 1; n <= 3; ++n) {
        IntegratorSettings few = settings_of(Integrator::backward_euler);
        few.newton_iterations = n;
        RigidState after = any_state();
        step_rigid_body(few, kBlock, coupling, 0.0, 0.004, after);
        left[static_cast<std::size_t>(n - 1)] =
            residual(kBlock, coupling, 0.0, 0.004, any_state(), after);
    }
    CHECK(left[1] < 0.05 * left[0]);
    CHECK(left[2] < 1.0e-3 * left[1]);
}

TEST_CASE("backward Euler: a linear force is solved at once; one solve a step is first order") {
    // v' = (v - h k/m x) / (1 + h b/m + h^2 k/m), about the centre: no turning.
    const PointSpringLoad spring({.stiffness_N_per_m = 800.0, .damping_Ns_per_m = 3.0});
    RigidState state;
    state.pose_W.position = {0.01, 0.0, 0.0};
    state.velocity_W.linear = {0.3, 0.0, 0.0};
    const double h = 0.002;
    const StepResult result =
        step_rigid_body(settings_of(Integrator::backward_euler), kBlock, spring, 0.0, h, state);
    CHECK(result.n_solves == 1);
    const double m = kBlock.mass_kg;
    const double v = (0.3 - h * 800.0 / m * 0.01) / (1.0 + h * 3.0 / m + h * h * 800.0 / m);
    CHECK(state.velocity_W.linear.x() == Approx(v).epsilon(1e-12));
    CHECK(state.pose_W.position.x() == Approx(0.01 + h * v).epsilon(1e-12));
    IntegratorSettings once = settings_of(Integrator::backward_euler);
    once.newton_iterations = 1;
    const ToolCouplingLoad coupling = stretched_coupling();
    state = any_state();
    const StepResult of_one = step_rigid_body(once, kBlock, coupling, 0.0, 0.001, state);
    CHECK(of_one.status == StepStatus::iterations_spent);
    CHECK(of_one.moved());
    CHECK(of_one.n_solves == 1);
    const RigidState converged =
        run(settings_of(Integrator::runge_kutta_4), kBlock, coupling, any_state(), 0.05, 20000);
    const auto error_of = [&](int n) {
        return distance_m(run(once, kBlock, coupling, any_state(), 0.05, n), converged, 0.03);
    };
    CHECK(std::abs(measure_order(error_of, 2000) - 1.0) < 0.1);
}

TEST_CASE("backward Euler: one solve a step is taken as it comes; two that overshoot are not") {
    // F = -F0 tanh(x / x0), let go where it is flat: the linear step is h F0 / m, far beyond the other side.
    static constexpr double kBend_m = 1.0e-5;
    class Flattening final : public Load {
      public:
        void add_wrench(const RigidState& state, double, Wrench& wrench) const noexcept override {
            wrench.force.x() -= 10.0 * std::tanh(state.pose_W.position.x() / kBend_m);
        }
        void add_linearised_wrench(const RigidState& state, double time_s, Wrench& wrench,
                                   WrenchJacobian& jacobian) const noexcept override {
            add_wrench(state, time_s, wrench);
            const double slope = 1.0 / std::cosh(state.pose_W.position.x() / kBend_m);
            jacobian.pose(0, 0) -= 10.0 / kBend_m * slope * slope;
        }
    };
    RigidState start;
    start.pose_W.position.x() = 2.0e-4;
    IntegratorSettings settings;
    settings.newton_iterations = 1;
    RigidState linear = start;
    CHECK(step_rigid_body(settings, kBlock, Flattening(), 0.0, 0.01, linear).status ==
          StepStatus::iterations_spent);
    CHECK(linear.velocity_W.linear.x() == Approx(-0.01 * 10.0 / kBlock.mass_kg).epsilon(1e-9));
    // With two, what is known to be best is where it started.
    settings.newton_iterations = 2;
    RigidState best = start;
    CHECK(step_rigid_body(settings, kBlock, Flattening(), 0.0, 0.01, best).status ==
          StepStatus::iterations_spent);
    CHECK(best.velocity_W.linear.x() == 0.0);
}

TEST_CASE("backward Euler: stays stable on a spring 1e5 times too stiff for explicit methods") {
    const PointSpringLoad spring({.point_B = {0.01, 0.0, 0.0}, .stiffness_N_per_m = 1.0e9});
    RigidState state = any_state();
    const auto energy_J = [&] {
        const Vector3 stretch = state.pose_W * Vector3(0.01, 0.0, 0.0);
        return compute_kinetic_energy_J(kBlock, state) + 0.5e9 * stretch.squaredNorm();
    };
    double before_J = energy_J();
    for (int i = 0; i < 2000; ++i) {
        REQUIRE(step_rigid_body(IntegratorSettings{}, kBlock, spring, 0.0, 0.001, state).moved());
        REQUIRE(energy_J() <= before_J * (1.0 + 1.0e-6));
        before_J = energy_J();
    }
}

TEST_CASE("backward Euler: a system without a solution is singular, and the state stays") {
    // m - h b = 0 along `axis`, for a damper that drives: b = m / h.
    class Driver final : public Load {
      public:
        explicit Driver(const Vector3& axis) : by_velocity_(100.0 * axis * axis.transpose()) {}
        void add_wrench(const RigidState& state, double, Wrench& wrench) const noexcept override {
            wrench.force += by_velocity_ * state.velocity_W.linear + Vector3::UnitX();
        }
        void add_linearised_wrench(const RigidState& state, double time_s, Wrench& wrench,
                                   WrenchJacobian& jacobian) const noexcept override {
            add_wrench(state, time_s, wrench);
            jacobian.velocity.topLeftCorner<3, 3>() += by_velocity_;
        }

      private:
        Matrix3 by_velocity_;
    };
    // Off the axes the pivot that should be zero is what rounding leaves of it.
    for (const Vector3& axis :
         {Vector3(1.0, 0.0, 0.0), Vector3(Vector3(1.0, 2.0, 3.0).normalized()),
          Vector3(Vector3(0.3, -0.5, 0.7).normalized())}) {
        RigidState state = any_state();
        const StepResult result = step_rigid_body(settings_of(Integrator::backward_euler), kBlock,
                                                  Driver(axis), 0.0, 0.001, state);
        CHECK(result.status == StepStatus::singular);
        CHECK_FALSE(result.moved());
        CHECK(distance_m(state, any_state(), 1.0) == 0.0);
    }
}

TEST_CASE("backward Euler: a contact that is struck within the step is solved in a few solves") {
    const PlaneContactsLoad contacts(kWedge);
    int worst = 0;
    for (int i = 0; i < 400; ++i) {
        RigidState state;
        state.pose_W.position = {0.0, 0.01 - 1.0e-4 * i, 0.0};
        state.velocity_W.linear = {0.1, -2.0, 0.0};
        state.velocity_W.angular = {0.0, 5.0, 20.0};
        const StepResult result =
            step_rigid_body(IntegratorSettings{}, kBlock, contacts, 0.0, 0.004, state);
        REQUIRE(result.moved());
        worst = std::max(worst, result.n_solves);
        CHECK(result.status == StepStatus::done);
    }
    CHECK(worst <= 8);
}

TEST_CASE("backward Euler: a strike that no step solves ends at the best and gains no energy") {
    // The plain Kelvin-Voigt law jumps at the touch, so a step that would end there has no solution.
    const std::array<PlaneContact, 1> plane{{{.point_B = {0.0, -0.01, 0.0},
                                              .plane_point_W = Vector3::Zero(),
                                              .normal_W = Vector3::UnitY(),
                                              .stiffness_N_per_m = 2000.0,
                                              .damping_Ns_per_m = 20.0,
                                              .damping_ramp_m = 0.0}}};
    const PlaneContactsLoad contact(plane);
    const Inertia inertia = make_ball_inertia(0.01, 0.02);
    int n_spent = 0;
    double worst = 0.0;
    for (int i = 0; i < 2000; ++i) {
        RigidState state;
        state.pose_W.position.y() = 0.01 + 1.0e-6 * i;
        state.velocity_W.linear.y() = -1.0;
        const double before_J = compute_kinetic_energy_J(inertia, state);
        const StepResult result =
            step_rigid_body(IntegratorSettings{}, inertia, contact, 0.0, 0.001, state);
        REQUIRE(result.moved());
        n_spent += result.status == StepStatus::iterations_spent ? 1 : 0;
        const double depth_m = std::max(0.0, compute_depth_m(plane[0], state.pose_W));
        const double after_J =
            compute_kinetic_energy_J(inertia, state) + 0.5 * 2000.0 * depth_m * depth_m;
        worst = std::max(worst, after_J / before_J);
    }
    CAPTURE(n_spent);
    CHECK(n_spent > 0);
    CHECK(worst <= 1.0 + 1.0e-9);
}

TEST_CASE(
    "backward Euler: it ends where loads cannot tell places apart, and finds stiff contacts as "
    "before") {
    const Inertia inertia = make_ball_inertia(0.02, 0.02);
    BlurredFloor floor;
    IntegratorSettings by_tolerance;
    IntegratorSettings by_place;
    by_place.least_way_m = 1.0e-8;
    by_place.least_turn_rad = 1.0e-7;
    // At rest on the floor.
    const double held_m = -BlurredFloor::kWeight_N / BlurredFloor::kStiffness_N_per_m;
    RigidState state;
    state.pose_W.position.y() = held_m;
    for (const bool blurred : {false, true}) {
        RigidState now = state;
        for (int i = 0; i < 100; ++i) {
            const StepResult result = step_rigid_body(blurred ? by_place : by_tolerance, inertia,
                                                      floor, 0.001 * i, 0.001, now);
            CHECK(result.status == (blurred ? StepStatus::done : StepStatus::iterations_spent));
            CHECK(std::abs(now.pose_W.position.y() - held_m) < 2.0 * BlurredFloor::kBlur_m);
        }
        const int n_asked = floor.take_count();
        CHECK((blurred ? n_asked < 300 : n_asked > 2000));
    }
    // Falling on it from any height within a step, and from next to none.
    for (const double height_m : {1.0e-3, 1.0e-4, 1.0e-6, 3.0e-8, 1.0e-9}) {
        for (const double speed_m_per_s : {0.0, 1.0e-6, 0.01, 2.0}) {
            RigidState falls;
            falls.pose_W.position.y() = height_m;
            falls.velocity_W.linear.y() = -speed_m_per_s;
            RigidState other = falls;
            double lowest_m = 0.0;
            double other_lowest_m = 0.0;
            for (int k = 0; k < 20; ++k) {
                (void)step_rigid_body(by_tolerance, inertia, floor, 0.001 * k, 0.001, falls);
                (void)step_rigid_body(by_place, inertia, floor, 0.001 * k, 0.001, other);
                lowest_m = std::min(lowest_m, falls.pose_W.position.y());
                other_lowest_m = std::min(other_lowest_m, other.pose_W.position.y());
            }
            CAPTURE(height_m, speed_m_per_s, lowest_m);
            CHECK(std::abs(other_lowest_m - lowest_m) < 2.0 * BlurredFloor::kBlur_m);
        }
    }
}

TEST_CASE("backward Euler: without time it ends with its best, which felt the load, and says so") {
    // A wall whose damper comes in with the depth, so that Newton needs several steps.
    class Hurried final : public Load {
      public:
        explicit Hurried(int n_looks) : n_left_(n_looks) {}
        void add_wrench(const RigidState& state, double time_s,
                        Wrench& wrench) const noexcept override {
            --n_left_;
            contacts_.add_wrench(state, time_s, wrench);
        }
        void add_linearised_wrench(const RigidState& state, double time_s, Wrench& wrench,
                                   WrenchJacobian& jacobian) const noexcept override {
            contacts_.add_linearised_wrench(state, time_s, wrench, jacobian);
        }
        [[nodiscard]] bool has_time() const noexcept override { return n_left_ > 0; }

      private:
        std::array<PlaneContact, 1> planes_{{{.plane_point_W = {0.0, 0.0, 0.0},
                                              .stiffness_N_per_m = 1.0e5,
                                              .damping_Ns_per_m = 50.0,
                                              .damping_ramp_m = 1.0e-3}}};
        PlaneContactsLoad contacts_{planes_};
        mutable int n_left_;
    };
    const auto step = [](int n_looks, RigidState& state) {
        state.pose_W.position = {0.0, 0.01, 0.0};
        state.velocity_W.linear = {0.1, -2.0, 0.0};
        return step_rigid_body(settings_of(Integrator::backward_euler), kBlock, Hurried(n_looks),
                               0.0, 0.01, state);
    };
    RigidState all;
    REQUIRE(step(1000, all).status == StepStatus::done);
    RigidState some;
    const StepResult result = step(1, some);
    CHECK(result.status == StepStatus::out_of_time);
    CHECK(result.moved());
    CHECK(result.n_solves == 1);
    CHECK(some.velocity_W.linear.y() > -1.0);  // it did not fall on
}
