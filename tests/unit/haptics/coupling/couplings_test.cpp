#include "haptics/coupling/passivity.h"
#include "haptics/coupling/tool_coupling.h"
#include "haptics/coupling/velocity_estimator.h"
#include "haptics/coupling/virtual_coupling.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/refused.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <rapidcheck.h>

using namespace fulcrum;

namespace {

constexpr double kRounding = 1.0e-12;

const ToolCouplingSettings kPlain{
    .shift = {.stiffness_N_per_m = 500.0, .damping_Ns_per_m = 4.0},
    .turn = {.stiffness_Nm_per_rad = 0.5, .damping_Nms_per_rad = {2e-3, 2e-3, 2e-3}}};

ToolCouplingSettings saturating() {
    ToolCouplingSettings settings = kPlain;
    settings.shift.linear_range_m = 0.004;
    settings.shift.saturation_range_m = 0.016;
    settings.shift.saturation_force_N = 5.0;
    settings.turn.linear_range_rad = 0.2;
    settings.turn.saturation_range_rad = 0.8;
    settings.turn.saturation_torque_Nm = 0.3;
    return settings;
}

MovingFrame at(const Vector3& position, const Vector3& turn) {
    return {{position, compute_exp(turn)}, {}};
}

double force_at(const ToolCouplingSettings& settings, double stretch_m) {
    const Vector3 along = Vector3(1.0, 2.0, -2.0) / 3.0;
    return compute_tool_coupling(settings, at(stretch_m * along, Vector3::Zero()),
                                 at(Vector3::Zero(), Vector3::Zero()))
        .force.dot(along);
}

double torque_at(const ToolCouplingSettings& settings, double turn_rad) {
    const Vector3 along = Vector3(2.0, -1.0, 2.0) / 3.0;
    return compute_tool_coupling(settings, at(Vector3::Zero(), turn_rad * along),
                                 at(Vector3::Zero(), Vector3::Zero()))
        .torque.dot(along);
}

const CouplingSettings kLinear{.stiffness_N_per_m = 800.0, .damping_Ns_per_m = 2.0};
// k s1 = 2 N; the blend ends at 5 N.
const CouplingSettings kSaturating{.stiffness_N_per_m = 800.0,
                                   .damping_Ns_per_m = 2.0,
                                   .linear_range_m = 0.0025,
                                   .saturation_range_m = 0.012,
                                   .saturation_force_N = 5.0};

double slope(const CouplingSettings& settings, double stretch_m) {
    const double step_m = 1.0e-8;
    return (compute_spring_force_N(settings, stretch_m + step_m) -
            compute_spring_force_N(settings, stretch_m - step_m)) /
           (2.0 * step_m);
}

}  // namespace

// What settings of this folder take and refuse.

TEST_CASE("passivity and velocity settings: the ranges named at each field, and nothing else") {
    CHECK(PassivitySettings{}.on);
    check_ranges(
        PassivitySettings{},
        {{"handle_mass_kg", [](auto& s) -> double& { return s.handle_mass_kg; }, 0.001, 10.0},
         {"handle_inertia_kg_m2", [](auto& s) -> double& { return s.handle_inertia_kg_m2; }, 1e-8,
          1.0},
         {"headroom_J", [](auto& s) -> double& { return s.headroom_J; }, 0.0, 0.01},
         {"memory_s", [](auto& s) -> double& { return s.memory_s; }, 0.01, 10.0}});
    check_ranges(
        VelocitySettings{},
        {{"cut-off in hertz", [](auto& s) -> double& { return s.cutoff_Hz; }, 1.0, 1000.0},
         {"noise bound", [](auto& s) -> double& { return s.noise_bound_m; }, 1e-9, 0.1},
         {"longest window", [](auto& s) -> double& { return s.longest_window_s; }, 0.0002, 0.008},
         {"acceleration density", [](auto& s) -> double& { return s.acceleration_density; }, 1e-12,
          1e6}});
}

