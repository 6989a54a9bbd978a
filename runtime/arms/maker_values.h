// What a maker's library says is checked before it counts, and what goes to it is bounded once more.
//
// Thread: any. Cost: a square root or two.
#pragma once

#include "haptics/device/device.h"
#include "haptics/math/length.h"

#include <optional>

namespace fulcrum::runtime {

/// No arm on a desk reaches farther from its zero, along any axis.
inline constexpr double kFarthest_m = 1.0;
/// How far from orthogonal a matrix may be, in any component of RᵀR - I: makers' are off by some 1e-3.
inline constexpr double kMostSkew = 0.02;

[[nodiscard]] inline bool is_place(const Vector3& position_m) noexcept {
    return is_finite(position_m) && position_m.cwiseAbs().maxCoeff() <= kFarthest_m;
}

/// The turn of a matrix that is nearly one of a rotation, of length 1; nothing where it is not.
[[nodiscard]] inline std::optional<Quaternion> turn_of(const Matrix3& R) noexcept {
    if (!R.allFinite() || R.determinant() <= 0.0 ||
        (R.transpose() * R - Matrix3::Identity()).cwiseAbs().maxCoeff() > kMostSkew) {
        return std::nullopt;
    }
    return Quaternion(R).normalized();
}

/// No more than the arm was said to give; nothing where it is no number.
[[nodiscard]] inline Wrench bounded(const Wrench& wrench_D, const DeviceTraits& traits) noexcept {
    if (!is_finite(wrench_D)) {
        return {};
    }
    return {.force = shorten(wrench_D.force, traits.max_force_N),
            .torque = shorten(wrench_D.torque, traits.max_torque_Nm)};
}

}  // namespace fulcrum::runtime
