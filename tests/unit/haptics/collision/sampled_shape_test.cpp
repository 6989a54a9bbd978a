#include "haptics/collision/sampled_shape.h"

#include "haptics/collision/shape_gap.h"
#include "haptics/geometry/height_field.h"
#include "haptics/geometry/shape.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

namespace fulcrum {
namespace {

TEST_CASE("sampled shape: round shapes and boxes have the distance of their closed forms") {
    Random random(4);
    const auto agrees = [&](const auto& shape) {
        const auto sampled = SampledShape::make(shape);
        REQUIRE(sampled);
        CHECK_FALSE((*sampled)->is_mesh());
        for (int i = 0; i < 200; ++i) {
            const Vector3 p = 0.3 * random.in_cube();
            CHECK((*sampled)->at(p).gap_m == find_gap(shape, p).gap_m);
            CHECK((*sampled)->bound_m(p) == find_gap(shape, p).gap_m);
        }
        for (const SurfaceSample& sample : (*sampled)->samples().all()) {
            CHECK(std::abs((*sampled)->at(sample.place_B).gap_m) < 4.0e-3);
        }
    };
    agrees(SphereShape{0.1});
    agrees(BoxShape{{0.1, 0.2, 0.05}});
    agrees(CapsuleShape{0.05, 0.1});
    agrees(CapsuleShape{0.05, 0.0});
    agrees(CylinderShape{0.1, 0.05});
}

TEST_CASE(
    "sampled shape: a hull's is the height over its planes, exact inside and never more than the "
    "distance outside") {
    const BoxShape box{{0.1, 0.2, 0.05}};
    std::vector<Vector3> corners;
    for (int i = 0; i < 8; ++i) {
        corners.emplace_back((i & 1) != 0 ? 0.1 : -0.1, (i & 2) != 0 ? 0.2 : -0.2,
                             (i & 4) != 0 ? 0.05 : -0.05);
    }
    const auto hull = SampledShape::make(*make_hull_shape(corners));
    REQUIRE(hull);
    Random random(5);
    for (int i = 0; i < 500; ++i) {
        const Vector3 p = 0.3 * random.in_cube();
        const double exact_m = find_gap(box, p).gap_m;
        const Gap gap = (*hull)->at(p);
        CHECK(gap.gap_m <= exact_m + 1.0e-12);
        CHECK((gap.gap_m > 0.0) == (exact_m > 0.0));
        if (exact_m < 0.0) {
            CHECK(gap.gap_m == Approx(exact_m).margin(1.0e-12));
        }
    }
}

TEST_CASE(
    "sampled shape: a mesh's is the distance field's near it, and goes on as a depth within") {
    const auto ring = touchable(make_torus(0.1, 0.03, 96, 48));
    const auto sampled = SampledShape::make(SolidShape(ring));
    REQUIRE(sampled);
    CHECK((*sampled)->is_mesh());
    const auto exact = [](const Vector3& p) {
        return std::hypot(std::hypot(p.x(), p.z()) - 0.1, p.y()) - 0.03;
    };
    Random random(6);
    int n_near = 0;
    for (int i = 0; i < 4000; ++i) {
        const Vector3 p = 0.13 * random.in_cube();
        const Gap gap = (*sampled)->at(p);
        CHECK(gap.normal_B.norm() == Approx(1.0));
        if (std::abs(exact(p)) < 0.004) {
            CHECK(gap.gap_m == Approx(exact(p)).margin(2.0e-4));
            ++n_near;
        }
        // Deep within the depth goes on: nothing is 0 there, and the way out is away from the ring's middle line.
        if (exact(p) < -0.01) {
            CHECK(gap.gap_m < -0.006);
        }
        if (exact(p) < -0.006 && exact(p) > -0.009) {
            const Vector3 middle = 0.1 * Vector3(p.x(), 0.0, p.z()) / std::hypot(p.x(), p.z());
            CHECK(gap.normal_B.dot((p - middle).normalized()) > 0.8);
        }
        CHECK((*sampled)->bound_m(p) <= std::max(exact(p), 0.0) + 2.0e-4);
    }
    CHECK(n_near > 50);
}

TEST_CASE(
    "sampled shape: open meshes, height fields and settings out of range are refused in a "
    "sentence") {
    const auto told = [](const Expected<std::shared_ptr<const SampledShape>>& made) {
        return made ? std::string() : to_sentence(made.error());
    };
    CHECK(told(SampledShape::make(SolidShape(touchable(make_plate(1.0, 1.0, 2))))).find("open") !=
          std::string::npos);
    CHECK(told(SampledShape::make(SphereShape{}, {.n_cells = 100})).find("eights") !=
          std::string::npos);
    CHECK(told(SampledShape::make(SphereShape{}, {.n_cells = 1024})).find("512") !=
          std::string::npos);
    CHECK_FALSE(SampledShape::make(SphereShape{}, {.n_face_places = 1}));
    CHECK_FALSE(SampledShape::make(SphereShape{-1.0}));
    const auto ground = make_height_field_shape(HeightField{});
    REQUIRE(ground);
    CHECK(told(SampledShape::make(SolidShape(*ground))).find("height field") != std::string::npos);
}

}  // namespace
}  // namespace fulcrum
