// What is told of a mesh near a cursor: leaf_triangles.h of eight triangles, near_leaves.h of the leaves in a box.
#include "haptics/collision/leaf_triangles.h"

#include "haptics/collision/near_leaves.h"
#include "haptics/collision/triangle_gap.h"
#include "haptics/geometry/shape.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

namespace fulcrum {
namespace {

constexpr int kPlaces = 33;  // on a way, where its distance is taken

double find_distance_m(const CollisionMesh& mesh, std::int32_t triangle, const Vector3& at) {
    return find_triangle_gap(prepare_for_gap(mesh, triangle), at).distance_m;
}

// The least distance between a triangle and the places of a way, which is that of the way or little more.
double least_distance(const CollisionMesh& mesh, std::int32_t triangle, const Vector3& from,
                      const Vector3& to) {
    const TriangleForGap prepared = prepare_for_gap(mesh, triangle);
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < kPlaces; ++k) {
        const Vector3 at = from + k / (kPlaces - 1.0) * (to - from);
        least = std::min(least, find_triangle_gap(prepared, at).distance_m);
    }
    return least;
}
struct Counts {
    int n_met = 0;
    int n_asked = 0;
    int n = 0;
};
// Every triangle that a ball meets on its way must be among those told.
Counts try_ways(const CollisionMesh& mesh, const Vector3& middle, double scale, unsigned seed) {
    Random random(seed);
    Counts counts;
    LeafTriangles leaf;
    const std::int32_t n_leaves = (mesh.n_triangles() + 7) / 8;
    for (std::int32_t index = 0; index < n_leaves; ++index) {
        leaf.load(mesh, index);
        for (int i = 0; i < 12; ++i) {
            const double distance = scale * std::exp(-4.0 + 3.0 * random.uniform());
            const Vector3 near = leaf.middle_B() + 2.0 * (leaf.radius_m() + distance) *
                                                       random.uniform() * random.direction();
            const Vector3 half = scale * std::exp(-5.0 + 3.0 * random.uniform()) *
                                 random.direction() * (i % 4 == 0 ? 0.0 : 1.0);
            const unsigned told = leaf.find_near(near, half, distance);
            for (int bit = 0; bit < 8 && 8 * index + bit < mesh.n_triangles(); ++bit) {
                const bool is_met =
                    least_distance(mesh, 8 * index + bit, near - half, near + half) <= distance;
                const bool is_told = (told >> static_cast<unsigned>(bit) & 1U) != 0;
                REQUIRE((is_told || !is_met));
                counts.n_met += is_met ? 1 : 0;
                counts.n_asked += is_told ? 1 : 0;
                ++counts.n;
            }
        }
    }
    CAPTURE(middle, scale);
    return counts;
}

TEST_CASE("leaf triangles: none that a ball meets on its way is left out, at any size and place") {
    for (const double scale : {1.0e-6, 1.0, 1.0e6}) {
        for (const double away : {0.0, 1.0e3}) {
            const auto body = make_bumpy_sphere(scale, 5, 0.1, 6.0);
            std::vector<Vector3> vertices(body->vertices_B().begin(), body->vertices_B().end());
            const Vector3 middle = away * scale * Vector3(1.0, -2.0, 0.5);
            for (Vector3& vertex : vertices) {
                vertex += middle;
            }
            const auto moved =
                TriangleMesh::build(vertices, {body->triangles().begin(), body->triangles().end()});
            const Counts counts = try_ways(*touchable(moved), middle, scale, 7);
            CHECK(counts.n_met > counts.n / 50);
            // Few are asked in vain.
            CHECK(counts.n_asked < counts.n_met + counts.n / 10);
        }
    }
}

TEST_CASE("leaf triangles: what is just touched is told, whatever single precision makes of it") {
    const auto mesh = touchable(make_bumpy_sphere(0.3, 8, 0.1, 6.0));
    Random random(31);
    LeafTriangles leaf;
    for (std::int32_t triangle = 0; triangle < mesh->n_triangles(); ++triangle) {
        leaf.load(*mesh, triangle / 8);
        const unsigned bit = 1U << static_cast<unsigned>(triangle % 8);
        const Vector3 a = mesh->places_B(triangle)[0];
        for (const double away : {0.01, 0.1, 1.0, 10.0}) {
            const Vector3 at = a + away * random.direction();
            const double distance = find_distance_m(*mesh, triangle, at);
            REQUIRE((leaf.find_near(at, Vector3::Zero(), distance * (1.0 + 1.0e-14)) & bit) != 0);
            // Met at the end of a way that leads towards it, or past it.
            const Vector3 half = 0.3 * away * random.direction();
            REQUIRE((leaf.find_near(at - half, half, distance * (1.0 + 1.0e-14)) & bit) != 0);
        }
    }
}

TEST_CASE("leaf triangles: slivers are asked, and of a fine surface only what a ball touches") {
    // Strips a thousandth as wide as long.
    std::vector<Vector3> vertices;
    std::vector<TriangleCorners> triangles;
    for (int i = 0; i < 9; ++i) {
        vertices.emplace_back(0.0, 1.0e-3 * i, 0.0);
        vertices.emplace_back(1.0, 1.0e-3 * i, 1.0e-4 * i * i);
    }
    for (int i = 0; i < 8; ++i) {
        triangles.push_back({2 * i, 2 * i + 1, 2 * i + 2});
        triangles.push_back({2 * i + 1, 2 * i + 3, 2 * i + 2});
    }
    const auto strips = touchable(TriangleMesh::build(vertices, triangles));
    CHECK(try_ways(*strips, Vector3::Zero(), 1.0, 9).n_met > 0);
    LeafTriangles leaf;
    leaf.load(*strips, 0);
    const double none = std::numeric_limits<double>::quiet_NaN();
    CHECK(leaf.find_near(Vector3::Constant(none), Vector3::Zero(), 0.1) == 0xFFU);
    const auto mesh = touchable(make_sphere(1.0, 40));
    constexpr double kRadius = 0.2;
    Random random(3);
    int n_asked = 0;
    constexpr int kPlacesOnIt = 50;
    leaf = LeafTriangles();
    for (int i = 0; i < kPlacesOnIt; ++i) {
        const Vector3 on = (1.0 + kRadius + 1.0e-4) * random.direction();
        for (std::int32_t index = 0; index < mesh->n_triangles() / 8; ++index) {
            leaf.load(*mesh, index);
            n_asked += std::popcount(leaf.find_near(on, Vector3::Zero(), kRadius));
        }
    }
    // A gap of 1e-4 leaves a cap of 4 mm in radius that is nearer than the flat middle of a face is below the sphere.
    CHECK(n_asked < 2 * kPlacesOnIt);
}

TEST_CASE("leaf triangles: a leaf that is not full tells of no others") {
    const auto mesh = touchable(make_box(Vector3::Ones()));
    REQUIRE(mesh->n_triangles() == 12);
    LeafTriangles leaf;
    leaf.load(*mesh, 1);
    CHECK(leaf.leaf() == 1);
    CHECK(leaf.find_near(Vector3::Zero(), Vector3::Zero(), 10.0) == 0x0FU);
    CHECK(leaf.find_near(Vector3(0.0, 3.0, 0.0), Vector3::Zero(), 0.1) == 0U);
}

constexpr double kBall = 0.1;

Box box_of(const Vector3& middle, double half) {
    return {middle - Vector3::Constant(half), middle + Vector3::Constant(half)};
}
std::set<std::int32_t> find_near_way(const NearLeaves& near, const Vector3& from,
                                     const Vector3& to) {
    std::set<std::int32_t> found;
    near.for_each_near_way(from, to, kBall, [&](std::int32_t triangle) { found.insert(triangle); });
    return found;
}

TEST_CASE("near leaves: as the cursor goes on they are those of the box, and few are loaded anew") {
    const auto mesh = touchable(make_bumpy_sphere(1.0, 20, 0.1, 6.0));
    NearLeaves near;
    CHECK_FALSE(near.covers(box_of(Vector3::UnitX(), 0.0)));
    Wanderer wanderer(2);
    std::uint64_t n_leaves = 0;
    constexpr int kSteps = 400;
    for (int i = 0; i < kSteps; ++i) {
        const Vector3 at = 1.1 * wanderer.next();
        const Box box = box_of(at, 0.15);
        REQUIRE(near.collect(*mesh, box));
        CHECK(near.covers(box));
        CHECK(near.covers(box_of(at, 0.14)));
        CHECK_FALSE(near.covers(box_of(at, 0.16)));
        NearLeaves fresh;
        REQUIRE(fresh.collect(*mesh, box));
        REQUIRE(std::equal(near.leaves().begin(), near.leaves().end(), fresh.leaves().begin(),
                           fresh.leaves().end()));
        const Vector3 to = at + 0.01 * wanderer.next();
        REQUIRE(find_near_way(near, at, to) == find_near_way(fresh, at, to));
        n_leaves += near.leaves().size();
    }
    CHECK(n_leaves > 10U * kSteps);
    CHECK(near.n_loads() < n_leaves / 5);
}

TEST_CASE("near leaves: every triangle that a ball meets on its way is told") {
    const auto mesh = touchable(make_bumpy_sphere(1.0, 16, 0.1, 6.0));
    Random random(8);
    NearLeaves near;
    int n_met = 0;
    for (int i = 0; i < 200; ++i) {
        const Vector3 from = (1.1 + 0.1 * random.uniform()) * random.direction();
        const Vector3 to = from + 0.05 * random.in_cube();
        REQUIRE(near.collect(*mesh, box_of(from, kBall + 0.06)));
        const std::set<std::int32_t> told = find_near_way(near, from, to);
        for (std::int32_t triangle = 0; triangle < mesh->n_triangles(); ++triangle) {
            if (find_distance_m(*mesh, triangle, from) <= kBall ||
                find_distance_m(*mesh, triangle, to) <= kBall) {
                REQUIRE(told.contains(triangle));
                ++n_met;
            }
        }
    }
    CHECK(n_met > 200);
}

TEST_CASE("near leaves: when they are too many none is covered, and the next box is as ever") {
    const auto mesh = touchable(make_sphere(1.0, 30));
    NearLeaves near;
    const Box small = box_of(Vector3::UnitX(), 0.1);
    REQUIRE(near.collect(*mesh, small));
    const std::size_t n = near.leaves().size();
    CHECK_FALSE(near.collect(*mesh, box_of(Vector3::Zero(), 2.0)));
    CHECK_FALSE(near.covers(small));
    REQUIRE(near.collect(*mesh, small));
    CHECK(near.leaves().size() == n);
    // Nothing had to be loaded again.
    CHECK(near.n_loads() == n);
    // A box beside the mesh has none, which is known.
    REQUIRE(near.collect(*mesh, box_of(Vector3(5.0, 0.0, 0.0), 0.1)));
    CHECK(near.leaves().empty());
    CHECK(find_near_way(near, Vector3(5.0, 0.0, 0.0), Vector3(5.0, 0.01, 0.0)).empty());
}

}  // namespace
}  // namespace fulcrum
