// A thing that a hand holds: gives poses, takes wrenches. Every kind (simulated, mouse, replay, an arm over the network, HID)
// stands behind this interface.
//
// Thread: `read` and `write` are called by the haptic loop alone; they neither wait nor allocate.
#pragma once

#include "haptics/base/fault.h"
#include "haptics/math/spatial.h"

#include <cmath>
#include <cstdint>
#include <string>

namespace fulcrum {

/// What a device reports at one instant, in its own base frame D.
struct DeviceReading {
    double stamp_s = 0.0;       ///< when the pose was measured, on the run's clock
    Pose pose_D{};              ///< metres
    std::uint32_t buttons = 0;  ///< one bit a button
    Fault faults =
        Fault::none;  ///< what the device itself has noticed, such as a stop pressed at it
};

/// False for what was garbled on its way: a number that is none, or a quaternion that is no turn.
[[nodiscard]] inline bool is_reading(const DeviceReading& reading) noexcept {
    constexpr double kUnitTolerance = 1.0e-3;
    return is_finite(reading.pose_D) && std::isfinite(reading.stamp_s) &&
           std::abs(reading.pose_D.orientation.coeffs().norm() - 1.0) <= kUnitTolerance;
}

/// What a device can do; fixed after it was opened.
struct DeviceTraits {
    std::string name;            ///< for people, e.g. "simulated hand"
    bool renders_force = false;  ///< false for a mouse: its forces are shown and heard instead
    double max_force_N = 0.0;    ///< the most it can give continuously; 0 when it renders none
    double max_torque_Nm = 0.0;
    double position_resolution_m =
        0.0;  ///< encoder step; 0 when it is finer than 1e-5 m or unknown
    /// Its own viscous friction at the handle, the least there is anywhere; 0 when it is unknown.
    double damping_Ns_per_m = 0.0;
    double mass_kg = 0.0;  ///< felt at the handle; 0 when it is unknown
    /// Half extents of the box that the handle can reach, metres; 0 when it is unknown, or as large as the scene wants it.
    Vector3 reach_m{Vector3::Zero()};
};

class Device {
  public:
    Device() = default;
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;
    virtual ~Device() = default;

    [[nodiscard]] virtual const DeviceTraits& traits() const noexcept = 0;
    /// The newest pose; false when the device gave none (the loop then counts a device_read fault).
    [[nodiscard]] virtual bool read(double now_s, DeviceReading& reading) noexcept = 0;
    /// Renders the wrench (newtons, newton metres, frame D) until the next call; false when it could not.
    [[nodiscard]] virtual bool write(double now_s, const Wrench& wrench_D) noexcept = 0;
};

}  // namespace fulcrum
