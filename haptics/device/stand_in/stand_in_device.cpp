// The step path of stand_in_device.h.
#include "haptics/device/stand_in/stand_in_device.h"

namespace fulcrum {

bool StandInDevice::read(double now_s, DeviceReading& reading) noexcept {
    if (!device_->read(now_s, reading)) {
        return read_pointer(now_s, reading);
    }
    if (stands_in()) {
        give_back(reading);
    }
    if (is_reading(reading)) {
        has_pose_ = true;
        held_D_ = reading.pose_D;
        seen_s_ = now_s;
    }
    return true;
}

void StandInDevice::give_back(DeviceReading& reading) noexcept {
    stands_in_.store(false, std::memory_order_release);
    reading.faults |= Fault::clutched;
}

bool StandInDevice::read_pointer(double now_s, DeviceReading& reading) noexcept {
    if (!has_pose_ || !(now_s - seen_s_ >= kPatience_s)) {
        return false;
    }
    const bool begins = !stands_in();
    if (begins) {
        pointer_->put(now_s, held_D_.position);
        is_muted_ = true;
        stands_in_.store(true, std::memory_order_release);
    }
    if (!pointer_->read(now_s, reading)) {
        return false;
    }
    reading.pose_D.orientation = held_D_.orientation;
    reading.faults = begins ? Fault::clutched : Fault::none;
    return true;
}

bool StandInDevice::write(double now_s, const Wrench& wrench_D) noexcept {
    if (stands_in()) {
        (void)device_->write(now_s, Wrench{});
        return pointer_->write(now_s, wrench_D);
    }
    is_muted_ = is_muted_ && !(wrench_D.force.isZero(0.0) && wrench_D.torque.isZero(0.0));
    return device_->write(now_s, is_muted_ ? Wrench{} : wrench_D);
}

}  // namespace fulcrum
