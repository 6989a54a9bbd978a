#include "haptics/collision/segment_query.h"

#include <algorithm>
#include <limits>

namespace fulcrum {

namespace {

// Triangles around a segment are taken in less far after they were too many, and further again while they are few.
constexpr double kLeastAround = 0x1.0p-10;
constexpr double kAroundGrowth = 1.25;

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

bool NearbyTriangles::collect(const CollisionMesh& mesh, const Box& box_B) noexcept {
    begin_ahead(mesh, box_B);
    go_on_ahead(mesh, std::numeric_limits<std::int32_t>::max());
    take_ahead();
    return present_.done;
}

void NearbyTriangles::begin_ahead(const CollisionMesh& mesh, const Box& box_B) noexcept {
    ahead_.search.begin(mesh.tree(), box_B);
    ahead_.nearby.box_B = box_B;
    ahead_.nearby.done = false;
}

Collecting NearbyTriangles::go_on_ahead(const CollisionMesh& mesh, std::int32_t n_nodes) noexcept {
    Nearby& next = ahead_.nearby;
    if (mesh.tree().go_on(ahead_.search, n_nodes, next.leaves)) {
        return Collecting::goes_on;
    }
    if (ahead_.search.n_found() > kCapacity) {
        return Collecting::too_many;
    }
    next.n_leaves = n_leaves_ = ahead_.search.n_found();
    next.done = true;
    for (std::size_t i = 0; i < next.n_leaves; ++i) {
        mesh.prefetch_leaf(next.leaves[i]);
    }
    return Collecting::done;
}

void NearbyTriangles::take_ahead() noexcept {
    present_ = ahead_.nearby;
    ahead_.nearby.done = false;
}

double NearbyTriangles::cover(const Vector3& from_B, const Vector3& to_B) noexcept {
    const double part = present_.find_covered_part(from_B, to_B);
    if (part == 1.0 || !(ahead_.nearby.find_covered_part(from_B, to_B) > part)) {
        return part;
    }
    take_ahead();
    return present_.find_covered_part(from_B, to_B);
}

double NearbyTriangles::Nearby::find_covered_part(const Vector3& from_B,
                                                  const Vector3& to_B) const noexcept {
    if (!covers(from_B)) {
        return 0.0;
    }
    double part = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double rate = to_B[axis] - from_B[axis];
        const double room =
            rate > 0.0 ? box_B.upper[axis] - from_B[axis] : from_B[axis] - box_B.lower[axis];
        if (std::abs(rate) * part > room) {
            part = room / std::abs(rate);
        }
    }
    constexpr double kEarly = 1.0 - 1.0e-9;  // by far more than rounding
    return part < 1.0 ? part * kEarly : 1.0;
}

SegmentHit NearbyTriangles::find_nearest_hit(const CollisionMesh& mesh, const Vector3& from_B,
                                             const Vector3& to_B, double part,
                                             double around_m) noexcept {
    const Vector3 end_B = part < 1.0 ? Vector3(from_B + part * (to_B - from_B)) : to_B;
    SegmentHit nearest;
    // Near the last segment, as back on its way after a hit, only the same triangles can be met.
    if (asked_fits_ && asked_box_B_.contains(from_B) && asked_box_B_.contains(end_B)) {
        nearest = asked_.find_nearest_hit(from_B, to_B);
    } else {
        const Vector3 around = Vector3::Constant(around_ * around_m);
        const Box wider{from_B.cwiseMin(end_B) - around, from_B.cwiseMax(end_B) + around};
        nearest = ask_within(mesh, wider.cut_to(present_.box_B), from_B, to_B);
    }
    // Beyond the covered part there may be nearer triangles than one that only reaches into it.
    return nearest.t <= part ? nearest : SegmentHit{};
}

SegmentHit NearbyTriangles::ask_within(const CollisionMesh& mesh, const Box& box_B,
                                       const Vector3& from_B, const Vector3& to_B) noexcept {
    SegmentHit nearest;
    const auto ask = [&]() noexcept {
        const SegmentHit hit = asked_.find_nearest_hit(from_B, to_B);
        nearest = hit.is_before(nearest) ? hit : nearest;
    };
    asked_.clear();
    asked_box_B_ = box_B;
    asked_fits_ = true;
    mesh.tree().for_each_in_leaves(std::span(present_.leaves.data(), present_.n_leaves),
                                   mesh.tree().to_steps(box_B),
                                   [&](std::int32_t triangle) noexcept {
                                       if (asked_.is_full()) {
                                           ask();
                                           asked_.clear();
                                           asked_fits_ = false;
                                       }
                                       asked_.add(prepare_triangle(mesh, triangle));
                                   });
    ask();
    if (!asked_fits_) {
        around_ = std::max(kLeastAround, 0.5 * around_);
    } else if (asked_.size() <= TriangleBatch::kCapacity / 4) {
        around_ = std::min(1.0, kAroundGrowth * around_);
    }
    return nearest;
}

}  // namespace fulcrum
