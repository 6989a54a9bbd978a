// A mesh's surface cut into convex pieces (piece_shape.h), as large as a flood makes them.
//
// A piece begins with the first triangle that has none, and takes neighbour after neighbour across shared edges, first come first served,
// while it stays convex. One whose hull something goes into, or that does not fill its polygon, keeps so many of its first triangles as do
// not harm: with fewer the hull is smaller, so half after half finds how many. A triangle alone is always a piece. Where an edge in a hundred
// is open, or an edge has three triangles or two windings, or all is inside out, there is no inside that a hull may fill: pieces are flat. With
// fewer open edges hulls fill what is behind the surface: who comes through a hole, from behind, may meet them before the surface.
//
// Thread: load. Cost: O(n times the size of a piece): 40 k triangles in 0.1 to 4 s.
// Source: S. Ehmann, M. Lin 2001, see piece_shape.h: greedy search by breadth.
#pragma once

#include "haptics/base/load_progress.h"
#include "haptics/geometry/mesh_report.h"
#include "haptics/levels/piece_shape.h"

#include <cstdint>
#include <vector>

namespace fulcrum {

struct ConvexPieces {
    std::vector<std::int32_t> piece_of;  ///< a triangle's piece, 0 to n_pieces - 1
    std::int32_t n_pieces = 0;
    bool has_inside = false;  ///< false: pieces are flat
    double slack_m = 0.0;     ///< what counts as on a plane
};

/// Fails only where `progress` stops it.
[[nodiscard]] Expected<ConvexPieces> make_convex_pieces(const TriangleMesh& mesh,
                                                        const LoadProgress& progress = {});

}  // namespace fulcrum
