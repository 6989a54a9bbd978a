#include "haptics/loop/scene_forces.h"

#include <algorithm>
#include <set>
#include <utility>

namespace fulcrum {
namespace {

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

}  // namespace

SceneForces::SceneForces(const HapticPlan& plan, const DeviceTraits& traits,
                         const SafetySettings& safety, HapticChannels& channels,
                         std::unique_ptr<Proxy> proxy)
    : plan_(plan), channels_(channels), tool_(make_tool_stage(plan)) {
    if (proxy) {
        touch_ = std::make_unique<TouchStage>(plan, std::move(proxy), traits, channels.touches);
    }
    if (touch_ || tool_) {
        solids_ = std::make_unique<SceneSolids>(plan, channels);
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
        lesson_force_ =
            std::make_unique<LinearisedWrenchStage>(choose_lesson_settings(plan, safety));
    }
}

std::vector<EffectSlot> SceneForces::list_effects() const {
    std::vector<EffectSlot> effects;
    const auto add = [&](bool is_there, Effect effect) {
        if (is_there) {
            effects.push_back({effect, -1});
        }
    };
    const SurfaceEffects* const surface = touch_ ? touch_->effects() : nullptr;
    add(tool_ != nullptr, Effect::tool);
    add(tool_ != nullptr, Effect::tool_damping);
    add(touch_ != nullptr, Effect::contact);
    add(touch_ != nullptr, Effect::contact_damping);
    add(touch_ && solids_->bodies, Effect::grip);
    add((surface != nullptr && surface->texture) || (tool_ && tool_->has_texture()),
        Effect::texture);
    add(surface != nullptr && surface->transient, Effect::tap);
    add(weight_ != nullptr, Effect::weight);
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        effects.push_back({Effect::field, static_cast<std::int32_t>(i)});
    }
    add(line_ != nullptr, Effect::line);
    add(lesson_force_ != nullptr, Effect::lesson);
    return effects;
}

void SceneForces::list_stages(std::vector<StageInfo>& list) const {
    const auto add = [&](HapticStage stage, std::size_t bytes) {
        list.push_back({stage, plan_.rate_hz, bytes});
    };
    if (touch_) {
        add(HapticStage::proxy, sizeof(TouchStage) + count_shape_bytes(plan_.solids));
        add(HapticStage::coupling, touch_->coupling_bytes());
    }
    if (tool_) {
        add(HapticStage::tool, tool_->memory_bytes());
    }
    if (solids_ && solids_->axles) {
        add(HapticStage::turning, solids_->axles->memory_bytes());
    }
    if (solids_ && solids_->bodies) {
        add(HapticStage::pushing, solids_->bodies->memory_bytes());
    }
    const SurfaceEffects* const surface = touch_ ? touch_->effects() : nullptr;
    if (surface != nullptr && surface->texture) {
        add(HapticStage::texture,
            surface->texture->memory_bytes() + surface->motion.memory_bytes());
    }
    if (surface != nullptr && surface->transient) {
        add(HapticStage::transient, surface->transient->memory_bytes());
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
}

}  // namespace fulcrum
