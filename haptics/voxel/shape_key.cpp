#include "haptics/voxel/shape_key.h"

#include <array>

namespace fulcrum {

Digest compute_shape_key(ShapeKind kind, const TriangleMesh& mesh,
                         std::span<const double> settings) {
    Sha256 hash;
    const std::array<std::uint64_t, 5> head{kShapeVersion, static_cast<std::uint64_t>(kind),
                                            mesh.vertices_B().size(), mesh.triangles().size(),
                                            settings.size()};
    hash.add(std::as_bytes(std::span(head)));
    for (const Vector3& vertex : mesh.vertices_B()) {
        hash.add(std::as_bytes(std::span(vertex.data(), 3)));
    }
    hash.add(std::as_bytes(std::span(mesh.triangles())));
    hash.add(std::as_bytes(settings));
    return hash.finish();
}

}  // namespace fulcrum
