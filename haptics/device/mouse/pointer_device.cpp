// The step path of pointer_device.h.
#include "haptics/device/mouse/pointer_device.h"

#include <cmath>

namespace fulcrum {

bool PointerDevice::read(double now_s, DeviceReading& reading) noexcept {
    const bool fresh = target_.take();
    const PointerTarget& target = target_.value();
    if (is_finite(target.position_D) && (started_ || fresh)) {
        const Vector3 pointed_D =
            target.position_D.cwiseMax(-settings_.half_extent_D).cwiseMin(settings_.half_extent_D);
        const Vector3 wanted_D = pointed_D + settings_.sag_m_per_N * force_D_;
        // The first target is where the hand begins.
        if (!started_ || settings_.smoothing == PointerSmoothing::none) {
            position_D_ = wanted_D;
            started_ = true;
        } else if (now_s > now_s_) {
            follow(wanted_D, now_s - now_s_);
        }
    }
    now_s_ = now_s;
    reading.stamp_s = now_s;
    reading.pose_D = {position_D_, Quaternion::Identity()};
    reading.buttons = target.buttons;
    return true;
}

void PointerDevice::put(double now_s, const Vector3& position_D) noexcept {
    now_s_ = now_s;
    position_D_ = position_D;
    velocity_D_.setZero();
    force_D_.setZero();
    started_ = true;
}

void PointerDevice::follow(const Vector3& target_D, double dt_s) noexcept {
    const double w = settings_.natural_rad_per_s / (1.0 + settings_.slow_per_N * force_D_.norm());
    const double decay = std::exp(-w * dt_s);
    const Vector3 away_D = position_D_ - target_D;
    const Vector3 slope_D = velocity_D_ + w * away_D;
    const Vector3 next_D = target_D + decay * (away_D + slope_D * dt_s);
    velocity_D_ = decay * (velocity_D_ - w * slope_D * dt_s);
    // No faster than a hand, whatever the pointer did.
    const double reach_m = settings_.max_speed_m_per_s * dt_s;
    const Vector3 way_D = next_D - position_D_;
    const double way_m = way_D.norm();
    if (way_m > reach_m) {
        velocity_D_ = way_D * (settings_.max_speed_m_per_s / way_m);
        position_D_ += way_D * (reach_m / way_m);
    } else {
        position_D_ = next_D;
    }
}

bool PointerDevice::write(double /*now_s*/, const Wrench& wrench_D) noexcept {
    const bool usable = is_finite(wrench_D);
    force_D_ = usable ? wrench_D.force : Vector3::Zero();
    return usable;
}

}  // namespace fulcrum
