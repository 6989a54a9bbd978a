// A mouse as a hand: the pointer moves in a plane, the wheel moves in depth. It renders no force; what
// would be felt is drawn and heard instead.
//
//   none                 the pose is the newest target
//   critically_damped    x'' = w^2 (x_target - x) - 2 w x', exact over each step with constant target;
//                        with y = x - x_target:  y(t) = e^(-wt) (y0 + (v0 + w y0) t)
//                                                v(t) = e^(-wt) (v0 - w (v0 + w y0) t)
//                        and |v| held to max_speed
// A window moves the pointer 60 times a second; the loop reads it 1000 times, and would see jumps.
//
// Thread: `read` and `write` on the haptic thread; the window publishes targets. Cost: about 20 ns.
// Source: the critically damped oscillator in closed form; A. Lecuyer, S. Coquillart, A. Kheddar,
// P. Richard, P. Coiffet 2000, Pseudo-haptic feedback: can isometric input devices simulate force
// feedback?, IEEE Virtual Reality (what is seen to yield is felt to resist).
#pragma once

#include "haptics/base/error.h"
#include "haptics/device/device.h"
#include "haptics/handover/latest_value.h"
#include "haptics/math/spatial.h"

#include <cstdint>

namespace fulcrum {

/// Where the pointer is, in the device's frame. Writer: the window.
struct PointerTarget {
    Vector3 position_D{Vector3::Zero()};  ///< metres; x and y from the pointer, z from the wheel
    std::uint32_t buttons = 0;            ///< one bit a button
};

enum class PointerSmoothing : std::uint8_t { none, critically_damped };

struct PointerSettings {
    PointerSmoothing smoothing = PointerSmoothing::critically_damped;
    double natural_rad_per_s = 60.0;  ///< w: 90 % of a step within 65 ms; 5 to 500
    double max_speed_m_per_s = 3.0;   ///< 0.1 to 100
    double sag_m_per_N = 0.0;         ///< how far the hand gives way, 0 to 0.05
    double slow_per_N = 0.0;          ///< how much later a loaded hand follows, 0 to 2
    Vector3 half_extent_D{0.2, 0.2,
                          0.2};  ///< targets are held within this box, metres; each 0.001 to 10
};

inline constexpr double kMostYield = 3.0;
/// What pushes the hand on the screen is seen in how it gives way and comes late, where nobody can feel it: `times` as much as ships, 0 (the
/// hand is where the pointer is) to kMostYield. `fulcrum bench yielding-mouse` draws what that does.
[[nodiscard]] PointerSettings make_yielding(double times);

/// Refuses settings outside the ranges named above, NaN included.
[[nodiscard]] Expected<void> validate(const PointerSettings& settings);

class PointerDevice final : public Device {
  public:
    /// Takes settings that `validate` accepted. `target` must outlive the device; this is its only
    /// reader.
    PointerDevice(const PointerSettings& settings, LatestValue<PointerTarget>& target);
    ~PointerDevice() override;

    [[nodiscard]] const DeviceTraits& traits() const noexcept override { return traits_; }
    /// Where the pointer is now; always true. A mouse that does not move is not stale.
    [[nodiscard]] bool read(double now_s, DeviceReading& reading) noexcept override;
    /// Nothing can be felt, but the hand on the screen yields. False for a wrench that is not
    /// finite, which counts as none.
    [[nodiscard]] bool write(double now_s, const Wrench& wrench_D) noexcept override;
    /// At `now_s` the hand is there, at rest, and goes on from there. On the haptic thread.
    void put(double now_s, const Vector3& position_D) noexcept;

  private:
    void follow(const Vector3& target_D, double dt_s) noexcept;

    PointerSettings settings_;
    DeviceTraits traits_;
    LatestValue<PointerTarget>& target_;
    bool started_ = false;  // a first target has come
    double now_s_ = 0.0;
    Vector3 position_D_{Vector3::Zero()};
    Vector3 velocity_D_{Vector3::Zero()};
    Vector3 force_D_{Vector3::Zero()};  // written last
};

}  // namespace fulcrum
