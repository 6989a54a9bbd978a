// The step path of fitted_device.h.
#include "haptics/device/fitted/fitted_device.h"

namespace fulcrum {

std::uint32_t FittedDevice::exchange(std::uint32_t buttons) const noexcept {
    constexpr std::uint32_t kFirst = 1U;
    constexpr std::uint32_t kSecond = 2U;
    if (!fit_.left_handed) {
        return buttons;
    }
    return (buttons & ~(kFirst | kSecond)) | (buttons & kFirst) << 1U | (buttons & kSecond) >> 1U;
}

// `reading` as the arm has it becomes as the scene has it.
void FittedDevice::hold_or_follow(bool is_clutched, DeviceReading& reading) noexcept {
    const Vector3 position_D = fit_.axes.turn(Vector3(reading.pose_D.position - fit_.middle_A));
    const Quaternion orientation_D = fit_.axes.turn(reading.pose_D.orientation);
    if (is_clutched_ && has_pose_) {
        // From where it was held, wherever the arm is now.
        shift_D_ = held_D_.position - position_D;
        turn_ = (orientation_D.conjugate() * held_D_.orientation).normalized();
    }
    is_clutched_ = is_clutched;
    reading.pose_D = {position_D + shift_D_, (orientation_D * turn_).normalized()};
    held_D_ = reading.pose_D;
    has_pose_ = true;
    if (is_clutched) {
        reading.faults |= Fault::clutched;
    }
}

bool FittedDevice::read(double now_s, DeviceReading& reading) noexcept {
    if (!device_->read(now_s, reading)) {
        return false;
    }
    const std::uint32_t buttons = exchange(reading.buttons);
    if (is_reading(reading)) {
        hold_or_follow((buttons & clutch_bit_) != 0, reading);
    }
    reading.buttons = buttons & ~clutch_bit_;
    return true;
}

bool FittedDevice::write(double now_s, const Wrench& wrench_D) noexcept {
    if (part_ == 0.0) {
        return device_->write(now_s, Wrench{});
    }
    const Wrench wrench_A = fit_.axes.turn_back(wrench_D);
    return device_->write(now_s, {part_ * wrench_A.force, part_ * wrench_A.torque});
}

}  // namespace fulcrum
