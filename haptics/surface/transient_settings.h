// What a tap on a surface adds to the spring that the coupling is: a short force of a shape that is known beforehand, as
// strong as the tap was fast. The laws stand in transient.h.
//
// Thread: load.
// Source: K. J. Kuchenbecker, J. Fiene, G. Niemeyer 2006, Improving contact realism through event-based haptic feedback,
// IEEE Trans. Visualization and Computer Graphics 12(2).
#pragma once

#include "haptics/base/error.h"

#include <cstdint>

namespace fulcrum {

enum class TransientKind : std::uint8_t {
    none,
    fixed_pulse,        ///< a constant force for a fixed time
    decaying_sinusoid,  ///< a force that rings and dies away
    /// The force that makes handle and hand ring with a given acceleration, through the inverse of what they are.
    acceleration_matching,
};

/// Fixed at load. What a kind does not use is not looked at.
struct TransientSettings {
    TransientKind kind = TransientKind::none;
    /// Force for each metre a second of the tap, 0 to 100: of a pulse, and of a sinusoid at its start.
    double force_Ns_per_m = 0.0;
    /// Acceleration for each metre a second of the tap, m/s^2 per m/s, 0 to 1e4: of acceleration matching.
    double acceleration_per_s = 0.0;
    double frequency_Hz = 100.0;  ///< of a ringing, 5 to 1000
    double decay_per_s = 90.0;    ///< rate B of exp(-B t), 5 to 2000
    double pulse_s = 0.01;        ///< length of a pulse, 0.001 to 0.1
    double max_force_N = 3.0;     ///< however fast the tap was, 0.1 to 10
    /// Most of the tap's kinetic energy that it may give back, 0 to 1: beyond that it is braked.
    double energy_share = 0.5;

    [[nodiscard]] bool any() const noexcept { return kind != TransientKind::none; }
};

/// Refuses settings outside the ranges named at each field, NaN included.
[[nodiscard]] Expected<void> validate(const TransientSettings& settings);

}  // namespace fulcrum
