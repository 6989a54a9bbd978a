// What a body's surface has besides stiffness and friction. What is not asked for here is not built and costs nothing.
//
// Thread: load.
#pragma once

#include "haptics/base/error.h"
#include "haptics/surface/energy_loan.h"
#include "haptics/surface/texture_settings.h"
#include "haptics/surface/transient_settings.h"

namespace fulcrum {

inline constexpr double kMostCrease_deg = 180.0;

/// Normals that turn evenly over a mesh's edges instead of jumping (shading.h).
struct ShadingSettings {
    bool on = false;
    double crease_angle_deg =
        30.0;  ///< edges that bend more than this stay sharp, 0 to kMostCrease_deg

    bool operator==(const ShadingSettings&) const = default;
};

/// Fixed at load.
struct SurfacePlan {
    TextureSettings texture{};
    TransientSettings transient{};
    ShadingSettings shading{};
    bool audible = false;  ///< what is felt here is told to the sound too (touch_sample.h)
};

/// Refuses settings outside the ranges named at each field, NaN included.
[[nodiscard]] Expected<void> validate(const ShadingSettings& settings);
[[nodiscard]] Expected<void> validate(const SurfacePlan& plan);
[[nodiscard]] Expected<void> validate(const EnergyLoanSettings& settings);

}  // namespace fulcrum
