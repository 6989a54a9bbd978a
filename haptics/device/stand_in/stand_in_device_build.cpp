// The load-path half of stand_in_device.h.
#include "haptics/device/stand_in/stand_in_device.h"

#include <utility>

namespace fulcrum {

StandInDevice::StandInDevice(std::unique_ptr<Device> device,
                             std::unique_ptr<PointerDevice> pointer) noexcept
    : device_(std::move(device)), pointer_(std::move(pointer)) {}

StandInDevice::~StandInDevice() = default;

}  // namespace fulcrum
