// Trees of oriented boxes over triangles, many in one store, and the test of a segment against such a box.
//
// A box's axes are those along which its triangles' surface spreads: the eigenvectors of the covariance of the surface,
//   C_jk = sum_i A_i / (12 A) (9 m_j m_k + a_j a_k + b_j b_k + c_j c_k) - mean_j mean_k
// with A_i the area and m the centre of triangle (a, b, c), the triangles themselves instead of their convex hull. A box is split
// across its longest axis at the mean of the centres.
// A segment of middle m and half vector w, in the box's frame, is apart from a box of half sizes t when
//   |m_x| > t_x + |w_x|  or  |m_y w_z - m_z w_y| > t_y |w_z| + t_z |w_y|,  likewise for the other axes: six tests.
// Boxes are kept in single precision and asked in double: the kept axes span a frame, orthogonal or not quite, in which sizes are
// measured, so nothing is lost; sizes are rounded up.
//
// Thread: build at load; questions from any thread. Cost: build O(n log n); 68 bytes a box.
// Source: S. Gottschalk, M. C. Lin, D. Manocha 1996, OBBTree: a hierarchical structure for rapid interference detection,
// SIGGRAPH; the segment's test: A. Gregory, M. C. Lin, S. Gottschalk, R. Taylor 1999, H-COLLIDE, IEEE Virtual Reality.
#pragma once

#include "haptics/geometry/triangle_mesh.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace fulcrum {

struct OrientedBox {
    std::array<float, 3> centre{};
    std::array<std::array<float, 3>, 3> axes{};  ///< one a row
    std::array<float, 3> half_size{};

    /// A row of the frame.
    [[nodiscard]] Vector3 axis(std::size_t row) const noexcept {
        return {static_cast<double>(axes[row][0]), static_cast<double>(axes[row][1]),
                static_cast<double>(axes[row][2])};
    }
    [[nodiscard]] Vector3 from_centre(const Vector3& point) const noexcept {
        return {point.x() - static_cast<double>(centre[0]),
                point.y() - static_cast<double>(centre[1]),
                point.z() - static_cast<double>(centre[2])};
    }
    /// A point in the box's frame.
    [[nodiscard]] Vector3 to_frame(const Vector3& point) const noexcept {
        const Vector3 away = from_centre(point);
        return {axis(0).dot(away), axis(1).dot(away), axis(2).dot(away)};
    }
};

/// A segment as the boxes want it.
struct CentredSegment {
    Vector3 middle;
    Vector3 half;      ///< from the middle to the end
    double largest_m;  ///< coordinate of either end, by magnitude
};

[[nodiscard]] inline CentredSegment to_centred(const Vector3& from, const Vector3& to) noexcept {
    return {0.5 * (from + to), 0.5 * (to - from),
            from.cwiseAbs().cwiseMax(to.cwiseAbs()).maxCoeff()};
}

/// May they meet? Never false when they do.
[[nodiscard]] inline bool overlaps(const OrientedBox& box, const CentredSegment& segment) noexcept {
    // In the box's frame; each component errs by some roundings of the coordinates.
    constexpr double kRoundings = 64.0 * std::numeric_limits<double>::epsilon();
    std::array<double, 3> m{};
    std::array<double, 3> w{};
    const Vector3 away = box.from_centre(segment.middle);
    double error_m = kRoundings * segment.largest_m;
    for (std::size_t i = 0; i < 3; ++i) {
        error_m += kRoundings * std::abs(static_cast<double>(box.centre[i]));
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const Vector3 axis = box.axis(i);
        m[i] = axis.dot(away);
        w[i] = axis.dot(segment.half);
        if (std::abs(m[i]) > static_cast<double>(box.half_size[i]) + std::abs(w[i]) + error_m) {
            return false;
        }
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const std::size_t k = (i + 2) % 3;
        const double reach = static_cast<double>(box.half_size[j]) * std::abs(w[k]) +
                             static_cast<double>(box.half_size[k]) * std::abs(w[j]);
        const double error =
            error_m * (std::abs(m[j]) + std::abs(m[k]) + std::abs(w[j]) + std::abs(w[k]) + error_m);
        if (std::abs(m[j] * w[k] - m[k] * w[j]) > reach + error) {
            return false;
        }
    }
    return true;
}

