// The triangles of one leaf of a mesh's tree, side by side, so that a ball on its way asks all eight at once which of them it may meet.
//
// For any direction u, all of a triangle lies below h(u) = max over its corners of u . corner, so a ball of radius r whose middle goes
// from p to q is free of it when
//   min(u . p, u . q) - h(u) > r |u|.
// As u is taken the way from the nearest point of the triangle's edges to the middle of p q, which is the best there is but over the
// face. Whatever u is, the answer errs on one side only: in single precision, about the leaf's own middle and in lengths of its
// radius, r is taken larger by more than rounding can amount to. So a triangle that is left out is not met; of the few others the exact
// question is asked.
//
// Thread: any. Cost: to put a leaf in about a hundred nanoseconds, to ask its eight triangles about ten; no allocation.
// Source: separating planes between convex bodies as in G. van den Bergen 2004 (see obstacle.h); nearest points of edges as in C. Ericson
// 2005, Real-Time Collision Detection, 5.1.
#pragma once

#include "haptics/collision/collision_mesh.h"
#include "haptics/math/spatial.h"

#include <array>
#include <cstdint>

namespace fulcrum {

class LeafTriangles {
  public:
    static constexpr int kWidth = BoundingTree::kWidth;

    /// Takes up the triangles of one leaf.
    void load(const CollisionMesh& mesh, std::int32_t leaf) noexcept;
    [[nodiscard]] std::int32_t leaf() const noexcept { return leaf_; }
    /// A sphere round all of them.
    [[nodiscard]] const Vector3& middle_B() const noexcept { return middle_B_; }
    [[nodiscard]] double radius_m() const noexcept { return radius_m_; }
    /// A bit for each triangle that a ball of `distance_m` may come to, on its way from `middle - half` to `middle + half`;
    /// bit i is triangle kWidth leaf() + i.
    [[nodiscard]] unsigned find_near(const Vector3& middle_B, const Vector3& half_B,
                                     double distance_m) const noexcept;

  private:
    using Row = std::array<float, kWidth>;  // a number of each triangle
    using Rows = std::array<Row, 3>;        // a vector's components

    // Those that are there and of which the number is not above zero; what is no number is asked about, too.
    [[nodiscard]] unsigned find_not_above_0(const Row& numbers) const noexcept;

    // About middle_B_, in radii: a corner, two edges from it, and 1 / their squares and that of the third edge.
    alignas(32) Rows a_{};
    Rows ab_{};
    Rows ac_{};
    Row per_ab_ab_{};
    Row per_ac_ac_{};
    Row per_bc_bc_{};
    Vector3 middle_B_{Vector3::Zero()};
    double radius_m_ = 0.0;
    double radii_per_m_ = 0.0;  // 0 for triangles that are all one point
    std::int32_t leaf_ = -1;
    unsigned present_ = 0;  // the last leaf of a mesh may have fewer
};

}  // namespace fulcrum
