#include "haptics/loop/line_stage.h"

namespace fulcrum {

void LineStage::tell_hand(const Vector3& hand_W) noexcept {
    if (channels_ != nullptr) {
        channels_->hand_W.publish(hand_W);
    }
}

LineForce LineStage::step(const Pose& tool_W, double now_s, double dt_s) noexcept {
    if (channels_ == nullptr) {
        return {};
    }
    (void)channels_->line.take();
    const Wrench felt_W = feel_.step(channels_->line.value(), tool_W, now_s, dt_s);
    const Wrench& held_W = feel_.held_W();
    return {felt_W, {felt_W.force, held_W.force}, {felt_W.torque, held_W.torque}};
}

}  // namespace fulcrum
