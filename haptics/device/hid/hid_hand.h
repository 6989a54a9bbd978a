// A SpaceMouse or a joystick as a hand.
//
//   SpaceMouse   its cap moves the hand by rate (rate_control.h); it renders no force: what would be felt is seen and heard
//   stick        its place is the hand's, over a box (stick.h); a force-feedback joystick renders forces along x and y
// Both are smoothed and held to a hand's speed, and a hand that feels nothing yields a little, as with a mouse (pointer_device.h). A cap that
// said it was pushed and has been silent for cap_silence_s counts as let go: a wireless one that is out of reach must not fly on.
// A stick with motors that repeats itself while it rests, and has been silent for stick_silence_s, gives no pose until it speaks again; one
// that speaks of changes alone may be silent: what a push must do to it tells whether it lives (device/watched).
//   stamp   of the read, for poses are carried on to it; a reader thread that is held up for 20 ms counts as a device that has gone
//   force   F_full shares of what is commanded; refused while the device takes none, or has had an order for kOverdue_s
//
// Thread: `read` and `write` on the haptic thread; the rest on the lesson's. Cost: about 200 ns; the device has threads of its own (hid_port.h).
#pragma once

#include "haptics/base/error.h"
#include "haptics/device/device.h"
#include "haptics/device/hid/hid_port.h"
#include "haptics/device/hid/rate_control.h"
#include "haptics/device/mouse/pointer_device.h"

#include <memory>
#include <string>

namespace fulcrum::hid {

inline constexpr double kOverdue_s = 0.1;

struct HidHandSettings {
    RateSettings rate{};            ///< of a SpaceMouse
    PointerSettings cap_pointer{};  ///< likewise: how the hand follows
    PointerSettings stick_pointer{.natural_rad_per_s =
                                      150.0};  ///< of a stick; its box is the stick's reach
    double cap_silence_s = 0.25;               ///< 0.05 to 5
    double stick_silence_s = 0.25;             ///< 0.15 to 5
    double full_force_N =
        3.0;  ///< of a stick whose motors do all they can; no device tells, 0.1 to 10
    ForceEffectSettings effects{};
};

/// Refuses settings outside the ranges named above, NaN included.
[[nodiscard]] Expected<void> validate(const HidHandSettings& settings);

class HidHand final : public Device {
  public:
    /// Opens what `choose_hand` chose, with its threads. Refuses a device that does not answer, in a sentence.
    [[nodiscard]] static Expected<std::unique_ptr<HidHand>> open(std::shared_ptr<HidBus> bus,
                                                                 const HidNode& node,
                                                                 const HidHandSettings& settings);
    /// Ends what is felt, waits for the device's threads, but never long.
    ~HidHand() override;

    [[nodiscard]] const DeviceTraits& traits() const noexcept override { return traits_; }
    /// False while the device is not plugged in, nothing has been known of it for 20 ms, or a stick that pushes has fallen silent.
    [[nodiscard]] bool read(double now_s, DeviceReading& reading) noexcept override;
    /// False for a wrench that is not finite, which counts as none, and while the device takes no force though it could.
    [[nodiscard]] bool write(double now_s, const Wrench& wrench_D) noexcept override;

    /// What has happened since the last call that people should know; empty when nothing has.
    [[nodiscard]] std::string take_notice() { return port_->take_notice(); }
    [[nodiscard]] HidCounts counts() const noexcept { return port_->counts(); }
    /// Along which of its axes x and y its motors push.
    [[nodiscard]] bool pushes_x() const noexcept {
        return has_force() && port_->ability().force->has_x;
    }
    [[nodiscard]] bool pushes_y() const noexcept {
        return has_force() && port_->ability().force->has_y;
    }
    /// For people: a SpaceMouse is moved otherwise than a stick.
    [[nodiscard]] HandForm form() const noexcept { return port_->ability().form; }

  private:
    HidHand(std::shared_ptr<HidPort> port, const HidHandSettings& settings);
    [[nodiscard]] bool has_force() const noexcept { return port_->ability().force.has_value(); }
    void move_by_cap(const HidSample& sample, double monotonic_s, double dt_s) noexcept;

    std::shared_ptr<HidPort> port_;
    HidHandSettings settings_;
    DeviceTraits traits_;
    bool is_cap_;
    RateControl rate_;
    LatestValue<PointerTarget> target_;  // written and read by the haptic thread
    PointerDevice pointer_;
    PointerTarget pointed_{};
    Vector3 force_D_{Vector3::Zero()};  // written last
    double now_s_ = 0.0;
    bool has_read_ = false;
};

}  // namespace fulcrum::hid
