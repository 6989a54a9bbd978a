// A mesh made ready to be touched: its triangles lie in the order of a bounding tree, its vertices in the order of use.
//
// Thread: made at load, then read from any thread. Cost: O(n log n); about 45 bytes a triangle.
#pragma once

#include "haptics/base/error.h"
#include "haptics/geometry/bounding_tree.h"
#include "haptics/geometry/triangle_mesh.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace fulcrum {

class CollisionMesh {
  public:
    /// Copies what it needs of a built mesh. Triangles are counted anew, see `source_triangle`.
    [[nodiscard]] static Expected<std::shared_ptr<const CollisionMesh>> create(
        const TriangleMesh& mesh);

    [[nodiscard]] std::int32_t n_triangles() const noexcept {
        return static_cast<std::int32_t>(triangles_.size());
    }
    [[nodiscard]] const TriangleCorners& corners(std::int32_t triangle) const noexcept {
        return triangles_[static_cast<std::size_t>(triangle)];
    }
    [[nodiscard]] const Vector3& vertex_B(std::int32_t vertex) const noexcept {
        return vertices_B_[static_cast<std::size_t>(vertex)];
    }
    /// Where a triangle's three corners lie.
    [[nodiscard]] std::array<Vector3, 3> places_B(std::int32_t triangle) const noexcept {
        const TriangleCorners& at = corners(triangle);
        return {vertex_B(at[0]), vertex_B(at[1]), vertex_B(at[2])};
    }
    [[nodiscard]] std::span<const Vector3> vertices_B() const noexcept { return vertices_B_; }
    [[nodiscard]] std::span<const TriangleCorners> triangles() const noexcept { return triangles_; }
    /// The triangles of one of the tree's leaves will be asked for soon.
    void prefetch_leaf(std::int32_t leaf) const noexcept {
        const auto first = static_cast<std::size_t>(leaf) * BoundingTree::kWidth;
        prefetch(&triangles_[first], BoundingTree::kWidth * sizeof(TriangleCorners));
    }
    /// The index that a triangle had in the mesh given to `create`.
    [[nodiscard]] std::int32_t source_triangle(std::int32_t triangle) const noexcept {
        return tree_.order()[static_cast<std::size_t>(triangle)];
    }
    [[nodiscard]] const BoundingTree& tree() const noexcept { return tree_; }
    /// A sphere round all triangles.
    [[nodiscard]] const Vector3& centre_B() const noexcept { return centre_B_; }
    [[nodiscard]] double radius_m() const noexcept { return radius_m_; }
    /// Everything held on the heap.
    [[nodiscard]] std::size_t memory_bytes() const noexcept;

  private:
    explicit CollisionMesh(const TriangleMesh& mesh);

    BoundingTree tree_;
    std::vector<Vector3> vertices_B_;
    std::vector<TriangleCorners> triangles_;
    Vector3 centre_B_{Vector3::Zero()};
    double radius_m_ = 0.0;
};

}  // namespace fulcrum
