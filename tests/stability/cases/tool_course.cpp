#include "tests/stability/cases/tool_course.h"

#include "haptics/voxel/voxelise.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace fulcrum::stability {

VoxelTool make_voxel_tool(ToolScene scene) {
    scene.sampling.stiffness_N_per_m = scene.stiffness_N_per_m;
    const auto grid = std::make_shared<const VoxelGrid>(
        voxelise(scene.object, {.voxel_m = scene.voxel_m}).value());
    VoxelToolSettings settings;
    settings.coupling.turn.stiffness_Nm_per_rad = 0.1;
    settings.inertia = scene.inertia;
    settings.integrator.newton_iterations = 8;
    return VoxelTool::build(
               {grid, nullptr, make_surface_pointshell(scene.tool, scene.n_points).value(),
                scene.sampling},
               settings)
        .value();
}

ToolCourse along(const Vector3& from, const Vector3& to) {
    return [from, to](double share) { return Pose::at(from + share * (to - from)); };
}

ToolRest run_course(VoxelTool& tool, int n_steps, const ToolCourse& course) {
    ToolRest rest;
    tool.place(course(0.0));
    double least_N = HUGE_VAL;
    double most_N = 0.0;
    for (int i = 1; i <= 2 * n_steps; ++i) {
        const bool goes_in = i <= n_steps;
        const double way = std::min(1.0, 2.0 * (goes_in ? i : i - n_steps) / n_steps);
        const Pose handle = course(goes_in ? way : 1.0 - way);
        const VoxelToolResult result = tool.step({handle, {}}, {}, i * kToolDt_s, kToolDt_s);
        rest.n_interior = std::max(rest.n_interior, result.contact.n_interior);
        const double felt_N = result.felt_W.force.norm();
        if (goes_in && i > n_steps * 4 / 5) {
            rest.speed_m_per_s = worse(rest.speed_m_per_s, tool.state().velocity_W.linear.norm());
            least_N = std::min(least_N, felt_N);
            most_N = worse(most_N, felt_N);
            rest.felt_N = felt_N;
            rest.felt_Nm = result.felt_W.torque.norm();
            rest.n_surface = result.contact.n_surface;
        }
        if (i == 2 * n_steps) {
            rest.left_m = (tool.state().pose_W.position - handle.position).norm();
            rest.left_N = felt_N;
        }
    }
    rest.ripple_N = most_N - least_N;
    return rest;
}

std::string tell(const ToolRest& rest) {
    return describe(
        "%.2g m/s, %.3g N and %.3g Nm felt, ripple %.1g N, %d in the surface, %d inside; "
        "let go %.2g mm away, %.2g N",
        rest.speed_m_per_s, rest.felt_N, rest.felt_Nm, rest.ripple_N,
        static_cast<int>(rest.n_surface), static_cast<int>(rest.n_interior), 1000.0 * rest.left_m,
        rest.left_N);
}

Finding judge_rest(const VoxelTool& tool, const ToolRest& rest, const RestDemand& demand) {
    constexpr double kOff = 0.05;
    constexpr double kAway_m = 1.0e-4;
    const ToolCouplingSettings& coupling = tool.coupling();
    const double clamp_N = coupling.shift.stiffness_N_per_m * coupling.clamp_m;
    const double clamp_Nm = coupling.turn.stiffness_Nm_per_rad * coupling.clamp_rad;
    const double off = demand.by_torque ? std::abs(rest.felt_Nm - clamp_Nm) / clamp_Nm
                                        : std::abs(rest.felt_N - clamp_N) / clamp_N;
    double worst = rest.n_interior > 0 ? 100.0 : 0.0;
    worst = worse(worst, rest.speed_m_per_s / demand.speed_m_per_s);
    worst = worse(worst, off / kOff);
    worst = worse(worst, rest.left_m / kAway_m);
    worst = worse(worst, rest.left_N > 0.0 ? 100.0 : 0.0);
    return {worst, 1.0, tell(rest)};
}

}  // namespace fulcrum::stability
