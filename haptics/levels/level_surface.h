// A closed surface of triangles in pieces that becomes simpler: edges end in a point, pieces become one.
//
// Who has which triangle is known from corner to triangles and from piece to triangles; pieces that became one are found by the one they became.
// An edge may end where the two ends have exactly two neighbours in common, those across the two triangles that go: then the surface stays one
// (the link condition). Corners of open edges, or of edges with three triangles or two windings, stay where they are.
//
// Thread: load. Cost: what is around the edge.
// Source: T. Dey, H. Edelsbrunner, S. Guha, D. Nekhayev 1999, Topology preserving edge contraction (link condition).
#pragma once

#include "haptics/geometry/step_box.h"
#include "haptics/levels/convex_pieces.h"

#include <cstdint>
#include <span>
#include <vector>

namespace fulcrum {

class LevelSurface {
  public:
    LevelSurface(const TriangleMesh& mesh, const ConvexPieces& pieces);

    [[nodiscard]] std::int32_t n_corners() const noexcept {
        return static_cast<std::int32_t>(places_.size());
    }
    [[nodiscard]] std::int32_t n_pieces() const noexcept { return n_pieces_; }
    [[nodiscard]] const Vector3& place(std::int32_t corner) const noexcept {
        return places_[static_cast<std::size_t>(corner)];
    }
    /// Those that have the corner; none of one that is gone.
    [[nodiscard]] std::span<const std::int32_t> triangles_at(std::int32_t corner) const noexcept {
        return at_corner_[static_cast<std::size_t>(corner)];
    }
    [[nodiscard]] const TriangleCorners& corners(std::int32_t triangle) const noexcept {
        return triangles_[static_cast<std::size_t>(triangle)];
    }
    [[nodiscard]] PieceTriangle places(std::int32_t triangle) const noexcept;
    /// The piece that has the triangle now.
    [[nodiscard]] std::int32_t piece_of(std::int32_t triangle) noexcept {
        return find_piece(first_piece_[static_cast<std::size_t>(triangle)]);
    }
    /// What a piece became.
    [[nodiscard]] std::int32_t find_piece(std::int32_t piece) noexcept;
    /// Of a piece that still is one.
    [[nodiscard]] std::span<const std::int32_t> triangles_of(std::int32_t piece);
    /// Pieces that still are, ascending.
    [[nodiscard]] std::vector<std::int32_t> collect_pieces();

    /// Writes the corners that share an edge with this one.
    void find_ring(std::int32_t corner, std::vector<std::int32_t>& ring) const;
    /// Ends the edge only where the surface stays one.
    [[nodiscard]] bool may_end(std::int32_t kept, std::int32_t gone) const;
    /// Both ends become one corner at `place`; a piece that has no triangle left becomes one with a neighbour.
    void end_edge(std::int32_t kept, std::int32_t gone, const Vector3& place);
    void join_pieces(std::int32_t kept, std::int32_t gone);

    /// As it is now.
    [[nodiscard]] Expected<TriangleMesh> to_mesh() const;
    /// Fills in a piece's corners and planes.
    void describe(std::int32_t piece, PieceShape& shape);
    /// Does any triangle outside the pieces `one` and `other` go into the hull deeper than `slack_m`?
    [[nodiscard]] bool is_entered(const PieceShape& shape, std::int32_t one, std::int32_t other,
                                  double slack_m);

  private:
    void fix_corners(const TriangleMesh& mesh);
    void measure_box(std::int32_t piece);
    void drop_joined();
    void drop_triangle(std::int32_t triangle);

    std::vector<Vector3> places_;
    std::vector<TriangleCorners> triangles_;
    std::vector<bool> is_there_;  // a triangle
    std::vector<bool> is_fixed_;  // a corner
    std::vector<std::vector<std::int32_t>> at_corner_;
    std::vector<std::int32_t> first_piece_;  // of a triangle, as it was cut
    std::vector<std::int32_t> became_;       // of a piece
    std::vector<std::vector<std::int32_t>> triangles_of_;
    std::vector<Box> box_of_;
    std::vector<std::int32_t> pieces_;  // that still are, and some that are no more
    std::vector<std::int32_t> seen_;    // a corner's stamp
    std::int32_t stamp_ = 0;
    std::int32_t n_pieces_ = 0;
};

}  // namespace fulcrum
