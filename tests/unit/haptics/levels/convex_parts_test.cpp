#include "haptics/geometry/shape.h"
#include "haptics/levels/convex_pieces.h"
#include "haptics/levels/piece_shape.h"
#include "tests/support/edited_meshes.h"
#include "tests/support/refused.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <limits>
#include <vector>

using namespace fulcrum;

namespace {

constexpr double kSlack_m = 1.0e-7;

// The triangles of each piece.
std::vector<PieceShape> collect_shapes(const TriangleMesh& mesh, const ConvexPieces& pieces) {
    std::vector<PieceShape> shapes(static_cast<std::size_t>(pieces.n_pieces));
    for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
        PieceTriangle places;
        for (std::size_t k = 0; k < 3; ++k) {
            places[k] = mesh.vertices_B()[static_cast<std::size_t>(mesh.triangles()[i][k])];
        }
        PieceShape& shape = shapes[static_cast<std::size_t>(pieces.piece_of[i])];
        shape.add_triangle(places);
        shape.corners.insert(shape.corners.end(), places.begin(), places.end());
    }
    return shapes;
}

// Every piece is what piece_shape.h says.
void check_all(const TriangleMesh& mesh, const ConvexPieces& pieces) {
    REQUIRE(pieces.piece_of.size() == mesh.triangles().size());
    const auto [least, most] = std::ranges::minmax(pieces.piece_of);
    REQUIRE(least == 0);
    REQUIRE(most == pieces.n_pieces - 1);
    const std::vector<PieceShape> shapes = collect_shapes(mesh, pieces);
    for (std::size_t piece = 0; piece < shapes.size(); ++piece) {
        const PieceShape& shape = shapes[piece];
        for (const PiecePlane& plane : shape.planes) {
            REQUIRE(shape.is_before(plane, pieces.slack_m));
        }
        if (shape.is_flat(pieces.slack_m)) {
            CHECK((shape.planes.size() == 1 || shape.fills_its_polygon()));
            continue;
        }
        CHECK(pieces.has_inside);
        const InnerHull inner(shape);
        for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
            const TriangleCorners& t = mesh.triangles()[i];
            const auto at = [&](std::size_t k) {
                return mesh.vertices_B()[static_cast<std::size_t>(t[k])];
            };
            if (static_cast<std::size_t>(pieces.piece_of[i]) != piece) {
                CHECK_FALSE(inner.is_entered_by({at(0), at(1), at(2)}));
            }
        }
    }
}

// Three sides of a unit cube's corner at (1, 1, 1), half a side each.
PieceShape make_corner() {
    PieceShape shape;
    const Vector3 top(1, 1, 1);
    const Vector3 x(0, 1, 1);
    const Vector3 y(1, 0, 1);
    const Vector3 z(1, 1, 0);
    shape.add_triangle({top, x, y});
    shape.add_triangle({top, y, z});
    shape.add_triangle({top, z, x});
    shape.corners = {top, x, y, z};
    return shape;
}

}  // namespace

TEST_CASE("convex pieces: convex is one, a few holes leave an inside, each time cut the same way") {
    for (const TriangleMesh& mesh :
         {make_box({0.1, 0.2, 0.3}).value(), make_sphere(0.1, 10).value(),
          make_cylinder(0.1, 0.3, 40).value(), make_plate(0.2, 0.1, 7).value()}) {
        const ConvexPieces pieces = make_convex_pieces(mesh).value();
        CHECK(pieces.n_pieces == 1);
        check_all(mesh, pieces);
    }
    const TriangleMesh holed = test::take_first(make_sphere(0.1, 8).value(), -1);
    const ConvexPieces pieces = make_convex_pieces(holed).value();
    CHECK(pieces.has_inside);
    CHECK(pieces.n_pieces == 1);
    check_all(holed, pieces);
    const TriangleMesh mesh = make_bumpy_sphere(0.1, 10, 0.2, 30.0).value();
    CHECK(make_convex_pieces(mesh).value().piece_of == make_convex_pieces(mesh).value().piece_of);
    const Expected<ConvexPieces> stopped = make_convex_pieces(
        make_bumpy_sphere(0.1, 80, 0.1, 200.0).value(), [](double) { return false; });
    CHECK(is_refused(stopped, "stopped"));
}

TEST_CASE("convex pieces: all that is convex, clear and filled, on shapes that are not convex") {
    for (const TriangleMesh& mesh :
         {make_torus(0.1, 0.03, 24, 12).value(), make_bumpy_sphere(0.1, 8, 0.2, 30.0).value(),
          make_boxes(std::vector<PlacedBox>{{{0, 0, 0}, {0.1, 0.1, 0.1}},
                                            {{0.08, 0.02, 0.01}, {0.1, 0.05, 0.04}}})
              .value()}) {
        const ConvexPieces pieces = make_convex_pieces(mesh).value();
        CHECK(pieces.has_inside);
        CHECK(pieces.n_pieces > 1);
        CHECK(pieces.n_pieces < static_cast<std::int32_t>(mesh.triangles().size()));
        check_all(mesh, pieces);
    }
}

TEST_CASE("convex pieces: a flat L is not filled by one polygon") {
    // Three squares of a corner.
    const TriangleMesh mesh =
        TriangleMesh::build({{0, 0, 0},
                             {1, 0, 0},
                             {2, 0, 0},
                             {0, 0, -1},
                             {1, 0, -1},
                             {2, 0, -1},
                             {0, 0, -2},
                             {1, 0, -2}},
                            {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {3, 4, 7}, {3, 7, 6}})
            .value();
    const ConvexPieces pieces = make_convex_pieces(mesh).value();
    CHECK_FALSE(pieces.has_inside);
    CHECK(pieces.n_pieces >= 2);
    check_all(mesh, pieces);
}

