#include "haptics/dynamics/axle.h"

#include "tests/support/bad_numbers.h"
#include "tests/support/refused.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace fulcrum;

namespace {

AxleSettings make_wheel(double inertia_kg_m2 = 0.2, double friction_Nm = 0.0) {
    AxleSettings wheel;
    wheel.inertia_kg_m2 = inertia_kg_m2;
    wheel.friction_Nm = friction_Nm;
    return wheel;
}

// A weight of 3 N on an arm of 0.4 m to the right of the pivot.
AxleSettings make_pendulum() {
    AxleSettings pendulum = make_wheel(0.05);
    pendulum.pivot_B = {0.1, 0.2, 0.0};
    pendulum.load_B = {0.5, 0.2, 0.0};
    pendulum.load_N = 3.0;
    return pendulum;
}

void step_for(const AxleSettings& axle, double torque_Nm, double seconds, double dt_s,
              AxleState& state) {
    const long n = std::lround(seconds / dt_s);
    for (long i = 0; i < n; ++i) {
        step_axle(axle, torque_Nm, dt_s, state);
    }
}

}  // namespace

TEST_CASE("axle: acceleration is torque over inertia, exactly, and its work is the energy") {
    for (const double dt_s : {1e-3, 1e-2, 0.5}) {
        AxleState state{0.3, -1.0};
        step_for(make_wheel(0.25), 0.5, 3.0, dt_s, state);
        INFO(dt_s);
        CHECK(state.spin_rad_per_s == Approx(-1.0 + 2.0 * 3.0).epsilon(1e-12));
        CHECK(state.angle_rad == Approx(0.3 - 3.0 + 0.5 * 2.0 * 9.0).epsilon(1e-12));
    }
    const AxleSettings wheel = make_wheel(0.07);
    AxleState state{};
    double work_J = 0.0;
    for (int i = 0; i < 5000; ++i) {
        const double torque_Nm = std::sin(0.01 * i) + 0.2;
        const double before_rad = state.angle_rad;
        step_axle(wheel, torque_Nm, 1e-3, state);
        work_J += torque_Nm * (state.angle_rad - before_rad);
    }
    CHECK(compute_axle_energy_J(wheel, state) == Approx(work_J).epsilon(1e-10));
}

TEST_CASE(
    "axle: friction stops it where its work has taken the energy, and holds what pushes less") {
    for (const double dt_s : {1e-3, 7e-3, 10.0}) {
        for (const double sign : {1.0, -1.0}) {
            const AxleSettings wheel = make_wheel(0.2, 0.05);
            AxleState state{0.0, sign * 3.0};
            step_for(wheel, 0.0, 20.0, dt_s, state);
            INFO(dt_s);
            CHECK(state.spin_rad_per_s == 0.0);
            CHECK(state.angle_rad == Approx(sign * 0.5 * 0.2 * 9.0 / 0.05).epsilon(1e-11));
        }
    }
    const AxleSettings wheel = make_wheel(0.2, 0.05);
    AxleState held{0.7, 0.0};
    step_for(wheel, 0.0499, 1.0, 1e-3, held);
    CHECK(held.angle_rad == 0.7);
    CHECK(held.spin_rad_per_s == 0.0);
    AxleState pushed{};
    step_for(wheel, -0.15, 2.0, 1e-3, pushed);
    CHECK(pushed.spin_rad_per_s == Approx(-(0.15 - 0.05) / 0.2 * 2.0));
    // Turned back within one long step: it slows down by 1 rad/s^2, stands at 1 s, and turns back by 0.5 rad/s^2.
    AxleState back{0.0, 1.0};
    step_axle(wheel, -0.15, 2.0, back);
    CHECK(back.spin_rad_per_s == Approx(-0.5));
    CHECK(back.angle_rad == Approx(0.5 - 0.25));
}

TEST_CASE("axle: a hanging weight turns it by r x F") {
    const AxleSettings pendulum = make_pendulum();
    CHECK(compute_load_torque_Nm(pendulum, 0.0) == Approx(-1.2));
    CHECK(compute_load_torque_Nm(pendulum, std::numbers::pi) == Approx(1.2));
    CHECK(compute_load_torque_Nm(pendulum, -std::numbers::pi / 2) == Approx(0.0).margin(1e-12));
    CHECK(compute_axle_torque_Nm(pendulum, Vector3(1, 1, 0), Vector3(1.5, 1, 9),
                                 Vector3(4, -2, 7)) == Approx(0.5 * -2.0));
    AxleSettings across = pendulum;
    across.axis_W = Vector3::UnitX();
    CHECK(compute_load_torque_Nm(across, 0.3) == Approx(0.0).margin(1e-12));
}

TEST_CASE("axle: a pendulum swings as long as theory says and keeps its energy for hours") {
    const AxleSettings pendulum = make_pendulum();
    const double bottom_rad = -std::numbers::pi / 2;
    AxleState state{bottom_rad + 0.01, 0.0};
    const double before_J = compute_axle_energy_J(pendulum, state);
    // T = 2 pi sqrt(I / (W r)). A quarter of a swing later it passes the bottom, where an inertia 0.1 % off would tell: 8e-6 rad.
    const double quarter_s = 0.5 * std::numbers::pi * std::sqrt(0.05 / (3.0 * 0.4));
    step_for(pendulum, 0.0, quarter_s, quarter_s / 1000.0, state);
    CHECK(state.angle_rad == Approx(bottom_rad).margin(5e-7));
    step_for(pendulum, 0.0, quarter_s, quarter_s / 1000.0, state);
    CHECK(state.angle_rad == Approx(bottom_rad - 0.01).margin(1e-6));
    state = {bottom_rad + 1.5, 0.0};
    const double high_J = compute_axle_energy_J(pendulum, state);
    double worst_J = 0.0;
    for (int i = 0; i < 2'000'000; ++i) {
        step_axle(pendulum, 0.0, 1e-3, state);
        worst_J = std::max(worst_J, std::abs(compute_axle_energy_J(pendulum, state) - high_J));
    }
    CHECK(worst_J < 1e-5);
    CHECK(before_J == Approx(-1.2).epsilon(1e-3));
}

