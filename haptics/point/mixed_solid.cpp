#include "haptics/point/mixed_solid.h"

#include <cmath>

namespace fulcrum {

namespace {

// A shape from which the proxy is no more than this many clearances, 1e-8 of its size, is lain on.
constexpr double kLainOn = 100.0;
// Nearer to a surface than this part of the clearance a start has no side.
constexpr double kNoSide = 0.5;

SegmentHit to_segment_hit(const CastHit& hit) noexcept {
    return {.t = hit.t, .triangle = hit.found() ? hit.feature : -1, .side = 1};
}

// As it is seen from `at_W`.
TouchedPlane to_touched(const ObstaclePlane& plane, const Vector3& at_W) noexcept {
    return {.solid = plane.solid,
            .feature = plane.feature,
            .side = 1,
            .normal_W = plane.normal_W,
            .point_W = at_W - plane.gap_m * plane.normal_W,
            .clearance_m = plane.clearance_m};
}

}  // namespace

bool MixedSolid::take_pose(const Pose& pose_W) noexcept {
    MovingSolid* const solid = mesh();
    return solid != nullptr ? solid->take_pose(pose_W) : shape().take_pose(pose_W);
}

SegmentHit MixedSolid::sweep(const Vector3& to_W) noexcept {
    const MovingSolid* const solid = mesh();
    return solid != nullptr ? solid->sweep(to_W) : to_segment_hit(shape().cast(to_W, 0.0, {}));
}

SegmentHit MixedSolid::sweep_nearby(const Vector3& to_W, double reach_m) noexcept {
    MovingSolid* const solid = mesh();
    return solid != nullptr ? solid->sweep_nearby(to_W, reach_m) : sweep(to_W);
}

void MixedSolid::look_ahead(double reach_m) noexcept {
    if (MovingSolid* const solid = mesh(); solid != nullptr) {
        solid->look_ahead(reach_m);
    }
}

std::uint64_t MixedSolid::n_searches() const noexcept {
    const MovingSolid* const solid = mesh();
    return solid != nullptr ? solid->n_searches() : 0;
}

SegmentHit MixedSolid::find_touching() const noexcept {
    if (const MovingSolid* const solid = mesh(); solid != nullptr) {
        return solid->find_touching();
    }
    const ObstaclePlane plane = shape().find_plane(0);
    return std::abs(plane.gap_m) < kNoSide * plane.clearance_m
               ? SegmentHit{.t = 0.0, .triangle = 0, .side = 0}
               : SegmentHit{};
}

TouchedPlane MixedSolid::find_plane(std::int32_t feature, int side) const noexcept {
    const MovingSolid* const solid = mesh();
    return solid != nullptr ? solid->find_plane(feature, side)
                            : to_touched(shape().find_plane(feature), carried_proxy_W());
}

bool MixedSolid::is_over(std::int32_t feature) const noexcept {
    const MovingSolid* const solid = mesh();
    return solid == nullptr || solid->is_over(feature);
}

bool MixedSolid::holds(const Vector3& p_W) const noexcept {
    const MovingSolid* const solid = mesh();
    return solid != nullptr ? solid->holds(p_W) : shape().holds(p_W);
}

bool MixedSolid::is_near(const Vector3& centre_W, double radius_m) const noexcept {
    const MovingSolid* const solid = mesh();
    return solid != nullptr ? solid->is_near(centre_W, radius_m)
                            : shape().is_near(centre_W, radius_m);
}

bool MixedSolid::renew(TouchedPlane& plane) const noexcept {
    if (mesh() != nullptr) {
        return false;
    }
    const ObstaclePlane now = shape().find_plane(plane.feature);
    plane = to_touched(now, carried_proxy_W());
    return now.gap_m > kLainOn * now.clearance_m;
}

}  // namespace fulcrum
