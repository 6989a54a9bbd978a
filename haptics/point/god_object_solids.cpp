// How the proxy keeps its side of solids that move.
#include "haptics/point/god_object.h"
#include "haptics/point/let_through.h"

#include <algorithm>

namespace fulcrum {

namespace {

constexpr int kMaxPushes = 8;  // planes met on the way out from between solids

}  // namespace

template <class Solid>
void GodObjectAmong<Solid>::carry(std::span<const Pose> solid_poses_W) noexcept {
    n_known_ = 0;
    n_sweeps_ = 0;
    leave_solids(std::span(solids_), proxy_W_, goal_W_);
    bool any_moved = false;
    for (std::size_t i = 0; i < std::min(solids_.size(), solid_poses_W.size()); ++i) {
        any_moved = solids_[i].take_pose(solid_poses_W[i]) || any_moved;
    }
    std::array<Vector3, kMaxTouches> anchors_W;
    anchors_W.fill(proxy_W_);
    if (any_moved) {
        for (std::size_t i = 0; i < planes_.count; ++i) {
            TouchedPlane& plane = planes_.plane[i];
            const Solid& solid = solids_[static_cast<std::size_t>(plane.solid)];
            plane = solid.find_plane(plane.feature, plane.side);
            if (i < kMaxTouches) {
                anchors_W[i] = solid.carried_proxy_W();
            }
        }
        follow_touched();
    }
    planes_.tell_carried(proxy_W_, anchors_W, contact_);
}

// With the touched solid, or where it was; else wherever there is room.
template <class Solid>
void GodObjectAmong<Solid>::follow_touched() noexcept {
    const Vector3 wish_W = find_carried_wish(solids_, contact_.solid, proxy_W_);
    Blocker blocker;
    // The wish, then standing still, then going with each solid that is in the way.
    const std::optional<Vector3> carried_W = find_carried_place(
        solids_, wish_W, proxy_W_, [this](const Vector3& to_W) { return find_blocker(to_W); },
        blocker);
    if (carried_W) {
        accept(*carried_W);
    } else if (!place_between(wish_W, blocker)) {
        ++n_squeezed_;
        accept(wish_W);
        give_way(std::span(solids_), wish_W, planes_);
    }
}

// Out of the way of all: the point nearest to the wish in front of every plane met so far, until nothing is met.
template <class Solid>
bool GodObjectAmong<Solid>::place_between(const Vector3& wish_W, const Blocker& first) noexcept {
    Planes planes = planes_;
    Blocker blocker = first;
    for (int push = 0; push < kMaxPushes && planes.count < kMaxPlanes; ++push) {
        planes.plane[planes.count++] = solids_[static_cast<std::size_t>(blocker.solid)].find_plane(
            blocker.hit.triangle, blocker.hit.side);
        const Vector3 candidate_W = wish_W + constrain(Vector3::Zero(), wish_W, planes);
        blocker = find_blocker(candidate_W);
        if (blocker.solid == kNoBody) {
            accept(candidate_W);
            return true;
        }
    }
    return false;
}

template <class Solid>
typename GodObjectAmong<Solid>::Blocker GodObjectAmong<Solid>::find_blocker(
    const Vector3& to_W) noexcept {
    for (std::size_t i = 0; i < solids_.size(); ++i) {
        const SegmentHit hit = solids_[i].lets_through() ? SegmentHit{} : solids_[i].sweep(to_W);
        if (hit.found()) {
            return {static_cast<std::int32_t>(i), hit};
        }
    }
    return {};
}

template <class Solid>
void GodObjectAmong<Solid>::accept(const Vector3& proxy_W) noexcept {
    proxy_W_ = proxy_W;
    for (Solid& solid : solids_) {
        solid.put_proxy(proxy_W);
    }
}

// A start exactly in a surface has no side: it gets the front's, or whichever is free.
template <class Solid>
void GodObjectAmong<Solid>::leave_surface() noexcept {
    const auto find_touching = [this]() noexcept -> Blocker {
        for (std::size_t i = 0; i < solids_.size(); ++i) {
            const SegmentHit hit =
                solids_[i].lets_through() ? SegmentHit{} : solids_[i].find_touching();
            if (hit.found()) {
                return {static_cast<std::int32_t>(i), hit};
            }
        }
        return {};
    };
    const Blocker touching = find_touching();
    if (touching.solid == kNoBody) {
        return;
    }
    const TouchedPlane plane =
        solids_[static_cast<std::size_t>(touching.solid)].find_plane(touching.hit.triangle, 1);
    const Vector3 start_W = proxy_W_;
    for (const double clearances : {1.0, -1.0, 16.0, -16.0}) {
        accept(start_W + clearances * plane.clearance_m * plane.normal_W);
        if (find_touching().solid == kNoBody) {
            return;
        }
    }
}

template class GodObjectAmong<MovingSolid>;
template class GodObjectAmong<MixedSolid>;

}  // namespace fulcrum
