// The load path of god_shading.h.
#include "haptics/geometry/mesh_edges.h"
#include "haptics/tool/god_object/god_shading.h"

#include <utility>

namespace fulcrum {
namespace {

// Which edge of the triangle it is, by its corner there.
std::size_t find_edge(const TriangleCorners& corners, std::int32_t low, std::int32_t high) {
    for (std::size_t k = 0; k < 2; ++k) {
        const std::int32_t a = corners[k];
        const std::int32_t b = corners[k + 1];
        if ((a == low && b == high) || (a == high && b == low)) {
            return k;
        }
    }
    return 2;
}

}  // namespace

GodShading::GodShading(const TriangleMesh& mesh, std::shared_ptr<const CollisionMesh> touched,
                       double crease_angle_deg)
    : mesh_(std::move(touched)),
      normals_(mesh_, crease_angle_deg),
      touched_(mesh.triangles().size()),
      even_(mesh.triangles().size(), {false, false, false}) {
    for (std::int32_t t = 0; t < mesh_->n_triangles(); ++t) {
        touched_[static_cast<std::size_t>(mesh_->source_triangle(t))] = t;
    }
    const auto normal_at = [&](const MeshEdge& edge, std::int32_t vertex) {
        const auto t = static_cast<std::size_t>(edge.triangle);
        std::size_t corner = 0;
        while (mesh.triangles()[t][corner] != vertex) {
            ++corner;
        }
        return normals_.corner_normal_B(touched_[t], corner);
    };
    const std::vector<MeshEdge> edges = collect_edges(mesh.triangles(), mesh.vertices_B().size());
    for_each_shared_edge(edges, [&](std::span<const MeshEdge> shared) {
        if (shared.size() != 2) {
            return;
        }
        const auto is_same_at = [&](std::int32_t vertex) {
            return normal_at(shared[0], vertex) == normal_at(shared[1], vertex);
        };
        const bool even = is_same_at(shared[0].low) && is_same_at(shared[0].high);
        for (const MeshEdge& edge : shared) {
            const auto t = static_cast<std::size_t>(edge.triangle);
            even_[t][find_edge(mesh.triangles()[t], edge.low, edge.high)] = even;
        }
    });
}

Expected<std::shared_ptr<const GodShading>> GodShading::create(const TriangleMesh& mesh,
                                                               const ShadingSettings& settings) {
    if (const auto checked = validate(settings); !checked) {
        return tl::unexpected(checked.error());
    }
    auto touched = CollisionMesh::create(mesh);
    if (!touched) {
        return tl::unexpected(touched.error());
    }
    return std::shared_ptr<const GodShading>(
        new GodShading(mesh, std::move(*touched), settings.crease_angle_deg));
}

std::size_t GodShading::memory_bytes() const noexcept {
    return sizeof(*this) + mesh_->memory_bytes() + normals_.memory_bytes() +
           touched_.capacity() * sizeof(touched_[0]) + even_.capacity() * sizeof(even_[0]);
}

}  // namespace fulcrum
