#include "haptics/geometry/shape.h"
#include "haptics/voxel/triangle_box.h"
#include "haptics/voxel/triangle_clusters.h"
#include "haptics/voxel/winding_number.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/edited_meshes.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <random>

using fulcrum::overlaps_box;
using fulcrum::TrianglePoints;
using fulcrum::Vector3;
using namespace fulcrum;

namespace {

const Vector3 kHalf{1.0, 1.0, 1.0};

constexpr double kRounding_m = 1.0e-12;

bool touches_unit(const TrianglePoints& t) {
    return overlaps_box(t, Vector3::Zero(), kHalf);
}

TrianglePoints moved(const TrianglePoints& t, const Vector3& by) {
    return {t[0] + by, t[1] + by, t[2] + by};
}

// Cuts the triangle by the box's six planes; what remains is the part inside. Sutherland and Hodgman's way: independent of
// separating lines.
std::vector<Vector3> clip(const TrianglePoints& t, const Vector3& half) {
    std::vector<Vector3> polygon(t.begin(), t.end());
    for (int axis = 0; axis < 3; ++axis) {
        for (const double sign : {-1.0, 1.0}) {
            std::vector<Vector3> kept;
            for (std::size_t i = 0; i < polygon.size(); ++i) {
                const Vector3& a = polygon[i];
                const Vector3& b = polygon[(i + 1) % polygon.size()];
                const double da = half[axis] - sign * a[axis];
                const double db = half[axis] - sign * b[axis];
                if (da >= 0.0) {
                    kept.push_back(a);
                }
                if ((da >= 0.0) != (db >= 0.0)) {
                    kept.emplace_back(a + da / (da - db) * (b - a));
                }
            }
            polygon = kept;
        }
    }
    return polygon;
}

double find_by_brute_force(const TriangleMesh& mesh, const Vector3& p) {
    double least = HUGE_VAL;
    for (const TriangleCorners& t : mesh.triangles()) {
        const auto at = [&](std::size_t i) {
            return mesh.vertices_B()[static_cast<std::size_t>(t[i])];
        };
        least = std::min(least, compute_square_distance(p, {at(0), at(1), at(2)}));
    }
    return std::sqrt(least);
}

constexpr double kExact = 1.0e9;     // an opening that no cluster reaches
constexpr double kRounding = 1e-12;  // of a few thousand arctangents
constexpr double kDipoles = 0.02;    // what the header promises of the default opening

}  // namespace

TEST_CASE(
    "triangle and box: each of the thirteen lines separates, and a little nearer they touch") {
    struct Trial {
        TrianglePoints triangle;
        Vector3 away;  // by which it moves off
    };
    // A corner, an edge or a face of the triangle against one of the box, at the touch.
    const std::vector<Trial> trials{
        {{Vector3(1, 0, 0), Vector3(3, 1, 0), Vector3(3, 0, 1)}, {1, 0, 0}},
        {{Vector3(0, -1, 0), Vector3(1, -3, 0), Vector3(0, -3, 1)}, {0, -1, 0}},
        {{Vector3(0, 0, 1), Vector3(1, 0, 3), Vector3(0, 1, 3)}, {0, 0, 1}},
        // The plane x + y + z = 3 through the corner 1, 1, 1.
        {{Vector3(5, -1, -1), Vector3(-1, 5, -1), Vector3(-1, -1, 5)}, {1, 1, 1}},
        // An edge of the triangle against one of the box, along x, y and z.
        {{Vector3(0, 3, -1), Vector3(0.5, -1, 3), Vector3(0.2, 5, 5)}, {0, 1, 1}},
        {{Vector3(3, 0, -1), Vector3(-1, 0.5, 3), Vector3(5, 0.2, 5)}, {1, 0, 1}},
        {{Vector3(3, -1, 0), Vector3(-1, 3, 0.5), Vector3(5, 5, 0.2)}, {1, 1, 0}}};
    for (const Trial& trial : trials) {
        CHECK(touches_unit(trial.triangle));
        CHECK(touches_unit(moved(trial.triangle, -1.0e-3 * trial.away)));
        CHECK_FALSE(touches_unit(moved(trial.triangle, 1.0e-9 * trial.away)));
    }
}

