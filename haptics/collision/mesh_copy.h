// A mesh that can be touched as the triangles it was made of, for what is made from those.
//
// Thread: load. Cost: a copy of all vertices and triangles.
#pragma once

#include "haptics/collision/collision_mesh.h"
#include "haptics/geometry/triangle_mesh.h"

namespace fulcrum {

/// The same vertices and triangles, nothing welded: it was built before.
[[nodiscard]] inline Expected<TriangleMesh> copy_triangles(const CollisionMesh& mesh) {
    return TriangleMesh::build({mesh.vertices_B().begin(), mesh.vertices_B().end()},
                               {mesh.triangles().begin(), mesh.triangles().end()},
                               {.weld_relative = 0.0, .crack_relative = 0.0});
}

}  // namespace fulcrum
