// The load-path half of replay_device.h.
#include "haptics/device/replay/replay_device.h"

#include <limits>

namespace fulcrum {

ReplayDevice::ReplayDevice(const Record& record) : samples_(record.samples) {
    traits_.name = "replay of " + record.header.lesson;
    traits_.renders_force = true;
    traits_.max_force_N = std::numeric_limits<double>::max();
    traits_.max_torque_Nm = std::numeric_limits<double>::max();
}

ReplayDevice::~ReplayDevice() = default;

}  // namespace fulcrum
