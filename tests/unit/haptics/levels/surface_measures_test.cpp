#include "haptics/levels/surface_measures.h"

#include "haptics/geometry/shape.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace fulcrum;

TEST_CASE("surface measures: heights over a box are those to its sides, edges and corners") {
    const SurfaceDistance distance(make_box({2.0, 2.0, 2.0}).value());
    for (const double guess_m : {1.0e-6, 0.1, 100.0}) {
        CHECK(distance.measure_height_m({1.5, 0.2, 0.1}, guess_m) == Approx(0.5));
        CHECK(distance.measure_height_m({4.0, 5.0, 0.1}, guess_m) == Approx(5.0));
        CHECK(distance.measure_height_m({2.0, 2.0, 2.0}, guess_m) == Approx(std::sqrt(3.0)));
        CHECK(distance.measure_height_m({0.75, 0.2, 0.1}, guess_m) == Approx(-0.25));
        CHECK(std::abs(distance.measure_height_m({1.0, 0.2, 0.1}, guess_m)) < 1.0e-12);
    }
}

TEST_CASE(
    "surface measures: a plane touches the cap of a ball, and of a plate what is counted at most") {
    constexpr double kRadius_m = 0.1;
    constexpr double kWithin_m = 2.0e-3;
    const TriangleMesh ball = make_sphere(kRadius_m, 24).value();
    const LevelSurface surface(ball, make_convex_pieces(ball).value());
    SupportArea support(surface, kWithin_m);
    const double cap_m2 = 2.0 * std::numbers::pi * kRadius_m * kWithin_m;
    for (const std::int32_t corner : {0, 100, 1000}) {
        // Triangles across the border do not count.
        CHECK(support.measure_m2(corner) == Approx(cap_m2).epsilon(0.3));
    }
    const TriangleMesh plate = make_plate(1.0, 1.0, 40).value();
    const LevelSurface flat(plate, make_convex_pieces(plate).value());
    SupportArea of_plate(flat, kWithin_m);
    CHECK(of_plate.measure_m2(840) == Approx(SupportArea::kMostTriangles / 3200.0).epsilon(1.0e-6));
    // A box's corner: three sides, each seen askew, and nothing of what falls away.
    const TriangleMesh box = make_box({1.0, 1.0, 1.0}).value();
    const LevelSurface corner(box, make_convex_pieces(box).value());
    SupportArea of_box(corner, kWithin_m);
    CHECK(of_box.measure_m2(0) > 0.0);
    CHECK(of_box.measure_m2(0) < 3.0);
}
