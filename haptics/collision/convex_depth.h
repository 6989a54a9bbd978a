// How far two convex bodies must be moved apart, and which way: least translation.
//
// The difference D of the bodies, all a - b, is convex; moved by t along -m they part where t reaches h(m), the farthest that D goes along
// the unit vector m. So the depth is the least h over all m. D is grown from inside as a polytope of its own support points: the face
// nearest to the origin, measured with its sign so that the origin may as well lie outside or on it, gives m; the support point there
// gives h(m), and where it lies beyond the face becomes a corner. The least offset of a face is a bound from below, the least h(m) from
// above: what is told is true whatever the iteration left, and nothing has to be known of where the origin lies at the start.
//
// Thread: any. Cost: 5 to 20 support points between polytopes, up to 60 where both are round; no allocation.
// Source: G. van den Bergen 2001, Proximity queries and penetration depth computation on 3D game objects, GDC: the expanding polytope;
// here the search may begin at any tetrahedron of D instead of one round the origin; who has found such a one saves twelve support points.
#pragma once

#include "haptics/collision/convex_gap.h"

#include <array>
#include <cstdint>

namespace fulcrum {

/// A polytope that grows by corners.
class GrowingHull {
  public:
    /// Four corners that are not in one plane.
    explicit GrowingHull(const std::array<Vector3, 4>& corners) noexcept;
    struct Face {
        std::array<std::uint8_t, 3> corners{};
        Vector3 normal{Vector3::Zero()};  ///< unit, outwards
        double offset_m = 0.0;            ///< of its plane from the origin, along the normal
    };
    /// The face of least offset.
    [[nodiscard]] const Face& find_nearest() const noexcept;
    /// Takes a corner in; false where it is beyond no face or there is no room.
    [[nodiscard]] bool grow(const Vector3& corner) noexcept;

  private:
    static constexpr int kMostCorners = 64;
    static constexpr int kMostFaces = 2 * kMostCorners;
    struct Edge {
        std::uint8_t from;
        std::uint8_t to;
    };
    void add_face(std::uint8_t a, std::uint8_t b, std::uint8_t c) noexcept;
    void remove_face(int i) noexcept;
    void toggle_edge(std::uint8_t from, std::uint8_t to) noexcept;

    std::array<Vector3, kMostCorners> corners_;
    std::array<Face, kMostFaces> faces_;
    std::array<Edge, kMostFaces> border_;
    int n_corners_ = 4;
    int n_faces_ = 0;
    int n_border_ = 0;
    double least_m_ = 0.0;  // what counts as beyond
};

/// Four points of D that span most, from any support function. False where D is flat: then `flat` is normal to it.
template <class FindSupport>
[[nodiscard]] bool find_corners_of(const FindSupport& find_support, std::array<Vector3, 4>& corners,
                                   Vector3& flat) noexcept;

/// The direction in which the first body has to go, unit, and minus how far; above 0 where the bodies are apart: then a lower bound of
/// their distance. `find_support` as of `find_convex_gap`.
template <class FindSupport>
[[nodiscard]] ConvexGap find_convex_depth(const FindSupport& find_support) noexcept;
/// The same from four points of D on, that span a volume: those round the origin that a search for the distance ended with are a good start.
template <class FindSupport>
[[nodiscard]] ConvexGap find_convex_depth(const FindSupport& find_support,
                                          const std::array<Vector3, 4>& from) noexcept;

/// What of D's size counts as nothing.
inline constexpr double kFlatPart = 1.0e-9;

template <class FindSupport>
bool find_corners_of(const FindSupport& find_support, std::array<Vector3, 4>& corners,
                     Vector3& flat) noexcept {
    double most = -1.0;
    for (int axis = 0; axis < 3; ++axis) {
        const Vector3 low = find_support(Vector3(-Vector3::Unit(axis)));
        const Vector3 high = find_support(Vector3(Vector3::Unit(axis)));
        if ((high - low).squaredNorm() > most) {
            most = (high - low).squaredNorm();
            corners[0] = low;
            corners[1] = high;
        }
    }
    if (!(most > 0.0)) {
        flat = Vector3::UnitY();
        return false;
    }
    const double least = kFlatPart * std::sqrt(most);
    const Vector3 along = compute_direction(Vector3(corners[1] - corners[0]));
    const Vector3 across = compute_direction(Vector3(along.unitOrthogonal()));
    most = -1.0;
    for (const Vector3& way :
         {across, Vector3(-across), Vector3(along.cross(across)), Vector3(-along.cross(across))}) {
        const Vector3 corner = find_support(way);
        const double away = along.cross(corner - corners[0]).squaredNorm();
        if (away > most) {
            most = away;
            corners[2] = corner;
        }
    }
    if (!(std::sqrt(most) > least)) {
        flat = across;
        return false;
    }
    flat = compute_direction(Vector3(along.cross(corners[2] - corners[0])));
    most = -1.0;
    for (const Vector3& way : {flat, Vector3(-flat)}) {
        const Vector3 corner = find_support(way);
        const double away = std::abs(flat.dot(corner - corners[0]));
        if (away > most) {
            most = away;
            corners[3] = corner;
        }
    }
    return most > least;
}

namespace details {

// The least of the ways that were tried.
template <class FindSupport>
class LeastWay {
  public:
    explicit LeastWay(const FindSupport& find_support) noexcept : find_support_(find_support) {}
    Vector3 try_way(const Vector3& way) noexcept {
        const Vector3 corner = find_support_(way);
        if (!has_best_ || -way.dot(corner) > best_.gap_m) {
            best_ = {Vector3(-way), -way.dot(corner)};
            has_best_ = true;
        }
        return corner;
    }
    // Grows them until no way can be less.
    const ConvexGap& grow_from(const std::array<Vector3, 4>& corners) noexcept {
        constexpr double kEnough = 1.0e-6;  // of D's size: what may be left
        const double enough_m = kEnough * (corners[1] - corners[0]).norm();
        GrowingHull hull(corners);
        for (bool goes_on = true; goes_on;) {
            const GrowingHull::Face& face = hull.find_nearest();
            const double offset_m = face.offset_m;
            const Vector3 corner = try_way(face.normal);
            goes_on = -best_.gap_m - offset_m > enough_m && hull.grow(corner);
        }
        return best_;
    }
    [[nodiscard]] const ConvexGap& best() const noexcept { return best_; }

  private:
    const FindSupport& find_support_;
    ConvexGap best_{.normal = Vector3::UnitY(), .gap_m = 0.0};
    bool has_best_ = false;
};

}  // namespace details

template <class FindSupport>
ConvexGap find_convex_depth(const FindSupport& find_support) noexcept {
    std::array<Vector3, 4> corners;
    Vector3 flat = Vector3::UnitY();
    details::LeastWay least(find_support);
    if (!find_corners_of(find_support, corners, flat)) {
        (void)least.try_way(flat);
        (void)least.try_way(Vector3(-flat));
        return least.best();
    }
    return least.grow_from(corners);
}

template <class FindSupport>
ConvexGap find_convex_depth(const FindSupport& find_support,
                            const std::array<Vector3, 4>& from) noexcept {
    return details::LeastWay(find_support).grow_from(from);
}

}  // namespace fulcrum
