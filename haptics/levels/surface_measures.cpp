#include "haptics/levels/surface_measures.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fulcrum {

SurfaceDistance::SurfaceDistance(const TriangleMesh& mesh)
    : tree_(mesh), farthest_m_(mesh.diagonal_m()) {
    // Without a mesh to be had at load this could not be: what was built has triangles.
    const auto made = CollisionMesh::create(mesh);
    triangles_.resize(mesh.triangles().size());
    for (std::int32_t i = 0; made && i < (*made)->n_triangles(); ++i) {
        TriangleForGap triangle = prepare_for_gap(**made, i);
        triangles_[static_cast<std::size_t>((*made)->source_triangle(i))] = triangle;
    }
}

double SurfaceDistance::measure_height_m(const Vector3& point, double guess_m) const noexcept {
    constexpr double kAlike = 1.0e-9;
    for (double reach_m = guess_m;; reach_m *= 4.0) {
        double nearest_m = std::numeric_limits<double>::infinity();
        double front = 0.0;
        const Vector3 reach = Vector3::Constant(reach_m);
        tree_.for_each_in_box({point - reach, point + reach}, [&](std::int32_t slot) {
            const auto triangle =
                static_cast<std::size_t>(tree_.order()[static_cast<std::size_t>(slot)]);
            const TriangleGap gap = find_triangle_gap(triangles_[triangle], point);
            // Of those that share the nearest corner the one that sees the point best.
            const double here = gap.normal_B.dot(triangles_[triangle].normal);
            const bool is_nearer = gap.distance_m < nearest_m * (1.0 - kAlike);
            if (is_nearer || (gap.distance_m <= nearest_m * (1.0 + kAlike) &&
                              std::abs(here) > std::abs(front))) {
                front = here;
            }
            nearest_m = std::min(nearest_m, gap.distance_m);
        });
        if (nearest_m <= reach_m || !(reach_m < 1.0e6 * farthest_m_)) {
            return front < 0.0 ? -nearest_m : nearest_m;
        }
    }
}

SupportArea::SupportArea(const LevelSurface& surface, double within_m)
    : surface_(surface), within_m_(within_m) {}

double SupportArea::measure_m2(std::int32_t corner) {
    const auto doubled_of = [this](std::int32_t triangle) -> Vector3 {
        const PieceTriangle at = surface_.places(triangle);
        return (at[1] - at[0]).cross(at[2] - at[0]);
    };
    Vector3 sum = Vector3::Zero();
    found_.clear();
    ++stamp_;
    const auto find = [&](std::int32_t triangle) {
        if (static_cast<std::size_t>(triangle) >= seen_.size()) {
            seen_.resize(static_cast<std::size_t>(triangle) + 1, 0);
        }
        if (seen_[static_cast<std::size_t>(triangle)] != stamp_) {
            seen_[static_cast<std::size_t>(triangle)] = stamp_;
            found_.push_back(triangle);
        }
    };
    for (const std::int32_t triangle : surface_.triangles_at(corner)) {
        sum += doubled_of(triangle);
        find(triangle);
    }
    const double length = sum.norm();
    if (!(length > 0.0)) {
        return 0.0;
    }
    const Vector3 normal = sum / length;
    const std::size_t n_around = found_.size();
    double area_m2 = 0.0;
    for (std::size_t i = 0; i < found_.size() && i < kMostTriangles; ++i) {
        const PieceTriangle at = surface_.places(found_[i]);
        const double share = normal.dot(doubled_of(found_[i]));
        const bool is_near = std::ranges::all_of(at, [&](const Vector3& place) {
            return normal.dot(place - surface_.place(corner)) >= -within_m_;
        });
        // Those at the corner itself count, whatever they do.
        if (i >= n_around && (!is_near || share <= 0.0)) {
            continue;
        }
        area_m2 += 0.5 * std::max(share, 0.0);
        for (const std::int32_t other : surface_.corners(found_[i])) {
            std::ranges::for_each(surface_.triangles_at(other), find);
        }
    }
    return area_m2;
}

}  // namespace fulcrum
