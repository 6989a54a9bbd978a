// What the haptic loop tells: its state, each effect's share of the force, every round for the record. See haptic_loop.h.
#include "haptics/loop/haptic_loop.h"
#include "haptics/loop/told_rings.h"

#include <algorithm>

namespace fulcrum {

// Where nobody asks there is nothing to clear and nothing to keep.
void HapticLoop::begin_shares() noexcept {
    tells_shares_ = channels_.record != nullptr || channels_.shares != nullptr;
    if (tells_shares_) {
        std::fill_n(shares_.each_W.begin(), shares_.n, Wrench{});
    }
}

// Told beside what is summed, so that the sum is the same whether anybody asks or not.
void HapticLoop::share(Effect effect, const Vector3& force_W, const Vector3& torque_W,
                       std::size_t field) noexcept {
    if (!tells_shares_ || !has_pose_) {
        return;
    }
    const auto first = slot_of_[static_cast<std::size_t>(effect)];
    shares_.each_W[static_cast<std::size_t>(first) + field] = {force_W, torque_W};
}

void HapticLoop::publish_state() noexcept {
    state_.tick = tick_++;
    state_.time_s = now_s_;
    felt_time_.add(state_, dt_s_ > 0.0 ? dt_s_ : 0.0);
    channels_.state_for_world.publish(state_);
    channels_.state_for_lesson.publish(state_);
    if (channels_.shares != nullptr) {
        channels_.shares->publish(shares_);
    }
}

void HapticLoop::record_round() noexcept {
    const bool kept = channels_.record->push_by([this](RecordRound& round) {
        round.sample = {
            state_.tick,        now_s_,           told_.stamp_s, told_.pose_D,  state_.tool_twist_W,
            state_.commanded_W, state_.applied_W, told_.buttons, state_.faults, state_.gate,
            state_.touched_body};
        round.shares.n = shares_.n;
        std::copy_n(shares_.each_W.begin(), shares_.n, round.shares.each_W.begin());
    });
    const bool all_kept = (channels_.told == nullptr ||
                           channels_.told->keep(state_.tick, {told_faults_, is_reading_})) &&
                          kept;
    late_faults_ |= all_kept ? Fault::none : Fault::record_full;
}

}  // namespace fulcrum
