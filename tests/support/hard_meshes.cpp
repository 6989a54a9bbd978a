#include "tests/support/hard_meshes.h"

#include "haptics/geometry/shape.h"
#include "tests/support/hollow_meshes.h"
#include "tests/support/wander.h"

#include <cmath>
#include <cstdint>
#include <utility>

namespace fulcrum {

namespace {

const Vector3& vertex_of(const TriangleMesh& mesh, std::int32_t index) {
    return mesh.vertices_B()[static_cast<std::size_t>(index)];
}

}  // namespace

Expected<TriangleMesh> make_trench(double slope, int n) {
    std::vector<Vector3> vertices;
    std::vector<TriangleCorners> triangles;
    for (std::int32_t i = 0; i <= n; ++i) {
        const double z = 2.0 * i / n - 1.0;
        vertices.emplace_back(-std::cos(slope), std::sin(slope), z);
        vertices.emplace_back(0.0, 0.0, z);
        vertices.emplace_back(std::cos(slope), std::sin(slope), z);
        if (i > 0) {
            const std::int32_t last = 3 * i;
            triangles.insert(triangles.end(), {{last - 3, last, last + 1},
                                               {last - 3, last + 1, last - 2},
                                               {last - 2, last + 1, last + 2},
                                               {last - 2, last + 2, last - 1}});
        }
    }
    return TriangleMesh::build(vertices, triangles);
}

Vector2 turn_quarters(Vector2 v, int quarters) {
    for (int i = 0; i < quarters; ++i) {
        v = {-v.y(), v.x()};
    }
    return v;
}

Expected<TriangleMesh> make_prism(const std::vector<Vector2>& corners, double length_m) {
    const auto n = static_cast<std::int32_t>(corners.size());
    std::vector<Vector3> vertices;
    std::vector<TriangleCorners> triangles;
    for (const double z : {-0.5 * length_m, 0.5 * length_m}) {
        for (const Vector2& corner : corners) {
            vertices.emplace_back(corner.x(), corner.y(), z);
        }
    }
    vertices.emplace_back(0.0, 0.0, -0.5 * length_m);
    vertices.emplace_back(0.0, 0.0, 0.5 * length_m);
    for (std::int32_t i = 0; i < n; ++i) {
        const std::int32_t next = (i + 1) % n;
        triangles.push_back({i, next, n + next});
        triangles.push_back({i, n + next, n + i});
        triangles.push_back({2 * n, next, i});
        triangles.push_back({2 * n + 1, n + i, n + next});
    }
    return TriangleMesh::build(std::move(vertices), std::move(triangles), {.weld_relative = 0.0});
}

Expected<TriangleMesh> make_messy(const TriangleMesh& mesh, double weld_relative) {
    std::vector<Vector3> vertices;
    std::vector<TriangleCorners> triangles;
    for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
        const TriangleCorners& t = mesh.triangles()[i];
        for (int copy = 0; copy < 2; ++copy) {
            const auto a = static_cast<std::int32_t>(vertices.size());
            for (const std::int32_t corner : t) {
                vertices.push_back(vertex_of(mesh, corner));
            }
            const bool turned = copy == 1 && i % 3 == 0;
            triangles.push_back({a, turned ? a + 2 : a + 1, turned ? a + 1 : a + 2});
            vertices.emplace_back(0.5 * (vertex_of(mesh, t[0]) + vertex_of(mesh, t[1])));
            triangles.push_back({a, a + 1, a + 3});
            triangles.push_back({a, a, a + 2});
        }
    }
    return TriangleMesh::build(std::move(vertices), std::move(triangles),
                               {.weld_relative = weld_relative});
}

Expected<TriangleMesh> make_heap(int n_triangles, unsigned seed) {
    Random random(seed);
    std::vector<Vector3> vertices;
    std::vector<TriangleCorners> triangles;
    for (std::int32_t i = 0; i < n_triangles; ++i) {
        for (int corner = 0; corner < 3; ++corner) {
            vertices.push_back(random.in_cube());
        }
        triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    return TriangleMesh::build(std::move(vertices), std::move(triangles), {.weld_relative = 0.0});
}

Expected<TriangleMesh> make_cracked(const TriangleMesh& mesh, double crack_m, unsigned seed,
                                    double weld_relative) {
    const auto is_upper = [&mesh](const TriangleCorners& t) {
        return vertex_of(mesh, t[0]).y() + vertex_of(mesh, t[1]).y() + vertex_of(mesh, t[2]).y() >
               0.0;
    };
    std::vector<bool> in_upper(mesh.vertices_B().size(), false);
    for (const TriangleCorners& t : mesh.triangles()) {
        for (const std::int32_t corner : t) {
            in_upper[static_cast<std::size_t>(corner)] =
                in_upper[static_cast<std::size_t>(corner)] || is_upper(t);
        }
    }
    // The lower half's corners follow the upper half's in the list; those on the seam are moved.
    Random random(seed);
    const auto n = static_cast<std::int32_t>(mesh.vertices_B().size());
    std::vector<Vector3> vertices = mesh.vertices_B();
    for (std::size_t i = 0; i < in_upper.size(); ++i) {
        const double moved_m = in_upper[i] ? crack_m / std::sqrt(3.0) : 0.0;
        vertices.emplace_back(mesh.vertices_B()[i] + moved_m * random.in_cube());
    }
    std::vector<TriangleCorners> triangles;
    for (const TriangleCorners& t : mesh.triangles()) {
        const std::int32_t first = is_upper(t) ? 0 : n;
        triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
    return TriangleMesh::build(std::move(vertices), std::move(triangles),
                               {.weld_relative = weld_relative});
}

Expected<TriangleMesh> make_t_junctions(const TriangleMesh& mesh) {
    std::vector<Vector3> vertices = mesh.vertices_B();
    std::vector<TriangleCorners> triangles;
    for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
        const TriangleCorners& t = mesh.triangles()[i];
        if (i % 3 != 0) {
            triangles.push_back(t);
            continue;
        }
        // Each of its edges in turn.
        const std::size_t edge = i / 3 % 3;
        const std::int32_t u = t[edge];
        const std::int32_t v = t[(edge + 1) % 3];
        const std::int32_t w = t[(edge + 2) % 3];
        const auto middle = static_cast<std::int32_t>(vertices.size());
        vertices.emplace_back(0.5 * (vertex_of(mesh, u) + vertex_of(mesh, v)));
        triangles.push_back({u, middle, w});
        triangles.push_back({middle, v, w});
    }
    return TriangleMesh::build(std::move(vertices), std::move(triangles), {.weld_relative = 0.0});
}

Expected<TriangleMesh> make_hollow(const TriangleMesh& outside, const TriangleMesh& hollow) {
    return make_both(outside, *make_inverted(hollow), Vector3::Zero());
}

}  // namespace fulcrum
