// What a convex piece of a surface has to be: some triangles that all lie on the hull round them, and a hull that nothing else goes into.
//
//   convex    every corner lies behind every triangle's plane, by up to `slack`
//   flat      all corners lie in one plane, by up to `slack`: then the triangles must fill a convex polygon, which their area tells
//   clear     no other triangle goes into the hull's inside. What of the hull is no triangle of the piece, its virtual faces, then lies inside
//             the solid: the inside is behind the piece's own triangles, and nothing else bounds it there
// So for a closed mesh the hulls of all pieces together lie in the solid and hold its surface: their distance is the mesh's.
//
// Thread: load. Cost: corners x triangles for convex, a GJK of 0.3 us each triangle near for clear.
// Source: S. Ehmann, M. Lin 2001, Accurate and fast proximity queries between polyhedra using convex surface decomposition, Eurographics,
// section 4; M. Otaduy, M. Lin 2003, Sensation preserving simplification for haptic rendering, SIGGRAPH, section 4 (constraints).
#pragma once

#include "haptics/levels/hull_pair.h"

#include <array>
#include <vector>

namespace fulcrum {

using PieceTriangle = std::array<Vector3, 3>;

/// n . x = offset on it, the front is where it is more.
struct PiecePlane {
    Vector3 normal{
        Vector3::Zero()};  ///< unit; zero of a triangle without area, which then bounds nothing
    double offset_m = 0.0;

    [[nodiscard]] static PiecePlane of(const PieceTriangle& triangle) noexcept;
    [[nodiscard]] double height_m(const Vector3& point) const noexcept {
        return normal.dot(point) - offset_m;
    }
};

/// Triangles that are, or may become, a piece.
struct PieceShape {
    std::vector<Vector3> corners;    ///< each once
    std::vector<PiecePlane> planes;  ///< one a triangle
    double area_m2 = 0.0;

    void clear() noexcept;
    void add_triangle(const PieceTriangle& triangle);
    /// Is the point behind all planes?
    [[nodiscard]] bool is_behind(const Vector3& point, double slack_m) const noexcept;
    /// Are all corners behind the plane?
    [[nodiscard]] bool is_before(const PiecePlane& plane, double slack_m) const noexcept;
    /// Do all corners lie in the first plane?
    [[nodiscard]] bool is_flat(double slack_m) const noexcept;
    /// Of a flat one: do the triangles fill the polygon round them?
    [[nodiscard]] bool fills_its_polygon() const;
};

/// A hull a hair smaller, to ask what goes into it: what only touches does not.
class InnerHull {
  public:
    /// What goes in no deeper than `slack_m` does not enter it.
    explicit InnerHull(const PieceShape& shape, double slack_m = 0.0);
    [[nodiscard]] bool is_entered_by(const PieceTriangle& triangle) const noexcept;
    [[nodiscard]] const Vector3& lower() const noexcept { return lower_; }
    [[nodiscard]] const Vector3& upper() const noexcept { return upper_; }

  private:
    const std::vector<PiecePlane>& planes_;
    std::vector<Vector3> points_;
    Vector3 middle_{Vector3::Zero()};
    Vector3 lower_{Vector3::Zero()};
    Vector3 upper_{Vector3::Zero()};
    double touch_m_ = 0.0;
    double slack_m_;
};

/// The corners of the polygon round points of a plane, counter-clockwise as seen from where `normal` points to; what lies on an edge is left out.
[[nodiscard]] std::vector<Vector3> find_flat_hull(const std::vector<Vector3>& points,
                                                  const Vector3& normal);

}  // namespace fulcrum
