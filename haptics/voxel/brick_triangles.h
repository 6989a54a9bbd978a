// Which triangles of a mesh may be within reach of which brick of a block: what a distance field is made from.
//
// A brick of 8^3 cells has those triangles that come as near to its middle as half its diagonal and the reach. Large triangles that
// cross the whole block are in as many bricks as their area fills, so that a heap of them makes a list as long as triangles times
// bricks; one that grows beyond `most` is given up, and how long it would have become is told.
//
// Thread: load. Cost: 20 ns a brick of a triangle's box, 12 bytes a pair.
#pragma once

#include "haptics/base/load_progress.h"
#include "haptics/geometry/triangle_mesh.h"
#include "haptics/voxel/triangle_clusters.h"
#include "haptics/voxel/voxel_frame.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace fulcrum {

/// The triangle in voxels of the block.
[[nodiscard]] TriangleAt find_lattice_triangle(const TriangleMesh& mesh, const VoxelFrame& frame,
                                               std::size_t index);

struct BrickTriangles {
    std::vector<std::int32_t>
        bricks;                      ///< those that have any, ascending; x fastest, then y, then z
    std::vector<std::size_t> first;  ///< of each, and the end
    std::vector<std::int32_t> triangles;  ///< ascending for each brick
    double n_pairs =
        0.0;  ///< of a brick and a triangle; where there were too many, about how many, and the lists are empty

    [[nodiscard]] std::size_t count(std::size_t listed) const noexcept {
        return first[listed + 1] - first[listed];
    }
};

/// `reach_voxels`: how far from a triangle a brick's corners may be. Nothing where it was stopped.
[[nodiscard]] std::optional<BrickTriangles> list_brick_triangles(const TriangleMesh& mesh,
                                                                 const VoxelFrame& frame,
                                                                 double reach_voxels, double most,
                                                                 const LoadProgress& progress);

}  // namespace fulcrum
