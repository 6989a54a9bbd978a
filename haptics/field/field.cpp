#include "haptics/field/field.h"

#include "haptics/field/magnet.h"
#include "haptics/field/spring.h"
#include "haptics/field/viscosity.h"

#include <algorithm>

#include <cmath>

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

void FieldStage::reset() noexcept {
    anchor_W_ = plan_.anchor_W;
    strength_ = 0.0;
}

Vector3 FieldStage::step(const FieldCommand& command, const Vector3& position_W,
                         const Vector3& velocity_W, double dt_s) noexcept {
    if (!(dt_s >= 0.0)) {
        dt_s = 0.0;
    }
    // Strength: towards the commanded one at a limited rate.
    const bool usable =
        command.on && std::isfinite(command.strength) && is_finite(command.anchor_W);
    const double wanted = usable ? std::clamp(command.strength, 0.0, 1.0) : 0.0;
    const double reach = kStrengthRate_per_s * dt_s;
    // A field that was off appears where it is wanted; one that is on glides there.
    if (usable) {
        const double share = strength_ > 0.0 ? 1.0 - std::exp(-dt_s / kAnchorTime_s) : 1.0;
        anchor_W_ += share * (command.anchor_W - anchor_W_);
    }
    strength_ += std::clamp(wanted - strength_, -reach, reach);
    return strength_ > 0.0
               ? Vector3(strength_ * compute_field_force(plan_, anchor_W_, position_W, velocity_W))
               : Vector3(Vector3::Zero());
}

}  // namespace fulcrum
