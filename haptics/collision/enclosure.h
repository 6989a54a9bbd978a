// Is a place in the stuff of a mesh, behind its surface?
//
// Along a ray that leaves the mesh, an odd number of meetings tells that the place is enclosed on that side, and the first one's side
// whether by a face that looks away from it. A place in the stuff is so enclosed both ways along a line; three lines in directions of no
// symmetry vote, so that one that grazes an edge or leaves through a hole decides nothing. What is seen from its front all round, a mesh
// that is inside out or the walls of a room, is hollow; an open sheet has no stuff.
//
// Thread: any. Cost: some microseconds, O(log n) a meeting; no allocation.
#pragma once

#include "haptics/collision/collision_mesh.h"
#include "haptics/math/spatial.h"

namespace fulcrum {

/// A place on the surface itself may be told either way. Body frame; false for a place that is not finite.
[[nodiscard]] bool is_in_stuff(const CollisionMesh& mesh, const Vector3& at_B) noexcept;

}  // namespace fulcrum
