// A device that is attached to this computer, whose position sensor is watched as an arm's server watches its own: what is frozen or
// shakes is told with the reading, and the loop fades the force (sensor_guard.h; a jump the loop finds itself).
//
// What may lie still for ever is told apart by what is known of its sensor: a mouse, a SpaceMouse, keys push nobody and have no force that a
// frozen place could hold on to, so their SensorLife is all zeros, and nothing is watched. Of a device with motors it is known that a change
// of force moves it; but not where it lies at an end of its way, `stop_D`, for there nothing more can be pushed.
//
// Thread: `read` and `write` on the haptic thread. Cost: a few nanoseconds and the device's own.
// Source: sensor_guard.h.
#pragma once

#include "haptics/device/device.h"
#include "haptics/device/watched/sensor_guard.h"

#include <memory>

namespace fulcrum {

/// What is known of a device's sensor; fixed at load.
struct SensorWatch {
    SensorLife life{};
    Vector3 pushed_D{Vector3::Ones()};  ///< 0 along an axis that has no motor
    /// Half extents, frame D, metres, from which on it may lie at a stop; along an axis of 0 there is none.
    Vector3 stop_D{Vector3::Zero()};
};

class WatchedDevice final : public Device {
  public:
    /// Takes a life that `validate` accepted, and the device.
    WatchedDevice(const SensorWatch& watch, std::unique_ptr<Device> device);
    ~WatchedDevice() override;

    [[nodiscard]] const DeviceTraits& traits() const noexcept override { return device_->traits(); }
    /// The device's reading, with what is wrong with it among its faults.
    [[nodiscard]] bool read(double now_s, DeviceReading& reading) noexcept override;
    [[nodiscard]] bool write(double now_s, const Wrench& wrench_D) noexcept override;
    /// The next reading may be of another clock. Before a loop steps.
    void begin_anew() noexcept { guard_.forget(); }

  private:
    [[nodiscard]] bool is_at_stop(const Vector3& position_D) const noexcept;

    SensorWatch watch_;
    std::unique_ptr<Device> device_;
    SensorGuard guard_;
    Vector3 acted_D_{Vector3::Zero()};  // written last
};

}  // namespace fulcrum
