#include "haptics/levels/filtered_collapse.h"

#include "haptics/geometry/shape.h"
#include "tests/support/edited_meshes.h"

#include <catch2/catch.hpp>

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

}  // namespace

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
