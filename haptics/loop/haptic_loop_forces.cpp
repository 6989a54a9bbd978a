// What each effect of the plan adds to the force, and what of it gives the hand's work back. See haptic_loop.h.
#include "haptics/loop/haptic_loop.h"

namespace fulcrum {

void HapticLoop::add_contact() noexcept {
    if (touch_->contact.solid < 0) {
        touch_->coupling.leave();
        return;
    }
    const ContactForce felt = touch_->coupling.step(
        touch_->contact, state_.tool_pose_W.position,
        state_.tool_twist_W.linear - touch_->proxy_velocity.velocity(), touch_->poses_W);
    demand_.contact = felt.spring;
    demand_.force += {felt.spring.force, felt.spring.force};
    demand_.wrench_W.force += felt.force_W;
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
}

void HapticLoop::add_field(std::size_t index) noexcept {
    FieldStage& field = fields_[index];
    demand_.wrench_W.force +=
        field.step(channels_.command.value().fields[index], state_.tool_pose_W.position,
                   state_.tool_twist_W.linear, dt_s_);
    demand_.force += field.elastic();
}

void HapticLoop::add_lesson_force() noexcept {
    const Wrench wrench_W =
        lesson_force_->step(channels_.command.value().linearised, state_.tool_pose_W.position,
                            state_.tool_twist_W.linear, now_s_);
    demand_.wrench_W.force += wrench_W.force;
    demand_.wrench_W.torque += wrench_W.torque;
    demand_.force += lesson_force_->elastic_force();
    demand_.torque += lesson_force_->elastic_torque();
    if (has(lesson_force_->notes(), LinearisationNote::refused_not_finite)) {
        state_.faults |= Fault::command_invalid;
    }
}

}  // namespace fulcrum