TEST_CASE("convex pieces: without an inside pieces are flat") {
    const TriangleMesh ball = make_sphere(0.1, 6).value();
    const TriangleMesh cracked = test::take_first(ball, std::ssize(ball.triangles()) / 2);
    const ConvexPieces of_open = make_convex_pieces(cracked).value();
    CHECK_FALSE(of_open.has_inside);
    CHECK(of_open.n_pieces == static_cast<std::int32_t>(cracked.triangles().size()));
    check_all(cracked, of_open);
    std::vector<TriangleCorners> flipped = ball.triangles();
    std::swap(flipped[3][0], flipped[3][1]);
    const TriangleMesh mixed = TriangleMesh::build(ball.vertices_B(), flipped).value();
    CHECK_FALSE(make_convex_pieces(mixed).value().has_inside);
    CHECK_FALSE(make_convex_pieces(make_inverted(ball).value()).value().has_inside);
    const TriangleMesh one =
        TriangleMesh::build({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}).value();
    CHECK(make_convex_pieces(one).value().n_pieces == 1);
}

TEST_CASE(
    "piece shape: a plane looks where its triangle's front does; what is behind all may join") {
    const PiecePlane plane = PiecePlane::of({{{0, 0, 2}, {1, 0, 2}, {0, 1, 2}}});
    CHECK((plane.normal - Vector3::UnitZ()).norm() < 1.0e-15);
    CHECK(plane.height_m({5, 5, 3}) == Approx(1.0));
    const PiecePlane none = PiecePlane::of({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}});
    CHECK(none.normal.norm() == 0.0);
    CHECK(none.height_m({5, 5, 3}) == 0.0);
    const PieceShape shape = make_corner();
    CHECK(shape.is_behind({0.5, 0.5, 0.5}, kSlack_m));
    CHECK_FALSE(shape.is_behind({0.5, 0.5, 1.1}, kSlack_m));
    CHECK_FALSE(shape.is_behind({1.1, 0.5, 0.5}, kSlack_m));
    CHECK(shape.is_before({.normal = Vector3::UnitZ(), .offset_m = 1.0}, kSlack_m));
    CHECK_FALSE(shape.is_before({.normal = Vector3::UnitZ(), .offset_m = 0.5}, kSlack_m));
    CHECK_FALSE(shape.is_flat(kSlack_m));
    CHECK(shape.area_m2 == Approx(1.5));
}

TEST_CASE("piece shape: what touches a hull does not enter it, what goes into it does") {
    const PieceShape shape = make_corner();
    const InnerHull inner(shape);
    const Vector3 x(0, 1, 1);
    const Vector3 y(1, 0, 1);
    const Vector3 z(1, 1, 0);
    // The virtual face itself, one on the other side of it, and one that shares an edge and turns away.
    CHECK_FALSE(inner.is_entered_by({x, y, z}));
    CHECK_FALSE(inner.is_entered_by({x, y, Vector3(0, 0, 0)}));
    CHECK_FALSE(inner.is_entered_by({x, y, Vector3(0.5, 0.5, 2.0)}));
    CHECK_FALSE(inner.is_entered_by({Vector3(5, 5, 5), Vector3(6, 5, 5), Vector3(5, 6, 5)}));
    // From below to the middle, and through and through.
    CHECK(inner.is_entered_by({x, y, Vector3(0.9, 0.9, 0.8)}));
    CHECK(inner.is_entered_by({Vector3(0, 0, 0), Vector3(2, 2, 1.9), Vector3(2, 1.9, 2)}));
}

TEST_CASE("flat hull: corners alone, in order; a polygon is filled, or it is not") {
    const std::vector<Vector3> points{{0, 0, 0}, {0.5, 0, 0}, {1, 0, 0},     {1, 0, 1},
                                      {0, 0, 1}, {0, 0, 0.5}, {0.5, 0, 0.5}, {0.2, 0, 0.7}};
    const std::vector<Vector3> hull = find_flat_hull(points, Vector3::UnitY());
    REQUIRE(hull.size() == 4);
    Vector3 doubled = Vector3::Zero();
    for (std::size_t i = 2; i < hull.size(); ++i) {
        doubled += (hull[i - 1] - hull[0]).cross(hull[i] - hull[0]);
    }
    CHECK(doubled.y() == Approx(2.0));
    PieceShape square;
    square.add_triangle({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}});
    square.corners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
    CHECK(square.fills_its_polygon());
    square.add_triangle({{{0, 0, 0}, {1, 1, 0}, {0, 1, 0}}});
    square.corners.emplace_back(0, 1, 0);
    CHECK(square.is_flat(kSlack_m));
    CHECK(square.fills_its_polygon());
    square.add_triangle({{{1, 0, 0}, {2, 0, 0}, {1, 1, 0}}});
    square.corners.emplace_back(2, 0, 0);
    CHECK(square.fills_its_polygon());
    square.add_triangle({{{2, 0, 0}, {3, 0, 0}, {2, 1, 0}}});
    square.corners.emplace_back(3, 0, 0);
    square.corners.emplace_back(2, 1, 0);
    CHECK_FALSE(square.fills_its_polygon());
}
