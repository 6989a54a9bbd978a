// The triangles of a mesh by their corners, and its edges, each as often as triangles have it, those of one pair of vertices side by side.
//
// Thread: load. Cost: O(triangles).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace fulcrum {

/// Indices of a triangle's corners; seen from its front they run counter-clockwise.
using TriangleCorners = std::array<std::int32_t, 3>;

/// One side of one triangle.
struct MeshEdge {
    std::int32_t low = 0;
    std::int32_t high = 0;
    std::int32_t triangle = 0;
    bool upwards = false;  ///< the triangle runs from low to high
};

/// By low, then by high vertex.
[[nodiscard]] std::vector<MeshEdge> collect_edges(std::span<const TriangleCorners> triangles,
                                                  std::size_t n_vertices);

/// Calls visit(edges) for each run of edges that have the same two vertices.
template <class Visit>
void for_each_shared_edge(std::span<const MeshEdge> edges, Visit&& visit) {
    for (std::size_t first = 0; first < edges.size();) {
        std::size_t end = first + 1;
        while (end < edges.size() && edges[end].low == edges[first].low &&
               edges[end].high == edges[first].high) {
            ++end;
        }
        visit(edges.subspan(first, end - first));
        first = end;
    }
}

}  // namespace fulcrum
