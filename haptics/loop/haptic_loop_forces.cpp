// What each effect of the plan adds to the force, and what of it gives the hand's work back. See haptic_loop.h.
#include "haptics/loop/haptic_loop.h"

#include <limits>

namespace fulcrum {

void HapticLoop::add_contact() noexcept {
    if (touch_->contact.solid < 0) {
        touch_->coupling.leave();
        touch_->velocity.leave();
    } else {
        add_touch();
    }
    if (plan_.expects_world || axles_ || bodies_) {
        touch_->velocity.keep(solid_poses_W_, reading_.stamp_s);
    }
}

void HapticLoop::add_touch() noexcept {
    const Vector3& hand_W = state_.tool_pose_W.position;
    const auto velocities_W =
        touch_->velocity.step(touch_->contact, solid_poses_W_, {velocity_, reading_.stamp_s});
    const ContactForce felt =
        touch_->coupling.step(touch_->contact, hand_W, velocities_W, solid_poses_W_);
    demand_.contact = felt.spring;
    demand_.force += felt.counted;
    demand_.wrench_W.force += felt.force_W;
    teller_->share(Effect::contact, felt.spring.force);
    teller_->share(Effect::contact_damping, felt.force_W - felt.spring.force);
}

// The tool among the solids; without a force while anything is wrong.
void HapticLoop::move_tool() noexcept {
    tool_force_ = {};
    if (!has_pose_) {
        return;
    }
    const GatePhase phase = gate_.phase();
    const bool is_open = phase != GatePhase::fading && phase != GatePhase::stopped;
    tool_force_ = tool_->step({.hand = {state_.tool_pose_W, state_.tool_twist_W},
                               .solid_poses_W = solid_poses_W_,
                               .is_fit = is_open && !any(state_.faults),
                               .now_s = now_s_,
                               .dt_s = dt_s_});
    if (tool_force_.failed) {
        state_.faults |= Fault::command_invalid;
    }
    state_.tool = tool_->effort();
    state_.proxy_position_W = tool_->pose_W().position;
    state_.proxy_orientation_W = tool_->pose_W().orientation;
    state_.touched_body = solids_->body_of(tool_->solid());
}

void HapticLoop::add_tool() noexcept {
    demand_.contact = tool_force_.contact;
    demand_.wrench_W.force += tool_force_.wrench_W.force;
    demand_.wrench_W.torque += tool_force_.wrench_W.torque;
    demand_.force += tool_force_.elastic_force;
    demand_.torque += tool_force_.elastic_torque;
    teller_->share(Effect::tool, tool_force_.spring_W.force, tool_force_.spring_W.torque);
    const Wrench& texture_W = tool_force_.texture_W;
    if (tool_->has_texture()) {
        teller_->share(Effect::texture, texture_W.force, texture_W.torque);
    }
    teller_->share(Effect::tool_damping,
                   tool_force_.wrench_W.force - tool_force_.spring_W.force - texture_W.force,
                   tool_force_.wrench_W.torque - tool_force_.spring_W.torque - texture_W.torque);
}

// What the hand presses turns; the contact's is the first force of the round, and so far the only one.
void HapticLoop::turn_axles() noexcept {
    if (tool_) {
        // The hand feels the world's torques over the scale (tool_stage.h).
        axles_->push_by_tool(
            tool_->pushes(),
            {gate_.find_most_N(dt_s_), gate_.find_most_Nm(dt_s_) * plan_.workspace.scale}, dt_s_);
        return;
    }
    axles_->push(touch_->contact, {demand_.wrench_W.force, gate_.find_most_N(dt_s_)}, dt_s_);
}

// Bodies are pushed by what the hand feels of them: the contact, the grip, the tool.
void HapticLoop::push_bodies() noexcept {
    if (tool_) {
        bodies_->push_by_tool(
            tool_->pushes(),
            {gate_.find_most_N(dt_s_), gate_.find_most_Nm(dt_s_) * plan_.workspace.scale}, now_s_);
        return;
    }
    const HandPush touch{demand_.wrench_W.force, gate_.find_most_N(dt_s_)};
    // A gate that lets nothing through holds nothing: what a grip asks for would keep it closed.
    const bool may_grip = gate_.phase() == GatePhase::open || gate_.phase() == GatePhase::rising;
    const GripForce grip =
        bodies_->grip(touch_->contact, {state_.tool_pose_W, state_.tool_twist_W,
                                        may_grip ? state_.buttons : std::uint32_t{0}, may_grip});
    demand_.wrench_W.force += grip.force_W;
    demand_.force += {grip.spring_W, grip.spring_W};
    teller_->share(Effect::grip, grip.force_W);
    if (bodies_->gripped() >= 0) {
        state_.touched_body = solids_->body_of(bodies_->gripped());
    }
    if (const Pose* const held_W = bodies_->held_pose_W()) {
        state_.proxy_position_W = held_W->position;
        state_.proxy_orientation_W = held_W->orientation;
    }
    bodies_->push(touch_->contact, touch, now_s_);
}

void HapticLoop::add_weight() noexcept {
    const Vector3& carried_W = channels_.world.value().carried_force_W;
    if (!is_finite(carried_W)) {
        state_.faults |= Fault::command_invalid;
    }
    const Vector3 before_W = weight_->force_W();
    const Vector3& force_W = weight_->step(carried_W, dt_s_);
    demand_.wrench_W.force += force_W;
    demand_.force += {force_W, before_W};
    teller_->share(Effect::weight, force_W);
}

void HapticLoop::add_field(std::size_t index) noexcept {
    FieldStage& field = fields_[index];
    const Vector3 force_W =
        field.step(channels_.command.value().fields[index], state_.tool_pose_W.position,
                   state_.tool_twist_W.linear, dt_s_);
    demand_.wrench_W.force += force_W;
    demand_.force += field.elastic();
    teller_->share(Effect::field, force_W, Vector3::Zero(), index);
}

void HapticLoop::add_line() noexcept {
    if (!has_pose_) {
        return;
    }
    // While the gate is shut the line lets go as if its world were silent: a pull that stays would keep it from engaging for ever.
    const GatePhase phase = gate_.phase();
    const bool is_open = phase == GatePhase::rising || phase == GatePhase::open;
    constexpr double kSilent_s = std::numeric_limits<double>::infinity();
    const double line_now_s = is_open ? now_s_ : +kSilent_s;
    // Nobody's hand jumps: where it is then the next round tells.
    if (!any(state_.faults & Fault::device_invalid)) {
        line_->tell_hand(state_.tool_pose_W.position);
    }
    const LineForce felt = line_->step(state_.tool_pose_W, line_now_s, dt_s_);
    demand_.wrench_W.force += felt.wrench_W.force;
    demand_.wrench_W.torque += felt.wrench_W.torque;
    demand_.force += felt.force;
    demand_.torque += felt.torque;
    teller_->share(Effect::line, felt.wrench_W.force, felt.wrench_W.torque);
}

void HapticLoop::add_lesson_force() noexcept {
    const Wrench wrench_W =
        lesson_force_->step(channels_.command.value().linearised, state_.tool_pose_W.position,
                            state_.tool_twist_W.linear, now_s_);
    demand_.wrench_W.force += wrench_W.force;
    demand_.wrench_W.torque += wrench_W.torque;
    demand_.force += lesson_force_->elastic_force();
    demand_.torque += lesson_force_->elastic_torque();
    teller_->share(Effect::lesson, wrench_W.force, wrench_W.torque);
    if (has(lesson_force_->notes(), LinearisationNote::refused_not_finite)) {
        state_.faults |= Fault::command_invalid;
    }
}

}  // namespace fulcrum
