// A floor of voxels and tools of a few points, and the sum over all points written out plainly in double precision.
#pragma once

#include "haptics/math/rotation.h"
#include "haptics/tool/voxel_sampling/voxel_sampling.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace fulcrum::test {

inline constexpr double kVoxel_m = 0.01;

/// 16 x 16 x 16 voxels about the origin: y = 7 is surface, so it lies from -0.01 to 0; under it is interior, over it
/// proximity. The outermost are free.
inline std::shared_ptr<const VoxelGrid> make_floor() {
    auto grid = std::make_shared<VoxelGrid>();
    grid->frame.voxel_m = kVoxel_m;
    grid->frame.n_cells = {16, 16, 16};
    grid->frame.lower_O = Vector3::Constant(-8.0 * kVoxel_m);
    grid->cells.assign(std::size_t{16} * 16 * 16, VoxelClass::free);
    for (std::int32_t z = 1; z < 15; ++z) {
        for (std::int32_t x = 1; x < 15; ++x) {
            for (std::int32_t y = 1; y < 7; ++y) {
                grid->cells[grid->index_of({x, y, z})] = VoxelClass::interior;
            }
            grid->cells[grid->index_of({x, 7, z})] = VoxelClass::surface;
            grid->cells[grid->index_of({x, 8, z})] = VoxelClass::proximity;
        }
    }
    return grid;
}

/// No averaging, no brakes, 100 N/m.
inline VoxelSamplingSettings plain() {
    VoxelSamplingSettings settings;
    settings.stiffness_N_per_m = 100.0;
    settings.averaging = ContactAveraging::none;
    settings.braking = PreContactBraking::off;
    return settings;
}

inline VoxelSampling make_sampling(const Pointshell& shell, const VoxelSamplingSettings& settings,
                                   std::shared_ptr<const VoxelGrid> grid = make_floor()) {
    return VoxelSampling::build({std::move(grid), nullptr, shell, settings}).value();
}

/// The net spring of all points, unaveraged, one by one.
inline Wrench sum_plainly(const VoxelGrid& grid, const Pointshell& shell, const Pose& X_OT,
                          double stiffness_N_per_m) {
    Wrench sum;
    for (std::size_t i = 0; i < shell.size(); ++i) {
        const Vector3 p = X_OT * shell.position_T(i);
        const Vector3 n = X_OT.orientation * shell.normal_T(i);
        const VoxelFrame::Cell cell = grid.frame.find_cell(p);
        if (grid.find_class(cell) == VoxelClass::surface) {
            const double d = std::max(0.0, n.dot(grid.frame.centre_of(cell) - p));
            add_point_force(p - X_OT.position, stiffness_N_per_m * d * n, sum);
        }
    }
    return sum;
}

}  // namespace fulcrum::test
