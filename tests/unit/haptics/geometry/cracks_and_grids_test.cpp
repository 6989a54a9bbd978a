#include "haptics/geometry/crack.h"
#include "haptics/geometry/hash_grid.h"
#include "haptics/geometry/mesh_report.h"
#include "haptics/geometry/shape.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/mesh_corners.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <map>
#include <set>

using namespace fulcrum;

namespace {

const Box kUnit{Vector3(-1.0, -1.0, -1.0), Vector3(1.0, 1.0, 1.0)};

MeshReport build_and_report(std::vector<Vector3> vertices, std::vector<TriangleCorners> triangles,
                            const MeshBuildSettings& settings = {}) {
    const auto mesh = TriangleMesh::build(std::move(vertices), std::move(triangles), settings);
    REQUIRE(mesh);
    return compute_mesh_report(*mesh);
}

// All meshes in one, nothing joined.
struct Parts {
    std::vector<Vector3> vertices;
    std::vector<TriangleCorners> triangles;
    void add(const TriangleMesh& mesh, const Vector3& by, bool turned = false) {
        const auto first = static_cast<std::int32_t>(vertices.size());
        for (const Vector3& vertex : mesh.vertices_B()) {
            vertices.emplace_back(vertex + by);
        }
        for (const TriangleCorners& t : mesh.triangles()) {
            triangles.push_back(
                {first + t[0], first + (turned ? t[2] : t[1]), first + (turned ? t[1] : t[2])});
        }
    }
};

}  // namespace

TEST_CASE("hash grid: what was put into a cell is found there and nowhere else; keys differ") {
    HashGrid grid(kUnit, 0.01);
    Random random(4);
    std::map<std::uint64_t, std::int32_t> expected;
    while (expected.size() < 5000) {
        expected[HashGrid::to_key(grid.find_cell(random.in_cube()))] =
            static_cast<std::int32_t>(expected.size());
    }
    grid.reserve(expected.size());
    for (const auto& [key, value] : expected) {
        grid.insert(key, value);
    }
    for (const auto& [key, value] : expected) {
        REQUIRE(grid.find(key) == value);
    }
    int n_nothing = 0;
    for (int i = 0; i < 5000; ++i) {
        const std::uint64_t key = HashGrid::to_key(grid.find_cell(random.in_cube()));
        n_nothing += grid.find(key) == HashGrid::kNothing ? 1 : 0;
        REQUIRE((grid.find(key) == HashGrid::kNothing) == (expected.count(key) == 0));
    }
    CHECK(n_nothing > 4000);
    std::set<std::uint64_t> keys;
    for (const std::int32_t x : {0, 1, 2, 1 << 19}) {
        for (const std::int32_t y : {0, 1, 2, 1 << 19}) {
            for (const std::int32_t z : {0, 1, 2, 1 << 19}) {
                keys.insert(HashGrid::to_key({x, y, z}));
            }
        }
    }
    CHECK(keys.size() == 64);
}

// Cells whose widened box holds a point of the segment, by asking many points.
TEST_CASE(
    "hash grid: a way leads through the cells of all its points, in order, and ends when told") {
    const HashGrid grid(kUnit, 0.1);
    Random random(5);
    for (int i = 0; i < 2000; ++i) {
        Vector3 from = 1.5 * random.in_cube();
        Vector3 to = 1.5 * random.in_cube();
        if (i % 3 == 0) {  // parallel to a plane of the grid
            to[i % 9 / 3] = from[i % 9 / 3];
        }
        std::map<std::uint64_t, double> left;  // and when
        double t_last = 0.0;
        grid.for_each_along(from, to, [&](std::uint64_t key, double t_leave) {
            REQUIRE(left.count(key) == 0);
            REQUIRE(t_leave >= t_last);
            t_last = t_leave;
            left[key] = t_leave;
            return true;
        });
        for (int k = 0; k <= 300; ++k) {
            const double t = k / 300.0;
            const Vector3 p = from + t * (to - from);
            if (kUnit.contains(p)) {
                // The point's cell, or right at a border its neighbour, is left no earlier than the point is passed.
                const auto cell = left.find(HashGrid::to_key(grid.find_cell(p)));
                REQUIRE(cell != left.end());
                REQUIRE(cell->second >= t - 1e-12);
            }
        }
    }
    int n = 0;
    grid.for_each_along(Vector3(-1.0, 0.03, 0.02), Vector3(1.0, 0.01, 0.04),
                        [&](std::uint64_t, double) { return ++n < 3; });
    CHECK(n == 3);
    n = 0;
    const auto count = [&](std::uint64_t, double) { return ++n < 1000; };
    grid.for_each_along(Vector3(-3.0, 2.0, 0.0), Vector3(3.0, 2.0, 0.0), count);
    grid.for_each_along(Vector3(1.5, 1.5, 1.5), Vector3(1.5, 1.5, 1.5), count);
    CHECK(n == 0);
    grid.for_each_along(Vector3(0.5, 0.5, 0.5), Vector3(0.5, 0.5, 0.5), count);
    CHECK(n == 1);
}

