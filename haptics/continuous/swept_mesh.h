// A mesh made ready to be swept (mesh_sweep.h): its triangles in a tree of oriented boxes, one a leaf.
//
// Thread: build at load; questions from any thread. Cost: O(n log n); 230 bytes a triangle.
#pragma once

#include "haptics/continuous/nearest_features.h"
#include "haptics/geometry/obb_tree.h"

#include <memory>

namespace fulcrum {

/// A mesh made ready to be swept. At load.
class SweptMesh {
  public:
    [[nodiscard]] static std::shared_ptr<const SweptMesh> create(const TriangleMesh& mesh);

    [[nodiscard]] std::int32_t n_triangles() const noexcept {
        return static_cast<std::int32_t>(corners_.size());
    }
    [[nodiscard]] Triangle triangle(std::int32_t index) const noexcept {
        const TriangleCorners& t = corners_[static_cast<std::size_t>(index)];
        return {vertices_[static_cast<std::size_t>(t[0])],
                vertices_[static_cast<std::size_t>(t[1])],
                vertices_[static_cast<std::size_t>(t[2])]};
    }
    [[nodiscard]] const ObbForest& boxes() const noexcept { return boxes_; }
    [[nodiscard]] std::int32_t root() const noexcept { return root_; }
    /// From the origin to the farthest corner.
    [[nodiscard]] double reach_m() const noexcept { return reach_m_; }
    [[nodiscard]] std::size_t memory_bytes() const noexcept;

    SweptMesh(const SweptMesh&) = delete;
    SweptMesh& operator=(const SweptMesh&) = delete;
    SweptMesh(SweptMesh&&) = delete;
    SweptMesh& operator=(SweptMesh&&) = delete;
    ~SweptMesh() = default;

  private:
    explicit SweptMesh(const TriangleMesh& mesh);

    std::vector<Vector3> vertices_;
    std::vector<TriangleCorners> corners_;
    ObbForest boxes_;
    std::int32_t root_ = 0;
    double reach_m_ = 0.0;
};

}  // namespace fulcrum
