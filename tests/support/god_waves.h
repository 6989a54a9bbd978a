// Waves of fine facets to draw a god-object over: a sheet along x, in squares of two triangles each.
#pragma once

#include "haptics/geometry/triangle_mesh.h"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace fulcrum::test {

struct GodWaves {
    double height_m = 0.0005;  ///< above and below the middle
    double length_m = 0.02;
    double facet_m = 0.0001;
    int n_waves = 3;
    double width_m = 0.008;  ///< along z, in four strips

    [[nodiscard]] double find_height_m(double x_m) const {
        return height_m * std::sin(2.0 * std::numbers::pi * x_m / length_m);
    }
    /// So far out of the surface, along its normal there.
    [[nodiscard]] Vector3 find_place(double x_m, double out_m) const {
        const double wave = 2.0 * std::numbers::pi / length_m;
        const Vector3 normal(-height_m * wave * std::cos(wave * x_m), 1.0, 0.0);
        return Vector3(x_m, find_height_m(x_m), 0.0) + out_m * normal.normalized();
    }
    [[nodiscard]] TriangleMesh make_mesh() const {
        constexpr int kStrips = 4;
        const int n = static_cast<int>(std::lround(n_waves * length_m / facet_m));
        std::vector<Vector3> vertices;
        std::vector<TriangleCorners> triangles;
        for (int i = 0; i <= n; ++i) {
            for (int j = 0; j <= kStrips; ++j) {
                const double z_m = width_m * (static_cast<double>(j) / kStrips - 0.5);
                vertices.emplace_back(facet_m * i, find_height_m(facet_m * i), z_m);
            }
        }
        for (int i = 0; i < n; ++i) {
            for (int j = 0; j < kStrips; ++j) {
                const std::int32_t at = i * (kStrips + 1) + j;
                const std::int32_t next = at + kStrips + 1;
                triangles.push_back({at, at + 1, next + 1});
                triangles.push_back({at, next + 1, next});
            }
        }
        return TriangleMesh::build(std::move(vertices), std::move(triangles)).value();
    }
};

}  // namespace fulcrum::test
