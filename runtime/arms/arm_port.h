// The threads between a maker's arm and the loop that serves it, which must wait for neither: what every such port has.
//
//   the port's own thread   sample  -> LatestValue -> the loop        what the arm told, as it came
//   the loop                order   -> LatestValue -> the port        what is to be felt; older than kSilence_s it counts as none
// A service or a library of a maker may hang, fail, or close: then `is_there` is false or the stamp grows old, and the loop's own gate
// fades. The other way round, where the loop hangs, the port gives no force kSilence_s later.
//
// Thread: made and stopped by who serves the arm; the two values cross as they say. Cost: none of its own.
// Source: haptics/device/hid/hid_port.h has the same for sticks; PROTOCOL.md names the silence.
#pragma once

#include "haptics/base/clock.h"
#include "haptics/device/device.h"
#include "haptics/device/watched/sensor_guard.h"
#include "haptics/handover/latest_value.h"

#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace fulcrum::runtime {

inline constexpr double kArmSilence_s = 0.02;

/// What the arm told last.
struct ArmSample {
    double stamp_s = 0.0;  ///< when it came, monotonic clock
    Pose pose_D{};         ///< metres, frame D: +X right, +Y up, +Z to the person
    std::uint32_t buttons = 0;
    Fault faults = Fault::none;
    bool is_there = false;  ///< false: it has gone, or may not be held now
};

/// What the loop wants felt.
struct ArmOrder {
    double stamp_s = 0.0;  ///< monotonic clock
    Wrench wrench_D{};     ///< N and N m
};

/// A name and a value, for the record of a run: "haply service" "3.5.1".
using ArmFact = std::pair<std::string, std::string>;

class ArmPort {
  public:
    ArmPort() = default;
    ArmPort(const ArmPort&) = delete;
    ArmPort& operator=(const ArmPort&) = delete;
    virtual ~ArmPort() = default;

    /// The arm without force, then the end of the port's thread; within a second, or the thread is left to itself. Again: nothing.
    virtual void stop() noexcept = 0;

    /// As the arm told them when it was opened; its name is "model serial". Then fixed.
    [[nodiscard]] virtual const DeviceTraits& traits() const noexcept = 0;
    /// How its sensors behave; zeros where nobody knows.
    [[nodiscard]] virtual SensorLife sensor() const noexcept { return {}; }
    /// What a record should name: versions, filters between order and motor.
    [[nodiscard]] virtual std::vector<ArmFact> facts() const = 0;
    /// Options of `fulcrum arm` by which it is the same when it is opened again in the middle of a lesson: what was found as it was opened.
    [[nodiscard]] virtual std::vector<std::string> words_again() const { return {}; }

    /// What has happened since the last call that people should know, a sentence; empty when nothing has. Any thread.
    [[nodiscard]] std::string take_notice() {
        const std::scoped_lock lock(mutex_);
        return std::exchange(notice_, {});
    }

    LatestValue<ArmSample> sample;  ///< port's thread -> loop
    LatestValue<ArmOrder> order;    ///< loop -> port's thread

  protected:
    /// Port's thread: what is to be felt now. Nothing where the newest order is older than kArmSilence_s, or is no number.
    [[nodiscard]] Wrench wanted_D(double monotonic_s) noexcept {
        (void)order.take();
        const ArmOrder& newest = order.value();
        const bool counts =
            monotonic_s - newest.stamp_s <= kArmSilence_s && is_finite(newest.wrench_D);
        return counts ? newest.wrench_D : Wrench{};
    }
    /// Not on a haptic thread: it locks. The newest sentence takes the place of one that nobody has read.
    void tell(std::string sentence) {
        const std::scoped_lock lock(mutex_);
        notice_ = std::move(sentence);
    }

  private:
    std::mutex mutex_;  // of the notice
    std::string notice_;
};

}  // namespace fulcrum::runtime
