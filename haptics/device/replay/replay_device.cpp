// The step path of replay_device.h.
#include "haptics/device/replay/replay_device.h"

#include <algorithm>
#include <limits>

namespace fulcrum {

bool ReplayDevice::read(double now_s, DeviceReading& reading) noexcept {
    if (samples_.empty()) {
        finished_.store(true, std::memory_order_release);
        return false;
    }
    // The record's clock is moved so that its first sample is now; zero when both began alike.
    if (!started_) {
        offset_s_ = now_s - samples_.front().time_s;
        started_ = true;
    }
    const double time_s = now_s - offset_s_;
    // Usually the next sample; after a gap the one before the first that lies in the future.
    const auto begin = samples_.begin();
    if (at_ + 2 < samples_.size() && samples_[at_ + 2].time_s <= time_s) {
        const auto after = std::upper_bound(
            begin + static_cast<std::ptrdiff_t>(at_), samples_.end(), time_s,
            [](double t_s, const RecordSample& sample) { return t_s < sample.time_s; });
        at_ = static_cast<std::size_t>(after - begin) - 1;
    } else if (at_ + 1 < samples_.size() && samples_[at_ + 1].time_s <= time_s) {
        ++at_;
    }
    const RecordSample& sample = samples_[at_];
    const bool past_end = at_ + 1 == samples_.size() && time_s > sample.time_s;
    if (past_end) {
        finished_.store(true, std::memory_order_release);
    }
    reading.pose_D = sample.pose_D;
    reading.buttons = sample.buttons;
    reading.faults = readings_[at_].faults;
    if (!readings_[at_].is_reading) {
        reading.pose_D.position.setConstant(std::numeric_limits<double>::quiet_NaN());
    }
    reading.stamp_s = past_end ? now_s : sample.stamp_s + offset_s_;
    return past_end || !any(sample.faults & Fault::device_read);
}

bool ReplayDevice::write(double /*now_s*/, const Wrench& /*wrench_D*/) noexcept {
    // It is noticed in the next round.
    return at_ + 1 >= samples_.size() || !any(samples_[at_ + 1].faults & Fault::device_write);
}

void ReplayDevice::reset() noexcept {
    at_ = 0;
    started_ = false;
    finished_.store(false, std::memory_order_release);
}

}  // namespace fulcrum
