// The task that distance fields of several libraries are given: a tool's points against a ball, values and slopes.
#pragma once

#include "haptics/geometry/shape.h"
#include "haptics/voxel/distance_field.h"
#include "haptics/voxel/pointshell.h"
#include "tests/bench/harness/curve.h"

#include <span>

namespace fulcrum::bench {

inline constexpr std::array<int, 4> kFieldPoints{614, 1454, 2489, 7782};  ///< as in the thesis
inline constexpr int kFieldCells = 80;                                    ///< along the ball

/// A ball of radius 1 and its copy as points, so placed that all lie within a voxel of the surface.
struct FieldPointsTask {
    TriangleMesh mesh;
    VoxelFrame frame;
    Pointshell shell;
    Pose X_OT;
};

[[nodiscard]] inline FieldPointsTask make_field_points_task(int n_points) {
    TriangleMesh mesh = *make_sphere(1.0, 60);
    const VoxelFrame frame = make_field_frame(mesh, kFieldCells).value();
    Pointshell shell = make_surface_pointshell(mesh, n_points).value();
    return {std::move(mesh),
            frame,
            std::move(shell),
            {{0.01, -0.012, 0.008}, Quaternion(AngleAxis(0.4, Vector3::UnitZ()))}};
}

/// Root mean square of value - (|p| - 1), voxels.
[[nodiscard]] inline double find_rms_voxels(const FieldPointsTask& task,
                                            std::span<const double> values_m) {
    double sum = 0.0;
    for (std::size_t i = 0; i < values_m.size(); ++i) {
        const double exact_m = (task.X_OT * task.shell.position_T(i)).norm() - 1.0;
        sum += (values_m[i] - exact_m) * (values_m[i] - exact_m);
    }
    return std::sqrt(sum / static_cast<double>(values_m.size())) / task.frame.voxel_m;
}

/// What the value of each point costs, asked for one after the other, and how exact it is: `read` gives it, metres, at a place.
template <class Read>
[[nodiscard]] CostPoint measure_one_by_one(const std::string& series, const FieldPointsTask& task,
                                           std::size_t bytes, const Timing& timing, Read read) {
    std::vector<double> values_m(task.shell.size());
    const Cost cost = measure_cost(
        [&] {
            for (std::size_t i = 0; i < values_m.size(); ++i) {
                values_m[i] = read(task.X_OT * task.shell.position_T(i));
            }
        },
        timing, bytes);
    return {
        series, static_cast<double>(values_m.size()), find_rms_voxels(task, values_m), cost, {}};
}

}  // namespace fulcrum::bench
