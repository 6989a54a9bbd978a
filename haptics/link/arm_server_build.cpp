// The load-path half of arm_server.h: it builds, speaks to people, and so allocates.
#include "haptics/base/range.h"
#include "haptics/link/arm_server.h"

#include <algorithm>

namespace fulcrum {
namespace {

LinkTraits describe_arm(const DeviceTraits& arm, const ArmServerSettings& settings) noexcept {
    LinkTraits traits;
    traits.name = make_link_name(arm.name);
    traits.rate_Hz = settings.rate_Hz;
    traits.max_force_N = std::min(arm.max_force_N, settings.safety.max_force_N);
    traits.max_torque_Nm = std::min(arm.max_torque_Nm, settings.safety.max_torque_Nm);
    traits.damping_Ns_per_m = arm.damping_Ns_per_m;
    traits.mass_kg = arm.mass_kg;
    traits.position_resolution_m = arm.position_resolution_m;
    traits.reach_m = settings.reach_m;
    return traits;
}

SafetySettings limits_of(const ArmServerSettings& settings, const DeviceTraits& arm) noexcept {
    SafetySettings safety = settings.safety;
    safety.max_force_N = std::min(safety.max_force_N, arm.max_force_N);
    safety.max_torque_Nm = std::min(safety.max_torque_Nm, arm.max_torque_Nm);
    return safety;
}

}  // namespace

Expected<void> validate(const ArmServerSettings& s) {
    const Range ranges[] = {
        {"rate_Hz", s.rate_Hz, 500.0, 2000.0},
        {"lost_after_s", s.lost_after_s, 0.05, 10.0},
        {"handle_mass_kg", s.handle_mass_kg, 0.001, 10.0},
        {"handle_inertia_kg_m2", s.handle_inertia_kg_m2, 1.0e-8, 1.0},
        {"reach_m.x", s.reach_m.x(), 0.01, 10.0},
        {"reach_m.y", s.reach_m.y(), 0.01, 10.0},
        {"reach_m.z", s.reach_m.z(), 0.01, 10.0},
    };
    return check_ranges("the arm setting", ranges)
        .and_then([&] { return validate(s.safety); })
        .and_then([&] { return validate(s.energy); })
        .and_then([&] { return validate(s.sensor); });
}

ArmServer::ArmServer(const ArmServerSettings& settings, Device& arm, Datagrams& datagrams,
                     const Seal& seal, SessionNumbers& numbers)
    : settings_(settings),
      arm_(arm),
      post_(datagrams, seal, numbers),
      traits_(describe_arm(arm.traits(), settings)),
      gate_(limits_of(settings, arm.traits()), 1.0 / settings.rate_Hz),
      guard_(settings.safety),
      sensor_(settings.sensor, arm.traits().position_resolution_m),
      velocity_(VelocitySettings{.noise_bound_m =
                                     std::clamp(arm.traits().position_resolution_m, 1.0e-5, 0.1)}),
      angular_velocity_(80.0),
      force_(LinkSide::arm, settings.energy),
      torque_(LinkSide::arm, settings.energy) {}

ArmServer::~ArmServer() = default;

}  // namespace fulcrum
