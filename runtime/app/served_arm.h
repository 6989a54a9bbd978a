// What `fulcrum arm` serves: a real arm, or a simulated one that a simulated hand holds, with what its server must know of it.
//
// Thread: made by who serves it.
#pragma once

#include "haptics/device/simulated/hand_target.h"
#include "haptics/handover/latest_value.h"
#include "haptics/link/arm_server.h"
#include "runtime/app/options.h"
#include "runtime/arms/arm_port.h"

#include <memory>

namespace fulcrum::runtime {

struct ServedArm {
    std::unique_ptr<Device> device;
    /// Set: rate, sensor, reach; limits are the program's to set.
    ArmServerSettings settings{};
    ArmPort* port = nullptr;  ///< of a real arm, for what it tells; lives as the device does
};

/// Opens the arm that is asked for. `target`: where the simulated hand wants to be; it outlives the arm.
[[nodiscard]] Expected<ServedArm> open_served_arm(const ArmOptions& options,
                                                  LatestValue<HandTarget>& target);

}  // namespace fulcrum::runtime
