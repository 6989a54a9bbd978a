// A tool of points on its coupling, led along a course into an object, held there, and let go: what hard cases of tools share.
#pragma once

#include "haptics/tool/voxel_tool.h"
#include "tests/stability/cases/stability_case.h"

#include <functional>
#include <string>

namespace fulcrum::stability {

inline constexpr double kToolDt_s = 0.001;

struct ToolScene {
    TriangleMesh object;
    double voxel_m;
    TriangleMesh tool;
    int n_points;
    Inertia inertia;
    double stiffness_N_per_m = 1000.0;
    VoxelSamplingSettings sampling{};
};

[[nodiscard]] VoxelTool make_voxel_tool(ToolScene scene);

/// Where the hand is, for shares of 0 to 1.
using ToolCourse = std::function<Pose(double)>;
[[nodiscard]] ToolCourse along(const Vector3& from, const Vector3& to);

/// What a course led to: the worst of its last fifth, when the hand has been still for long.
struct ToolRest {
    double speed_m_per_s = 0.0;
    double ripple_N = 0.0;  // between the least and the greatest force felt
    double felt_N = 0.0;
    double felt_Nm = 0.0;
    std::int64_t n_surface = 0;
    std::int64_t n_interior = 0;  // at any time
    double left_m = 0.0;  // from the hand once it has gone back, and the same long again has passed
    double left_N = 0.0;  // felt then
};

/// The handle goes by `course` of 0 to 1 in the first half, stays for the second, and goes back likewise.
[[nodiscard]] ToolRest run_course(VoxelTool& tool, int n_steps, const ToolCourse& course);
[[nodiscard]] std::string tell(const ToolRest& rest);

/// What a course must lead to: a tool that rests, with no point ever inside, that gives the hand what the coupling's clamp gives,
/// for the hand is far deeper, and that comes back to the hand when it leaves.
struct RestDemand {
    double speed_m_per_s = 0.02;
    bool by_torque = false;  // the clamp of the turn, not that of the shift
};
inline constexpr const char* kRestMeasured =
    "worst of: speed in 20 mm/s, force or torque off the clamp's in 5 %, distance after release in "
    "0.1 mm; 100: a point was inside";
[[nodiscard]] Finding judge_rest(const VoxelTool& tool, const ToolRest& rest,
                                 const RestDemand& demand = {});

}  // namespace fulcrum::stability
