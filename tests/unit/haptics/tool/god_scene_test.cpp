#include "tests/support/god_scene.h"

#include "haptics/math/rotation.h"

#include <catch2/catch.hpp>

using namespace fulcrum;

TEST_CASE("god-object tool: what watches it in tests sees a tool that something encloses") {
    const TriangleMesh large = make_box({0.2, 0.2, 0.2}).value();
    const TriangleMesh small = make_sphere(0.02, 12).value();
    const Pose turned{Vector3(0.02, 0.01, -0.03), compute_exp(Vector3(0.3, 0.2, 0.1))};
    CHECK_FALSE(test::do_cross(large, {}, small, turned));
    CHECK(test::do_enter(large, {}, small, turned));
    CHECK(test::do_enter(small, turned, large, {}));
    CHECK_FALSE(test::do_enter(large, {}, small, Pose::at({0.0, 0.121, 0.0})));
    CHECK(test::do_enter(large, {}, small, Pose::at({0.0, 0.119, 0.0})));
    // In a hole it is in nothing; nor is it before a floor that is open.
    const TriangleMesh block = test::make_block_with_hole(8, 0.03, 0.06, 0.05);
    CHECK_FALSE(test::do_enter(block, {}, small, {}));
    CHECK(test::find_winding(block, Vector3::Zero()) == Approx(0.0).margin(1e-9));
    CHECK(test::find_winding(block, Vector3(0.045, 0.0, 0.0)) == Approx(1.0));
    const TriangleMesh floor = TriangleMesh::build({{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}},
                                                   {{0, 2, 1}, {0, 3, 2}})
                                   .value();
    CHECK_FALSE(test::do_enter(floor, {}, small, Pose::at({0.0, -0.0201, 0.0})));
}
