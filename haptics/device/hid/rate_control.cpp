// The step path of rate_control.h.
#include "haptics/device/hid/rate_control.h"

#include "haptics/math/rotation.h"

#include <algorithm>
#include <cmath>

namespace fulcrum::hid {
namespace {

Vector3 shape_all(const RateSettings& settings, const Vector3& cap_D) noexcept {
    return {shape_cap(settings, cap_D.x()), shape_cap(settings, cap_D.y()),
            shape_cap(settings, cap_D.z())};
}

}  // namespace

double shape_cap(const RateSettings& settings, double cap) noexcept {
    const double beyond = std::abs(cap) - settings.dead_zone;
    if (!(beyond > 0.0)) {
        return 0.0;
    }
    const double share = std::min(beyond / (1.0 - settings.dead_zone), 1.0);
    return std::copysign(std::pow(share, settings.exponent), cap);
}

const Pose& RateControl::step(const CapState& cap, const Vector3& force_D, double dt_s) noexcept {
    const double held_s = dt_s > 0.0 ? std::min(dt_s, kLongestRateStep_s) : 0.0;
    Vector3 velocity_D = settings_.max_speed_m_per_s * shape_all(settings_, cap.push_D);

    // What opposes the way takes speed from it.
    const double speed_m_per_s = velocity_D.norm();
    if (speed_m_per_s > 0.0 && is_finite(force_D)) {
        const double against_N = std::max(0.0, -force_D.dot(velocity_D) / speed_m_per_s);
        velocity_D *= std::max(0.0, 1.0 - against_N / settings_.full_push_N);
    }
    const Vector3 corner_D = Vector3::Constant(settings_.half_extent_m);
    pose_D_.position =
        (pose_D_.position + held_s * velocity_D).cwiseMax(-corner_D).cwiseMin(corner_D);

    const Vector3 turn_rad_per_s = settings_.max_turn_rad_per_s * shape_all(settings_, cap.turn_D);
    pose_D_.orientation = compute_exp(held_s * turn_rad_per_s) * pose_D_.orientation;
    pose_D_.orientation.normalize();
    return pose_D_;
}

}  // namespace fulcrum::hid
