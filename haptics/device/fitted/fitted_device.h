// Any device as it stands before one person: its middle, its axes, its buttons, and a clutch.
//
//   p_D = A (p_A - m) + s        q_D = P q_A P^-1 c        f_A = A^T f_D        t_A = P^T t_D        (axis_order.h)
//   A, P, m   axes and middle, fixed           s, c   how far, and how turned, the clutch has carried the hand on
// Clutch: while its button is held the pose stays as it was when it was pressed, the arm moves freely and Fault::clutched is told, by
// which the last gate fades the force and keeps it away. When it is let go, s and c become what makes the pose go on from there:
//   s = p_held - A (p_A - m)     c = (P q_A P^-1)^-1 q_held
// so that nothing jumps, and the gate begins anew: after calm, softly. c stands behind, so that a turn about an axis of the room stays one
// about that axis, and torques need not be turned. Lengths are not scaled here, for the loop counts energy in the hand's own metres: the
// scale is the workspace's (loop/workspace.h). All that is here is rigid: |f_A| = |f_D| and f_A . v_A = f_D . v_D.
// Buttons: for a left hand the first two are exchanged; of what comes of that the clutch's is kept and not told on.
//
// Limits come behind it: the loop's gate and the arm's own see what is to be given, and no bit of it is larger than before; a part of it is
// written where that was asked for.
// Thread: `read` and `write` on the haptic thread. Cost: some 20 ns.
// Source: J. Dominjon, A. Lecuyer, J.-M. Burkhardt, G. Andrade-Barroso, S. Richir 2005, The "bubble" technique: interacting with large
// virtual environments using haptic devices with limited workspace, World Haptics: clutching, as what is compared with.
#pragma once

#include "haptics/base/error.h"
#include "haptics/device/device.h"
#include "haptics/device/fitted/axis_order.h"

#include <cstdint>
#include <memory>

namespace fulcrum {

inline constexpr double kFurthestMiddle_m = 0.5;  ///< along each axis
inline constexpr int kMostClutchButton = 8;

/// How a device stands before who holds it; fixed at load.
struct DeviceFit {
    AxisOrder axes{};
    /// The arm's place, in its own axes, that is the middle of the scene's room; metres, each within kFurthestMiddle_m.
    Vector3 middle_A{Vector3::Zero()};
    int clutch_button = 0;     ///< 1 to kMostClutchButton, as people count; 0: none
    bool left_handed = false;  ///< the first two buttons are exchanged
};

/// Refuses a fit outside the ranges named above, NaN included.
[[nodiscard]] Expected<void> validate(const DeviceFit& fit);

class FittedDevice final : public Device {
  public:
    /// Takes a fit that `validate` accepted, and the device.
    FittedDevice(const DeviceFit& fit, std::unique_ptr<Device> device);
    ~FittedDevice() override;

    /// The device's own: nothing of it is larger or smaller. Without force once `give_no_force` was called.
    [[nodiscard]] const DeviceTraits& traits() const noexcept override { return traits_; }
    /// From now on the device is written this part of each wrench, 0 to 1; anything else counts as 0. For one of unknown strength, until it
    /// was tried. Before a loop steps.
    void give_part(double part) noexcept;
    /// From now on whatever is written is no force, and there is no way back. Before a loop steps.
    void give_no_force() noexcept;
    /// What is no reading is told on as it came.
    [[nodiscard]] bool read(double now_s, DeviceReading& reading) noexcept override;
    [[nodiscard]] bool write(double now_s, const Wrench& wrench_D) noexcept override;

  private:
    [[nodiscard]] std::uint32_t exchange(std::uint32_t buttons) const noexcept;
    void hold_or_follow(bool is_clutched, DeviceReading& reading) noexcept;

    DeviceFit fit_;
    std::uint32_t clutch_bit_;
    std::unique_ptr<Device> device_;
    DeviceTraits traits_;
    double part_ = 1.0;  // of each wrench; 0 once there is to be none
    Vector3 shift_D_{Vector3::Zero()};
    Quaternion turn_{Quaternion::Identity()};
    bool is_clutched_ = false;
    bool has_pose_ = false;
    Pose held_D_{};  // told last
};

}  // namespace fulcrum
