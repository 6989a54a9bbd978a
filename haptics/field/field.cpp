#include "haptics/field/field.h"

#include "haptics/field/magnet.h"
#include "haptics/field/spring.h"
#include "haptics/field/viscosity.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fulcrum {

Vector3 compute_field_force(const FieldPlan& plan, const Vector3& anchor_W,
                            const Vector3& position_W, const Vector3& velocity_W) noexcept {
    switch (plan.kind) {
        case FieldKind::spring:
            return compute_spring_force(position_W, velocity_W, anchor_W, plan.stiffness_N_per_m,
                                        plan.damping_Ns_per_m);
        case FieldKind::viscosity:
            return compute_viscous_force(velocity_W, plan.damping_Ns_per_m);
        case FieldKind::magnet:
            return compute_magnet_force(position_W, anchor_W, plan.peak_force_N, plan.range_m);
    }
    return Vector3::Zero();
}

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
    // A field that was off appears where it is wanted; one that is on glides there.
    if (usable && strength_ > 0.0) {
        anchor_W_ += (1.0 - std::exp(-dt_s / kAnchorTime_s)) * (command.anchor_W - anchor_W_);
    } else if (usable) {
        anchor_W_ = command.anchor_W;
    }
    strength_ += std::clamp(wanted - strength_, -reach, reach);
    return strength_ > 0.0
               ? Vector3(strength_ * compute_field_force(plan_, anchor_W_, position_W, velocity_W))
               : Vector3(Vector3::Zero());
}

}  // namespace fulcrum
