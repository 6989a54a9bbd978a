// A hand that was recorded: gives the poses of a record again, at the times at which they were read.
//
// A read at now gives the newest sample whose time is not after now, with its own stamp, buttons and,
// where the device had failed, its failure; a write fails where it failed. At the times of the recorded
// rounds that repeats the hand to the bit.
//
// Thread: `read` and `write` on the haptic thread, `finished` on any.
// Cost: one comparison a read; a binary search after a gap.
#pragma once

#include "haptics/device/device.h"
#include "haptics/handover/told.h"
#include "haptics/record/record.h"

#include <atomic>
#include <cstddef>
#include <vector>

namespace fulcrum {

class ReplayDevice final : public Device {
  public:
    /// Plays `record`; its first sample is given at the first read.
    explicit ReplayDevice(const Record& record);
    ~ReplayDevice() override;

    /// Those of the recorded device, where the record tells them; else it renders any force, to nobody.
    [[nodiscard]] const DeviceTraits& traits() const noexcept override { return traits_; }
    /// False where the recorded read failed, or when the record is empty. After the end it holds
    /// the last pose with a fresh stamp.
    [[nodiscard]] bool read(double now_s, DeviceReading& reading) noexcept override;
    /// Takes the wrench and lets nobody feel it. False where the recorded write failed.
    [[nodiscard]] bool write(double now_s, const Wrench& wrench_D) noexcept override;

    /// True once a read lay past the last sample.
    [[nodiscard]] bool finished() const noexcept {
        return finished_.load(std::memory_order_acquire);
    }
    /// Starts again from the first sample.
    void reset() noexcept;

  private:
    DeviceTraits traits_;
    std::vector<RecordSample> samples_;
    std::vector<ToldReading> readings_;  // what it told besides, of each sample
    std::size_t at_ = 0;
    bool started_ = false;
    double offset_s_ = 0.0;  // run's clock minus record's clock
    std::atomic<bool> finished_{false};
};

}  // namespace fulcrum
