#include "haptics/loop/touch_velocity.h"

#include <algorithm>

namespace fulcrum {

std::span<const Vector3> TouchVelocity::step(const ProxyContact& contact,
                                             std::span<const Pose> solid_poses_W,
                                             const Hand& hand) noexcept {
    const std::span<const SolidTouch> touches = contact.active();
    forget_left(touches);
    velocities_W_.fill(hand.velocity.velocity());
    for (std::size_t i = 0; i < touches.size(); ++i) {
        const auto solid = static_cast<std::size_t>(touches[i].solid);
        if (touches[i].solid >= 0 && solid < solid_poses_W.size()) {
            velocities_W_[i] =
                follow(touches[i].solid, solid_poses_W[solid], contact.position_W, hand);
        }
    }
    return {velocities_W_.data(), std::max<std::size_t>(touches.size(), 1)};
}

void TouchVelocity::keep(std::span<const Pose> solid_poses_W, double stamp_s) noexcept {
    n_kept_ = std::min(solid_poses_W.size(), kept_W_.size());
    std::copy_n(solid_poses_W.begin(), n_kept_, kept_W_.begin());
    kept_s_ = stamp_s;
}

void TouchVelocity::put(std::uint32_t solids, std::span<const Pose> solid_poses_W) noexcept {
    for (std::size_t i = 0; i < std::min(n_kept_, solid_poses_W.size()); ++i) {
        if ((solids >> i & 1U) != 0) {
            kept_W_[i] = solid_poses_W[i];
        }
    }
    for (Touched& touched : std::span(solids_.data(), n_solids_)) {
        const auto solid = static_cast<std::size_t>(touched.solid);
        if ((solids >> solid & 1U) != 0 && solid < solid_poses_W.size()) {
            touched.pose_W = solid_poses_W[solid];
            touched.moves = false;
        }
    }
}

// What is touched no more.
void TouchVelocity::forget_left(std::span<const SolidTouch> touches) noexcept {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < n_solids_; ++i) {
        if (std::ranges::find(touches, solids_[i].solid, &SolidTouch::solid) != touches.end()) {
            if (kept != i) {
                solids_[kept] = solids_[i];
            }
            ++kept;
        }
    }
    n_solids_ = kept;
}

// Where the solid was in the round before, as far as that is known.
void TouchVelocity::begin(Touched& touched, std::int32_t solid, const Pose& pose_W) const noexcept {
    const auto index = static_cast<std::size_t>(solid);
    touched.solid = solid;
    touched.pose_W = index < n_kept_ ? kept_W_[index] : pose_W;
    touched.stamp_s = kept_s_;
    touched.moves = false;
}

// The velocity against one solid, whose matter at `place_W` is what counts.
Vector3 TouchVelocity::follow(std::int32_t solid, const Pose& pose_W, const Vector3& place_W,
                              const Hand& hand) noexcept {
    std::size_t i = 0;
    while (i < n_solids_ && solids_[i].solid != solid) {
        ++i;
    }
    Touched& touched = solids_[i];
    if (i == n_solids_) {
        ++n_solids_;
        begin(touched, solid, pose_W);
    }
    if (!touched.moves && !is_same(touched.pose_W, pose_W)) {
        touched.moves = true;
        touched.carried_W.setZero();
        touched.matter = VelocityEstimator(hand.velocity.settings());
        touched.matter.step(touched.carried_W, touched.stamp_s);
    }
    if (touched.moves) {
        touched.carried_W += place_W - touched.pose_W * (pose_W.inverse() * place_W);
        touched.matter.step(touched.carried_W, hand.stamp_s);
        touched.pose_W = pose_W;
    }
    touched.stamp_s = hand.stamp_s;
    return touched.moves ? Vector3(hand.velocity.velocity() - touched.matter.velocity())
                         : hand.velocity.velocity();
}

}  // namespace fulcrum
