// The triangles of a mesh in balls within balls: how far a point is from the nearest of them, and what a far cluster of them
// amounts to as one.
//
// A complete 8-ary tree without pointers over the order of BoundingTree: triangle slot i belongs to leaf i / 8, leaf j to the
// cluster j / 8 above, and so on. A cluster keeps a ball round its triangles and the sum of their area vectors,
//   N = sum of (b - a) x (c - a) / 2,    about    c = sum of area * centroid / sum of area
// Distance: branch and bound, a cluster whose ball is farther than the nearest triangle so far is left out.
//
// Thread: build at load; questions from any thread. Cost: build O(n log n), 90 bytes a triangle; a question O(log n) triangles.
#pragma once

#include "haptics/geometry/triangle_mesh.h"

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace fulcrum {

/// Three corners in metres, body frame; the front sees them counter-clockwise.
struct TriangleAt {
    Vector3 a{Vector3::Zero()}, b{Vector3::Zero()}, c{Vector3::Zero()};

    /// Half the cross product of two sides: the normal times the area.
    [[nodiscard]] Vector3 area_vector() const noexcept { return 0.5 * (b - a).cross(c - a); }
};

/// The square of how far `p` is from the nearest point of the triangle. Slivers are their longest edges.
[[nodiscard]] double compute_square_distance(const Vector3& p, const TriangleAt& triangle) noexcept;

struct TriangleCluster {
    Vector3 centre_B{Vector3::Zero()};
    double radius_m = 0.0;  ///< of a ball round `centre_B` that holds its triangles
    Vector3 area_vector_B{Vector3::Zero()};  ///< sum of its triangles', m^2
};

class TriangleClusters {
  public:
    static constexpr std::int32_t kWidth = 8;

    explicit TriangleClusters(const TriangleMesh& mesh);

    /// From `p_B` to the nearest triangle, or `at_most` where none is nearer. With a `slack` of 0 to 1 the answer may be too
    /// small by that share, and is had much sooner where many triangles are about as near.
    [[nodiscard]] double find_distance(const Vector3& p_B,
                                       double at_most = std::numeric_limits<double>::infinity(),
                                       double slack = 0.0) const noexcept;

    /// Walks from the root: `is_far(cluster)` says whether a cluster is to be taken as one, else its parts come, at last
    /// `visit(triangle)`.
    template <class IsFar, class Visit>
    void for_each_near(IsFar&& is_far, Visit&& visit) const noexcept;

  private:
    static constexpr std::size_t kMaxLevels = 11;
    static constexpr std::size_t kStack = kMaxLevels * kWidth;
    struct Place {
        std::int32_t level = 0;
        std::int32_t index = 0;
        double bound = 0.0;
    };
    struct Children {
        std::int32_t first = 0;
        std::int32_t end = 0;
    };

    void build_leaves();
    void build_parents();
    [[nodiscard]] std::int32_t count_at(std::int32_t level) const noexcept {
        const auto l = static_cast<std::size_t>(level);
        return level_first_[l + 1] - level_first_[l];
    }
    [[nodiscard]] const TriangleCluster& cluster_at(std::int32_t level,
                                                    std::int32_t index) const noexcept {
        return clusters_[static_cast<std::size_t>(level_first_[static_cast<std::size_t>(level)]) +
                         static_cast<std::size_t>(index)];
    }
    // Level 0 is that of the leaves, whose children are triangles.
    [[nodiscard]] Children children_of(const Place& place) const noexcept {
        const auto n = place.level == 0 ? static_cast<std::int32_t>(triangles_.size())
                                        : count_at(place.level - 1);
        return {place.index * kWidth, std::min(n, (place.index + 1) * kWidth)};
    }
    [[nodiscard]] Place root() const noexcept { return {n_levels_ - 1, 0, 0.0}; }

    std::vector<TriangleAt> triangles_;
    std::vector<TriangleCluster> clusters_;
    std::array<std::int32_t, kMaxLevels + 1> level_first_{};
    std::int32_t n_levels_ = 0;
};

template <class IsFar, class Visit>
void TriangleClusters::for_each_near(IsFar&& is_far, Visit&& visit) const noexcept {
    std::array<Place, kStack> stack{};
    std::size_t n = 0;
    stack[n++] = root();
    while (n > 0) {
        const Place place = stack[--n];
        if (is_far(cluster_at(place.level, place.index))) {
            continue;
        }
        const auto [first, end] = children_of(place);
        for (std::int32_t child = first; child < end; ++child) {
            if (place.level == 0) {
                visit(triangles_[static_cast<std::size_t>(child)]);
            } else {
                stack[n++] = {place.level - 1, child, 0.0};
            }
        }
    }
}

}  // namespace fulcrum
