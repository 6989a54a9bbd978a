// How far two convex bodies are apart, known by nothing but their farthest points in a direction.
//
// The difference of the bodies, all a - b, is convex; its point nearest to the origin is the shortest vector v between them. It is sought
// in simplices of up to four support points: nearest point of the simplex, then the support point w farthest back along v, until
// v . w says that nothing is nearer. With n = v / |v| all of the difference lies beyond n . w: so that n . w, not |v|, is told as the
// gap, what is told is a true lower bound, whatever the iteration left.
//
// Thread: any. Cost: some 5 to 15 support points; no allocation.
// Source: E. G. Gilbert, D. W. Johnson, S. S. Keerthi 1988, A fast procedure for computing the distance between complex objects in
// three-dimensional space, IEEE J. Robotics and Automation 4(2); the end by bounds as in G. van den Bergen 1999.
#pragma once

#include "haptics/math/length.h"
#include "haptics/math/spatial.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

namespace fulcrum {

/// The core of a convex body: what is left of it when `radius_m` is taken off all round. About its own origin, round axis y.
struct ConvexCore {
    enum class Kind : std::uint8_t { point, segment, box, cylinder, cloud };
    Kind kind = Kind::point;
    Vector3 half_m{Vector3::Zero()};  ///< segment: y; box: all; cylinder: x radius, y half height
    std::span<const Vector3> cloud{};
    double radius_m = 0.0;

    /// A point of the core that lies farthest in the direction.
    [[nodiscard]] Vector3 find_support(const Vector3& direction) const noexcept;
    /// Of a sphere round the origin that holds the body.
    [[nodiscard]] double bounding_radius_m() const noexcept;
};

/// The shortest way between two bodies.
struct ConvexGap {
    Vector3 normal{Vector3::UnitY()};  ///< unit, from the second to the first
    double gap_m = 0.0;                ///< 0 where they meet
};

/// `find_support(d)` gives the point of the difference first - second that is farthest along d. `start` is any vector from the second
/// to the first, not zero. Ends early where is_enough(n, n . w, |v|) says so: a direction, and how far the bodies are
/// apart at least and at most.
template <class FindSupport, class IsEnough>
[[nodiscard]] ConvexGap find_convex_gap(const Vector3& start, FindSupport&& find_support,
                                        IsEnough&& is_enough) noexcept;
template <class FindSupport>
[[nodiscard]] ConvexGap find_convex_gap(const Vector3& start, FindSupport&& find_support) noexcept {
    return find_convex_gap(
        start, find_support,
        [](const Vector3& /*normal*/, double /*least_m*/, double /*most_m*/) { return false; });
}

/// The points of a simplex, and its point nearest to the origin.
class Simplex {
  public:
    /// False when the point is one of it already.
    bool add(const Vector3& point) noexcept;
    /// Nearest to the origin; keeps only the points that it lies between.
    [[nodiscard]] Vector3 reduce() noexcept;
    [[nodiscard]] std::size_t count() const noexcept { return count_; }

  private:
    [[nodiscard]] Vector3 reduce_segment() noexcept;
    [[nodiscard]] Vector3 reduce_triangle() noexcept;
    [[nodiscard]] Vector3 reduce_tetrahedron() noexcept;
    void keep(std::size_t i) noexcept;

    Vector3 points_[4];
    std::size_t count_ = 0;
};

template <class FindSupport, class IsEnough>
ConvexGap find_convex_gap(const Vector3& start, FindSupport&& find_support,
                          IsEnough&& is_enough) noexcept {
    constexpr int kMostSteps = 64;
    constexpr double kEnough = 1.0e-10;  // of the distance: what may be left
    constexpr double kMeet = 1.0e-14;    // of the difference's size: no distance
    Simplex simplex;
    Vector3 v = start;
    ConvexGap best{.normal = compute_direction(start), .gap_m = 0.0};
    double size_m = 0.0;
    double last_m = std::numeric_limits<double>::infinity();
    for (int i = 0; i < kMostSteps; ++i) {
        const double length_m = v.norm();
        // No shorter than before: rounding alone is left.
        if (!(length_m > kMeet * size_m) || (i > 1 && !(length_m < last_m))) {
            return best;
        }
        last_m = length_m;
        const Vector3 normal = v / length_m;
        const Vector3 w = find_support(Vector3(-normal));
        const double bound_m = normal.dot(w);
        if (bound_m > best.gap_m) {
            best = {normal, bound_m};
        }
        size_m = size_m > w.norm() ? size_m : w.norm();
        const double most_m = i > 0 ? length_m : std::numeric_limits<double>::infinity();
        if (most_m - bound_m <= kEnough * length_m || is_enough(normal, bound_m, most_m)) {
            return best;
        }
        if (!simplex.add(w)) {
            return best;
        }
        v = simplex.reduce();
        if (simplex.count() == 4) {
            return best;
        }
    }
    return best;
}

}  // namespace fulcrum
