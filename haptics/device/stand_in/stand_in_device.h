// A device that may be unplugged, and a pointer that stands in for it until it is plugged in again.
//
//   held       the device gives poses: they are told as they are
//   gone       it gives none: neither does this, so that the loop fades what is felt; after kPatience_s the pointer stands in
//   stood in   the pointer, from where the hand was last, turned as it was then; it renders no force, and its hand yields a little
//              (pointer_device.h). What is written to the device is no force
//   held again as soon as the device gives a pose. Whatever is asked for then, the device is written no force before no force was asked
//              for: so it is given back by the gate's own calm and soft start
// Where the hand changes hands Fault::clutched is told for one round, by which the gate closes and begins anew: the way from one place
// to the other is nobody's force.
//
// Thread: `read` and `write` on the haptic thread; `stands_in` any. Cost: that of the two.
#pragma once

#include "haptics/device/device.h"
#include "haptics/device/mouse/pointer_device.h"

#include <atomic>
#include <memory>

namespace fulcrum {

class StandInDevice final : public Device {
  public:
    static constexpr double kPatience_s = 0.5;  ///< a device that stutters is not given up

    StandInDevice(std::unique_ptr<Device> device, std::unique_ptr<PointerDevice> pointer) noexcept;
    ~StandInDevice() override;

    /// The device's, whoever moves the hand.
    [[nodiscard]] const DeviceTraits& traits() const noexcept override { return device_->traits(); }
    [[nodiscard]] bool read(double now_s, DeviceReading& reading) noexcept override;
    [[nodiscard]] bool write(double now_s, const Wrench& wrench_D) noexcept override;

    /// The next reading may be of another clock. Before a loop steps.
    void begin_anew() noexcept { has_pose_ = false; }

    /// Whether the pointer moves the hand now.
    [[nodiscard]] bool stands_in() const noexcept {
        return stands_in_.load(std::memory_order_acquire);
    }

  private:
    void give_back(DeviceReading& reading) noexcept;
    [[nodiscard]] bool read_pointer(double now_s, DeviceReading& reading) noexcept;

    std::unique_ptr<Device> device_;
    std::unique_ptr<PointerDevice> pointer_;
    std::atomic<bool> stands_in_{false};
    bool is_muted_ = false;  // until no force is asked for
    bool has_pose_ = false;
    double seen_s_ = 0.0;  // when the device gave a pose last
    Pose held_D_{};        // that one
};

}  // namespace fulcrum
