// Normals that turn evenly over a mesh, so that a coarse mesh of a smooth body feels smooth.
//
//   n(p) = (a_0 n_0 + a_1 n_1 + a_2 n_2) / |...|      a_i: area of the triangle of p and the side opposite to corner i
//   n_i  = sum of angle_f N_f / |...|                  over the faces f round the corner that belong together
// The force keeps its size and takes this direction. Faces belong together round a vertex when a chain of edges, each bent by at
// most the crease angle, joins them; so both triangles of such an edge have the same two normals at its ends, and the direction
// is continuous across it. Edges that bend more, that have a triangle more or less than two, or whose triangles are wound
// against each other stay as sharp as they are. A corner whose normals cancel keeps its face's.
//
// Of a smooth body with faces of size s and radius R the faces' own normals are wrong by s / R, these by about (s / R)^2; near a
// crease that is rounded off they are wrong by as much as half of it: `fulcrum bench shading`.
// Thread: made at load, then read from any. Cost: O(n log n) at load, 33 bytes a triangle; about 50 ns a normal.
// Source: C. Basdogan, C.-H. Ho, M. A. Srinivasan 1997, A ray-based haptic rendering technique for displaying shape and
// texture of 3D objects in virtual environments, ASME DSC 61 (after H. Gouraud's and B. T. Phong's shading): normals by
// angles at the vertices, by areas within the triangle. The groups by creases are ours.
#pragma once

#include "haptics/collision/collision_mesh.h"
#include "haptics/math/spatial.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace fulcrum {

class ShadedNormals {
  public:
    /// `crease_angle_deg` 0 to 180. Triangles are counted as in the mesh, which is kept.
    ShadedNormals(std::shared_ptr<const CollisionMesh> mesh, double crease_angle_deg);

    /// The unit normal at a point of a triangle, on the side that `side_B` is on (any vector off the plane). A point beside
    /// the triangle is taken to its nearest weights.
    [[nodiscard]] Vector3 normal_B(std::int32_t triangle, const Vector3& point_B,
                                   const Vector3& side_B) const noexcept;
    /// The normal that a triangle has at one of its corners, 0 to 2.
    [[nodiscard]] const Vector3& corner_normal_B(std::int32_t triangle,
                                                 std::size_t corner) const noexcept {
        return normals_B_[static_cast<std::size_t>(
            groups_[static_cast<std::size_t>(triangle)][corner])];
    }
    /// About the most work, for each newton of push, that turning it from a face's own normal does along that face: the corners' lean
    /// grows evenly from the middle, so that it has a potential there of half the lean along the way to a corner.
    [[nodiscard]] double bump_m() const noexcept { return bump_m_; }
    [[nodiscard]] std::size_t memory_bytes() const noexcept {
        return normals_B_.capacity() * sizeof(Vector3) + groups_.capacity() * sizeof(groups_[0]);
    }

  private:
    std::shared_ptr<const CollisionMesh> mesh_;
    std::vector<Vector3> normals_B_;                   // one a group of corners
    std::vector<std::array<std::int32_t, 3>> groups_;  // of each triangle's corners
    double bump_m_ = 0.0;
};

}  // namespace fulcrum
