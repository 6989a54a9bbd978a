#include "runtime/scene/gltf/collision_from_model.h"

#include <utility>

namespace fulcrum::runtime {

Expected<TriangleMesh> collision_from_model(const LoadedModel& model, const std::string& where) {
    std::vector<Vector3> vertices_B;
    std::vector<TriangleCorners> triangles;
    for (const ModelPrimitive& primitive : model.primitives) {
        const auto first = static_cast<std::int32_t>(vertices_B.size());
        for (std::size_t i = 0; i + 2 < primitive.positions.size(); i += 3) {
            vertices_B.emplace_back(static_cast<double>(primitive.positions[i]),
                                    static_cast<double>(primitive.positions[i + 1]),
                                    static_cast<double>(primitive.positions[i + 2]));
        }
        for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
            TriangleCorners corners{};
            for (std::size_t k = 0; k < 3; ++k) {
                corners[k] = first + static_cast<std::int32_t>(primitive.indices[i + k]);
            }
            triangles.push_back(corners);
        }
    }
    return TriangleMesh::build(std::move(vertices_B), std::move(triangles), {}, where);
}

}  // namespace fulcrum::runtime
