#include "runtime/arms/arm_device.h"

#include <algorithm>

namespace fulcrum::runtime {

bool ArmDevice::read(double now_s, DeviceReading& reading) noexcept {
    (void)port_->sample.take();
    const ArmSample& sample = port_->sample.value();
    if (!sample.is_there) {
        return false;
    }
    // A round that looks late must not make the same pose older than it was: a stamp that went back is a fault.
    const double ahead_s = now_s - monotonic_now_s();
    clock_ahead_s_ = now_s < read_s_ ? ahead_s : std::max(clock_ahead_s_, ahead_s);
    read_s_ = now_s;
    reading = {.stamp_s = sample.stamp_s + clock_ahead_s_,
               .pose_D = sample.pose_D,
               .buttons = sample.buttons,
               .faults = sample.faults};
    return true;
}

bool ArmDevice::write(double /*now_s*/, const Wrench& wrench_D) noexcept {
    port_->order.publish({monotonic_now_s(), wrench_D});
    return port_->sample.value().is_there;
}

}  // namespace fulcrum::runtime
