// How stiff the link between hand and proxy is.
#pragma once

namespace fulcrum {

/// Spring and damper between hand and proxy; in world metres.
/// With the last three fields zero the spring is linear at any stretch; otherwise its force is
/// linear up to `linear_range_m`, constant from `saturation_range_m` on, and a cubic joins the two.
struct CouplingSettings {
    double stiffness_N_per_m = 500.0;  ///< 0 to 1e5
    double damping_Ns_per_m = 1.0;     ///< 0 to 1e3, of the hand against the proxy
    double linear_range_m = 0.0;       ///< 0 or more
    double saturation_range_m = 0.0;   ///< above linear_range_m, or 0
    double saturation_force_N = 0.0;   ///< the constant; at least what keeps the cubic rising
};

}  // namespace fulcrum
