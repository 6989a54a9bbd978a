// A body that can be touched, as the plan names it.
#pragma once

#include "haptics/collision/solid_shape.h"
#include "haptics/coupling/coupling_settings.h"
#include "haptics/handover/messages.h"
#include "haptics/math/spatial.h"
#include "haptics/surface/friction.h"
#include "haptics/surface/material.h"
#include "haptics/surface/surface_plan.h"

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
    SurfacePlan surface{};                       ///< texture, transient, shading, sound
    /// A hand that begins in it, or on which it is put, is let out instead of being held inside, or pushed out. Scenes ask for it;
    /// rooms do not.
    bool lets_out = false;
    Pose
        shape_B{};  ///< where the shape's own middle and axes lie in the body; of a mesh nowhere else
};

/// Makes the body of a material: its coupling, friction, texture and transient become the material's. Shading and sound
/// stay as they are.
inline void put_material(const Material& material, SolidPlan& solid) {
    solid.coupling = material.coupling;
    solid.friction = material.friction;
    solid.surface.texture = material.texture;
    solid.surface.transient = material.transient;
}

}  // namespace fulcrum
