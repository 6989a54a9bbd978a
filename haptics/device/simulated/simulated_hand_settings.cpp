// The load-path half of simulated_hand.h.
#include "haptics/base/range.h"
#include "haptics/device/simulated/simulated_hand.h"

#include <cmath>

namespace fulcrum {
Expected<void> validate(const SimulatedHandSettings& s) {
    const Range ranges[] = {
        {"mass_kg", s.mass_kg, 0.05, 20.0},
        {"stiffness_N_per_m", s.stiffness_N_per_m, 1.0, 5000.0},
        {"damping_Ns_per_m", s.damping_Ns_per_m, 0.0, 500.0},
        {"inertia_kg_m2", s.inertia_kg_m2, 1e-5, 1.0},
        {"turn_stiffness_Nm_per_rad", s.turn_stiffness_Nm_per_rad, 0.01, 100.0},
        {"turn_damping_Nms_per_rad", s.turn_damping_Nms_per_rad, 0.0, 10.0},
        {"position_resolution_m", s.position_resolution_m, 0.0, 0.01},
        {"max_force_N", s.max_force_N, 0.0, 100.0},
        {"max_torque_Nm", s.max_torque_Nm, 0.0, 10.0},
    };
    if (auto checked = check_ranges("the simulated hand's", ranges); !checked) {
        return checked;
    }
    if (!is_finite(s.start_pose_D) ||
        std::abs(s.start_pose_D.orientation.coeffs().norm() - 1.0) > 1e-6) {
        return fail("the simulated hand's start is not a position and a unit quaternion", {},
                    "give it a finite position and a normalised orientation");
    }
    return {};
}

SimulatedHand::SimulatedHand(const SimulatedHandSettings& settings, LatestValue<HandTarget>& target)
    : settings_(settings), target_(target) {
    traits_.name = "simulated hand";
    traits_.renders_force = true;
    traits_.max_force_N = settings.max_force_N;
    traits_.max_torque_Nm = settings.max_torque_Nm;
    traits_.position_resolution_m = settings.position_resolution_m;
    reset();
}

SimulatedHand::~SimulatedHand() = default;

}  // namespace fulcrum
