// The step path of hid_hand.h.
#include "haptics/device/hid/hid_hand.h"

#include "haptics/base/clock.h"

namespace fulcrum::hid {
namespace {

// The reader hands over every kReadWait_ms, whether or not the device has spoken.
constexpr double kHeldUp_s = 0.02;

}  // namespace

bool HidHand::read(double now_s, DeviceReading& reading) noexcept {
    port_->sample.take();
    const HidSample& sample = port_->sample.value();
    const double dt_s = has_read_ ? now_s - now_s_ : 0.0;
    now_s_ = now_s;
    has_read_ = true;
    const double monotonic_s = monotonic_now_s();
    if (!sample.is_there || monotonic_s - sample.stamp_s > kHeldUp_s) {
        return false;
    }
    if (has_force() && sample.repeats_itself &&
        monotonic_s - sample.reported_s > settings_.stick_silence_s) {
        return false;
    }
    if (is_cap_) {
        move_by_cap(sample, monotonic_s, dt_s);
    } else {
        const Vector3& reach_D = settings_.stick_pointer.half_extent_D;
        pointed_.position_D = sample.stick.place.cwiseProduct(reach_D);
        pointed_.buttons = sample.stick.buttons;
    }
    target_.publish(pointed_);
    const bool is_read = pointer_.read(now_s, reading);
    reading.pose_D.orientation = rate_.pose_D().orientation;
    return is_read;
}

void HidHand::move_by_cap(const HidSample& sample, double monotonic_s, double dt_s) noexcept {
    const bool is_silent = monotonic_s - sample.reported_s > settings_.cap_silence_s;
    CapState cap = sample.cap;
    if (is_silent) {
        cap.push_D.setZero();
        cap.turn_D.setZero();
    }
    pointed_.position_D = rate_.step(cap, force_D_, dt_s).position;
    pointed_.buttons = cap.buttons;
}

bool HidHand::write(double now_s, const Wrench& wrench_D) noexcept {
    const bool usable = pointer_.write(now_s, wrench_D);
    force_D_ = usable ? wrench_D.force : Vector3::Zero();
    if (!traits_.renders_force) {
        return usable;
    }
    const double monotonic_s = monotonic_now_s();
    port_->force.publish({monotonic_s, force_D_.x() / settings_.full_force_N,
                          force_D_.y() / settings_.full_force_N});
    return usable && port_->takes_force() && port_->overdue_s(monotonic_s) <= kOverdue_s;
}

}  // namespace fulcrum::hid
