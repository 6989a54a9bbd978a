// What a Haply arm can do, and what a record should name of it and of what stands between an order and its motors.
//
// Thread: any. Cost: allocates.
#pragma once

#include "runtime/arms/arm_port.h"
#include "runtime/arms/haply/haply_message.h"

namespace fulcrum::runtime {

/// The most that is ordered. The motors give more (10 N by chai3d's driver), but what they give for long is not documented.
inline constexpr double kHaplyForce_N = 3.0;

/// Of one that has a configuration.
[[nodiscard]] DeviceTraits make_haply_traits(const HaplyArm& arm);

/// Likewise; what the service does not tell is "not told". A just-noticeable difference of stiffness that is felt through gate and
/// damping is one of arm and service.
[[nodiscard]] std::vector<ArmFact> list_haply_facts(const HaplyArm& arm, const std::string& version,
                                                    const std::optional<double>& force_scale,
                                                    const Vector3& centre_A);

}  // namespace fulcrum::runtime
