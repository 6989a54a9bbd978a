#include "haptics/levels/level_surface.h"

#include "haptics/geometry/shape.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace fulcrum;

TEST_CASE("level surface: an edge that ends takes two triangles and one corner away") {
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
}

TEST_CASE(
    "level surface: an edge may not end where the surface would fold onto itself, or is open") {
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
