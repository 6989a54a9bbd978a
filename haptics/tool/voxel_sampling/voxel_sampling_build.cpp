#include "haptics/base/range.h"
#include "haptics/dynamics/integrator.h"
#include "haptics/tool/voxel_sampling/voxel_sampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace fulcrum {
namespace {

// A place that no pose brings into a map.
constexpr float kNowhere = 1.0e30F;

voxel_lanes::Shell prepare(const Pointshell& shell, double voxel_m) {
    using voxel_lanes::kBlock;
    voxel_lanes::Shell prepared;
    prepared.n_points = shell.size();
    const std::size_t padded = (shell.size() + kBlock - 1) / kBlock * kBlock;
    const std::array<const std::vector<float>*, 3> places{&shell.x_m, &shell.y_m, &shell.z_m};
    const std::array<const std::vector<float>*, 3> normals{&shell.nx, &shell.ny, &shell.nz};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const float x_m : *places[axis]) {
            prepared.place[axis].push_back(static_cast<float>(x_m / voxel_m));
        }
        prepared.place[axis].resize(padded, axis == 0 ? kNowhere : 0.0F);
        prepared.normal[axis] = *normals[axis];
        prepared.normal[axis].resize(padded, 0.0F);
    }
    return prepared;
}

bool is_sound(const Pointshell& shell) {
    const auto is_number = [](float x) { return std::isfinite(x); };
    const std::array<const std::vector<float>*, 6> arrays{&shell.x_m, &shell.y_m, &shell.z_m,
                                                          &shell.nx,  &shell.ny,  &shell.nz};
    return std::all_of(arrays.begin(), arrays.end(), [&](const std::vector<float>* one) {
        return one->size() == shell.size() && std::all_of(one->begin(), one->end(), is_number);
    });
}

// One face to either map.
struct AnyMap {
    const VoxelGrid* grid;
    const Voxmap* map;

    [[nodiscard]] const VoxelFrame& frame() const {
        return grid != nullptr ? grid->frame : map->frame();
    }
    [[nodiscard]] VoxelClass find_class(const VoxelFrame::Cell& cell) const {
        return grid != nullptr ? grid->find_class(cell) : map->find_class(cell);
    }
};

}  // namespace

Expected<void> validate(const VoxelSamplingSettings& settings) {
    if (const auto checked = validate(settings.inertia); !checked) {
        return checked;
    }
    const std::array<Range, 5> ranges{
        {{"stiffness_N_per_m", settings.stiffness_N_per_m, 0.0, 1.0e6},
         {"full_contacts", settings.full_contacts, 1.0, 1.0e6},
         {"braking_Ns_per_m", settings.braking_Ns_per_m, 0.0, 1.0e4},
         {"look_ahead_cycles", settings.look_ahead_cycles, 0.0, 100.0},
         {"cycle_s", settings.cycle_s, kShortestCycle_s, kLongestCycle_s}}};
    return check_ranges("the voxel sampling's", ranges);
}

Expected<VoxelSampling> VoxelSampling::build(VoxelSamplingPlan plan) {
    if (const auto checked = validate(plan.settings); !checked) {
        return tl::unexpected(checked.error());
    }
    if (plan.grid == nullptr && plan.map == nullptr) {
        return fail("there are no voxels to sample", {}, "give the plan a grid or a voxmap");
    }
    if (plan.shell.size() == 0 || !is_sound(plan.shell)) {
        return fail("the tool's pointshell has no points, or numbers that are none", {},
                    "make it anew from the tool's mesh");
    }
    const AnyMap any{plan.grid.get(), plan.map.get()};
    // Places outside are taken for the outermost voxels.
    if (!is_free_outside(any.frame(),
                         [&](const VoxelFrame::Cell& cell) { return any.find_class(cell); })) {
        return fail("the outermost voxels are not all free", {},
                    "make the voxels by voxelise, which leaves a layer around the mesh");
    }
    VoxelSampling sampling;
    sampling.frame_ = any.frame();
    sampling.shell_ = prepare(plan.shell, sampling.frame_.voxel_m);
    sampling.settings_ = plan.settings;
    for (std::size_t i = 0; i < plan.shell.size(); ++i) {
        sampling.reach_m_ = std::max(sampling.reach_m_, plan.shell.position_T(i).norm());
    }
    sampling.grid_ = std::move(plan.grid);
    sampling.map_ = std::move(plan.map);
    return sampling;
}

std::size_t VoxelSampling::memory_bytes() const noexcept {
    const std::size_t map = grid_ != nullptr ? grid_->memory_bytes() : map_->memory_bytes();
    return sizeof(*this) + map + 6 * sizeof(float) * shell_.padded_size();
}

}  // namespace fulcrum
