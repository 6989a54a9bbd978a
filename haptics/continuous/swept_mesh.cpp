#include "haptics/continuous/swept_mesh.h"

#include <algorithm>
#include <numeric>

namespace fulcrum {
namespace {

constexpr int kTrianglesALeaf = 1;

}  // namespace

SweptMesh::SweptMesh(const TriangleMesh& mesh)
    : vertices_(mesh.vertices_B()),
      corners_(mesh.triangles()),
      boxes_(vertices_, corners_, kTrianglesALeaf) {
    std::vector<std::int32_t> all(corners_.size());
    std::iota(all.begin(), all.end(), 0);
    root_ = boxes_.add(all);
    boxes_.shrink();
    for (const Vector3& vertex : vertices_) {
        reach_m_ = std::max(reach_m_, vertex.norm());
    }
}

std::shared_ptr<const SweptMesh> SweptMesh::create(const TriangleMesh& mesh) {
    return std::shared_ptr<const SweptMesh>(new SweptMesh(mesh));
}

std::size_t SweptMesh::memory_bytes() const noexcept {
    return boxes_.memory_bytes() + vertices_.capacity() * sizeof(Vector3) +
           corners_.capacity() * sizeof(TriangleCorners);
}

}  // namespace fulcrum
