#include "haptics/collision/self_intersection.h"

#include "haptics/geometry/shape.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

namespace fulcrum {
namespace {

// Two meshes in one, the second moved.
Expected<TriangleMesh> join(const TriangleMesh& one, const TriangleMesh& other, const Vector3& by) {
    std::vector<Vector3> vertices = one.vertices_B();
    std::vector<TriangleCorners> triangles = one.triangles();
    const auto first = static_cast<std::int32_t>(vertices.size());
    for (const Vector3& vertex : other.vertices_B()) {
        vertices.emplace_back(vertex + by);
    }
    for (const TriangleCorners& t : other.triangles()) {
        triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
    return TriangleMesh::build(std::move(vertices), std::move(triangles), {.weld_relative = 0.0});
}

TEST_CASE("self-intersection: sound meshes have none, whatever their scale and their slivers") {
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
}

TEST_CASE(
    "self-intersection: a triangle through another is one place, from whichever it is asked") {
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
    const auto both = join(*ball, *ball, by);
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

TEST_CASE("self-intersection: it stops at its limits, and says so") {
    Random random(2);
    std::vector<Vector3> vertices;
    std::vector<TriangleCorners> triangles;
    for (std::int32_t i = 0; i < 500; ++i) {
        for (int k = 0; k < 3; ++k) {
            vertices.emplace_back(random.in_cube());
        }
        triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    const auto soup = TriangleMesh::build(vertices, triangles);
    const SelfIntersections capped = find_self_intersections(*soup, {.most_crossings = 100});
    CHECK(capped.count == 100);
    CHECK(capped.more);
    const SelfIntersections tired = find_self_intersections(*soup, {.most_pairs_a_triangle = 1});
    CHECK(tired.more);
    CHECK(tired.count < 500);
    const SelfIntersections all =
        find_self_intersections(*soup, {.most_crossings = 1000000, .most_pairs_a_triangle = 1000});
    CHECK_FALSE(all.more);
    CHECK(all.count > 1000);
}

TEST_CASE("self-intersection: the full report tells them") {
    const auto ball = make_sphere(1.0, 4);
    const auto both = join(*ball, *ball, Vector3(0.7, 0.31, 0.17));
    const MeshReport report = compute_full_mesh_report(*both);
    CHECK(report.self_intersections == find_self_intersections(*both).count);
    CHECK(to_sentence(report).find("passes through itself") != std::string::npos);
    CHECK(compute_full_mesh_report(*ball).is_sound());
}

}  // namespace
}  // namespace fulcrum