TEST_CASE("hash grid: cells are no smaller than a million along the longest side") {
    const HashGrid grid(kUnit, 1.0e-12);
    CHECK(grid.cell_m() > 2.0 / HashGrid::kMaxCells);
    CHECK(grid.cell_m() < 2.1 / HashGrid::kMaxCells);
    const HashGrid coarse(kUnit, 0.1);
    CHECK(coarse.resolves(1.0));
    CHECK_FALSE(coarse.resolves(1.0e12));
    CHECK(coarse.memory_bytes() > 0);
}

TEST_CASE("crack: one of 1e-5 or 1e-4 m round a ball of 0.1 m is closed by default, and told") {
    const auto ball = make_bumpy_sphere(0.1, 12, 0.03, 5.0);
    for (const double crack_m : {1e-5, 1e-4}) {
        const auto cracked = make_cracked(*ball, crack_m, 41, 0.0);
        const MeshReport open = compute_mesh_report(*cracked);
        CHECK(open.open_edges > 50);
        CHECK(open.closed_cracks == 0);
        const MeshReport closed = build_and_report(cracked->vertices_B(), cracked->triangles());
        CHECK(closed.is_closed());
        CHECK(closed.inconsistent_edges == 0);
        CHECK(closed.closed_cracks == 1);
        CHECK(closed.n_triangles == open.n_triangles);
        CHECK(to_sentence(closed).find("1 crack, now closed") != std::string::npos);
    }
}

TEST_CASE("crack: one wider than asked for stays open, 0 closes none, and two are counted as two") {
    const auto ball = make_sphere(0.1, 12);
    const auto cracked = make_cracked(*ball, 1e-3, 41, 0.0);
    CHECK(build_and_report(cracked->vertices_B(), cracked->triangles()).open_edges > 50);
    const auto fine = make_cracked(*ball, 1e-4, 41, 0.0);
    CHECK(build_and_report(fine->vertices_B(), fine->triangles(), {.crack_relative = 0.0})
              .open_edges > 50);
    CHECK(
        build_and_report(fine->vertices_B(), fine->triangles(), {.weld_relative = 0.0}).open_edges >
        50);
    // Two cracked balls beside each other, one of them turned over.
    Parts parts;
    const auto ring = make_cracked(*make_sphere(0.1, 6), 2e-5, 3, 0.0);
    parts.add(*ring, Vector3::Zero());
    parts.add(*ring, Vector3(0.3, 0.0, 0.0), true);
    const MeshReport report = build_and_report(parts.vertices, parts.triangles);
    CHECK(report.closed_cracks == 2);
    CHECK(report.is_closed());
}

TEST_CASE("crack: the two faces of an open thin plate are never joined") {
    // 0.1 mm apart, well within the tolerance of 0.4 of a thousandth of the diagonal of 0.5 m.
    const auto sheet = make_plate(0.35, 0.35, 6);
    for (const double apart_m : {1e-4, 2e-5}) {
        Parts parts;
        parts.add(*sheet, Vector3::Zero());
        parts.add(*sheet, Vector3(0.0, apart_m, 0.0), true);
        const MeshReport report = build_and_report(parts.vertices, parts.triangles);
        CHECK(report.closed_cracks == 0);
        CHECK(report.open_edges == 48);
        CHECK(report.n_vertices == 2 * 49);
    }
}

