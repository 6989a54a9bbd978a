#include "haptics/collision/segment_query.h"

#include <algorithm>

namespace fulcrum {

namespace {

// Where a segment that starts in the box leaves it, taken a little too early.
double find_leaving_t(const Box& box, const Vector3& from, const Vector3& to) noexcept {
    constexpr double early = 1.0 - 1.0e-9;  // far above the rounding of t
    double t_leave = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double rate = to[axis] - from[axis];
        const double room =
            rate > 0.0 ? box.upper[axis] - from[axis] : from[axis] - box.lower[axis];
        if (std::abs(rate) * t_leave > room) {
            t_leave = room / std::abs(rate);
        }
    }
    return t_leave * early;
}

}  // namespace

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
    count_ = 0;
    covers_ = true;
    box_B_ = box_B;
    mesh.tree().for_each_in_box(box_B, [&](std::int32_t triangle) noexcept {
        if (count_ == kCapacity) {
            covers_ = false;
            return;
        }
        triangles_[count_++] = prepare_triangle(mesh, triangle);
    });
}

SegmentHit NearbyTriangles::find_nearest_hit(const CollisionMesh& mesh, const Vector3& from_B,
                                             const Vector3& to_B) const noexcept {
    SegmentHit nearest;
    for (std::size_t i = 0; i < count_; ++i) {
        const SegmentHit hit = meet(triangles_[i], from_B, to_B);
        if (hit.is_before(nearest)) {
            nearest = hit;
        }
    }
    // Beyond the box there may be nearer triangles than one that only reaches into it.
    const bool within = box_B_.contains(to_B) || nearest.t <= find_leaving_t(box_B_, from_B, to_B);
    return within ? nearest : fulcrum::find_nearest_hit(mesh, from_B, to_B);
}

}  // namespace fulcrum
