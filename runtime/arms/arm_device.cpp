#include "runtime/arms/arm_device.h"

namespace fulcrum::runtime {

bool ArmDevice::read(double now_s, DeviceReading& reading) noexcept {
    (void)port_->sample.take();
    const ArmSample& sample = port_->sample.value();
    if (!sample.is_there) {
        return false;
    }
    reading = {.stamp_s = now_s - (monotonic_now_s() - sample.stamp_s),
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
