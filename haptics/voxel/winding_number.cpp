#include "haptics/voxel/winding_number.h"

#include <cmath>
#include <numbers>

namespace fulcrum {

double compute_solid_angle(const Vector3& p, const TriangleAt& triangle) noexcept {
    const Vector3 a = triangle.a - p;
    const Vector3 b = triangle.b - p;
    const Vector3 c = triangle.c - p;
    const double a_m = a.norm();
    const double b_m = b.norm();
    const double c_m = c.norm();
    const double above = a.dot(b.cross(c));
    const double below = a_m * b_m * c_m + a.dot(b) * c_m + b.dot(c) * a_m + c.dot(a) * b_m;
    return 2.0 * std::atan2(above, below);
}

namespace {

// Calls dipole(cluster, away, square) for each cluster that is far, triangle(t) for the others.
template <class Dipole, class Triangle>
void walk(const TriangleClusters& clusters, const Vector3& p_B, double opening, Dipole&& dipole,
          Triangle&& triangle) noexcept {
    clusters.for_each_near(
        [&](const TriangleCluster& cluster) noexcept {
            const Vector3 away = cluster.centre_B - p_B;
            const double square = away.squaredNorm();
            const double near = opening * cluster.radius_m;
            if (square <= near * near) {
                return false;
            }
            dipole(cluster, away, square);
            return true;
        },
        triangle);
}

}  // namespace

double compute_winding_number(const TriangleClusters& clusters, const Vector3& p_B,
                              double opening) noexcept {
    double steradians = 0.0;
    walk(
        clusters, p_B, opening,
        [&](const TriangleCluster& cluster, const Vector3& away, double square) noexcept {
            steradians += cluster.area_vector_B.dot(away) / (square * std::sqrt(square));
        },
        [&](const TriangleAt& triangle) noexcept {
            steradians += compute_solid_angle(p_B, triangle);
        });
    return steradians / (4.0 * std::numbers::pi);
}

double count_winding_terms(const TriangleClusters& clusters, const Vector3& p_B,
                           double opening) noexcept {
    constexpr double kTriangle = 5.0;
    double terms = 0.0;
    walk(
        clusters, p_B, opening,
        [&](const TriangleCluster& /*cluster*/, const Vector3& /*away*/,
            double /*square*/) noexcept { terms += 1.0; },
        [&](const TriangleAt& /*triangle*/) noexcept { terms += kTriangle; });
    return terms;
}

bool is_wound_round(const TriangleClusters& clusters, const Vector3& p_B) noexcept {
    return std::abs(compute_winding_number(clusters, p_B)) >= 0.5;
}

}  // namespace fulcrum
