#include "haptics/levels/surface_measures.h"

#include "haptics/geometry/shape.h"
#include "haptics/levels/level_draft.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

using namespace fulcrum;

namespace {

constexpr int kSquares = 48;
constexpr double kSquare_m = 0.002;

// Waves along both sides, in squares of 2 mm; its front is up.
TriangleMesh make_bumpy_sheet(double height_m, double per_m) {
    std::vector<Vector3> vertices;
    std::vector<TriangleCorners> triangles;
    for (int i = 0; i <= kSquares; ++i) {
        for (int j = 0; j <= kSquares; ++j) {
            const double x = kSquare_m * i;
            const double z = kSquare_m * j;
            vertices.emplace_back(x, height_m * std::sin(per_m * x) * std::sin(per_m * z), z);
        }
    }
    for (int i = 0; i < kSquares; ++i) {
        for (int j = 0; j < kSquares; ++j) {
            const int a = i * (kSquares + 1) + j;
            triangles.push_back({a, a + 1, a + kSquares + 2});
            triangles.push_back({a, a + kSquares + 2, a + kSquares + 1});
        }
    }
    return TriangleMesh::build(std::move(vertices), std::move(triangles)).value();
}

// The hull of a square piece of the sheet.
LevelDraft hull_of_piece(const TriangleMesh& sheet, int i, int j, int n) {
    std::vector<Vector3> corners;
    for (int k = 0; k <= n; ++k) {
        for (int l = 0; l <= n; ++l) {
            corners.push_back(
                sheet.vertices_B()[static_cast<std::size_t>((i + k) * (kSquares + 1) + j + l)]);
        }
    }
    LevelDraft draft;
    draft.take_hull(corners);
    return draft;
}

// By samples a twentieth of a side apart.
double measure_densely_m(const LevelDraft& draft, const SurfaceDistance& surface) {
    constexpr int kParts = 20;
    double most_m = 0.0;
    for (const PieceTriangle& face : draft.faces) {
        for (int i = 0; i <= kParts; ++i) {
            for (int k = 0; i + k <= kParts; ++k) {
                const Vector3 point = face[0] + (static_cast<double>(i) * (face[1] - face[0]) +
                                                 static_cast<double>(k) * (face[2] - face[0])) /
                                                    static_cast<double>(kParts);
                most_m = std::max(most_m, surface.measure_height_m(point, 1.0e-3));
            }
        }
    }
    return most_m;
}

}  // namespace

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

TEST_CASE("surface measures: hulls stand out by no more than they do, and a fifth less at most") {
    const TriangleMesh sheet = make_bumpy_sheet(0.002, 300.0);
    const SurfaceDistance surface(sheet);
    double least_share = 1.0;
    for (const int n : {4, 8, 16}) {
        for (int i = 0; i + n <= kSquares; i += 7) {
            for (int j = 0; j + n <= kSquares; j += 9) {
                const LevelDraft draft = hull_of_piece(sheet, i, j, n);
                const double there_m = measure_densely_m(draft, surface);
                const double measured_m = draft.measure_bulge_m(
                    surface, kSquare_m, std::numeric_limits<double>::infinity());
                CAPTURE(n, i, j, there_m, measured_m);
                CHECK(measured_m <= there_m * 1.001 + 1.0e-6);
                least_share = std::min(least_share, measured_m / std::max(there_m, 1.0e-5));
            }
        }
    }
    CAPTURE(least_share);
    CHECK(least_share >= 0.8);
    CHECK(least_share < 0.999);
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
