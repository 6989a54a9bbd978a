// What may be asked of a whole mesh: self_intersection.h, enclosure.h, wall_thickness.h, surface_samples.h.
#include "haptics/collision/self_intersection.h"

#include "haptics/collision/enclosure.h"
#include "haptics/collision/surface_samples.h"
#include "haptics/collision/wall_thickness.h"
#include "haptics/geometry/shape.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/hollow_meshes.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace fulcrum {
namespace {

TriangleMesh make_without_last(const TriangleMesh& mesh) {
    std::vector<TriangleCorners> triangles = mesh.triangles();
    triangles.pop_back();
    return *TriangleMesh::build(mesh.vertices_B(), triangles);
}

TEST_CASE("self-intersection: sound meshes have none, a triangle through another is one place") {
    CHECK(find_self_intersections(*make_box(Vector3::Ones())).count == 0);
    CHECK(find_self_intersections(*make_globe(1.0, 300, 12)).count == 0);
    CHECK(find_self_intersections(*make_torus(1.0, 0.3, 40, 20)).count == 0);
    CHECK(find_self_intersections(*make_plate(1.0, 1.0, 20)).count == 0);
    for (const double scale : {1e-6, 1.0, 1e6}) {
        const SelfIntersections found =
            find_self_intersections(*make_bumpy_sphere(scale, 20, 0.1, 9.0));
        CHECK(found.count == 0);
        CHECK_FALSE(found.more);
    }
    std::vector<Vector3> vertices{{0, 0, 0},        {1, 0, 0},       {0, 1, 0},
                                  {0.2, 0.2, -1.0}, {0.2, 0.2, 1.0}, {5.0, 5.0, 0.5}};
    const auto through = [&](const Vector3& by) {
        std::vector<Vector3> moved = vertices;
        for (std::size_t i = 3; i < 6; ++i) {
            moved[i] += by;
        }
        return find_self_intersections(
                   *TriangleMesh::build(moved, {{0, 1, 2}, {3, 4, 5}}, {.weld_relative = 0.0}))
            .count;
    };
    CHECK(through(Vector3::Zero()) == 1);
    // Only edges of the first go through the second, beside it, and not at all.
    CHECK(through(Vector3(-0.3, -0.3, 0.0)) == 1);
    CHECK(through(Vector3(0.0, 0.0, 3.0)) == 0);
    CHECK(through(Vector3(2.0, 0.0, 0.0)) == 0);
    // Touching with a corner, or along an edge, is not passing through.
    CHECK(through(Vector3(0.0, 0.0, 1.0)) == 0);
}

TEST_CASE("self-intersection: as many as trying all pairs finds, between two balls") {
    const auto ball = make_sphere(1.0, 6);
    const Vector3 by(0.7, 0.31, 0.17);
    const auto both = make_both(*ball, *ball, by);
    const SelfIntersections found = find_self_intersections(*both);
    // Every pair by plane geometry in doubles; the balls are in general position.
    const auto& v = both->vertices_B();
    const auto at = [&v](std::int32_t i) { return v[static_cast<std::size_t>(i)]; };
    const auto pierces = [&](const TriangleCorners& e, const TriangleCorners& t) {
        const Vector3 n = (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0]));
        for (std::size_t i = 0; i < 3; ++i) {
            const Vector3 p = at(e[i]);
            const Vector3 q = at(e[(i + 1) % 3]);
            const double h = n.dot(p - at(t[0]));
            const double g = n.dot(q - at(t[0]));
            if (h * g < 0.0) {
                const Vector3 x = p + h / (h - g) * (q - p);
                bool inside = true;
                for (std::size_t k = 0; k < 3; ++k) {
                    const Vector3 u = at(t[k]);
                    inside = inside && n.dot((at(t[(k + 1) % 3]) - u).cross(x - u)) > 0.0;
                }
                if (inside) {
                    return true;
                }
            }
        }
        return false;
    };
    std::int64_t expected = 0;
    const auto half = both->triangles().size() / 2;
    for (std::size_t i = 0; i < half; ++i) {
        for (std::size_t k = half; k < 2 * half; ++k) {
            const auto& a = both->triangles()[i];
            const auto& b = both->triangles()[k];
            expected += pierces(a, b) || pierces(b, a) ? 1 : 0;
        }
    }
    CHECK(expected > 50);
    CHECK(found.count == expected);
    CHECK_FALSE(found.more);
}

