#include "runtime/lesson/tool_extent.h"

#include <algorithm>
#include <variant>

namespace fulcrum::runtime {
namespace {

constexpr std::size_t kMostLeaves = 128;

// The largest of the points' places along a direction of their own frame.
double find_farthest_m(const Pointshell& shell, const Vector3& direction_T) {
    double farthest_m = 0.0;
    for (std::size_t i = 0; i < shell.size(); ++i) {
        farthest_m = std::max(farthest_m, shell.position_T(i).dot(direction_T));
    }
    return farthest_m;
}

double find_farthest_m(const ShellTree& shell, const Vector3& direction_T) {
    std::size_t thinning = 0;
    while (shell.n_leaves(thinning) > kMostLeaves && thinning + 1 < shell.n_thinnings()) {
        ++thinning;
    }
    double farthest_m = 0.0;
    for (std::size_t leaf = 0; leaf < shell.n_leaves(thinning); ++leaf) {
        const ShellPoints points = shell.points(thinning, leaf);
        for (std::size_t i = 0; i < shell.count_in(thinning, leaf); ++i) {
            farthest_m = std::max(farthest_m,
                                  Vector3(points.x[i], points.y[i], points.z[i]).dot(direction_T));
        }
    }
    return farthest_m;
}

double find_farthest_m(const GodSurface& surface, const Vector3& direction_T) {
    double farthest_m = 0.0;
    for (std::size_t i = 0; i < surface.n_places(); ++i) {
        farthest_m = std::max(farthest_m, surface.place_B(i).dot(direction_T));
    }
    return farthest_m;
}

// The root's hull holds all.
double find_farthest_m(const ContactLevels& levels, const Vector3& direction_T) {
    return std::max(0.0, levels.hull(0).find_support(direction_T).dot(direction_T));
}

}  // namespace

double compute_tool_extent_m(const ToolPlan& plan, const Quaternion& turn_W,
                             const Vector3& direction_W) {
    const VoxelToolSettings& settings = plan.settings;
    const Vector3 direction_T = (turn_W * settings.handle_turn).conjugate() * direction_W;
    double farthest_m = 0.0;
    if (const auto* voxels = std::get_if<std::vector<VoxelSamplingPlan>>(&plan.objects)) {
        farthest_m = voxels->empty() ? 0.0 : find_farthest_m(voxels->front().shell, direction_T);
    } else if (const auto* meshes = std::get_if<std::vector<GodObjectPlan>>(&plan.objects)) {
        farthest_m = meshes->empty() ? 0.0 : find_farthest_m(*meshes->front().tool, direction_T);
    } else if (const auto* levels = std::get_if<std::vector<LevelContactsPlan>>(&plan.objects)) {
        farthest_m = levels->empty() ? 0.0 : find_farthest_m(*levels->front().tool, direction_T);
    } else if (const auto& fields = std::get<std::vector<FieldSamplingPlan>>(plan.objects);
               !fields.empty() && fields.front().shell != nullptr) {
        farthest_m = find_farthest_m(*fields.front().shell, direction_T);
    }
    return std::max(farthest_m - settings.grip_T.dot(direction_T), 0.0);
}

}  // namespace fulcrum::runtime
