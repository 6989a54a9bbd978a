// Meshes from files, for people who want to see their own measured.
#pragma once

#include "haptics/base/error.h"
#include "haptics/geometry/triangle_mesh.h"

#include <string>
#include <utility>
#include <vector>

namespace fulcrum::bench {

/// Reads vertices ("v x y z") and faces ("f 1 2/5 3//7 …", numbers from 1, or from the end when negative) of a Wavefront OBJ text;
/// faces of more corners are cut into triangles from their first one. All else is skipped. `where` names the file in errors.
[[nodiscard]] Expected<TriangleMesh> read_obj(const std::string& text, const std::string& where);

/// The same triangles, each vertex at `place` of where it was.
template <class Place>
[[nodiscard]] TriangleMesh make_changed(const TriangleMesh& mesh, Place place) {
    std::vector<Vector3> vertices;
    for (const Vector3& v : mesh.vertices_B()) {
        vertices.push_back(place(v));
    }
    return TriangleMesh::build(std::move(vertices), mesh.triangles()).value();
}

/// So many times as large, its middle at the origin.
[[nodiscard]] TriangleMesh make_scaled(const TriangleMesh& mesh, double scale);

/// Loads an .obj, .glb or .gltf file.
[[nodiscard]] Expected<TriangleMesh> load_mesh_file(const std::string& file);

}  // namespace fulcrum::bench
