// The load path of haptic_loop.h: checks a plan, builds its stages, describes them.
#include "haptics/base/range.h"
#include "haptics/coupling/virtual_coupling.h"
#include "haptics/loop/haptic_loop.h"
#include "haptics/point/make_proxy.h"

#include <algorithm>
#include <cmath>
#include <set>
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

// A lesson's own slopes get what the declared fields leave, seen through the scale.
LinearisedWrenchSettings choose_lesson_settings(const HapticPlan& plan,
                                                const SafetySettings& safety) {
    FieldGains left{kMaxFeltStiffness_N_per_m / plan.workspace.scale,
                    kMaxFeltDamping_Ns_per_m / plan.workspace.scale};
    for (const FieldPlan& field : plan.fields) {
        const FieldGains gains = compute_largest_gains(field);
        left.stiffness_N_per_m -= gains.stiffness_N_per_m;
        left.damping_Ns_per_m -= gains.damping_Ns_per_m;
    }
    LinearisedWrenchSettings settings;
    settings.timeout_s = safety.command_timeout_s;
    settings.blend_s = 1.0 / plan.lesson_rate_hz;
    settings.max_force_N = safety.max_force_N;
    settings.max_torque_Nm = safety.max_torque_Nm;
    settings.max_stiffness_N_per_m = std::max(left.stiffness_N_per_m, 0.0);
    settings.max_damping_Ns_per_m = std::max(left.damping_Ns_per_m, 0.0);
    settings.max_torque_stiffness_Nm_per_m =
        kMaxFeltTorqueStiffness_Nm_per_m / plan.workspace.scale;
    return settings;
}

template <class Add>
void add_surface_stages(const SurfaceEffects* effects, const Add& add) {
    if (effects != nullptr && effects->texture) {
        add(HapticStage::texture,
            effects->texture->memory_bytes() + effects->motion.memory_bytes());
    }
    if (effects != nullptr && effects->transient) {
        add(HapticStage::transient, effects->transient->memory_bytes());
    }
}

// Solids of one mesh share it.
std::size_t count_shape_bytes(const std::vector<SolidPlan>& solids) {
    std::size_t bytes = 0;
    std::set<const CollisionMesh*> counted;
    for (const SolidPlan& solid : solids) {
        const MeshShape* mesh = find_mesh(solid.shape);
        if (mesh == nullptr || counted.insert(mesh->get()).second) {
            bytes += memory_bytes(solid.shape);
        }
    }
    return bytes;
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
      gate_(choose_safety_settings(plan, device.traits()), 1.0 / plan.rate_hz),
      guard_(plan.safety) {
    if (proxy) {
        touch_ = std::make_unique<TouchStage>(
            TouchStage{std::move(proxy),
                       ContactStage(plan),
                       {},
                       {},
                       make_surface_effects(plan, device.traits(), channels.touches)});
    }
    tool_ = make_tool_stage(plan);
    if (touch_ || tool_) {
        solids_ = std::make_unique<SolidPlaces>(plan);
        axles_ = make_axle_stage(plan, channels.axles);
        bodies_ = make_body_stage(plan, channels.rigid);
    }
    if (plan.carries_weight) {
        weight_ = std::make_unique<WeightRamp>(plan.weight_onset_s);
    }
    fields_.reserve(plan.fields.size());
    for (const FieldPlan& field : plan.fields) {
        fields_.emplace_back(field);
    }
    if (plan.line) {
        line_ = std::make_unique<LineStage>(*plan.line, channels.kite);
    }
    if (plan.lesson_force) {
        lesson_force_ = std::make_unique<LinearisedWrenchStage>(
            choose_lesson_settings(plan, choose_safety_settings(plan, device.traits())));
    }
    if (plan.passivity.on && (touch_ || has_forces(plan))) {
        passivity_ = std::make_unique<PassivityStage>(plan, device.traits());
    }
    teller_.emplace(channels, list_effects());
}

// In the order in which the step adds them.
std::vector<EffectSlot> HapticLoop::list_effects() const {
    std::vector<EffectSlot> effects;
    const auto add = [&](bool is_there, Effect effect) {
        if (is_there) {
            effects.push_back({effect, -1});
        }
    };
    const SurfaceEffects* const surface = touch_ ? touch_->effects.get() : nullptr;
    add(tool_ != nullptr, Effect::tool);
    add(tool_ != nullptr, Effect::tool_damping);
    add(touch_ != nullptr, Effect::contact);
    add(touch_ != nullptr, Effect::contact_damping);
    add(bodies_ && touch_, Effect::grip);
    add((surface != nullptr && surface->texture) || (tool_ && tool_->has_texture()),
        Effect::texture);
    add(surface != nullptr && surface->transient, Effect::tap);
    add(weight_ != nullptr, Effect::weight);
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        effects.push_back({Effect::field, static_cast<std::int32_t>(i)});
    }
    add(line_ != nullptr, Effect::line);
    add(lesson_force_ != nullptr, Effect::lesson);
    add(passivity_ != nullptr, Effect::brake);
    return effects;
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
    if (touch_) {
        add(HapticStage::proxy, sizeof(TouchStage) + count_shape_bytes(plan_.solids));
        add(HapticStage::coupling, touch_->coupling.memory_bytes());
    }
    if (tool_) {
        add(HapticStage::tool, tool_->memory_bytes());
    }
    if (axles_) {
        add(HapticStage::turning, axles_->memory_bytes());
    }
    if (bodies_) {
        add(HapticStage::pushing, bodies_->memory_bytes());
    }
    if (touch_) {
        add_surface_stages(touch_->effects.get(), add);
    }
    if (weight_) {
        add(HapticStage::weight, sizeof(WeightRamp));
    }
    for (const FieldPlan& field : plan_.fields) {
        add(stage_of(field.kind), sizeof(FieldStage));
    }
    if (line_) {
        add(HapticStage::line, sizeof(LineStage) + sizeof(KiteChannels::line));
    }
    if (lesson_force_) {
        add(HapticStage::lesson, sizeof(LinearisedWrenchStage));
    }
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
