// The load path of haptic_loop.h: checks a plan, builds its stages, describes them.
#include "haptics/base/range.h"
#include "haptics/coupling/virtual_coupling.h"
#include "haptics/loop/haptic_loop.h"
#include "haptics/point/make_proxy.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace fulcrum {
namespace {

constexpr double kFineResolution_m = 1.0e-5;  // of a device that names none

VelocitySettings choose_velocity_settings(const HapticPlan& plan, const DeviceTraits& traits) {
    VelocitySettings settings;
    settings.method = plan.velocity_method;
    settings.cutoff_Hz = plan.velocity_cutoff_hz;
    const double resolution_m =
        traits.position_resolution_m > 0.0 ? traits.position_resolution_m : kFineResolution_m;
    settings.noise_bound_m = resolution_m * plan.workspace.scale;
    // The hand moves in its own metres.
    settings.acceleration_density *= plan.workspace.scale * plan.workspace.scale;
    return settings;
}

// The scene's limits, and no more than the device can give.
SafetySettings choose_safety_settings(const HapticPlan& plan, const DeviceTraits& traits) {
    SafetySettings settings = plan.safety;
    if (traits.renders_force) {
        settings.max_force_N = std::min(settings.max_force_N, traits.max_force_N);
        settings.max_torque_Nm = std::min(settings.max_torque_Nm, traits.max_torque_Nm);
    }
    return settings;
}

Expected<void> check_ringing(const HapticPlan& plan) {
    Expected<void> good;
    for (const SolidPlan& solid : plan.solids) {
        good = good ? validate_ringing(solid.surface.transient, plan.rate_hz) : good;
    }
    return good;
}

}  // namespace

Expected<void> validate_ringing(const TransientSettings& tap, double rate_hz) {
    if (!tap.any()) {
        return {};
    }
    const Range ranges[] = {
        {"frequency in hertz", tap.frequency_Hz, 0.0, kFastestRinging * rate_hz}};
    return check_ranges("at a loop of " + std::to_string(std::lround(rate_hz)) + " Hz the tap's",
                        ranges);
}

Expected<void> validate(const HapticPlan& plan) {
    const Range ranges[] = {
        {"rate in hertz", plan.rate_hz, kLeastRate_Hz, kMostRate_Hz},
        {"workspace scale", plan.workspace.scale, 0.01, 100.0},
        {"onset of a weight in seconds", plan.weight_onset_s, 0.02, 5.0},
        {"answers of a lesson in hertz", plan.lesson_rate_hz, 1.0, kMostRate_Hz},
        {"number of force fields", static_cast<double>(plan.fields.size()), 0.0, kMaxFields},
    };
    const Expected<void> checks[] = {
        check_ranges("the haptic plan's", ranges),
        validate(plan.safety),
        validate(plan.coupling),
        validate(plan.passivity),
        validate(plan.shading_loan),
        validate(plan.proxy, plan.solids),
        check_ringing(plan),
        validate_axles(plan),
        validate_rigid(plan),
        validate_tool(plan),
        plan.line ? validate(*plan.line) : Expected<void>{},
        validate(VelocitySettings{.method = plan.velocity_method,
                                  .cutoff_Hz = plan.velocity_cutoff_hz,
                                  .noise_bound_m = kFineResolution_m}),
    };
    for (const Expected<void>& check : checks) {
        if (!check) {
            return check;
        }
    }
    for (const FieldPlan& field : plan.fields) {
        if (const Expected<void> check = validate(field); !check) {
            return check;
        }
    }
    const Quaternion& turn = plan.workspace.pose_WD.orientation;
    if (!is_finite(plan.workspace.pose_WD) || std::abs(turn.coeffs().norm() - 1.0) > 1e-9) {
        return fail("the workspace's pose is not a position and a unit quaternion", {},
                    "give it a finite position and a normalised orientation");
    }
    return {};
}

Expected<void> validate(const HapticPlan& plan, const DeviceTraits& traits) {
    return validate(plan).and_then([&]() -> Expected<void> {
        if (const auto velocity = validate(choose_velocity_settings(plan, traits)); !velocity) {
            return fail(
                "the resolution of the device \"" + traits.name +
                    "\" is out of range at the workspace's scale: " + velocity.error().message,
                {}, "choose a smaller scale or a finer device");
        }
        return {};
    });
}

HapticLoop::HapticLoop(const HapticPlan& plan, Device& device, HapticChannels& channels)
    : HapticLoop(plan, device, channels,
                 plan.tool
                     ? nullptr
                     : make_proxy(plan.proxy, plan.solids, {plan.coupling, 1.0 / plan.rate_hz})) {}

HapticLoop::HapticLoop(const HapticPlan& plan, Device& device, HapticChannels& channels,
                       std::unique_ptr<Proxy> proxy)
    : plan_(plan),
      device_(device),
      channels_(channels),
      velocity_(choose_velocity_settings(plan, device.traits())),
      angular_velocity_(plan.velocity_cutoff_hz),
      scene_(plan_, device.traits(), choose_safety_settings(plan, device.traits()), channels,
             std::move(proxy)),
      gate_(choose_safety_settings(plan, device.traits()), 1.0 / plan.rate_hz),
      guard_(plan.safety) {
    std::vector<EffectSlot> effects = scene_.list_effects();
    if (plan.passivity.on && (scene_.has_proxy() || has_forces(plan))) {
        passivity_ = std::make_unique<PassivityStage>(plan, device.traits());
        effects.push_back({Effect::brake, -1});
    }
    teller_.emplace(channels, std::move(effects));
}

HapticLoop::~HapticLoop() = default;

std::vector<StageInfo> HapticLoop::stages() const {
    std::vector<StageInfo> list;
    const auto add = [&](HapticStage stage, std::size_t bytes) {
        list.push_back({stage, plan_.rate_hz, bytes});
    };
    add(HapticStage::take_inputs, sizeof(channels_.command) + sizeof(channels_.world));
    add(HapticStage::read, sizeof(reading_));
    add(HapticStage::estimate, sizeof(velocity_) + sizeof(angular_velocity_));
    scene_.list_stages(list);
    if (passivity_) {
        add(HapticStage::passivity, sizeof(PassivityStage));
    }
    add(HapticStage::limits, sizeof(gate_));
    add(HapticStage::write, sizeof(applied_D_));
    add(HapticStage::publish,
        sizeof(state_) + sizeof(channels_.state_for_world) + sizeof(channels_.state_for_lesson));
    if (channels_.record != nullptr) {
        add(HapticStage::record, sizeof(RecordRing));
    }
    return list;
}

}  // namespace fulcrum
