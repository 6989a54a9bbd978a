// The load-path half of safety.h: it speaks to people and so allocates.
#include "haptics/base/range.h"
#include "haptics/loop/safety.h"

#include <cmath>

namespace fulcrum {
Expected<void> validate(const SafetySettings& s) {
    const Range ranges[] = {
        {"max_force_N", s.max_force_N, 0.5, kHardForceCap_N},
        {"max_torque_Nm", s.max_torque_Nm, 0.0, kHardTorqueCap_Nm},
        {"max_slew_N_per_s", s.max_slew_N_per_s, 10.0, 5000.0},
        {"max_transient_N", s.max_transient_N, 0.0, kMostTransient_N},
        {"transient_Ns", s.transient_Ns, 0.001, 0.05},
        {"transient_N2s", s.transient_N2s, 0.001, 0.5},
        {"engage_below_N", s.engage_below_N, 0.01, 1.0},
        {"engage_cycles", static_cast<double>(s.engage_cycles), 1.0, 1000.0},
        {"rest_speed_m_per_s", s.rest_speed_m_per_s, 0.0, 0.2},
        {"rest_s", s.rest_s, 0.2, 60.0},
        {"soft_start_N_per_s", s.soft_start_N_per_s, 0.5, 50.0},
        {"soft_start_s", s.soft_start_s, 0.0, 10.0},
        {"fade_s", s.fade_s, 0.01, 0.5},
        {"command_timeout_s", s.command_timeout_s, 0.02, 1.0},
        {"device_timeout_s", s.device_timeout_s, 0.002, 0.1},
        {"max_hand_speed_m_per_s", s.max_hand_speed_m_per_s, 0.1, 100.0},
        {"max_felt_speed_m_per_s", s.max_felt_speed_m_per_s, 0.5, 10.0},
        {"max_energy_J", s.max_energy_J, 0.5, 20.0},
    };
    return check_ranges("the safety setting", ranges);
}

}  // namespace fulcrum
