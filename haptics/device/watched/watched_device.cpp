#include "haptics/device/watched/watched_device.h"

namespace fulcrum {

bool WatchedDevice::read(double now_s, DeviceReading& reading) noexcept {
    if (!device_->read(now_s, reading)) {
        guard_.forget();
        return false;
    }
    const Vector3& position_D = reading.pose_D.position;
    if (is_at_stop(position_D)) {
        guard_.forget();
        return true;
    }
    reading.faults |= guard_.step(position_D, reading.stamp_s, acted_D_);
    return true;
}

bool WatchedDevice::write(double now_s, const Wrench& wrench_D) noexcept {
    acted_D_ = wrench_D.force.cwiseProduct(watch_.pushed_D);
    return device_->write(now_s, wrench_D);
}

bool WatchedDevice::is_at_stop(const Vector3& position_D) const noexcept {
    for (Index i = 0; i < 3; ++i) {
        if (watch_.stop_D[i] > 0.0 && std::abs(position_D[i]) >= watch_.stop_D[i]) {
            return true;
        }
    }
    return false;
}

}  // namespace fulcrum
