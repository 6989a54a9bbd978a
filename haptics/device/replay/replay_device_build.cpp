// The load-path half of replay_device.h.
#include "haptics/device/replay/recorded_traits.h"
#include "haptics/device/replay/replay_device.h"

#include <algorithm>
#include <limits>

namespace fulcrum {

ReplayDevice::ReplayDevice(const Record& record) : samples_(record.samples) {
    traits_.renders_force = true;
    traits_.max_force_N = std::numeric_limits<double>::max();
    traits_.max_torque_Nm = std::numeric_limits<double>::max();
    traits_ = find_traits(record.header).value_or(traits_);
    traits_.name = "replay of " + record.header.lesson;
    // A clutch is told by nobody else; whatever else the device told stands in records of runs in real time.
    readings_.reserve(samples_.size());
    for (const RecordSample& sample : samples_) {
        // What a device can have noticed by itself: a clutch, and that what came before was lost.
        readings_.push_back({sample.faults & (Fault::clutched | Fault::device_stale)});
    }
    for (const RecordTold& told : record.told) {
        const auto at = std::ranges::lower_bound(samples_, told.tick, {}, &RecordSample::tick);
        if (told.kind == RecordToldKind::reading && at != samples_.end() && at->tick == told.tick) {
            read_told(record, told, readings_[static_cast<std::size_t>(at - samples_.begin())]);
        }
    }
}

ReplayDevice::~ReplayDevice() = default;

}  // namespace fulcrum
