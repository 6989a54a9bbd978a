#include "haptics/geometry/shape.h"
#include "haptics/levels/filtered_collapse.h"
#include "haptics/levels/level_draft.h"
#include "haptics/levels/level_surface.h"
#include "haptics/levels/surface_measures.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/edited_meshes.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

using namespace fulcrum;

namespace {

struct Simplified {
    explicit Simplified(const TriangleMesh& mesh)
        : pieces(make_convex_pieces(mesh).value()),
          surface(mesh, pieces),
          collapse(surface, pieces.slack_m),
          pulse(nobody) {}
    ConvexPieces pieces;
    LevelSurface surface;
    FilteredCollapse collapse;
    LoadProgress nobody;
    LoadPulse pulse;
};

// Each piece lies on the hull round it.
void check_convex(LevelSurface& surface, double slack_m) {
    PieceShape shape;
    for (const std::int32_t piece : surface.collect_pieces()) {
        surface.describe(piece, shape);
        REQUIRE_FALSE(shape.planes.empty());
        for (const PiecePlane& plane : shape.planes) {
            CHECK(shape.is_before(plane, slack_m));
        }
    }
}

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

TEST_CASE("level surface: an edge that ends takes two triangles and a corner, if nothing folds") {
    const TriangleMesh mesh = make_sphere(0.1, 4).value();
    LevelSurface surface(mesh, make_convex_pieces(mesh).value());
    const std::int32_t kept = 20;
    std::vector<std::int32_t> ring;
    surface.find_ring(kept, ring);
    const std::int32_t gone = ring.front();
    REQUIRE(surface.may_end(kept, gone));
    const Vector3 middle = 0.5 * (surface.place(kept) + surface.place(gone));
    surface.end_edge(kept, gone, middle);
    CHECK(surface.triangles_at(gone).empty());
    CHECK(surface.place(kept) == middle);
    const TriangleMesh after = surface.to_mesh().value();
    CHECK(after.triangles().size() == mesh.triangles().size() - 2);
    CHECK(compute_mesh_report(after).is_closed());
    CHECK(surface.triangles_of(0).size() == after.triangles().size());
    // A tetrahedron has nothing that may go.
    const TriangleMesh four = TriangleMesh::build({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                                  {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}})
                                  .value();
    LevelSurface least(four, make_convex_pieces(four).value());
    for (std::int32_t i = 0; i < 4; ++i) {
        for (std::int32_t k = 0; k < i; ++k) {
            CHECK_FALSE(least.may_end(i, k));
        }
    }
    const TriangleMesh plate = make_plate(1.0, 1.0, 2).value();
    LevelSurface open(plate, make_convex_pieces(plate).value());
    for (const TriangleCorners& t : plate.triangles()) {
        CHECK_FALSE(open.may_end(t[0], t[1]));  // one of them at least is on the border
    }
}

TEST_CASE("level surface: pieces that become one are found as one") {
    const TriangleMesh mesh = make_torus(0.1, 0.03, 16, 8).value();
    LevelSurface surface(mesh, make_convex_pieces(mesh).value());
    const std::int32_t n = surface.n_pieces();
    REQUIRE(n > 3);
    const std::size_t n_triangles = surface.triangles_of(0).size() +
                                    surface.triangles_of(1).size() + surface.triangles_of(2).size();
    const std::int32_t of_two = surface.triangles_of(2).front();
    surface.join_pieces(1, 2);
    surface.join_pieces(0, 1);
    surface.join_pieces(0, 0);
    CHECK(surface.n_pieces() == n - 2);
    CHECK(surface.find_piece(2) == 0);
    CHECK(surface.piece_of(of_two) == 0);
    CHECK(surface.triangles_of(0).size() == n_triangles);
    const std::vector<std::int32_t> left = surface.collect_pieces();
    CHECK(static_cast<std::int32_t>(left.size()) == n - 2);
    CHECK(std::ranges::is_sorted(left));
}

TEST_CASE("filtered collapse: down to a quarter the surface stays closed and of convex pieces") {
    for (const TriangleMesh& mesh :
         {make_bumpy_sphere(0.1, 12, 0.03, 60.0).value(), make_torus(0.1, 0.03, 40, 20).value()}) {
        Simplified one(mesh);
        double longest_m = 0.0;
        for (int i = 0; i < 2; ++i) {
            const std::int32_t before = one.surface.n_pieces();
            REQUIRE(one.collapse.go_on_to(before / 2, one.pulse));
            CHECK(one.surface.n_pieces() <= before / 2);
            // Coarser and coarser.
            CHECK(one.collapse.longest_m() >= longest_m);
            longest_m = one.collapse.longest_m();
            check_convex(one.surface, one.collapse.slack_m() + 1.0e-12);
            const TriangleMesh simpler = one.surface.to_mesh().value();
            const MeshReport report = compute_mesh_report(simpler);
            CHECK(report.is_closed());
            CHECK(report.inconsistent_edges == 0);
            CHECK_FALSE(report.inside_out);
        }
        CHECK(one.collapse.n_ended() > 100);
    }
}

TEST_CASE(
    "filtered collapse: bumps that are finer than its edges are smoothed away, the ball stays") {
    const TriangleMesh mesh = make_bumpy_sphere(0.1, 24, 0.01, 150.0).value();
    Simplified one(mesh);
    one.collapse.go_on_to(one.surface.n_pieces() / 16, one.pulse);
    const TriangleMesh simpler = one.surface.to_mesh().value();
    CHECK(simpler.triangles().size() < mesh.triangles().size() / 3);
    for (const TriangleCorners& triangle : simpler.triangles()) {
        for (const std::int32_t corner : triangle) {
            CHECK(std::abs(simpler.vertices_B()[static_cast<std::size_t>(corner)].norm() - 0.1) <
                  2.0e-3);
        }
    }
    CHECK(compute_mesh_report(simpler).volume_m3 ==
          Approx(compute_mesh_report(mesh).volume_m3).epsilon(0.03));
}

TEST_CASE("filtered collapse: corners of open edges stay, and one that is told to stop does") {
    const TriangleMesh mesh = test::take_first(make_bumpy_sphere(0.1, 12, 0.03, 60.0).value(), -1);
    const std::int64_t n_open = compute_mesh_report(mesh).open_edges;
    REQUIRE(n_open == 3);
    Simplified one(mesh);
    REQUIRE(one.collapse.go_on_to(one.surface.n_pieces() / 4, one.pulse));
    CHECK(compute_mesh_report(one.surface.to_mesh().value()).open_edges == n_open);
    const LoadProgress stop = [](double) { return false; };
    LoadPulse stopped(stop);
    CHECK_FALSE(stopped.goes_on_now(0.0));
    CHECK_FALSE(one.collapse.go_on_to(1, stopped));
}

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
                const double measured_m = draft.measure_bulge_m(surface, kSquare_m, kInfinity);
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
