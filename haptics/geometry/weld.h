// Which vertices of a mesh are the same point.
//
// Each vertex becomes the first kept vertex within the tolerance, or is kept itself; so the result
// depends on the order alone. Kept vertices lie in a hash table of cubic cells twice the tolerance
// wide: a ball meets at most 8.
//
// Thread: load. Cost: O(n) for meshes whose vertices are further apart than the tolerance.
#pragma once

#include "haptics/math/spatial.h"

#include <cstdint>
#include <span>
#include <vector>

namespace fulcrum {

/// For each vertex the index of the one it becomes; its own index when it stays. `tolerance_m` > 0.
[[nodiscard]] std::vector<std::int32_t> compute_welded_indices(std::span<const Vector3> vertices,
                                                               double tolerance_m);

}  // namespace fulcrum
