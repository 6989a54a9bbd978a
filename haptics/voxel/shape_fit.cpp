#include "haptics/voxel/shape_fit.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr double kFitRounding = 1.0e-9;
constexpr double kSingle = 1.0e-6;  // of a coordinate in single precision

bool is_in_box(const TriangleMesh& mesh, const Vector3& p, double beyond_m) noexcept {
    return all_at_most(mesh.lower_B() - Vector3::Constant(beyond_m), p) &&
           all_at_most(p, mesh.upper_B() + Vector3::Constant(beyond_m));
}

// Whether of each of some corners of triangles, spread over all of them.
template <class Holds>
bool holds_at_corners(const TriangleMesh& mesh, Holds&& holds) noexcept {
    constexpr std::size_t kMost = 20'000;
    const std::size_t stride = mesh.triangles().size() / kMost + 1;
    for (std::size_t i = 0; i < mesh.triangles().size(); i += stride) {
        const auto corner = static_cast<std::size_t>(mesh.triangles()[i][i / stride % 3]);
        if (!holds(mesh.vertices_B()[corner])) {
            return false;
        }
    }
    return true;
}

bool are_alike(const SolidMoments& a, const SolidMoments& b, double longest_m) noexcept {
    return std::abs(a.volume_m3 - b.volume_m3) <= kFitRounding * b.volume_m3 &&
           (a.centre_B - b.centre_B).cwiseAbs().maxCoeff() <= kFitRounding * longest_m &&
           (a.second_m5 - b.second_m5).cwiseAbs().maxCoeff() <= kFitRounding * b.second_m5.trace();
}

}  // namespace

bool can_be_of(const DistanceField& field, const TriangleMesh& mesh) noexcept {
    const double beyond_m = field.error_bound_m() + kSingle * mesh.diagonal_m();
    const double radius_m = field.ball_radius_m() * (1.0 + kFitRounding);
    return holds_at_corners(mesh, [&](const Vector3& corner) {
        return (corner - field.ball_centre_O()).squaredNorm() <= radius_m * radius_m &&
               std::abs(field.sample(corner).value_m + field.sheet_m()) <= beyond_m;
    });
}

bool can_be_of(const VoxelGrid& grid, const TriangleMesh& mesh) noexcept {
    const auto is_solid = [&](const Vector3& corner) {
        const VoxelFrame::Cell cell = grid.frame.find_cell(corner);
        const VoxelClass kind =
            grid.frame.contains(cell) ? grid.find_class(cell) : VoxelClass::free;
        return kind == VoxelClass::surface || kind == VoxelClass::interior;
    };
    const auto find_class = [&](const VoxelFrame::Cell& cell) { return grid.find_class(cell); };
    return is_free_outside(grid.frame, find_class) &&
           std::find(grid.cells.begin(), grid.cells.end(), VoxelClass::surface) !=
               grid.cells.end() &&
           holds_at_corners(mesh, is_solid);
}

bool can_be_of(const Pointshell& shell, const TriangleMesh& mesh) noexcept {
    const double longest_m =
        std::max(mesh.lower_B().cwiseAbs().maxCoeff(), mesh.upper_B().cwiseAbs().maxCoeff());
    Vector3 middle = Vector3::Zero();
    for (std::size_t i = 0; i < shell.size(); ++i) {
        if (!is_in_box(mesh, shell.position_T(i), kSingle * longest_m)) {
            return false;
        }
        middle += shell.position_T(i) / static_cast<double>(shell.size());
    }
    double square = 0.0;
    for (std::size_t i = 0; i < shell.size(); ++i) {
        square = std::max(square, (shell.position_T(i) - middle).squaredNorm());
    }
    const double least_m = kSingle * mesh.diagonal_m();
    return shell.size() == 1 || square > least_m * least_m;
}

bool can_be_of(const MeasuredSolid& solid, const TriangleMesh& mesh) noexcept {
    const SolidMoments& moments = solid.moments;
    const Vector3 size_m = mesh.upper_B() - mesh.lower_B();
    const double longest_m = size_m.maxCoeff();
    if (!solid.by_samples) {
        SolidMoments own = compute_solid_moments(mesh);
        if (own.volume_m3 < 0.0) {
            own.volume_m3 *= -1.0;
            own.second_m5 *= -1.0;
        }
        return are_alike(moments, own, longest_m);
    }
    // A sample stands for a cube of up to a twelfth of the longest side; those at the rim reach beyond the box.
    constexpr double kRim = 1.0 / 12.0;
    constexpr double kLeastShare = 1.0e-4;  // of the longest side's cube
    const Vector3 edges = size_m + Vector3::Constant(kRim * longest_m);
    const double volume_m3 = moments.volume_m3;
    if (volume_m3 < kLeastShare * longest_m * longest_m * longest_m || volume_m3 > edges.prod() ||
        !is_in_box(mesh, moments.centre_B, kRim * longest_m)) {
        return false;
    }
    for (Index axis = 0; axis < 3; ++axis) {
        const double second_m5 = moments.second_m5(axis, axis);
        const double thinnest_m = volume_m3 * edges[axis] / edges.prod();
        // A single layer of places has no spread.
        const double least_m = std::max(thinnest_m - kRim * longest_m, 0.0);
        if (second_m5 < volume_m3 * least_m * least_m / 12.0 ||
            second_m5 > volume_m3 * edges[axis] * edges[axis] / 4.0) {
            return false;
        }
    }
    return true;
}

}  // namespace fulcrum
