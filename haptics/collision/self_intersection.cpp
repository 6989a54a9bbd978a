#include "haptics/collision/self_intersection.h"

#include "haptics/geometry/bounding_tree.h"
#include "haptics/math/orientation.h"

#include <algorithm>
#include <array>

namespace fulcrum {

namespace {

using Corners = std::array<Vector3, 3>;

// Does the edge p q go through the inside of the triangle?
bool crosses(const Vector3& p, const Vector3& q, const Corners& t) {
    if (orientation(t[0], t[1], t[2], p) * orientation(t[0], t[1], t[2], q) >= 0) {
        return false;
    }
    const int first = orientation(p, q, t[0], t[1]);
    return first != 0 && orientation(p, q, t[1], t[2]) == first &&
           orientation(p, q, t[2], t[0]) == first;
}

bool any_edge_crosses(const Corners& one, const Corners& other) {
    return crosses(one[0], one[1], other) || crosses(one[1], one[2], other) ||
           crosses(one[2], one[0], other);
}

bool share_an_edge(const TriangleCorners& a, const TriangleCorners& b) {
    return std::count_if(a.begin(), a.end(), [&b](std::int32_t corner) {
               return std::find(b.begin(), b.end(), corner) != b.end();
           }) >= 2;
}

Corners corners_of(const TriangleMesh& mesh, const TriangleCorners& t) {
    const auto& vertices = mesh.vertices_B();
    return {vertices[static_cast<std::size_t>(t[0])], vertices[static_cast<std::size_t>(t[1])],
            vertices[static_cast<std::size_t>(t[2])]};
}

// Asks pairs until a limit is reached.
class Counter {
  public:
    Counter(const TriangleMesh& mesh, const SelfIntersectionLimits& limits)
        : mesh_(mesh),
          tree_(mesh),
          limits_(limits),
          pairs_left_(limits.most_pairs_a_triangle *
                      static_cast<std::int64_t>(mesh.triangles().size())) {}

    SelfIntersections run() {
        const auto n = static_cast<std::int32_t>(tree_.order().size());
        for (std::int32_t slot = 0; slot < n && !found_.more; ++slot) {
            const TriangleCorners& t = triangle_at(slot);
            const Corners corners = corners_of(mesh_, t);
            const Box box{corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]),
                          corners[0].cwiseMax(corners[1]).cwiseMax(corners[2])};
            tree_.for_each_in_box(box, [&](std::int32_t other) noexcept {
                // Each pair once.
                if (other > slot && !found_.more) {
                    ask(t, corners, triangle_at(other));
                }
            });
        }
        return found_;
    }

  private:
    [[nodiscard]] const TriangleCorners& triangle_at(std::int32_t slot) const noexcept {
        const std::int32_t index = tree_.order()[static_cast<std::size_t>(slot)];
        return mesh_.triangles()[static_cast<std::size_t>(index)];
    }
    void ask(const TriangleCorners& one, const Corners& corners,
             const TriangleCorners& other) noexcept {
        found_.more = --pairs_left_ < 0;
        // Neighbours along an edge can at most be folded onto each other.
        if (found_.more || share_an_edge(one, other)) {
            return;
        }
        const Corners theirs = corners_of(mesh_, other);
        if (any_edge_crosses(corners, theirs) || any_edge_crosses(theirs, corners)) {
            found_.more = found_.count >= limits_.most_crossings;
            found_.count += found_.more ? 0 : 1;
        }
    }

    const TriangleMesh& mesh_;
    BoundingTree tree_;
    SelfIntersectionLimits limits_;
    std::int64_t pairs_left_;
    SelfIntersections found_;
};

}  // namespace

SelfIntersections find_self_intersections(const TriangleMesh& mesh,
                                          const SelfIntersectionLimits& limits) {
    return Counter(mesh, limits).run();
}

MeshReport compute_full_mesh_report(const TriangleMesh& mesh) {
    MeshReport report = compute_mesh_report(mesh);
    const SelfIntersections found = find_self_intersections(mesh);
    report.self_intersections = found.count;
    report.more_self_intersections = found.more;
    return report;
}

}  // namespace fulcrum