TEST_CASE("virtual coupling settings: ranges, and a blend that does not fall") {
    check_ranges(CouplingSettings{},
                 {{"stiffness", [](auto& s) -> double& { return s.stiffness_N_per_m; }, 0.0, 1e5},
                  {"damping", [](auto& s) -> double& { return s.damping_Ns_per_m; }, 0.0, 1e3}});
    CHECK(validate(CouplingSettings{.stiffness_N_per_m = 800.0, .damping_Ns_per_m = 2.0}));
    const CouplingSettings saturating{.stiffness_N_per_m = 800.0,
                                      .damping_Ns_per_m = 2.0,
                                      .linear_range_m = 0.0025,
                                      .saturation_range_m = 0.012,
                                      .saturation_force_N = 5.0};
    check_refused(
        saturating,
        {[](auto& s) { s.linear_range_m = std::nan(""); }, [](auto& s) { s.linear_range_m = -1.0; },
         [](auto& s) { s.saturation_range_m = std::nan(""); },
         [](auto& s) { s.saturation_range_m = -1.0; }, [](auto& s) { s.saturation_range_m = 0.0; },
         [](auto& s) { s.saturation_force_N = std::nan(""); },
         [](auto& s) { s.saturation_force_N = -1.0; },
         [](auto& s) { s.saturation_force_N = 2.1; }});
}

TEST_CASE("tool coupling settings: ranges, no torque that falls, and a clamp or saturation") {
    check_ranges(ToolCouplingSettings{},
                 {{"damping_Nms_per_rad.x",
                   [](auto& s) -> double& { return s.turn.damping_Nms_per_rad.x(); }, 0.0, 100.0},
                  {"damping_Nms_per_rad.y",
                   [](auto& s) -> double& { return s.turn.damping_Nms_per_rad.y(); }, 0.0, 100.0},
                  {"damping_Nms_per_rad.z",
                   [](auto& s) -> double& { return s.turn.damping_Nms_per_rad.z(); }, 0.0, 100.0},
                  {"stiffness_Nm_per_rad",
                   [](auto& s) -> double& { return s.turn.stiffness_Nm_per_rad; }, 0.0, 1e3},
                  {"clamp_m", [](auto& s) -> double& { return s.clamp_m; }, 0.0, 1.0}});
    check_refused(ToolCouplingSettings{},
                  {[](auto& s) { s.shift.stiffness_N_per_m = -1.0; },
                   [](auto& s) { s.shift.damping_Ns_per_m = std::nan(""); },
                   [](auto& s) { s.clamp_rad = -0.05; }, [](auto& s) { s.clamp_rad = 4.0; }});
    // Linear range, saturation range and torque.
    ToolCouplingSettings saturating;
    saturating.turn = {0.5, Vector3::Zero(), 0.1, 1.0, 0.3};
    check_refused(saturating, {[](auto& s) {
                                   s.turn = {0.5, Vector3::Zero(), 1.0, 0.5, 0.6};
                               },
                               [](auto& s) { s.turn.saturation_torque_Nm = 0.19; },
                               [](auto& s) { s.turn.saturation_range_rad = kInfinity; },
                               [](auto& s) { s.turn.saturation_torque_Nm = kInfinity; },
                               [](auto& s) { s.turn.linear_range_rad = -0.1; },
                               [](auto& s) { s.clamp_rad = 0.05; }});
    ToolCouplingSettings clamped;
    clamped.clamp_m = 0.001;
    clamped.clamp_rad = 0.05;
    check_refused(clamped, {[](auto& s) {
                      s.shift.linear_range_m = 0.004;
                      s.shift.saturation_range_m = 0.016;
                      s.shift.saturation_force_N = 5.0;
                  }});
}

TEST_CASE("tool coupling: pulls the tool to the handle and turns it its way, both proportionally") {
    const Wrench wrench = compute_tool_coupling(kPlain, at({0.01, 0.0, -0.02}, {0.0, 0.3, 0.0}),
                                                at({0.0, 0.01, 0.0}, Vector3::Zero()));
    CHECK((wrench.force - Vector3(5.0, -5.0, -10.0)).norm() < kRounding);
    CHECK((wrench.torque - Vector3(0.0, 0.15, 0.0)).norm() < kRounding);
}

TEST_CASE("tool coupling: dampers act against what the tool does beyond the handle") {
    MovingFrame handle = at(Vector3::Zero(), Vector3::Zero());
    MovingFrame grip = handle;
    handle.velocity_W = {{0.1, 0.0, 0.0}, {0.0, 1.0, 0.0}};
    grip.velocity_W = {{0.3, 0.0, 0.0}, {0.0, 1.0, 4.0}};
    const Wrench wrench = compute_tool_coupling(kPlain, handle, grip);
    CHECK((wrench.force - Vector3(-0.8, 0.0, 0.0)).norm() < kRounding);
    CHECK((wrench.torque - Vector3(0.0, 0.0, -8.0e-3)).norm() < kRounding);
}

