#include "haptics/loop/passivity_stage.h"

#include "haptics/math/rotation.h"

namespace fulcrum {

PassivityStage::PassivityStage(const HapticPlan& plan, const DeviceTraits& traits) noexcept
    : scale_(plan.workspace.scale),
      force_(plan.passivity,
             {plan.passivity.handle_mass_kg, traits.damping_Ns_per_m, 1.0 / plan.rate_hz}) {
    if (has_torques(plan) && traits.max_torque_Nm > 0.0) {
        torque_.emplace(plan.passivity,
                        PortLimits{plan.passivity.handle_inertia_kg_m2, 0.0, 1.0 / plan.rate_hz});
    }
}

Wrench PassivityStage::step(const SceneDemand& demand, const Pose& tool_W, double dt_s,
                            bool is_new) noexcept {
    const Pose before_W = has_pose_ ? last_W_ : tool_W;
    last_W_ = tool_W;
    has_pose_ = true;
    // Translation. The contact's energy is newtons times metres of the world: the hand's are scale times fewer.
    PortRound push;
    push.motion = (tool_W.position - before_W.position) / scale_;
    push.asked = demand.wrench_W.force;
    push.elastic = demand.force;
    push.dt_s = dt_s;
    push.is_new = is_new;
    ContactSpring contact = demand.contact;
    contact.energy_J /= scale_;
    push.kink_J = compute_kink_J(contact_, contact, push.motion);
    push.normal = contact.normal;
    push.push = contact.push;
    contact_ = contact;
    Wrench brake_W{force_.step(push), Vector3::Zero()};
    if (torque_) {
        // Turning.
        PortRound turn;
        turn.motion = compute_log(tool_W.orientation * before_W.orientation.conjugate());
        turn.asked = demand.wrench_W.torque;
        turn.elastic = demand.torque;
        turn.dt_s = dt_s;
        turn.is_new = is_new;
        brake_W.torque = torque_->step(turn);
    }
    return brake_W;
}

void PassivityStage::sent(const Wrench& applied_W) noexcept {
    force_.sent(applied_W.force);
    if (torque_) {
        torque_->sent(applied_W.torque);
    }
}

void PassivityStage::forget() noexcept {
    has_pose_ =
        false;  // the next round is the first again, and what came before it is not looked at
    force_.reset();
    if (torque_) {
        torque_->reset();
    }
}

}  // namespace fulcrum
