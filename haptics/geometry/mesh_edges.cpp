#include "haptics/geometry/mesh_edges.h"

#include <algorithm>

namespace fulcrum {

std::vector<MeshEdge> collect_edges(std::span<const TriangleCorners> triangles,
                                    std::size_t n_vertices) {
    const auto visit_all = [&triangles](auto&& visit) {
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                const std::int32_t from = triangles[i][k];
                const std::int32_t to = triangles[i][(k + 1) % 3];
                visit(MeshEdge{std::min(from, to), std::max(from, to), static_cast<std::int32_t>(i),
                               from < to});
            }
        }
    };
    // Counted by their low vertex first, so that only few have to be sorted at a time.
    std::vector<std::size_t> first(n_vertices + 1, 0);
    visit_all([&first](const MeshEdge& edge) { ++first[static_cast<std::size_t>(edge.low) + 1]; });
    for (std::size_t i = 0; i < n_vertices; ++i) {
        first[i + 1] += first[i];
    }
    std::vector<MeshEdge> edges(3 * triangles.size());
    std::vector<std::size_t> next(first.begin(), first.end() - 1);
    visit_all(
        [&](const MeshEdge& edge) { edges[next[static_cast<std::size_t>(edge.low)]++] = edge; });
    for (std::size_t i = 0; i < n_vertices; ++i) {
        std::stable_sort(edges.begin() + static_cast<std::ptrdiff_t>(first[i]),
                         edges.begin() + static_cast<std::ptrdiff_t>(first[i + 1]),
                         [](const MeshEdge& a, const MeshEdge& b) { return a.high < b.high; });
    }
    return edges;
}

}  // namespace fulcrum