TEST_CASE("tool coupling: the turn's damper turns along; what moves with its handle is free") {
    ToolCouplingSettings settings = kPlain;
    settings.turn.damping_Nms_per_rad = {1.0e-3, 2.0e-3, 5.0e-3};
    const Quaternion q_WT = compute_exp({0.4, -1.1, 0.7});
    for (const int axis : {0, 1, 2}) {
        MovingFrame frame{{Vector3::Zero(), q_WT}, {}};
        const MovingFrame handle = frame;
        frame.velocity_W.angular = q_WT * Vector3(3.0 * Vector3::Unit(axis));
        const Wrench wrench = compute_tool_coupling(settings, handle, frame);
        const double expected_Nm = -3.0 * settings.turn.damping_Nms_per_rad[axis];
        CHECK((wrench.torque - expected_Nm * (q_WT * Vector3::Unit(axis))).norm() < kRounding);
    }
    MovingFrame handle = at({0.3, 0.1, -0.2}, {1.0, 2.0, -1.0});
    handle.velocity_W = {{1.0, -0.5, 0.2}, {3.0, 0.0, -7.0}};
    const Wrench wrench = compute_tool_coupling(saturating(), handle, handle);
    CHECK(wrench.force.norm() < kRounding);
    CHECK(wrench.torque.norm() < kRounding);
}

TEST_CASE(
    "tool coupling: force and torque are linear, then a cubic, then constant, with continuous "
    "slopes") {
    const ToolCouplingSettings settings = saturating();
    CHECK(force_at(settings, 0.002) == Approx(1.0).epsilon(kRounding));
    CHECK(force_at(settings, 0.5) == Approx(5.0).epsilon(kRounding));
    CHECK(torque_at(settings, 0.1) == Approx(0.05).epsilon(1e-9));
    CHECK(torque_at(settings, 2.0) == Approx(0.3).epsilon(1e-9));
    constexpr double kStep = 1.0e-7;
    const auto slope_jump = [&](auto curve, double seam) {
        const double below = curve(settings, seam) - curve(settings, seam - kStep);
        const double above = curve(settings, seam + kStep) - curve(settings, seam);
        return std::abs(above - below) / kStep;
    };
    // A C1 seam: one-sided differences differ by curvature times the step, 1e-7 x 1e5 N/m^2 at most.
    CHECK(slope_jump(force_at, 0.004) < 0.05);
    CHECK(slope_jump(force_at, 0.016) < 0.05);
    CHECK(slope_jump(torque_at, 0.2) < 1.0e-4);
    CHECK(slope_jump(torque_at, 0.8) < 1.0e-4);
}

TEST_CASE("tool coupling: the clamp of voxel sampling holds the force at half a voxel's stretch") {
    ToolCouplingSettings settings = kPlain;
    settings.clamp_m = 0.0015;
    REQUIRE(validate(settings));
    CHECK(force_at(settings, 0.001) == Approx(0.5).epsilon(kRounding));
    CHECK(force_at(settings, 0.0015) == Approx(0.75).epsilon(kRounding));
    CHECK(force_at(settings, 0.3) == Approx(0.75).epsilon(kRounding));
    // It holds the shift alone; the turn has its own.
    CHECK(torque_at(settings, 1.0) == Approx(0.5).epsilon(1e-9));
    settings.clamp_rad = 0.2;
    REQUIRE(validate(settings));
    CHECK(torque_at(settings, 0.1) == Approx(0.05).epsilon(1e-9));
    CHECK(torque_at(settings, 1.0) == Approx(0.1).epsilon(1e-9));
}

