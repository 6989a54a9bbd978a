#include "haptics/collision/segment_query.h"

#include <algorithm>

namespace fulcrum {

SegmentHit find_nearest_hit(const CollisionMesh& mesh, const Vector3& from_B,
                            const Vector3& to_B) noexcept {
    SegmentHit nearest;
    mesh.tree().for_each_along(from_B, to_B, [&](std::int32_t triangle, double t_end) noexcept {
        const SegmentHit hit = meet(prepare_triangle(mesh, triangle), from_B, to_B);
        if (hit.is_before(nearest)) {
            nearest = hit;
        }
        return std::min(t_end, nearest.t);
    });
    return nearest;
}

SegmentHit find_nearest_hit_brute_force(const CollisionMesh& mesh, const Vector3& from_B,
                                        const Vector3& to_B) noexcept {
    SegmentHit nearest;
    for (std::int32_t triangle = 0; triangle < mesh.n_triangles(); ++triangle) {
        const SegmentHit hit = meet(prepare_triangle(mesh, triangle), from_B, to_B);
        if (hit.is_before(nearest)) {
            nearest = hit;
        }
    }
    return nearest;
}

void NearbyTriangles::collect(const CollisionMesh& mesh, const Box& box_B) noexcept {
    const std::optional<std::size_t> n_found = mesh.tree().collect_leaves(box_B, leaves_);
    covers_ = n_found.has_value();
    n_leaves_ = n_found.value_or(0);
    box_B_ = box_B;
}

double NearbyTriangles::find_covered_part(const Vector3& from_B,
                                          const Vector3& to_B) const noexcept {
    double part = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double rate = to_B[axis] - from_B[axis];
        const double room =
            rate > 0.0 ? box_B_.upper[axis] - from_B[axis] : from_B[axis] - box_B_.lower[axis];
        if (std::abs(rate) * part > room) {
            part = room / std::abs(rate);
        }
    }
    constexpr double kEarly = 1.0 - 1.0e-9;  // by far more than rounding
    return part < 1.0 ? part * kEarly : 1.0;
}

SegmentHit NearbyTriangles::find_nearest_hit(const CollisionMesh& mesh, const Vector3& from_B,
                                             const Vector3& to_B, double part) const noexcept {
    const Vector3 end_B = part < 1.0 ? Vector3(from_B + part * (to_B - from_B)) : to_B;
    SegmentHit nearest;
    mesh.tree().for_each_in_leaves(
        std::span(leaves_.data(), n_leaves_), {from_B.cwiseMin(end_B), from_B.cwiseMax(end_B)},
        [&](std::int32_t triangle) noexcept {
            const SegmentHit hit = meet(prepare_triangle(mesh, triangle), from_B, to_B);
            if (hit.is_before(nearest)) {
                nearest = hit;
            }
        });
    // Beyond the covered part there may be nearer triangles than one that only reaches into it.
    return nearest.t <= part ? nearest : SegmentHit{};
}

}  // namespace fulcrum