TEST_CASE("self-intersection: it stops at its limits, and says so; the full report tells all") {
    const TriangleMesh soup = *make_heap(500, 2);
    const SelfIntersections capped = find_self_intersections(soup, {.most_crossings = 100});
    CHECK(capped.count == 100);
    CHECK(capped.more);
    const SelfIntersections tired = find_self_intersections(soup, {.most_pairs_a_triangle = 1});
    CHECK(tired.more);
    CHECK(tired.count < 500);
    const SelfIntersections all =
        find_self_intersections(soup, {.most_crossings = 1000000, .most_pairs_a_triangle = 1000});
    CHECK_FALSE(all.more);
    CHECK(all.count > 1000);
    const auto ball = make_sphere(1.0, 4);
    const auto both = make_both(*ball, *ball, Vector3(0.7, 0.31, 0.17));
    const MeshReport report = compute_full_mesh_report(*both);
    CHECK(report.self_intersections == find_self_intersections(*both).count);
    CHECK(to_sentence(report).find("passes through itself") != std::string::npos);
    CHECK(compute_full_mesh_report(*ball).is_sound());
}

TEST_CASE("enclosure: in a ball's stuff is what is nearer to its middle than its facets") {
    const auto mesh = touchable(make_sphere(0.1, 24));
    Random random(3);
    int n_inside = 0;
    for (int i = 0; i < 4000; ++i) {
        const Vector3 at_B = 0.13 * random.in_cube();
        if (at_B.norm() < 0.098 || at_B.norm() > 0.1) {
            REQUIRE(is_in_stuff(*mesh, at_B) == (at_B.norm() < 0.099));
            n_inside += at_B.norm() < 0.099 ? 1 : 0;
        }
    }
    CHECK(n_inside > 500);
}

TEST_CASE("enclosure: exactly over corners, edges and diagonals, in a box and with a hole in it") {
    const auto mesh = touchable(make_box(Vector3(2.0, 2.0, 2.0)));
    for (const double x : {-0.999, -0.5, 0.0, 0.5, 0.999}) {
        CHECK(is_in_stuff(*mesh, Vector3(x, x, x)));
        CHECK(is_in_stuff(*mesh, Vector3(x, 0.0, 0.0)));
        CHECK_FALSE(is_in_stuff(*mesh, Vector3(x, 1.001, 0.0)));
        CHECK_FALSE(is_in_stuff(*mesh, Vector3(x, x, -1.001)));
    }
    // By two rays of three.
    const auto holed = touchable(make_without_last(*make_box(Vector3(2.0, 2.0, 2.0))));
    CHECK(is_in_stuff(*holed, Vector3(-0.1, -0.2, 0.05)));
    CHECK_FALSE(is_in_stuff(*holed, Vector3(0.0, 1.5, 0.0)));
    // A place that is no number, or at the end of the world.
    CHECK_FALSE(is_in_stuff(*mesh, Vector3(std::nan(""), 0.0, 0.0)));
    CHECK_FALSE(is_in_stuff(*mesh, Vector3(1.0e300, 0.0, 0.0)));
    CHECK_FALSE(is_in_stuff(*mesh, Vector3::Constant(std::numeric_limits<double>::infinity())));
}

TEST_CASE("enclosure: an inside-out mesh, a room, has its stuff outside; an open one has none") {
    const auto box = make_box(Vector3(2.0, 2.0, 2.0));
    REQUIRE(box);
    const auto room = touchable(make_inverted(*box));
    CHECK_FALSE(is_in_stuff(*room, Vector3(0.1, 0.2, 0.3)));
    CHECK_FALSE(is_in_stuff(*room, Vector3(1.5, 0.0, 0.0)));
    const auto plate = touchable(make_plate(1.0, 1.0, 4));
    for (const double y : {-0.1, -1e-6, 1e-6, 0.1}) {
        CHECK_FALSE(is_in_stuff(*plate, Vector3(0.1, y, 0.05)));
    }
}

double find(const TriangleMesh& mesh, double share = 0.05) {
    return find_wall_m(*CollisionMesh::create(mesh).value(),
                       make_surface_pointshell(mesh, 1000).value(), share);
}

constexpr double kSingle_m = 1.0e-5;  // places are single precision, ways begin off the surface

TEST_CASE("wall thickness: a plate is as thick as it is, inside out too") {
    const TriangleMesh plate = *make_box({0.4, 0.003, 0.3});
    for (const double share : {0.0, 0.05, 0.5}) {
        CHECK(find(plate, share) == Approx(0.003).margin(kSingle_m));
        CHECK(find(*make_inverted(plate), share) == Approx(0.003).margin(kSingle_m));
    }
    // Its rims are walls of 0.3 and 0.4 m.
    CHECK(find(plate, 0.999) > 0.29);
}

TEST_CASE("wall thickness: a ball is as thick as its diameter, a hollow one as its skin") {
    CHECK(find(*make_sphere(0.1, 40), 0.0) > 0.195);
    const TriangleMesh hollow = *make_hollow(*make_sphere(0.1, 40), *make_sphere(0.095, 40));
    CHECK(find(hollow, 0.05) > 0.0045);
    CHECK(find(hollow, 0.95) < 0.0065);
}