TEST_CASE("tool coupling: a turn is measured the shorter way, critical damping for each axis") {
    CHECK(torque_at(kPlain, 3.0) == Approx(1.5).epsilon(1e-9));
    CHECK(torque_at(kPlain, 2.0 * std::numbers::pi - 3.0) == Approx(-1.5).epsilon(1e-9));
    CHECK(torque_at(kPlain, 2.0 * std::numbers::pi - 1.0) == Approx(-0.5).epsilon(1e-9));
    const ToolCouplingSettings settings =
        make_critically_damped(kPlain, 0.01, {2.0e-6, 8.0e-6, 1.8e-5});
    CHECK(settings.shift.damping_Ns_per_m == Approx(2.0 * std::sqrt(5.0)).epsilon(kRounding));
    CHECK((settings.turn.damping_Nms_per_rad - Vector3(2.0e-3, 4.0e-3, 6.0e-3)).norm() < kRounding);
    CHECK(settings.shift.stiffness_N_per_m == 500.0);
    // The defaults are those of a tool of 10 g and 2.4e-6 kg m^2.
    const ToolCouplingSettings defaults =
        make_critically_damped({}, 0.01, Vector3::Constant(2.4e-6));
    CHECK(defaults.shift.damping_Ns_per_m ==
          Approx(ToolCouplingSettings{}.shift.damping_Ns_per_m).epsilon(1e-3));
    CHECK(defaults.turn.damping_Nms_per_rad.isApprox(
        ToolCouplingSettings{}.turn.damping_Nms_per_rad, 1e-2));
}

TEST_CASE("tool coupling: the linearised law is the law, also at no stretch") {
    ToolCouplingSettings clamped = kPlain;
    clamped.clamp_m = 0.004;
    clamped.clamp_rad = 0.05;
    for (const ToolCouplingSettings& settings : {kPlain, saturating(), clamped}) {
        for (const double size : {0.0, 1.0e-9, 0.003, 0.01, 0.1}) {
            MovingFrame handle = at({size, -size, 0.5 * size}, {20.0 * size, 0.0, 10.0 * size});
            const MovingFrame grip = at(Vector3::Zero(), Vector3::Zero());
            handle.velocity_W = {{0.1, 0.2, 0.3}, {1.0, 2.0, 3.0}};
            const Wrench plain = compute_tool_coupling(settings, handle, grip);
            const ToolCouplingWrench linear =
                compute_linearised_tool_coupling(settings, handle, grip);
            CHECK((plain.force - linear.shift.force).norm() < kRounding);
            CHECK((plain.torque - linear.torque).norm() < kRounding);
        }
        const MovingFrame same = at(Vector3::Zero(), Vector3::Zero());
        const ToolCouplingWrench at_rest = compute_linearised_tool_coupling(settings, same, same);
        CHECK((at_rest.shift.by_position + 500.0 * Matrix3::Identity()).norm() < kRounding);
        CHECK((at_rest.torque_by_turn + 0.5 * Matrix3::Identity()).norm() < kRounding);
    }
}

TEST_CASE("tool coupling: the energy of its shift is the work done on it, beyond the clamp too") {
    ToolCouplingSettings clamped = kPlain;
    clamped.clamp_m = 0.005;
    for (const ToolCouplingSettings& settings : {kPlain, clamped, saturating()}) {
        double work_J = 0.0;
        constexpr int kSteps = 2000;
        constexpr double kStep_m = 0.02 / kSteps;
        for (int i = 0; i < kSteps; ++i) {
            work_J += force_at(settings, (i + 0.5) * kStep_m) * kStep_m;
        }
        CHECK(compute_shift_energy_J(settings, 0.02) == Approx(work_J).epsilon(1e-5));
        CHECK(compute_shift_energy_J(settings, 0.0) == 0.0);
    }
    CHECK(compute_shift_energy_J(clamped, 0.02) == Approx(250.0 * 2.5e-5 + 0.015 * 2.5));
}