TEST_CASE("axle: on another pivot the inertia grows by the mass and the distances' squares") {
    AxleSettings beam = make_wheel(0.5);
    beam.axis_W = Vector3(0.0, 0.6, 0.8);
    beam.mass_kg = 3.0;
    beam.centre_B = {0.2, 0.1, -0.3};
    beam.pivot_B = {-0.1, 0.4, 0.2};
    // Along the axis nothing changes; there and back is the same.
    CHECK(move_pivot(beam, beam.pivot_B + 0.7 * beam.axis_W).inertia_kg_m2 == Approx(0.5));
    const AxleSettings moved = move_pivot(beam, {1.0, 2.0, 3.0});
    CHECK(move_pivot(moved, beam.pivot_B).inertia_kg_m2 == Approx(0.5));
    // From the centre, where it is least, by m d^2.
    const AxleSettings centred = move_pivot(beam, beam.centre_B);
    CHECK(centred.inertia_kg_m2 < 0.5);
    CHECK(move_pivot(centred, beam.centre_B + Vector3(0.4, 0.0, 0.0)).inertia_kg_m2 ==
          Approx(centred.inertia_kg_m2 + 3.0 * 0.16));
    beam.mass_kg = 0.0;
    CHECK(move_pivot(beam, {1.0, 2.0, 3.0}).inertia_kg_m2 == 0.5);
}

TEST_CASE("axle: balance is where the torques cancel, and from there nothing moves") {
    AxleSettings lever = make_pendulum();
    AxleState state{};
    step_for(lever, 1.2, 1.0, 1e-3, state);  // 1.2 N m against 3 N on 0.4 m
    CHECK(state.angle_rad == Approx(0.0).margin(1e-9));
    lever.pivot_B = lever.load_B;  // the support under the weight: nothing to hold
    step_for(lever, 0.0, 1.0, 1e-3, state);
    CHECK(state.angle_rad == Approx(0.0).margin(1e-9));
}

TEST_CASE("axle: it stops at the end of its range, and turns about its pivot, not its middle") {
    AxleSettings lever = make_wheel();
    lever.lowest_rad = -0.1;
    lever.highest_rad = 0.2;
    AxleState state{0.0, 1.0};
    step_for(lever, 0.0, 1.0, 1e-3, state);
    CHECK(state.angle_rad == 0.2);
    CHECK(state.spin_rad_per_s == 0.0);
    step_for(lever, -0.2, 5.0, 1e-3, state);
    CHECK(state.angle_rad == -0.1);
    lever = make_wheel();
    lever.pivot_B = {0.5, 0.0, 0.0};
    const Pose turned =
        compute_turned_pose(lever, std::numbers::pi / 2, Pose::at(Vector3(1, 2, 3)));
    CHECK((turned.position - Vector3(1.5, 1.5, 3.0)).norm() < 1e-12);
    CHECK((turned * Vector3(0.5, 0, 0) - Vector3(1.5, 2, 3)).norm() < 1e-12);
    CHECK((turned * Vector3(1.5, 0, 0) - Vector3(1.5, 3, 3)).norm() < 1e-12);
}

TEST_CASE("axle: what is no time and no torque moves nothing") {
    for (const double dt_s : {0.0, -1.0, kNan, kInfinity}) {
        AxleState state{0.1, 2.0};
        step_axle(make_wheel(), 1.0, dt_s, state);
        CHECK(state.angle_rad == 0.1);
        CHECK(state.spin_rad_per_s == 2.0);
    }
    AxleState state{0.0, 2.0};
    step_axle(make_wheel(), kNan, 0.5, state);
    CHECK(state.angle_rad == Approx(1.0));
}

TEST_CASE("axle: settings out of range are refused with a sentence") {
    using A = AxleSettings;
    check_refused(make_pendulum(), {{&A::inertia_kg_m2, 0.0},
                                    {&A::friction_Nm, -1.0},
                                    {&A::highest_rad, -2e9},
                                    {&A::mass_kg, -1.0},
                                    {&A::load_N, std::nan("")},
                                    [](A& a) { a.axis_W *= 2.0; },
                                    [](A& a) {
                                        a.lowest_rad = 1.0;
                                        a.highest_rad = 0.5;
                                    },
                                    [](A& a) { a.centre_B.x() = std::nan(""); },
                                    [](A& a) { a.load_B.x() = std::nan(""); }});
    AxleSettings still = make_pendulum();
    still.inertia_kg_m2 = 0.0;
    CHECK(to_sentence(validate(still).error()) ==
          "an axle's inertia in kilogram square metres is 0, outside the range 0.0001 to 1e+06; "
          "set it within that range.");
    // 1 kg 1 m from the pivot has 1 kg m^2 about it at least.
    AxleSettings light = make_pendulum();
    light.mass_kg = 1.0;
    light.centre_B = light.pivot_B + Vector3(1.0, 0.0, 0.0);
    CHECK(
        to_sentence(validate(light).error()) ==
        "an axle's inertia is 0.05 kg m^2, and its mass alone, where its centre lies, has 1 about "
        "the pivot; give it that much at least, or less mass.");
}
