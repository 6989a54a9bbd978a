// Meshes of several parts, and the outline of a bar with slivers.
#pragma once

#include "haptics/geometry/triangle_mesh.h"

#include <utility>
#include <vector>

namespace fulcrum {

/// The outline, for make_prism, of a square of 2 `half_m` with a band of twenty slivers of a micrometre in the middle of each side.
[[nodiscard]] std::vector<Vector2> make_slivered_square(double half_m);

/// Parts told as one mesh, each at its pose; where they cross nothing is cut.
[[nodiscard]] Expected<TriangleMesh> join_meshes(
    const std::vector<std::pair<TriangleMesh, Pose>>& parts,
    const MeshBuildSettings& settings = {});

}  // namespace fulcrum
