// What settings of this folder take and refuse.
#include "haptics/coupling/passivity.h"
#include "haptics/coupling/tool_coupling.h"
#include "haptics/coupling/velocity_estimator.h"
#include "haptics/coupling/virtual_coupling.h"
#include "tests/support/refused.h"

#include <limits>

using namespace fulcrum;
using test::check_ranges;
using test::check_refused;

TEST_CASE("passivity settings: the ranges named at each field, and nothing else") {
    CHECK(PassivitySettings{}.on);
    check_ranges(
        PassivitySettings{},
        {{"handle_mass_kg", [](auto& s) -> double& { return s.handle_mass_kg; }, 0.001, 10.0},
         {"handle_inertia_kg_m2", [](auto& s) -> double& { return s.handle_inertia_kg_m2; }, 1e-8,
          1.0},
         {"headroom_J", [](auto& s) -> double& { return s.headroom_J; }, 0.0, 0.01},
         {"memory_s", [](auto& s) -> double& { return s.memory_s; }, 0.01, 10.0}});
}

TEST_CASE("velocity settings: the ranges named at each field, and nothing else") {
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
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
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
                               [](auto& s) { s.turn.saturation_range_rad = kInfinite; },
                               [](auto& s) { s.turn.saturation_torque_Nm = kInfinite; },
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
