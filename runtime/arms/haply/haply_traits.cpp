#include "runtime/arms/haply/haply_traits.h"

#include "runtime/arms/haply/haply_judge.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace fulcrum::runtime {
namespace {

std::string say_haply_number(const std::optional<double>& value) {
    std::array<char, 32> text{};
    (void)std::snprintf(text.data(), text.size(), "%g", value.value_or(0.0));
    return value ? text.data() : "not told";
}

std::string say_haply_flag(const std::optional<bool>& value) {
    return value ? (*value ? "on" : "off") : "not told";
}

}  // namespace

DeviceTraits make_haply_traits(const HaplyArm& arm) {
    DeviceTraits traits;
    traits.name = name_haply_arm(arm);
    traits.renders_force = true;
    traits.max_force_N = kHaplyForce_N;
    // The box within the ball; encoder step, friction and mass are nowhere told.
    traits.reach_m = Vector3::Constant(find_haply_reach_m(*arm.config) / std::sqrt(3.0));
    return traits;
}

std::vector<ArmFact> list_haply_facts(const HaplyArm& arm, const std::string& version,
                                      const std::optional<double>& force_scale,
                                      const Vector3& centre_A) {
    const HaplyConfig& config = *arm.config;
    std::array<char, 80> centre{};
    (void)std::snprintf(centre.data(), centre.size(), "%.4f %.4f %.4f", centre_A.x(), centre_A.y(),
                        centre_A.z());
    return {{"haply service", version},
            {"haply arm", config.type + " " + arm.id},
            {"haply force gate", say_haply_number(config.gate_gain)},
            {"haply damping", say_haply_number(config.damping_Ns_per_m)},
            {"haply gravity compensation", say_haply_flag(config.compensates_gravity)},
            {"haply gravity scale", say_haply_number(config.gravity_scale)},
            {"haply torque scaling", say_haply_flag(config.scales_torque)},
            {"haply force scale", say_haply_number(force_scale)},
            {"haply handedness", config.handedness},
            {"haply preset", config.preset},
            {"haply centre", centre.data()}};
}

}  // namespace fulcrum::runtime
