#include "haptics/collision/leaf_triangles.h"

#include "haptics/collision/triangle_gap.h"
#include "haptics/geometry/shape.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

namespace fulcrum {
namespace {

constexpr int kPlaces = 33;  // on a way, where its distance is taken

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
        const auto [a, b, c] = mesh->places_B(triangle);
        for (const double away : {0.01, 0.1, 1.0, 10.0}) {
            const Vector3 at = a + away * random.direction();
            const double distance =
                find_triangle_gap(prepare_for_gap(*mesh, triangle), at).distance_m;
            REQUIRE((leaf.find_near(at, Vector3::Zero(), distance * (1.0 + 1.0e-14)) & bit) != 0);
            // Met at the end of a way that leads towards it, or past it.
            const Vector3 half = 0.3 * away * random.direction();
            REQUIRE((leaf.find_near(at - half, half, distance * (1.0 + 1.0e-14)) & bit) != 0);
        }
        const Vector3 up = random.direction();
        const double top = std::max({up.dot(a), up.dot(b), up.dot(c)});
        REQUIRE((leaf.find_above(up, top - 1.0e-15) & bit) != 0);
        const Vector3 lower = a.cwiseMin(b).cwiseMin(c);
        const Vector3 upper = a.cwiseMax(b).cwiseMax(c);
        REQUIRE((leaf.find_in_box({upper, upper + Vector3::Ones()}) & bit) != 0);
        REQUIRE((leaf.find_in_box({lower - Vector3::Ones(), lower}) & bit) != 0);
    }
}

TEST_CASE("leaf triangles: slivers and triangles of one point are asked rather than left out") {
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
}

TEST_CASE("leaf triangles: of a fine surface a ball that lies on it asks about what it touches") {
    const auto mesh = touchable(make_sphere(1.0, 40));
    constexpr double kRadius = 0.2;
    Random random(3);
    int n_asked = 0;
    constexpr int kPlacesOnIt = 50;
    LeafTriangles leaf;
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

TEST_CASE("leaf triangles: those in a box, and those above a plane, are all told and few others") {
    for (const double scale : {1.0e-6, 1.0, 1.0e6}) {
        const auto mesh = touchable(make_bumpy_sphere(scale, 8, 0.1, 6.0));
        Random random(12);
        LeafTriangles leaf;
        int n_wrong = 0;
        int n_in_box = 0;
        int n_above = 0;
        for (std::int32_t index = 0; index < mesh->n_triangles() / 8; ++index) {
            leaf.load(*mesh, index);
            const Vector3 middle = leaf.middle_B() + leaf.radius_m() * random.in_cube();
            const Vector3 half = 0.5 * leaf.radius_m() * random.in_cube().cwiseAbs();
            const Box box{middle - half, middle + half};
            const Vector3 up = random.direction();
            const double height = up.dot(middle);
            const unsigned in_box = leaf.find_in_box(box);
            const unsigned above = leaf.find_above(up, height);
            for (unsigned bit = 0; bit < 8; ++bit) {
                const auto [a, b, c] = mesh->places_B(8 * index + static_cast<std::int32_t>(bit));
                const Box own{a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
                const bool is_in_box = own.overlaps(box);
                const bool is_above = std::max({up.dot(a), up.dot(b), up.dot(c)}) > height;
                REQUIRE(((in_box >> bit & 1U) != 0 || !is_in_box));
                REQUIRE(((above >> bit & 1U) != 0 || !is_above));
                n_wrong += (in_box >> bit & 1U) != (is_in_box ? 1U : 0U) ? 1 : 0;
                n_wrong += (above >> bit & 1U) != (is_above ? 1U : 0U) ? 1 : 0;
                n_in_box += is_in_box ? 1 : 0;
                n_above += is_above ? 1 : 0;
            }
        }
        CHECK(n_wrong < 4);
        CHECK(n_in_box > 50);
        CHECK(n_above > 100);
    }
}

TEST_CASE("leaf triangles: a leaf that is not full tells of no others") {
    const auto mesh = touchable(make_box(Vector3::Ones()));
    REQUIRE(mesh->n_triangles() == 12);
    LeafTriangles leaf;
    leaf.load(*mesh, 1);
    CHECK(leaf.leaf() == 1);
    CHECK(leaf.find_near(Vector3::Zero(), Vector3::Zero(), 10.0) == 0x0FU);
    CHECK(leaf.find_near(Vector3(0.0, 3.0, 0.0), Vector3::Zero(), 0.1) == 0U);
    CHECK(leaf.find_in_box({Vector3::Constant(-1.0), Vector3::Constant(1.0)}) == 0x0FU);
    CHECK(leaf.find_above(Vector3::UnitY(), -1.0) == 0x0FU);
    CHECK(leaf.find_above(Vector3::UnitY(), 0.6) == 0U);
}

}  // namespace
}  // namespace fulcrum