TEST_CASE("triangle and box: agrees with cutting the triangle to the box") {
    std::mt19937 random(7);  // NOLINT(cert-msc51-cpp): the same each time
    std::uniform_real_distribution<double> place(-2.5, 2.5);
    int n_touching = 0;
    for (int i = 0; i < 20000; ++i) {
        TrianglePoints t;
        for (Vector3& corner : t) {
            corner = {place(random), place(random), place(random)};
        }
        const Vector3 half{0.3, 1.0, 0.7};
        const bool touching = !clip(t, half).empty();
        n_touching += touching ? 1 : 0;
        REQUIRE(overlaps_box(t, Vector3::Zero(), half) == touching);
        // Where box and triangle lie changes nothing.
        REQUIRE(overlaps_box(moved(t, {7.0, -3.0, 2.0}), {7.0, -3.0, 2.0}, half) == touching);
    }
    CHECK(n_touching > 3000);
    CHECK(n_touching < 17000);
}

TEST_CASE(
    "triangle and box: no touch is missed by rounding; bodies of no size; NaN touches nothing") {
    // A triangle that hangs by its corner on the box's face, far from the origin, at places that no double holds exactly.
    std::mt19937 random(11);  // NOLINT(cert-msc51-cpp): the same each time
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (int i = 0; i < 20000; ++i) {
        const Vector3 centre = 1.0e3 * Vector3(unit(random), unit(random), unit(random));
        const Vector3 half = Vector3::Constant(1.0 / 3.0);
        const Vector3 corner = centre + Vector3(half.x(), 0.3 * unit(random), 0.3 * unit(random));
        const TrianglePoints t{corner, corner + Vector3(1.0, unit(random), unit(random)),
                               corner + Vector3(1.0, unit(random), unit(random))};
        REQUIRE(overlaps_box(t, centre, half));
    }
    CHECK(touches_unit({Vector3(-9, -9, 0), Vector3(9, -9, 0), Vector3(0, 9, 0)}));
    CHECK(touches_unit({Vector3(0.1, 0, 0), Vector3(0, 0.1, 0), Vector3(0, 0, 0.1)}));
    CHECK(touches_unit({Vector3(-2, 0, 0), Vector3(2, 0, 0), Vector3(2, 0, 0)}));
    CHECK_FALSE(touches_unit({Vector3(-2, 2.5, 0), Vector3(2.5, -2, 3.5), Vector3(2.5, -2, 3.5)}));
    CHECK(touches_unit({Vector3(1, 1, 1), Vector3(1, 1, 1), Vector3(1, 1, 1)}));
    CHECK_FALSE(touches_unit({Vector3(1.1, 0, 0), Vector3(1.1, 0, 0), Vector3(1.1, 0, 0)}));
    const double nan = std::nan("");
    CHECK_FALSE(touches_unit({Vector3(nan, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1)}));
    CHECK_FALSE(touches_unit({Vector3(kInfinity, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1)}));
    CHECK_FALSE(overlaps_box({Vector3(0, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1)},
                             {0.0, nan, 0.0}, kHalf));
}

