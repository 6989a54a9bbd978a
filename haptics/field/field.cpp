#include "haptics/field/field.h"

#include "haptics/field/magnet.h"
#include "haptics/field/spring.h"
#include "haptics/field/viscosity.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fulcrum {

namespace {

Vector3 pull_of_spring(const FieldPlan& plan, const Vector3& anchor_W,
                       const Vector3& position_W) noexcept {
    return compute_spring_pull(position_W, anchor_W, plan.stiffness_N_per_m);
}

Vector3 pull_of_liquid(const FieldPlan& /*plan*/, const Vector3& /*anchor_W*/,
                       const Vector3& /*position_W*/) noexcept {
    return Vector3::Zero();
}

Vector3 pull_of_magnet(const FieldPlan& plan, const Vector3& anchor_W,
                       const Vector3& position_W) noexcept {
    return compute_magnet_force(position_W, anchor_W, plan.peak_force_N, plan.range_m);
}

// In the order of FieldKind: a kind's law, and whether its damping counts.
struct FieldLaw {
    ElasticLaw elastic;
    bool damps;
};
constexpr FieldLaw kLaws[] = {
    {pull_of_spring, true},
    {pull_of_liquid, true},
    {pull_of_magnet, false},
};

const FieldLaw& law_of(FieldKind kind) noexcept {
    return kLaws[static_cast<std::size_t>(kind)];
}

double damping_of(const FieldPlan& plan) noexcept {
    return law_of(plan.kind).damps ? plan.damping_Ns_per_m : 0.0;
}

}  // namespace

FieldGains compute_largest_gains(const FieldPlan& plan) noexcept {
    switch (plan.kind) {
        case FieldKind::spring:
            return {plan.stiffness_N_per_m, plan.damping_Ns_per_m};
        case FieldKind::viscosity:
            return {0.0, plan.damping_Ns_per_m};
        case FieldKind::magnet:
            return {plan.peak_force_N * std::sqrt(std::numbers::e) / plan.range_m, 0.0};
    }
    return {};
}

FieldStage::FieldStage(const FieldPlan& plan) noexcept
    : plan_(plan),
      law_(law_of(plan.kind).elastic),
      damping_Ns_per_m_(damping_of(plan)),
      anchor_W_(plan.anchor_W) {}

Vector3 FieldStage::step(const FieldCommand& command, const Vector3& position_W,
                         const Vector3& velocity_W, double dt_s) noexcept {
    if (!(dt_s >= 0.0)) {
        dt_s = 0.0;
    }
    // Strength: towards the commanded one at a limited rate.
    const bool usable = command.on && std::isfinite(command.strength) &&
                        is_finite(command.anchor_W) &&
                        command.anchor_W.cwiseAbs().maxCoeff() <= kFarthestAnchor_m;
    const double wanted = usable ? std::clamp(command.strength, 0.0, 1.0) : 0.0;
    const double reach = kStrengthRate_per_s * dt_s;
    const double former_strength = strength_;
    const Vector3 former_anchor_W = anchor_W_;
    // A field that was off appears where it is wanted; one that is on glides there.
    if (usable && strength_ > 0.0) {
        anchor_W_ += (1.0 - std::exp(-dt_s / kAnchorTime_s)) * (command.anchor_W - anchor_W_);
    } else if (usable) {
        anchor_W_ = command.anchor_W;
    }
    strength_ += std::clamp(wanted - strength_, -reach, reach);
    if (strength_ <= 0.0 && former_strength <= 0.0) {
        elastic_ = ElasticForce{};
        return Vector3::Zero();
    }
    // What gives work back, as it is now and as it were had nothing been switched or moved.
    const Vector3 pull_W = law_(plan_, anchor_W_, position_W);
    elastic_.now_W = strength_ * pull_W;
    elastic_.held_W =
        former_strength *
        (former_anchor_W == anchor_W_ ? pull_W : law_(plan_, former_anchor_W, position_W));
    return elastic_.now_W + compute_viscous_force(velocity_W, strength_ * damping_Ns_per_m_);
}

}  // namespace fulcrum
