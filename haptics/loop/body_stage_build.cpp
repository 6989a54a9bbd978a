// The load path of body_stage.h.
#include "haptics/loop/body_stage.h"
#include "haptics/tool/tool_plan.h"

#include <algorithm>
#include <set>
#include <string>
#include <variant>

namespace fulcrum {
namespace {

// How late a damper knows its velocity (coupling/velocity_estimator.h, adaptive_window).
constexpr double kVelocityLate_s = 0.008;

CouplingSettings find_coupling(const HapticPlan& plan, const RigidSolidPlan& body) {
    return plan.tool      ? plan.tool->settings.coupling.shift
           : body.is_held ? plan.coupling
                          : plan.solids[body.solid].coupling.value_or(plan.coupling);
}

PushSlopes find_slopes(const HapticPlan& plan, const RigidSolidPlan& body) {
    PushSlopes slopes;
    const CouplingSettings coupling = find_coupling(plan, body);
    slopes.stiffness_N_per_m = coupling.stiffness_N_per_m;
    slopes.damping_Ns_per_m = coupling.damping_Ns_per_m;
    slopes.late_mass_kg = kVelocityLate_s * coupling.damping_Ns_per_m;
    if (plan.tool) {
        const TurnCouplingSettings& turn = plan.tool->settings.coupling.turn;
        slopes.turn_stiffness_Nm_per_rad = turn.stiffness_Nm_per_rad;
        slopes.turn_damping_Nms_per_rad = turn.damping_Nms_per_rad.maxCoeff();
    }
    return slopes;
}

}  // namespace

Expected<void> validate_rigid(const HapticPlan& plan) {
    std::set<std::size_t> taken;
    for (const AxlePlan& axle : plan.axles) {
        taken.insert(axle.solid);
    }
    for (const RigidSolidPlan& body : plan.rigid) {
        const std::size_t n_slots = plan.solids.size() + (body.is_held ? 1 : 0);
        if (body.solid >= n_slots || n_slots > static_cast<std::size_t>(kMaxSolids) ||
            (body.is_held && (body.solid + 1 != n_slots || plan.tool)) ||
            !taken.insert(body.solid).second) {
            return fail("a rigid body is solid " + std::to_string(body.solid) +
                            ", which the plan has not, or moves otherwise",
                        {}, "name each solid that there is once");
        }
        if (!(body.mass_kg > 0.0) || !(body.moment_kg_m2 > 0.0)) {
            return fail("solid " + std::to_string(body.solid) +
                            " is a rigid body without mass or moment of inertia",
                        {}, "give it both, above 0");
        }
    }
    return {};
}

BodyStage::BodyStage(const HapticPlan& plan, RigidChannels* channels)
    : channels_(channels), period_s_(1.0 / plan.rate_hz), cursor_m_(0.0) {
    if (const auto* ball = std::get_if<SphereShape>(&plan.proxy.cursor)) {
        cursor_m_ = ball->radius_m;
    }
    for (const RigidSolidPlan& planned : plan.rigid) {
        Body body;
        body.plan = planned;
        body.slopes = find_slopes(plan, planned);
        body.friction = plan.tool || planned.is_held
                            ? 0.0
                            : plan.solids[planned.solid].friction.static_coefficient;
        if (planned.is_held) {
            held_ = bodies_.size();
            most_held_N_ = plan.safety.max_force_N;
        }
        bodies_.push_back(body);
    }
}

std::size_t BodyStage::memory_bytes() const noexcept {
    return sizeof(BodyStage) + bodies_.capacity() * sizeof(Body) +
           (channels_ != nullptr ? sizeof(RigidChannels) : 0);
}

std::unique_ptr<BodyStage> make_body_stage(const HapticPlan& plan, RigidChannels* channels) {
    return plan.rigid.empty() ? nullptr : std::make_unique<BodyStage>(plan, channels);
}

}  // namespace fulcrum
