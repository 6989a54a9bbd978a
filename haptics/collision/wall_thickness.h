// How thick the walls of a mesh are: what a field or voxels of it must be fine enough for.
//
//   t(p) = the way from p on the surface, along the inward normal n, to the first triangle that is met there
// counted where that is left through its front, near to straight: n.n' >= 0.9, n' its own outward normal. Beside edges and near tips,
// where the other side is slanted, there is no wall. A mesh inside out has the walls that it had.
//
// Thread: load. Cost: 1 us a place.
#pragma once

#include "haptics/collision/collision_mesh.h"
#include "haptics/voxel/pointshell.h"

namespace fulcrum {

/// The thickness below which `share` (0 to 1) of the mesh's surface lies; infinite where less of it has any. `places` are spread
/// evenly over the mesh, with normals inwards, as make_surface_pointshell has them.
[[nodiscard]] double find_wall_m(const CollisionMesh& mesh, const Pointshell& places, double share);

}  // namespace fulcrum
