#include "haptics/collision/h_collide.h"

#include "haptics/geometry/shape.h"
#include "tests/support/random_segments.h"
#include "tests/support/touchable.h"

#include <catch2/catch.hpp>

namespace fulcrum {
namespace {

std::shared_ptr<const HCollide> make(const std::shared_ptr<const CollisionMesh>& mesh,
                                     const HCollideSettings& settings) {
    auto made = HCollide::create(mesh, settings);
    REQUIRE(made);
    return *made;
}

TEST_CASE(
    "h-collide: whatever the cells and leaves, and whatever it remembers, hits are the same") {
    const auto mesh = touchable(make_bumpy_sphere(1.0, 8, 0.05, 9.0));
    for (const double triangles_a_cell : {1.0, 20.0, 1000.0, 1.0e6}) {
        for (const int triangles_a_leaf : {1, 7, 1000}) {
            const auto grid = make(mesh, {triangles_a_cell, triangles_a_leaf});
            RandomSegments segments(*mesh, 5);
            HCollide::Memory kept;
            for (int i = 0; i < 400; ++i) {
                const auto [from, to] = i % 2 == 0
                                            ? segments.draw()
                                            : segments.draw_hard(i / 2 % RandomSegments::kKinds);
                const SegmentHit expected = find_nearest_hit_brute_force(*mesh, from, to);
                HCollide::Memory fresh;
                for (HCollide::Memory* const memory : {&kept, &fresh}) {
                    const SegmentHit hit = grid->find_nearest_hit(from, to, *memory);
                    REQUIRE(hit.triangle == expected.triangle);
                    REQUIRE(hit.t == expected.t);
                }
            }
        }
    }
}

TEST_CASE("h-collide: it remembers the triangle that was met and the cell where it ended") {
    const auto mesh = touchable(make_box(Vector3::Ones()));
    const auto grid = make(mesh, {});
    HCollide::Memory memory;
    const SegmentHit hit =
        grid->find_nearest_hit(Vector3(0.1, 2.0, 0.2), Vector3(0.1, 0.0, 0.2), memory);
    CHECK(hit.found());
    CHECK(memory.triangle == hit.triangle);
    CHECK(memory.has_cell);
    // A miss forgets nothing: the next question will be near.
    (void)grid->find_nearest_hit(Vector3(0.1, 2.0, 0.2), Vector3(0.1, 1.0, 0.2), memory);
    CHECK(memory.triangle == hit.triangle);
}

TEST_CASE(
    "h-collide: cells hold about as many triangles as they are asked to, and no empty one is "
    "kept") {
    const auto mesh = touchable(make_sphere(1.0, 30));  // 18000 triangles
    const auto fine = make(mesh, {.triangles_a_cell = 4.0});
    const auto coarse = make(mesh, {.triangles_a_cell = 64.0});
    // A sheet passes through some twice the cells that its area alone would fill.
    CHECK(fine->n_cells() > 18000 / 4);
    CHECK(fine->n_cells() < 3 * 18000 / 4);
    CHECK(coarse->n_cells() > 18000 / 64);
    CHECK(coarse->n_cells() < 3 * 18000 / 64);
    CHECK(coarse->cell_m() == Approx(4.0 * fine->cell_m()));
    CHECK(fine->memory_bytes() > coarse->memory_bytes());
}

TEST_CASE("h-collide: long triangles among small ones do not fill the memory") {
    // Blades across the whole room, and a ball of small triangles that asks for small cells.
    const auto ball = make_sphere(0.01, 12);
    std::vector<Vector3> vertices = ball->vertices_B();
    std::vector<TriangleCorners> triangles = ball->triangles();
    Random random(3);
    for (int i = 0; i < 300; ++i) {
        const auto first = static_cast<std::int32_t>(vertices.size());
        const Vector3 end = random.direction();
        vertices.emplace_back(end);
        vertices.emplace_back(-end);
        vertices.emplace_back(end + 1.0e-4 * random.direction());
        triangles.push_back({first, first + 1, first + 2});
    }
    const auto mesh = touchable(TriangleMesh::build(vertices, triangles));
    const auto grid = make(mesh, {});
    CHECK(grid->memory_bytes() < 2000U * static_cast<unsigned>(mesh->n_triangles()));
    RandomSegments segments(*mesh, 7);
    HCollide::Memory memory;
    for (int i = 0; i < 600; ++i) {
        const auto [from, to] = segments.draw_hard(i % RandomSegments::kKinds);
        REQUIRE(grid->find_nearest_hit(from, to, memory).triangle ==
                find_nearest_hit_brute_force(*mesh, from, to).triangle);
    }
}

TEST_CASE("h-collide: meshes from the smallest to the largest size that a mesh may have") {
    for (const double scale : {1e-15, 1e-4, 1e4, 1e15}) {
        const auto mesh = touchable(make_bumpy_sphere(scale, 4, 0.05, 9.0));
        const auto grid = make(mesh, {});
        RandomSegments segments(*mesh, 9);
        HCollide::Memory memory;
        for (int i = 0; i < 2000; ++i) {
            const auto [from, to] = segments.draw();
            REQUIRE(grid->find_nearest_hit(from, to, memory).triangle ==
                    find_nearest_hit_brute_force(*mesh, from, to).triangle);
        }
    }
}

}  // namespace
}  // namespace fulcrum