TEST_CASE(
    "triangle clusters: distances above face, edges, corners; without area the longest edge") {
    const TriangleAt t{{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {0.0, 2.0, 0.0}};
    CHECK(compute_square_distance({0.5, 0.5, -0.7}, t) == Approx(0.49));
    CHECK(compute_square_distance({1.0, -3.0, 4.0}, t) == Approx(25.0));
    CHECK(compute_square_distance({2.0, 2.0, 0.0}, t) == Approx(2.0));
    CHECK(compute_square_distance({-1.0, -2.0, 2.0}, t) == Approx(9.0));
    CHECK(compute_square_distance({5.0, 0.0, 4.0}, t) == Approx(25.0));
    const TriangleAt line{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {3.0, 0.0, 0.0}};
    CHECK(compute_square_distance({2.0, 0.5, 0.0}, line) == Approx(0.25));
    const TriangleAt point{Vector3::UnitX(), Vector3::UnitX(), Vector3::UnitX()};
    CHECK(compute_square_distance({1.0, 0.0, 2.0}, point) == Approx(4.0));
}

TEST_CASE(
    "triangle clusters: the nearest triangle is brute force's, near, far, inside and bounded") {
    const TriangleMesh mesh = *make_bumpy_sphere(1.0, 9, 0.1, 8.0);
    const TriangleClusters clusters(mesh);
    Random random(1);
    for (int i = 0; i < 300; ++i) {
        const Vector3 p = random.direction() * (3.0 * random.uniform());
        const double exact = find_by_brute_force(mesh, p);
        CHECK(clusters.find_distance(p) == Approx(exact).margin(kRounding_m));
        CHECK(clusters.find_distance(p, 0.5 * exact) == 0.5 * exact);
        CHECK(clusters.find_distance(p, 2.0 * exact + 0.1) == Approx(exact).margin(kRounding_m));
    }
}

TEST_CASE(
    "triangle clusters: one triangle is a tree as well, and a far cluster's area vector is the "
    "sum") {
    const std::vector<Vector3> vertices{Vector3::Zero(), Vector3::UnitX(), Vector3::UnitY()};
    const TriangleClusters one(TriangleMesh::build(vertices, {{0, 1, 2}}).value());
    CHECK(one.find_distance({0.2, 0.2, 3.0}) == Approx(3.0));

    const TriangleClusters ball(*make_sphere(1.0, 10));
    int n_clusters = 0;
    ball.for_each_near(
        [&](const TriangleCluster& whole) noexcept {
            ++n_clusters;
            CHECK(whole.area_vector_B.norm() < 1.0e-12);  // closed
            CHECK(whole.radius_m >= 1.0);
            return true;
        },
        [](const TriangleAt&) noexcept {});
    CHECK(n_clusters == 1);
}

TEST_CASE(
    "winding number: an octant is pi / 2; inside one, outside zero, exactly and with dipoles") {
    const TriangleAt octant{Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ()};
    CHECK(compute_solid_angle(Vector3::Zero(), octant) ==
          Approx(std::numbers::pi / 2.0).margin(kRounding));
    CHECK(compute_solid_angle(Vector3::Constant(2.0), octant) < 0.0);
    const TriangleMesh mesh = *make_bumpy_sphere(1.0, 20, 0.05, 15.0);
    const TriangleClusters clusters(mesh);
    Random random(3);
    for (int i = 0; i < 300; ++i) {
        const bool inside = i % 2 == 0;
        const Vector3 p = random.direction() * (inside ? 0.9 : 1.1) *
                          (inside ? std::abs(random.uniform()) : 1.0 + std::abs(random.uniform()));
        CHECK(compute_winding_number(clusters, p, kExact) ==
              Approx(inside ? 1.0 : 0.0).margin(1.0e-9));
        CHECK(compute_winding_number(clusters, p) == Approx(inside ? 1.0 : 0.0).margin(kDipoles));
        CHECK(is_wound_round(clusters, p) == inside);
    }
}

TEST_CASE("winding number: a ball that lost its cap is closed by the surface of one half") {
    const TriangleMesh open = test::take_away(
        *make_sphere(1.0, 30), [](const Vector3& middle) { return middle.y() > 0.8; });
    const TriangleClusters clusters(open);
    CHECK(is_wound_round(clusters, {0.0, 0.0, 0.0}));
    CHECK(is_wound_round(clusters, {0.0, 0.6, 0.0}));
    CHECK_FALSE(is_wound_round(clusters, {0.0, 1.2, 0.0}));
    // In the middle of the hole about half the sky is surface; the disc's own half is missing.
    const double at_hole = compute_winding_number(clusters, {0.0, 0.8, 0.0}, kExact);
    CHECK(at_hole == Approx(0.5).margin(0.03));
    Random random(4);
    for (int i = 0; i < 200; ++i) {
        const Vector3 p = 1.5 * random.direction() * random.uniform();
        CHECK(compute_winding_number(clusters, p) ==
              Approx(compute_winding_number(clusters, p, kExact)).margin(kDipoles));
    }
}

TEST_CASE("winding number: doubled, loose and turned triangles leave a ball what it is") {
    const TriangleMesh ball = *make_sphere(1.0, 12);
    const TriangleMesh messy = make_messy(ball, 0.0).value();
    const TriangleClusters clusters(messy);
    Random random(5);
    for (int i = 0; i < 200; ++i) {
        const double r =
            i % 2 == 0 ? 0.8 * std::abs(random.uniform()) : 1.1 + std::abs(random.uniform());
        CHECK(is_wound_round(clusters, r * random.direction()) == (r < 1.0));
    }
}

TEST_CASE("winding number: a mesh inside out encloses the same") {
    const TriangleClusters clusters(make_inverted(*make_sphere(1.0, 8)).value());
    CHECK(compute_winding_number(clusters, Vector3::Zero(), kExact) == Approx(-1.0));
    CHECK(is_wound_round(clusters, {0.3, 0.2, 0.1}));
    CHECK_FALSE(is_wound_round(clusters, {1.3, 0.2, 0.1}));
}
