// What a thing is made of, for the hand: how stiff, how slippery, how rough it is and how it rings.
//
// Thread: load.
#pragma once

#include "haptics/base/error.h"
#include "haptics/coupling/coupling_settings.h"
#include "haptics/surface/friction.h"
#include "haptics/surface/texture_settings.h"
#include "haptics/surface/transient_settings.h"

#include <string>

namespace fulcrum {

/// All by numbers; a scene puts one onto as many bodies as it likes (point/solid_plan.h, `put_material`).
struct Material {
    std::string name;               ///< "wood": how people call it; not empty
    CouplingSettings coupling{};    ///< stiffness and damping under the hand
    FrictionSettings friction{};    ///< felt by proxies of the kind friction_cone
    TextureSettings texture{};      ///< its relief
    TransientSettings transient{};  ///< how it answers a tap
};

/// Refuses a material without a name, and settings outside the ranges named at each field, NaN included; the sentence
/// begins with the material's name.
[[nodiscard]] Expected<void> validate(const Material& material);

}  // namespace fulcrum
