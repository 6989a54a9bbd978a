#include "haptics/levels/piece_shape.h"

#include <catch2/catch.hpp>

#include <limits>

using namespace fulcrum;

namespace {

constexpr double kSlack_m = 1.0e-7;

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

TEST_CASE(
    "piece shape: a triangle's plane looks where its front does, and bounds nothing without area") {
    const PiecePlane plane = PiecePlane::of({{{0, 0, 2}, {1, 0, 2}, {0, 1, 2}}});
    CHECK((plane.normal - Vector3::UnitZ()).norm() < 1.0e-15);
    CHECK(plane.height_m({5, 5, 3}) == Approx(1.0));
    const PiecePlane none = PiecePlane::of({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}});
    CHECK(none.normal.norm() == 0.0);
    CHECK(none.height_m({5, 5, 3}) == 0.0);
}

TEST_CASE("piece shape: what is behind all planes may join, what is before one may not") {
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

TEST_CASE("flat hull: corners alone are kept, and in order") {
    const std::vector<Vector3> points{{0, 0, 0}, {0.5, 0, 0}, {1, 0, 0},     {1, 0, 1},
                                      {0, 0, 1}, {0, 0, 0.5}, {0.5, 0, 0.5}, {0.2, 0, 0.7}};
    const std::vector<Vector3> hull = find_flat_hull(points, Vector3::UnitY());
    REQUIRE(hull.size() == 4);
    Vector3 doubled = Vector3::Zero();
    for (std::size_t i = 2; i < hull.size(); ++i) {
        doubled += (hull[i - 1] - hull[0]).cross(hull[i] - hull[0]);
    }
    CHECK(doubled.y() == Approx(2.0));
}

TEST_CASE("flat hull: a polygon is filled, or it is not") {
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
