// A force field as a scene declares it. The law of each kind stands in the header of the same name
// beside this file.
#pragma once

#include "haptics/math/spatial.h"

#include <cstdint>

namespace fulcrum {

enum class FieldKind : std::uint8_t { spring, viscosity, magnet };

/// The stiffest and the most viscous that all forces together may be in the hand, and so any one
/// of them: what is stiffer than an arm and its loop can hold shakes instead of pulling.
inline constexpr double kMaxFeltStiffness_N_per_m = 2000.0;
inline constexpr double kMaxFeltDamping_Ns_per_m = 50.0;
inline constexpr double kMaxFieldPeak_N = 10.0;  ///< of a magnet: the hard cap on force

/// A force field declared by the scene; fixed at load.
struct FieldPlan {
    FieldKind kind = FieldKind::spring;
    Vector3 anchor_W{Vector3::Zero()};  ///< spring, magnet: metres
    double stiffness_N_per_m = 0.0;     ///< spring: 0 to kMaxFeltStiffness_N_per_m
    double damping_Ns_per_m = 0.0;      ///< spring, viscosity: 0 to kMaxFeltDamping_Ns_per_m
    double peak_force_N = 0.0;          ///< magnet: largest pull, 0 to kMaxFieldPeak_N
    double range_m = 0.1;               ///< magnet: distance of the largest pull, 0.001 to 100
};

}  // namespace fulcrum