TEST_CASE("virtual coupling: linear, then a cubic, then constant, with a continuous slope") {
    CHECK(compute_spring_force_N(kSaturating, 0.0) == 0.0);
    CHECK(compute_spring_force_N(kSaturating, 0.001) == Approx(0.8).epsilon(1e-12));
    CHECK(compute_spring_force_N(kSaturating, 0.0025) == Approx(2.0).epsilon(1e-12));
    CHECK(compute_spring_force_N(kSaturating, 0.012) == Approx(5.0).epsilon(1e-12));
    CHECK(compute_spring_force_N(kSaturating, 1.0e6) == 5.0);
    // Continuity from both sides of each seam; a difference of 1e-9 m is at most k 1e-9 = 1e-6 N.
    for (const double seam_m : {0.0025, 0.012}) {
        CHECK(std::abs(compute_spring_force_N(kSaturating, seam_m + 1e-9) -
                       compute_spring_force_N(kSaturating, seam_m - 1e-9)) < 2.0e-6);
        CHECK(std::abs(slope(kSaturating, seam_m + 2e-8) - slope(kSaturating, seam_m - 2e-8)) <
              0.02);
    }
    CHECK(slope(kSaturating, 0.0025 + 2e-8) == Approx(800.0).epsilon(1e-4));
    CHECK(std::abs(slope(kSaturating, 0.012 - 2e-8)) < 0.02);
    // The middle of a Hermite cubic: mean of the ends plus an eighth of width times slope
    // difference.
    CHECK(compute_spring_force_N(kSaturating, 0.00725) ==
          Approx(0.5 * (2.0 + 5.0) + 0.125 * 0.0095 * (800.0 - 0.0)).epsilon(1e-12));
}

TEST_CASE("virtual coupling: the slope is the force's derivative; it never falls") {
    for (const double stretch_m : {0.0005, 0.002, 0.004, 0.007, 0.011, 0.02}) {
        CHECK(compute_spring_slope_N_per_m(kSaturating, stretch_m) ==
              Approx(slope(kSaturating, stretch_m)).epsilon(1e-6).margin(1e-6));
        CHECK(compute_spring_slope_N_per_m(kLinear, stretch_m) == 800.0);
    }
    CHECK(compute_spring_slope_N_per_m(kSaturating, 0.0025 + 1e-12) == Approx(800.0).epsilon(1e-6));
    CHECK(std::abs(compute_spring_slope_N_per_m(kSaturating, 0.012 - 1e-12)) < 1e-5);
    CouplingSettings steepest = kSaturating;
    steepest.saturation_force_N = 2.0 + 800.0 * 0.0095 / 3.0;
    steepest.saturation_force_N *= 1.0 + 1e-12;
    REQUIRE(validate(steepest));
    CouplingSettings steeper = steepest;
    steeper.saturation_force_N = 2.0 + 800.0 * 0.0095 / 3.0 * (1.0 - 1e-9);
    CHECK_FALSE(validate(steeper));
    double before_N = 0.0;
    for (int i = 1; i <= 20000; ++i) {
        const double force_N = compute_spring_force_N(steepest, 0.02 * i / 20000.0);
        REQUIRE(force_N >= before_N - 1e-12);
        before_N = force_N;
    }
}

TEST_CASE(
    "virtual coupling: direction survives extreme lengths; the bare handle is critically damped") {
    const Vector3 direction = Vector3(1.0, -2.0, 2.0) / 3.0;
    for (const double stretch_m : {1e-300, 1e-12, 1e-3, 1.0, 1e200}) {
        const Vector3 force =
            compute_coupling_spring(kSaturating, direction * stretch_m, Vector3::Zero());
        REQUIRE(is_finite(force));
        const double expected_N = compute_spring_force_N(kSaturating, stretch_m);
        CHECK((force - direction * expected_N).norm() <= 1e-12 * expected_N + 1e-300);
    }
    const CouplingSettings settings;
    CHECK(settings.stiffness_N_per_m == 500.0);
    // m x'' + b x' + k x = 0 has a double root exactly when b^2 = 4 m k.
    CHECK(settings.damping_Ns_per_m * settings.damping_Ns_per_m ==
          Approx(4.0 * kHandleMass_kg * settings.stiffness_N_per_m).epsilon(0.01));
}

TEST_CASE("virtual coupling: the energy is the integral of the force, at every stretch") {
    for (const CouplingSettings& settings : {kLinear, kSaturating}) {
        constexpr double kStep_m = 1e-7;
        double energy_J = 0.0;
        for (int i = 0; i < 200000; ++i) {
            energy_J += kStep_m * compute_spring_force_N(settings, (i + 0.5) * kStep_m);
            if (i % 1000 == 999) {
                REQUIRE(compute_spring_energy_J(settings, (i + 1) * kStep_m) ==
                        Approx(energy_J).epsilon(1e-6));
            }
        }
        CHECK(compute_spring_energy_J(settings, 0.0) == 0.0);
    }
}
