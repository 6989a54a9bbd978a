// What this place allows a hand to feel, whatever a lesson wants. Of device, site and lesson the least holds.
#pragma once

#include "haptics/loop/haptic_plan.h"

#include <algorithm>
#include <optional>

namespace fulcrum::runtime {

/// SI; the widest that there is are SafetySettings' own.
struct SiteLimits {
    double force_N = SafetySettings{}.max_force_N;                   ///< 0.5 to 10
    double torque_Nm = SafetySettings{}.max_torque_Nm;               ///< 0 to 1
    double speed_m_per_s = SafetySettings{}.max_felt_speed_m_per_s;  ///< 0.5 to 10
    double energy_J = SafetySettings{}.max_energy_J;                 ///< 0.5 to 20
};

/// As the loop and an arm's server keep them.
inline void apply(const SiteLimits& limits, SafetySettings& safety) {
    safety.max_force_N = limits.force_N;
    safety.max_torque_Nm = limits.torque_Nm;
    safety.max_felt_speed_m_per_s = limits.speed_m_per_s;
    safety.max_energy_J = limits.energy_J;
}

/// Those of a place that allows `force_N` and says no more: the torque falls with the force, for the gate's torque rates go with the ratio
/// of the two.
[[nodiscard]] inline SiteLimits make_site_limits(double force_N) {
    const SiteLimits usual;
    SiteLimits limits;
    limits.force_N = force_N;
    limits.torque_Nm = usual.torque_Nm * std::min(1.0, force_N / usual.force_N);
    return limits;
}

/// Those of a place for a lesson that wants no more than `wanted_N`; never more than the place allows.
[[nodiscard]] inline SiteLimits lower(const SiteLimits& site, std::optional<double> wanted_N) {
    SiteLimits limits = site;
    if (wanted_N && *wanted_N < site.force_N) {
        limits.torque_Nm *= *wanted_N / site.force_N;
        limits.force_N = *wanted_N;
    }
    return limits;
}

}  // namespace fulcrum::runtime
