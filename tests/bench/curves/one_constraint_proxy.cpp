#include "tests/bench/curves/one_constraint_proxy.h"

#include <algorithm>

namespace fulcrum::bench {

namespace {

constexpr double kGap_m = 1.0e-9;  // how high above a plane it is held

}  // namespace

void OneConstraintProxy::reset(const Vector3& hand_W) noexcept {
    contact_ = {.position_W = hand_W};
    touching_ = false;
}

const ProxyContact& OneConstraintProxy::step(const Vector3& hand_W,
                                             std::span<const Pose> /*solid_poses_W*/) noexcept {
    Vector3 target = hand_W;
    if (touching_ && normal_.dot(hand_W - point_) < 0.0) {
        target -= normal_ * (normal_.dot(hand_W - point_) - kGap_m);
    }
    const SegmentHit hit = find_nearest_hit(*mesh_, contact_.position_W, target);
    touching_ = touching_ || hit.found();
    if (!hit.found()) {
        contact_.position_W = target;
        const SegmentHit below = find_nearest_hit(*mesh_, target, hand_W);
        touching_ = below.found();
        take_plane(below);
    } else {
        const Vector3 way = target - contact_.position_W;
        take_plane(hit);
        const double fall = -normal_.dot(way);
        contact_.position_W += std::max(0.0, hit.t - (fall > 0.0 ? kGap_m / fall : 0.0)) * way;
    }
    const Vector3 push = contact_.position_W - hand_W;
    contact_.n_constraints = touching_ ? 1 : 0;
    contact_.normal_W = push.squaredNorm() > 0.0 ? Vector3(push.normalized()) : push;
    return contact_;
}

void OneConstraintProxy::take_plane(const SegmentHit& hit) noexcept {
    if (hit.found()) {
        const PreparedTriangle triangle = prepare_triangle(*mesh_, hit.triangle);
        normal_ = triangle.doubled_area.normalized() * (hit.side < 0 ? -1.0 : 1.0);
        point_ = triangle.a;
    }
}

}  // namespace fulcrum::bench
