// A body that can be touched, as the plan names it.
#pragma once

#include "haptics/collision/solid_shape.h"
#include "haptics/coupling/coupling_settings.h"
#include "haptics/handover/messages.h"
#include "haptics/math/spatial.h"
#include "haptics/surface/friction.h"

#include <cstdint>
#include <optional>

namespace fulcrum {

/// A body that can be touched.
struct SolidPlan {
    std::int32_t body = kNoBody;  ///< its index in the scene
    SolidShape shape;
    Pose initial_pose_W{};
    std::optional<CouplingSettings> coupling{};  ///< of its own, instead of the plan's
    FrictionSettings friction{};                 ///< felt by proxies of the kind friction_cone
};

}  // namespace fulcrum
