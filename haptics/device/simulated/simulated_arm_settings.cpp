// The load-path half of simulated_arm.h.
#include "haptics/base/range.h"
#include "haptics/device/simulated/simulated_arm.h"

namespace fulcrum {

Expected<void> validate(const SimulatedArmSettings& s) {
    const Range ranges[] = {
        {"mass_kg", s.mass_kg, 0.001, 100.0},
        {"dry_friction_N", s.dry_friction_N, 0.0, 10.0},
        {"damping_Ns_per_m", s.damping_Ns_per_m, 0.0, 1000.0},
        {"position_resolution_m", s.position_resolution_m, 0.0, 0.01},
        {"delay_s", s.delay_s, 0.0, 0.02},
        {"max_force_N", s.max_force_N, 0.0, 100.0},
        {"human.mass_kg", s.human.mass_kg, 0.0, 100.0},
        {"human.damping_Ns_per_m", s.human.damping_Ns_per_m, 0.0, 1000.0},
        // A spring softer than this is none: give 0.
        {"human.stiffness_N_per_m", s.human.stiffness_N_per_m,
         s.human.stiffness_N_per_m == 0.0 ? 0.0 : 1.0, 1.0e8},
    };
    if (auto checked = check_ranges("the simulated arm's", ranges); !checked) {
        return checked;
    }
    if (!is_finite(s.start_D)) {
        return fail("the simulated arm's start is not a position", {},
                    "give it three finite numbers");
    }
    return {};
}

SimulatedArmSettings make_desktop_arm() {
    SimulatedArmSettings arm;
    arm.mass_kg = 0.045;
    arm.dry_friction_N = 0.26;
    arm.damping_Ns_per_m = 0.5;
    arm.position_resolution_m = 5.5e-5;
    arm.max_force_N = 3.3;
    return arm;
}

SimulatedArm::SimulatedArm(const SimulatedArmSettings& settings, LatestValue<HandTarget>& target)
    : settings_(settings), target_(target) {
    traits_.name = "simulated arm";
    traits_.renders_force = true;
    traits_.max_force_N = settings.max_force_N;
    traits_.position_resolution_m = settings.position_resolution_m;
    traits_.damping_Ns_per_m = settings.damping_Ns_per_m;
    traits_.mass_kg = settings.mass_kg;
    reset();
}

SimulatedArm::~SimulatedArm() = default;

}  // namespace fulcrum
