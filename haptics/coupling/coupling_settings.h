// How stiff the link between hand and proxy is.
#pragma once

namespace fulcrum {

/// Spring and damper between hand and proxy; in world metres.
struct CouplingSettings {
    double stiffness_N_per_m = 500.0;
    double damping_Ns_per_m = 1.0;
};

}  // namespace fulcrum
