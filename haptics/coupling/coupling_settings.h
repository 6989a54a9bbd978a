// How stiff the link between hand and proxy is.
#pragma once

namespace fulcrum {

/// The lightest thing that hangs on the coupling: a handle that nobody holds.
inline constexpr double kHandleMass_kg = 0.045;

/// Of a saturating spring: how steep its blend may begin, in secants of the blend, and still rise everywhere (Fritsch and
/// Carlson 1980, see virtual_coupling.h).
inline constexpr double kSteepestStart = 3.0;

/// Spring and damper between hand and proxy; in world metres.
/// With the last three fields zero the spring is linear at any stretch; otherwise its force is
/// linear up to `linear_range_m`, constant from `saturation_range_m` on, and a cubic joins the two.
struct CouplingSettings {
    double stiffness_N_per_m = 500.0;  ///< 0 to 1e5
    /// 0 to 1e3, of the hand against what is touched, along its normal (contact_damper.h). The default is critical for the handle alone,
    /// 2 sqrt(m k); a hand brings damping of its own. Critical for a whole arm (45 Ns/m) would shake
    /// the bare handle, for the velocity is known some milliseconds late.
    double damping_Ns_per_m = 9.5;
    double linear_range_m = 0.0;      ///< 0 or more
    double saturation_range_m = 0.0;  ///< above linear_range_m, or 0
    double saturation_force_N = 0.0;  ///< the constant; at least what keeps the cubic rising

    [[nodiscard]] bool saturates() const noexcept { return saturation_range_m > 0.0; }
};

}  // namespace fulcrum
