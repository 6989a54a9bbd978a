#include "haptics/collision/segment_query.h"

#include <algorithm>
#include <limits>

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

bool NearbyTriangles::collect(const CollisionMesh& mesh, const Box& box_B) noexcept {
    begin_ahead(mesh, box_B);
    covers_ = go_on_ahead(mesh, std::numeric_limits<std::int32_t>::max()) == Collecting::done;
    return covers_;
}

void NearbyTriangles::begin_ahead(const CollisionMesh& mesh, const Box& box_B) noexcept {
    ahead_.search.begin(mesh.tree(), box_B);
    ahead_.box_B = box_B;
}

Collecting NearbyTriangles::go_on_ahead(const CollisionMesh& mesh, std::int32_t n_nodes) noexcept {
    if (mesh.tree().go_on(ahead_.search, n_nodes, ahead_.leaves)) {
        return Collecting::goes_on;
    }
    if (ahead_.search.n_found() > kCapacity) {
        return Collecting::too_many;
    }
    leaves_ = ahead_.leaves;
    n_leaves_ = ahead_.search.n_found();
    box_B_ = ahead_.box_B;
    covers_ = true;
    for (std::size_t i = 0; i < n_leaves_; ++i) {
        mesh.prefetch_leaf(leaves_[i]);
    }
    return Collecting::done;
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
                                             const Vector3& to_B, double part) noexcept {
    const Vector3 end_B = part < 1.0 ? Vector3(from_B + part * (to_B - from_B)) : to_B;
    const StepBox steps = mesh.tree().to_steps({from_B.cwiseMin(end_B), from_B.cwiseMax(end_B)});
    SegmentHit nearest;
    const auto take = [&](const PreparedTriangle& triangle) noexcept {
        const SegmentHit hit = meet(triangle, from_B, to_B);
        if (hit.is_before(nearest)) {
            nearest = hit;
        }
    };
    // Back on the way of the last sweep, as after a hit, only the same triangles can be met.
    if (n_asked_ <= kMaxAsked && asked_box_.contains(steps)) {
        std::for_each_n(asked_.begin(), n_asked_, take);
    } else {
        n_asked_ = 0;
        asked_box_ = steps;
        mesh.tree().for_each_in_leaves(
            std::span(leaves_.data(), n_leaves_), steps, [&](std::int32_t index) noexcept {
                const PreparedTriangle triangle = prepare_triangle(mesh, index);
                take(triangle);
                if (n_asked_ < kMaxAsked) {
                    asked_[n_asked_] = triangle;
                }
                ++n_asked_;
            });
    }
    // Beyond the covered part there may be nearer triangles than one that only reaches into it.
    return nearest.t <= part ? nearest : SegmentHit{};
}

}  // namespace fulcrum
