#include "haptics/collision/enclosure.h"

#include "haptics/geometry/shape.h"
#include "tests/support/touchable.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace fulcrum {
namespace {

TEST_CASE("enclosure: in a ball's stuff is what is nearer to its middle than its facets") {
    const auto mesh = touchable(make_sphere(0.1, 24));
    std::mt19937 random(3);
    std::uniform_real_distribution<double> any(-0.13, 0.13);
    int n_inside = 0;
    for (int i = 0; i < 4000; ++i) {
        const Vector3 at_B(any(random), any(random), any(random));
        if (at_B.norm() < 0.098 || at_B.norm() > 0.1) {
            REQUIRE(is_in_stuff(*mesh, at_B) == (at_B.norm() < 0.099));
            n_inside += at_B.norm() < 0.099 ? 1 : 0;
        }
    }
    CHECK(n_inside > 500);
}

TEST_CASE("enclosure: exactly over corners, edges and the diagonals of a box") {
    const auto mesh = touchable(make_box(Vector3(2.0, 2.0, 2.0)));
    for (const double x : {-0.999, -0.5, 0.0, 0.5, 0.999}) {
        CHECK(is_in_stuff(*mesh, Vector3(x, x, x)));
        CHECK(is_in_stuff(*mesh, Vector3(x, 0.0, 0.0)));
        CHECK_FALSE(is_in_stuff(*mesh, Vector3(x, 1.001, 0.0)));
        CHECK_FALSE(is_in_stuff(*mesh, Vector3(x, x, -1.001)));
    }
}

TEST_CASE("enclosure: an inside-out mesh, a room, has its stuff outside; an open one has none") {
    const auto box = make_box(Vector3(2.0, 2.0, 2.0));
    REQUIRE(box);
    const auto room = touchable(make_inverted(*box));
    CHECK_FALSE(is_in_stuff(*room, Vector3(0.1, 0.2, 0.3)));
    CHECK_FALSE(is_in_stuff(*room, Vector3(1.5, 0.0, 0.0)));
    const auto plate = touchable(make_plate(1.0, 1.0, 4));
    for (const double y : {-0.1, -1e-6, 1e-6, 0.1}) {
        CHECK_FALSE(is_in_stuff(*plate, Vector3(0.1, y, 0.05)));
    }
}

TEST_CASE("enclosure: a box with a hole in one side still encloses, by two rays of three") {
    const auto box = make_box(Vector3(2.0, 2.0, 2.0));
    REQUIRE(box);
    std::vector<TriangleCorners> triangles = box->triangles();
    triangles.pop_back();
    const auto mesh = touchable(TriangleMesh::build(box->vertices_B(), triangles));
    CHECK(is_in_stuff(*mesh, Vector3(-0.1, -0.2, 0.05)));
    CHECK_FALSE(is_in_stuff(*mesh, Vector3(0.0, 1.5, 0.0)));
}

TEST_CASE("enclosure: a place that is no number, or at the end of the world, lies in nothing") {
    const auto mesh = touchable(make_box(Vector3(2.0, 2.0, 2.0)));
    CHECK_FALSE(is_in_stuff(*mesh, Vector3(std::nan(""), 0.0, 0.0)));
    CHECK_FALSE(is_in_stuff(*mesh, Vector3(1.0e300, 0.0, 0.0)));
    CHECK_FALSE(is_in_stuff(*mesh, Vector3::Constant(std::numeric_limits<double>::infinity())));
}

}  // namespace
}  // namespace fulcrum
