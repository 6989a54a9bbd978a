// The load-path half of replay_device.h.
#include "haptics/device/replay/recorded_traits.h"
#include "haptics/device/replay/replay_device.h"

#include <limits>

namespace fulcrum {

ReplayDevice::ReplayDevice(const Record& record) : samples_(record.samples) {
    traits_.renders_force = true;
    traits_.max_force_N = std::numeric_limits<double>::max();
    traits_.max_torque_Nm = std::numeric_limits<double>::max();
    traits_ = find_traits(record.header).value_or(traits_);
    traits_.name = "replay of " + record.header.lesson;
}

ReplayDevice::~ReplayDevice() = default;

}  // namespace fulcrum
