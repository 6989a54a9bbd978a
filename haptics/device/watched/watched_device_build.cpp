#include "haptics/device/watched/watched_device.h"

#include <utility>

namespace fulcrum {

WatchedDevice::WatchedDevice(const SensorWatch& watch, std::unique_ptr<Device> device)
    : watch_(watch),
      device_(std::move(device)),
      guard_(watch.life, device_->traits().position_resolution_m) {}

WatchedDevice::~WatchedDevice() = default;

}  // namespace fulcrum
