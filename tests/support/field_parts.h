// Distance fields and shells of points in a line each, for what samples them.
#pragma once

#include "haptics/geometry/shape.h"
#include "haptics/voxel/distance_field.h"
#include "haptics/voxel/pointshell.h"
#include "haptics/voxel/shell_tree.h"

#include <memory>

namespace fulcrum::test {

/// With the margin that its band, or its sheet, needs.
inline DistanceField build_field(const TriangleMesh& mesh, int n_along,
                                 const DistanceFieldSettings& settings = {}) {
    const VoxelFrame frame =
        make_field_frame(mesh, n_along, settings.band_voxels + settings.sheet_voxels).value();
    return DistanceField::build(mesh, frame, settings).value();
}

inline std::shared_ptr<const DistanceField> make_field(const TriangleMesh& mesh, int n_along,
                                                       const DistanceFieldSettings& settings = {}) {
    return std::make_shared<const DistanceField>(build_field(mesh, n_along, settings));
}

/// A ball of a metre with bumps of a twentieth: how finely its field is cut.
inline DistanceField build_bumpy_field(int n_along) {
    return build_field(make_bumpy_sphere(1.0, 16, 0.05, 12.0).value(), n_along);
}

inline std::shared_ptr<const DistanceField> make_unit_box_field(int n_along) {
    return make_field(make_box({1.0, 1.0, 1.0}).value(), n_along);
}

inline std::shared_ptr<const ShellTree> make_shell(const Pointshell& points) {
    return std::make_shared<const ShellTree>(ShellTree::build(points).value());
}

inline std::shared_ptr<const ShellTree> make_shell(const TriangleMesh& mesh, int n_points) {
    return make_shell(make_surface_pointshell(mesh, n_points).value());
}

/// Rows of n x n points about the origin; `up_m(row, column)` says how far each lies over y = 0.
template <class Up>
Pointshell make_point_rows(int n, double side_m, Up up_m) {
    Pointshell points;
    for (int row = 0; row < n; ++row) {
        for (int column = 0; column < n; ++column) {
            points.add({side_m * column / n - 0.5 * side_m, up_m(row, column),
                        side_m * row / n - 0.5 * side_m},
                       Vector3::UnitY());
        }
    }
    return points;
}

inline ShellPoints points_of(const Pointshell& shell) {
    return {shell.x_m.data(), shell.y_m.data(), shell.z_m.data(),
            shell.nx.data(),  shell.ny.data(),  shell.nz.data()};
}

}  // namespace fulcrum::test
