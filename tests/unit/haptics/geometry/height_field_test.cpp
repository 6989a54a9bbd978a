#include "haptics/geometry/height_field.h"

#include "tests/support/bad_numbers.h"
#include "tests/support/mesh_corners.h"

#include <catch2/catch.hpp>

namespace fulcrum {
namespace {

TEST_CASE("height field: its corners are the grid's points, rows along z, and its front looks up") {
    const auto mesh = make_height_field(
        {.width_m = 2.0, .depth_m = 4.0, .n_x = 3, .n_z = 2, .heights_m = {1, 2, 3, 4, 5, 6}});
    REQUIRE(mesh);
    REQUIRE(mesh->vertices_B().size() == 6);
    CHECK(mesh->vertices_B()[0] == Vector3(-1.0, 1.0, -2.0));
    CHECK(mesh->vertices_B()[1] == Vector3(0.0, 2.0, -2.0));
    CHECK(mesh->vertices_B()[5] == Vector3(1.0, 6.0, 2.0));
    REQUIRE(mesh->triangles().size() == 4);
    for (const TriangleCorners& t : mesh->triangles()) {
        CHECK(front_of(*mesh, t).y() > 0.0);
    }
}

TEST_CASE("height field: sizes and counts out of range are refused") {
    CHECK(make_height_field({}));
    CHECK_FALSE(make_height_field({.width_m = 0.0}));
    CHECK_FALSE(make_height_field({.depth_m = -1.0}));
    CHECK_FALSE(make_height_field({.n_x = 1, .heights_m = {0.0, 0.0}}));
    CHECK_FALSE(make_height_field({.n_x = 3}));
    CHECK_FALSE(make_height_field({.heights_m = {0.0, 0.0, 0.0, kNan}}));
}

}  // namespace
}  // namespace fulcrum
