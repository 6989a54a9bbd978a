// Closed meshes that are not convex, made by rule, and two meshes in one.
#pragma once

#include "tests/support/join_meshes.h"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace fulcrum {

/// A channel open upwards, along z: walls and floor `wall_m` thick, `inner_m` wide and deep inside; its floor's underside at y = 0.
inline Expected<TriangleMesh> make_channel(double inner_m, double wall_m, double length_m) {
    const double a = 0.5 * inner_m;
    const double b = a + wall_m;
    const double top = wall_m + inner_m;
    const std::array<std::array<double, 2>, 8> round{
        {{-b, 0.0}, {b, 0.0}, {b, top}, {a, top}, {a, wall_m}, {-a, wall_m}, {-a, top}, {-b, top}}};
    std::vector<Vector3> vertices;
    for (const double z : {-0.5 * length_m, 0.5 * length_m}) {
        for (const auto& corner : round) {
            vertices.emplace_back(corner[0], corner[1], z);
        }
    }
    std::vector<TriangleCorners> triangles;
    for (int i = 0; i < 8; ++i) {
        const int next = (i + 1) % 8;
        triangles.push_back({i, next, 8 + next});
        triangles.push_back({i, 8 + next, 8 + i});
    }
    constexpr std::array<std::array<int, 4>, 3> kParts{{{0, 5, 6, 7}, {0, 1, 4, 5}, {1, 2, 3, 4}}};
    for (const auto& part : kParts) {
        // The end at -z looks back, that at +z forwards.
        triangles.push_back({part[0], part[2], part[1]});
        triangles.push_back({part[0], part[3], part[2]});
        triangles.push_back({8 + part[0], 8 + part[1], 8 + part[2]});
        triangles.push_back({8 + part[0], 8 + part[2], 8 + part[3]});
    }
    return TriangleMesh::build(vertices, triangles);
}

/// Half a ball of `outer_m` with half a ball of `inner_m` taken out of it, open upwards, both about the origin.
inline Expected<TriangleMesh> make_bowl(double outer_m, double inner_m, int n_round, int n_down) {
    std::vector<Vector3> vertices;
    const auto add_row = [&](double radius_m, double angle) {
        for (int i = 0; i < n_round; ++i) {
            const double turn = 2.0 * std::numbers::pi * i / n_round;
            vertices.push_back(radius_m * Vector3(std::cos(angle) * std::cos(turn),
                                                  -std::sin(angle),
                                                  std::cos(angle) * std::sin(turn)));
        }
    };
    // From below outwards and up, over the rim, and down again inside.
    for (int j = n_down - 1; j >= 0; --j) {
        add_row(outer_m, 0.5 * std::numbers::pi * j / n_down);
    }
    for (int j = 0; j < n_down; ++j) {
        add_row(inner_m, 0.5 * std::numbers::pi * j / n_down);
    }
    const int bottom = static_cast<int>(vertices.size());
    vertices.emplace_back(0.0, -outer_m, 0.0);
    vertices.emplace_back(0.0, -inner_m, 0.0);
    std::vector<TriangleCorners> triangles;
    const auto at = [&](int row, int i) { return row * n_round + i % n_round; };
    const int n_rows = 2 * n_down;
    for (int i = 0; i < n_round; ++i) {
        for (int row = 0; row + 1 < n_rows; ++row) {
            triangles.push_back({at(row, i), at(row + 1, i), at(row + 1, i + 1)});
            triangles.push_back({at(row, i), at(row + 1, i + 1), at(row, i + 1)});
        }
        triangles.push_back({bottom, at(0, i), at(0, i + 1)});
        triangles.push_back({bottom + 1, at(n_rows - 1, i + 1), at(n_rows - 1, i)});
    }
    return TriangleMesh::build(vertices, triangles);
}

/// Both surfaces in one mesh, the second moved, nothing welded.
inline Expected<TriangleMesh> make_both(const TriangleMesh& one, const TriangleMesh& other,
                                        const Vector3& by) {
    return join_meshes({{one, {}}, {other, Pose::at(by)}}, {.weld_relative = 0.0});
}

}  // namespace fulcrum
