// A tool as points on its surface, each with the unit normal that points into the tool; made in either of two ways.
//
//   from voxels   the centres of the voxels that the surface touches, as McNeely made them. A point may lie up to
//                 sqrt(3)/2 voxels beside the surface; its normal is the mean of the triangles through its voxel
//   on the mesh   points of the surface itself, as many as asked for: the mesh is cut into that many pieces of equal area,
//                 piece after piece along a curve that fills space, and each gets one point
// Points that follow each other lie near each other (Morton's order of their cells), so that what touches is a few runs.
// A single precision place is off by at most 6e-8 of its distance from the origin.
//
// Thread: load. Cost: about 1 us a point.
// Source: W. McNeely, K. Puterbaugh, J. Troy 1999, Six degree-of-freedom haptic rendering using voxel sampling, section
// 4.1 (centres of voxels; "its accuracy may be improved by choosing points that lie on the exact geometrical
// representation"). Points within a triangle: M. Roberts 2018, The unreasonable effectiveness of quasirandom sequences
// (the R2 sequence).
#pragma once

#include "haptics/base/error.h"
#include "haptics/base/parallel_for.h"
#include "haptics/geometry/triangle_mesh.h"

#include <cstddef>
#include <vector>

namespace fulcrum {

/// All arrays are of one length. Tool's frame T.
struct Pointshell {
    std::vector<float> x_m, y_m, z_m;  ///< metres
    std::vector<float> nx, ny, nz;     ///< unit, into the tool

    [[nodiscard]] std::size_t size() const noexcept { return x_m.size(); }
    [[nodiscard]] Vector3 position_T(std::size_t i) const noexcept {
        return {x_m[i], y_m[i], z_m[i]};
    }
    [[nodiscard]] Vector3 normal_T(std::size_t i) const noexcept { return {nx[i], ny[i], nz[i]}; }
    void add(const Vector3& position_T, const Vector3& normal_T);
    [[nodiscard]] std::size_t memory_bytes() const noexcept {
        return sizeof(*this) + 6 * sizeof(float) * x_m.capacity();
    }
};

inline constexpr int kMostShellPoints = 16'000'000;

/// The centres of the voxels of edge `voxel_m` that the mesh's triangles touch; T is the mesh's frame. Refuses what
/// `validate` of voxelise.h refuses, and more than 512 voxels along an axis.
[[nodiscard]] Expected<Pointshell> make_voxel_pointshell(const TriangleMesh& mesh, double voxel_m);

/// `n_points` points on the mesh's triangles, from 1 to 16 million; the same ones each time. T is the mesh's frame. An error too
/// where `progress` stops it.
[[nodiscard]] Expected<Pointshell> make_surface_pointshell(const TriangleMesh& mesh, int n_points,
                                                           const LoadProgress& progress = {});

/// The same tool seen from another frame N: p_N = X_NT p_T.
[[nodiscard]] Pointshell make_moved(const Pointshell& shell, const Pose& X_NT);

}  // namespace fulcrum
