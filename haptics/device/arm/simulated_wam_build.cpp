// The load-path half of simulated_wam.h.
#include "haptics/base/range.h"
#include "haptics/device/arm/simulated_wam.h"

namespace fulcrum {
namespace {

// Base +X to D +Z, +Y to +X, +Z to +Y.
Quaternion make_turn_DB() {
    Matrix3 turn;
    turn << 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0;
    return Quaternion(turn);
}

// The settings with a handle that is level in the home posture.
SimulatedWamSettings level_handle(SimulatedWamSettings settings) {
    ArmPosture home;
    compute_posture(settings.model, settings.workspace.home_rad, home);
    const Quaternion last_B(home.turn_B[static_cast<std::size_t>(settings.model.n)]);
    settings.model.handle.orientation = (make_turn_DB() * last_B).conjugate().normalized();
    return settings;
}

}  // namespace

Expected<void> validate(const SimulatedWamSettings& s) {
    if (auto checked = validate(s.model); !checked) {
        return checked;
    }
    const double stiffness = s.grip.push.stiffness_N_per_m;
    const Range ranges[] = {
        {"posture_per_s", s.posture_per_s, 0.0, 20.0},
        {"delay_s", s.delay_s, 0.0, 0.02},
        {"longest_step_s", s.longest_step_s, 0.00005, 0.002},
        {"grip.push.mass_kg", s.grip.push.mass_kg, 0.0, 100.0},
        {"grip.push.damping_Ns_per_m", s.grip.push.damping_Ns_per_m, 0.0, 1000.0},
        {"grip.push.stiffness_N_per_m", stiffness, 0.0, 1.0e5},
        {"grip.inertia_kg_m2", s.grip.inertia_kg_m2, 0.0, 1.0},
        {"grip.turn_stiffness_Nm_per_rad", s.grip.turn_stiffness_Nm_per_rad, 0.0, 100.0},
        {"grip.turn_damping_Nms_per_rad", s.grip.turn_damping_Nms_per_rad, 0.0, 10.0},
        {"grip.strongest_N", s.grip.strongest_N, 0.0, 1000.0},
        {"grip.strongest_Nm", s.grip.strongest_Nm, 0.0, 100.0},
    };
    return check_ranges("the simulated WAM's", ranges);
}

Expected<std::unique_ptr<SimulatedWam>> SimulatedWam::create(const SimulatedWamSettings& settings,
                                                             LatestValue<HandTarget>& target) {
    if (auto checked = validate(settings); !checked) {
        return tl::unexpected<Error>(checked.error());
    }
    const auto reach = compute_reach(settings.model, settings.workspace);
    if (!reach) {
        return tl::unexpected<Error>(reach.error());
    }
    return std::unique_ptr<SimulatedWam>(new SimulatedWam(level_handle(settings), *reach, target));
}

SimulatedWam::SimulatedWam(const SimulatedWamSettings& settings, const ArmReach& reach,
                           LatestValue<HandTarget>& target)
    : settings_(settings),
      target_(target),
      twists_(compute_twists(settings.model)),
      joint_per_motor_(compute_joint_per_motor(settings.model)),
      control_(settings.model, {settings.workspace.home_rad, settings.posture_per_s}),
      motion_(settings.model) {
    traits_.name = "simulated WAM";
    traits_.renders_force = true;
    traits_.max_force_N = reach.force_N;
    traits_.max_torque_Nm = reach.torque_Nm;
    traits_.position_resolution_m = reach.step_m;
    traits_.damping_Ns_per_m = reach.damping_Ns_per_m;
    traits_.mass_kg = reach.mass_kg;
    // D's origin is the handle at home.
    ArmPosture home;
    compute_posture(settings_.model, settings_.workspace.home_rad, home);
    pose_DB_.orientation = make_turn_DB();
    pose_DB_.position = -(pose_DB_.orientation * home.handle_B.position);
    reset();
}

SimulatedWam::~SimulatedWam() = default;

}  // namespace fulcrum
