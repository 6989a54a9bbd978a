// The load-path half of fitted_device.h.
#include "haptics/base/range.h"
#include "haptics/device/fitted/fitted_device.h"

#include <utility>

namespace fulcrum {

Expected<void> validate(const DeviceFit& fit) {
    const Range ranges[] = {
        {"middle along x in metres", fit.middle_A.x(), -kFurthestMiddle_m, kFurthestMiddle_m},
        {"middle along y in metres", fit.middle_A.y(), -kFurthestMiddle_m, kFurthestMiddle_m},
        {"middle along z in metres", fit.middle_A.z(), -kFurthestMiddle_m, kFurthestMiddle_m},
        {"clutch button", static_cast<double>(fit.clutch_button), 0.0, kMostClutchButton},
    };
    return check_ranges("the hand's", ranges);
}

FittedDevice::FittedDevice(const DeviceFit& fit, std::unique_ptr<Device> device)
    : fit_(fit),
      clutch_bit_(fit.clutch_button > 0 ? 1U << (fit.clutch_button - 1) : 0U),
      device_(std::move(device)),
      traits_(device_->traits()) {}

void FittedDevice::give_part(double part) noexcept {
    part_ = traits_.renders_force && part >= 0.0 && part <= 1.0 ? part : 0.0;
}

void FittedDevice::give_no_force() noexcept {
    part_ = 0.0;
    traits_.renders_force = false;
    traits_.max_force_N = traits_.max_torque_Nm = 0.0;
}

FittedDevice::~FittedDevice() = default;

}  // namespace fulcrum