TEST_CASE("wall thickness: the cleft between two plates is no wall, and an open sheet has none") {
    // Two plates of 20 mm, 1 mm apart.
    const TriangleMesh plate = *make_box({0.4, 0.02, 0.3});
    CHECK(find(*make_both(plate, plate, {0.0, 0.021, 0.0})) == Approx(0.02).margin(kSingle_m));
    CHECK(std::isinf(find(*make_plate(0.4, 0.3, 4), 0.99)));
    // Sheets that lie upon each other are a wall of none.
    CHECK(find(*make_box({0.4, 1.0e-5, 0.3})) < 2.0e-5);
}

int count_kind(const SurfaceSamples& samples, SampleKind kind) {
    return static_cast<int>(std::ranges::count_if(
        samples.all(), [&](const SurfaceSample& s) { return s.kind == kind; }));
}

TEST_CASE("surface samples: corners, faces and edges of a box; what is round has faces alone") {
    const auto samples = SurfaceSamples::make(*make_box({0.4, 0.2, 0.1}), 200);
    REQUIRE(samples);
    CHECK(samples->spacing_m() == Approx(std::sqrt(2.0 * (0.08 + 0.04 + 0.02) / 200.0)));
    CHECK(count_kind(*samples, SampleKind::corner) == 8);
    CHECK(count_kind(*samples, SampleKind::face) == 200);
    // Four of each length, the middles of pieces no longer than the spacing; diagonals of faces are not sharp.
    const auto inner = [&](double length_m) {
        return 4 * static_cast<int>(std::ceil(length_m / samples->spacing_m()));
    };
    CHECK(count_kind(*samples, SampleKind::edge) == inner(0.4) + inner(0.2) + inner(0.1));
    for (const SurfaceSample& sample : samples->all()) {
        const Vector3 beyond = sample.place_B.cwiseAbs() - Vector3(0.2, 0.1, 0.05);
        const auto on =
            std::ranges::count_if(beyond, [](double x) { return std::abs(x) < 1.0e-7; });
        CHECK(beyond.maxCoeff() == Approx(0.0).margin(1.0e-7));
        CHECK(on >= (sample.kind == SampleKind::corner ? 3
                     : sample.kind == SampleKind::edge ? 2
                                                       : 1));
        CHECK(sample.along_B.norm() == Approx(sample.kind == SampleKind::edge ? 1.0 : 0.0));
    }
    const auto ball = SurfaceSamples::make(*make_sphere(0.1, 8), 64);
    REQUIRE(ball);
    CHECK(ball->all().size() == 64);
    // A box turned inside out: all of its edges are grooves.
    const auto room = SurfaceSamples::make(*make_inverted(*make_box({1.0, 1.0, 1.0})), 64);
    REQUIRE(room);
    CHECK(room->all().size() == 64);
    // A plate's rim has one triangle alone.
    const auto plate = SurfaceSamples::make(*make_plate(1.0, 1.0, 2), 64);
    REQUIRE(plate);
    CHECK(count_kind(*plate, SampleKind::corner) == 8);
}

TEST_CASE("surface samples: groups hold each once, in their balls; too few or many are refused") {
    const auto samples = SurfaceSamples::make(*make_cylinder(0.05, 0.2, 64), 512);
    REQUIRE(samples);
    std::uint32_t next = 0;
    for (const SurfaceSamples::Group& group : samples->groups()) {
        CHECK(group.first == next);
        CHECK(group.count <= 16);
        next += group.count;
        for (const SurfaceSample& sample : samples->of(group)) {
            CHECK((sample.place_B - group.centre_B).norm() <= group.radius_m);
        }
    }
    CHECK(next == samples->all().size());
    CHECK(samples->memory_bytes() >= next * sizeof(SurfaceSample));
    CHECK_FALSE(SurfaceSamples::make(*make_box({1.0, 1.0, 1.0}), 15));
    CHECK_FALSE(SurfaceSamples::make(*make_box({1.0, 1.0, 1.0}), 100'001));
    std::vector<Vector3> corners;
    std::vector<TriangleCorners> triangles;
    for (int i = 0; i < 40'000; ++i) {
        for (const Vector3& corner : {Vector3(i, 0, 0), Vector3(i, 0.5, 0), Vector3(i, 0, 0.5)}) {
            corners.push_back(corner);
        }
        triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    const auto loose = SurfaceSamples::make(*TriangleMesh::build(corners, triangles), 64);
    REQUIRE_FALSE(loose);
    CHECK(to_sentence(loose.error()).find("100000") != std::string::npos);
}

}  // namespace
}  // namespace fulcrum
