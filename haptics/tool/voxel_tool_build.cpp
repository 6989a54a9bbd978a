#include "haptics/base/range.h"
#include "haptics/tool/voxel_tool.h"

#include <algorithm>
#include <array>
#include <utility>

namespace fulcrum {
namespace {

constexpr double kWidestClamp_rad = 1.0;  // of a tool smaller than its voxels

}  // namespace

Expected<void> validate(const VoxelToolSettings& settings) {
    if (const auto checked = validate(settings.coupling); !checked) {
        return checked;
    }
    if (const auto checked = validate(settings.integrator); !checked) {
        return checked;
    }
    if (const auto checked = validate(settings.inertia); !checked) {
        return checked;
    }
    const std::array<Range, 4> ranges{
        {{"static_iterations", static_cast<double>(settings.static_iterations), 1.0, 100.0},
         {"grip_T x", settings.grip_T.x(), -10.0, 10.0},
         {"grip_T y", settings.grip_T.y(), -10.0, 10.0},
         {"grip_T z", settings.grip_T.z(), -10.0, 10.0}}};
    return check_ranges("the tool's", ranges);
}

VoxelTool::VoxelTool(VoxelSampling sampling, const VoxelToolSettings& settings) noexcept
    : sampling_(std::move(sampling)), settings_(settings), coupling_(settings.coupling) {
    if (settings.critically_damped) {
        // The least moment's: for the others the damper is below critical, so no turn creeps.
        coupling_ = make_critically_damped(coupling_, settings.inertia.mass_kg,
                                           settings.inertia.moments_kg_m2.minCoeff());
    }
    if (settings.mass == ToolMass::massless) {
        coupling_.shift.damping_Ns_per_m = 0.0;
        coupling_.turn.damping_Nms_per_rad = 0.0;
    }
    if (settings.clamped_at_half_voxel) {
        coupling_.clamp_m = 0.5 * sampling_.frame().voxel_m;
        coupling_.clamp_rad = std::min(coupling_.clamp_m / sampling_.reach_m(), kWidestClamp_rad);
    }
}

Expected<VoxelTool> VoxelTool::build(VoxelSamplingPlan sampling,
                                     const VoxelToolSettings& settings) {
    if (const auto checked = validate(settings); !checked) {
        return tl::unexpected(checked.error());
    }
    sampling.settings.inertia = settings.inertia;
    if (settings.mass == ToolMass::massless) {
        sampling.settings.braking = PreContactBraking::off;
    }
    auto built = VoxelSampling::build(std::move(sampling));
    if (!built) {
        return tl::unexpected(built.error());
    }
    VoxelTool tool(std::move(*built), settings);
    // A clamp and a saturating coupling exclude each other.
    if (const auto checked = validate(tool.coupling_); !checked) {
        return tl::unexpected(checked.error());
    }
    return tool;
}

}  // namespace fulcrum
