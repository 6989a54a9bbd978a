// How a surface holds a point that is dragged over it.
//
//   sticking: |F_t| <= mu_static F_n          sliding at v: F_t = -(mu_dynamic F_n + b v) along the slip
//
// Thread: load.
#pragma once

#include "haptics/base/error.h"

namespace fulcrum {

struct FrictionSettings {
    double static_coefficient = 0.0;   ///< dynamic_coefficient to 5
    double dynamic_coefficient = 0.0;  ///< 0 to 5
    double viscous_Ns_per_m = 0.0;     ///< 0 to 100

    [[nodiscard]] bool any() const noexcept {
        return static_coefficient > 0.0 || dynamic_coefficient > 0.0 || viscous_Ns_per_m > 0.0;
    }
};

/// Refuses settings outside the ranges named at each field, NaN included.
[[nodiscard]] Expected<void> validate(const FrictionSettings& settings);

}  // namespace fulcrum