TEST_CASE("crack: two sheets side by side become one, and so do two at a right angle") {
    const auto sheet = make_plate(0.2, 0.2, 4);
    Parts flat;
    flat.add(*sheet, Vector3::Zero());
    flat.add(*sheet, Vector3(0.2 + 5e-5, 2e-5, 1e-5));
    const MeshReport joined = build_and_report(flat.vertices, flat.triangles);
    CHECK(joined.closed_cracks == 1);
    CHECK(joined.open_edges == 24);
    CHECK(joined.n_vertices == 2 * 25 - 5);
    // The second one stands on the first one's rim.
    Parts corner;
    corner.add(*sheet, Vector3::Zero());
    const auto first = static_cast<std::int32_t>(corner.vertices.size());
    for (const Vector3& vertex : sheet->vertices_B()) {
        corner.vertices.emplace_back(0.1 + 3e-5, vertex.x() + 0.1, vertex.z() + 2e-5);
    }
    for (const TriangleCorners& t : sheet->triangles()) {
        corner.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
    const MeshReport bent = build_and_report(corner.vertices, corner.triangles);
    CHECK(bent.closed_cracks == 1);
    CHECK(bent.open_edges == 24);
}

TEST_CASE("crack: no triangle that the first weld kept collapses or turns over") {
    // A fan of slivers thinner than the tolerance, twice, side by side: all of it stays.
    Random random(12);
    Parts parts;
    const auto strip = make_plate(1.0, 1.0, 1);
    parts.add(*strip, Vector3::Zero());
    for (int i = 0; i < 200; ++i) {
        const auto first = static_cast<std::int32_t>(parts.vertices.size());
        const Vector3 at = random.in_cube();
        parts.vertices.emplace_back(at);
        for (int k = 0; k < 5; ++k) {
            parts.vertices.emplace_back(at + 2e-4 * random.in_cube());
        }
        parts.triangles.push_back({first, first + 1, first + 2});
        parts.triangles.push_back({first + 3, first + 4, first + 5});
    }
    const auto without = TriangleMesh::build(parts.vertices, parts.triangles,
                                             {.weld_relative = 1e-9, .crack_relative = 0.0});
    const auto with = TriangleMesh::build(parts.vertices, parts.triangles,
                                          {.weld_relative = 1e-9, .crack_relative = 4e-4});
    REQUIRE(without->triangles().size() == with->triangles().size());
    CHECK(with->counts().welded_vertices > 20);
    for (std::size_t i = 0; i < with->triangles().size(); ++i) {
        const auto normal = [i](const TriangleMesh& mesh) {
            return front_of(mesh, mesh.triangles()[i]).normalized();
        };
        REQUIRE(normal(*with).dot(normal(*without)) > 0.49);
    }
}

TEST_CASE("crack: a T-junction is told, a closed mesh is left as it is, a bad width is refused") {
    // Two triangles above a seam, one below it: the vertex between the two faces no vertex.
    const std::vector<Vector3> vertices{{0, 0, 0},     {0.5, 0, 0},   {1, 0, 0},   {0.5, 1, 0},
                                        {0, -1e-6, 0}, {1, -1e-6, 0}, {0.5, -1, 0}};
    const MeshReport report =
        build_and_report(vertices, {{0, 1, 3}, {1, 2, 3}, {4, 6, 5}}, {.weld_relative = 1e-9});
    CHECK(report.closed_cracks == 0);
    CHECK(report.open_edges == 7);
    const auto ball = make_sphere(1.0, 4);
    const ClosedCracks none = close_cracks(ball->vertices_B(), ball->triangles(), 0.5);
    CHECK(none.becomes.empty());
    CHECK(none.cracks == 0);
    CHECK(none.closed_edges == 0);
    const auto box = make_box(Vector3::Ones());
    CHECK_FALSE(TriangleMesh::build(box->vertices_B(), box->triangles(), {.crack_relative = 0.02}));
    CHECK_FALSE(TriangleMesh::build(box->vertices_B(), box->triangles(), {.crack_relative = -1.0}));
}
