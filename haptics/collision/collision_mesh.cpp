#include "haptics/collision/collision_mesh.h"

#include <algorithm>

namespace fulcrum {

Expected<std::shared_ptr<const CollisionMesh>> CollisionMesh::create(const TriangleMesh& mesh) {
    // A mesh that was moved from holds no triangles.
    if (mesh.triangles().empty()) {
        return fail("the mesh to be touched has no triangles", {}, "build the mesh first");
    }
    return std::shared_ptr<const CollisionMesh>(new CollisionMesh(mesh));
}

CollisionMesh::CollisionMesh(const TriangleMesh& mesh) : tree_(mesh) {
    // Vertices in the order in which the tree's triangles name them, so that near triangles share cache lines.
    std::vector<std::int32_t> renamed(mesh.vertices_B().size(), -1);
    triangles_.reserve(mesh.triangles().size());
    vertices_B_.reserve(mesh.vertices_B().size());
    for (const std::int32_t source : tree_.order()) {
        TriangleCorners corners = mesh.triangles()[static_cast<std::size_t>(source)];
        for (std::int32_t& corner : corners) {
            std::int32_t& name = renamed[static_cast<std::size_t>(corner)];
            if (name < 0) {
                name = static_cast<std::int32_t>(vertices_B_.size());
                vertices_B_.push_back(mesh.vertices_B()[static_cast<std::size_t>(corner)]);
            }
            corner = name;
        }
        triangles_.push_back(corners);
    }
    centre_B_ = 0.5 * (mesh.lower_B() + mesh.upper_B());
    for (const Vector3& vertex : vertices_B_) {
        radius_m_ = std::max(radius_m_, (vertex - centre_B_).norm());
    }
}

std::size_t CollisionMesh::memory_bytes() const noexcept {
    return tree_.memory_bytes() + vertices_B_.capacity() * sizeof(Vector3) +
           triangles_.capacity() * sizeof(TriangleCorners);
}

}  // namespace fulcrum
