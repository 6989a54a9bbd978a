#include "haptics/loop/touch_motion.h"

#include <algorithm>

namespace fulcrum {
namespace {

constexpr double kEvenedOver = 4.0;  // rounds

bool asks(const SolidPlan& solid) noexcept {
    return solid.surface.texture.any() || solid.surface.transient.any() || solid.surface.audible;
}

}  // namespace

bool TouchMotion::is_needed(const HapticPlan& plan) noexcept {
    return std::ranges::any_of(plan.solids, asks);
}

TouchMotion::TouchMotion(const HapticPlan& plan) {
    if (const auto* sphere = std::get_if<SphereShape>(&plan.proxy.cursor); sphere != nullptr) {
        cursor_radius_m_ = sphere->radius_m;
    }
    solids_.resize(plan.solids.size());
    for (std::size_t i = 0; i < solids_.size(); ++i) {
        solids_[i].asks = asks(plan.solids[i]);
    }
}

void TouchMotion::forget() noexcept {
    for (Solid& solid : solids_) {
        solid.now = {};
        solid.n_poses = 0;
    }
    tap_ = {};
}

void TouchMotion::step(std::span<const TouchForce> touches, std::span<const Pose> solid_poses_W,
                       const HandMotion& hand) noexcept {
    tap_ = {};
    for (std::size_t i = 0; i < std::min(solids_.size(), solid_poses_W.size()); ++i) {
        Solid& solid = solids_[i];
        if (!solid.asks) {
            continue;
        }
        const auto found =
            std::ranges::find(touches, static_cast<std::int32_t>(i), &TouchForce::solid);
        if (found == touches.end()) {
            solid.now = {};
        } else {
            touch(solid, *found, solid_poses_W[i], hand);
        }
        solid.poses_W[next_] = solid_poses_W[i];
        solid.n_poses = std::min(solid.n_poses + 1, kRounds);
    }
    next_ = (next_ + 1) % kRounds;
}

void TouchMotion::touch(Solid& solid, const TouchForce& touch, const Pose& pose_W,
                        const HandMotion& hand) noexcept {
    const Quaternion turn_BW = pose_W.orientation.conjugate();
    const Vector3 place_B =
        turn_BW * (hand.proxy_W - cursor_radius_m_ * touch.normal_W - pose_W.position);
    if (solid.now.touched) {
        solid.now.stroke_B += (place_B - solid.now.place_B - solid.now.stroke_B) / kEvenedOver;
    } else {
        const Vector3 against_W = hand.velocity_W - velocity_of(solid, pose_W, place_B, hand.dt_s);
        const double away_m_per_s = against_W.dot(touch.normal_W);
        solid.now.stroke_B = turn_BW * (hand.dt_s * (against_W - away_m_per_s * touch.normal_W));
        // Of two taps in one round the faster counts.
        if (-away_m_per_s > std::max(kSlowestTap_m_per_s, tap_.speed_m_per_s)) {
            tap_ = {touch.solid, -away_m_per_s};
        }
    }
    Index view = 0;
    (turn_BW * touch.normal_W).cwiseAbs().maxCoeff(&view);
    solid.now.view = static_cast<std::size_t>(view);
    solid.now.touched = true;
    solid.now.place_B = place_B;
    solid.now.slip_m_per_s = hand.dt_s > 0.0 ? solid.now.stroke_B.norm() / hand.dt_s : 0.0;
}

Vector3 TouchMotion::velocity_of(const Solid& solid, const Pose& pose_W, const Vector3& place_B,
                                 double dt_s) const noexcept {
    if (solid.n_poses < kRounds || !(dt_s > 0.0)) {
        return Vector3::Zero();
    }
    const Vector3 way_W = pose_W * place_B - solid.poses_W[next_] * place_B;
    return way_W / (static_cast<double>(kRounds) * dt_s);
}

}  // namespace fulcrum