class ObbForest {
  public:
    /// Boxes with up to `triangles_a_leaf` >= 1 triangles are not split.
    ObbForest(std::span<const Vector3> vertices, std::span<const TriangleCorners> triangles,
              int triangles_a_leaf)
        : vertices_(vertices),
          corners_(triangles),
          triangles_a_leaf_(static_cast<std::size_t>(triangles_a_leaf)) {}

    /// Builds a tree over some of the triangles, one at least; returns its root. Vertices and triangles must still be there.
    std::int32_t add(std::span<const std::int32_t> triangles);
    /// Calls visit(triangle) for those in boxes of the tree that the segment may meet.
    template <class Visit>
    void for_each_met(std::int32_t root, const CentredSegment& segment,
                      Visit&& visit) const noexcept;
    [[nodiscard]] const OrientedBox& box(std::int32_t node) const noexcept {
        return nodes_[static_cast<std::size_t>(node)].box;
    }
    /// The first of a node's two children, the other one follows it; -1 of a leaf.
    [[nodiscard]] std::int32_t first_child(std::int32_t node) const noexcept {
        const Node& one = nodes_[static_cast<std::size_t>(node)];
        return one.n_triangles == 0 ? one.first : -1;
    }
    /// A leaf's triangles.
    [[nodiscard]] std::span<const std::int32_t> triangles_of(std::int32_t leaf) const noexcept {
        const Node& one = nodes_[static_cast<std::size_t>(leaf)];
        return std::span(triangles_)
            .subspan(static_cast<std::size_t>(one.first),
                     static_cast<std::size_t>(one.n_triangles));
    }
    /// Gives back what the build took too much.
    void shrink();
    [[nodiscard]] std::size_t memory_bytes() const noexcept;

  private:
    struct Node {
        OrientedBox box;
        std::int32_t first = 0;  // child, the other one follows it; of a leaf the first triangle
        std::int32_t n_triangles = 0;  // 0: not a leaf
    };
    // Halves at worst, so no tree is deeper than the logarithm of 2^31 triangles.
    static constexpr std::size_t kStack = 64;

    [[nodiscard]] OrientedBox fit(std::span<const std::int32_t> triangles) const;
    [[nodiscard]] Vector3 measure(const OrientedBox& box, std::span<const std::int32_t> triangles,
                                  Vector3& middle) const;
    [[nodiscard]] std::size_t split(const OrientedBox& box,
                                    std::span<std::int32_t> triangles) const;
    [[nodiscard]] std::array<Vector3, 3> corners_of(std::int32_t triangle) const;

    std::span<const Vector3> vertices_;
    std::span<const TriangleCorners> corners_;
    std::size_t triangles_a_leaf_;
    std::vector<Node> nodes_;
    std::vector<std::int32_t> triangles_;
};

template <class Visit>
void ObbForest::for_each_met(std::int32_t root, const CentredSegment& segment,
                             Visit&& visit) const noexcept {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): filled as it grows
    std::array<std::int32_t, kStack> stack;
    std::size_t n_stacked = 0;
    stack[n_stacked++] = root;
    while (n_stacked > 0) {
        const Node& node = nodes_[static_cast<std::size_t>(stack[--n_stacked])];
        if (!overlaps(node.box, segment)) {
            continue;
        }
        if (node.n_triangles == 0) {
            stack[n_stacked++] = node.first + 1;
            stack[n_stacked++] = node.first;
        }
        const auto first = static_cast<std::size_t>(node.first);
        const auto count = static_cast<std::size_t>(node.n_triangles);
        for (const std::int32_t triangle :
             std::span(triangles_).subspan(count > 0 ? first : 0, count)) {
            visit(triangle);
        }
    }
}

}  // namespace fulcrum
