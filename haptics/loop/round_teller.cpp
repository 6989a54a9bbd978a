#include "haptics/loop/round_teller.h"

#include <algorithm>

namespace fulcrum {

void RoundTeller::begin(bool has_pose) noexcept {
    const bool is_asked = channels_->record != nullptr || channels_->shares != nullptr;
    if (is_asked) {
        std::fill_n(shares_.each_W.begin(), shares_.n, Wrench{});
    }
    is_kept_ = is_asked && has_pose;
}

void RoundTeller::share(Effect effect, const Vector3& force_W, const Vector3& torque_W,
                        std::size_t field) noexcept {
    if (!is_kept_) {
        return;
    }
    const auto first = slot_of_[static_cast<std::size_t>(effect)];
    shares_.each_W[static_cast<std::size_t>(first) + field] = {force_W, torque_W};
}

void RoundTeller::publish(HapticState& state, double now_s, double dt_s) noexcept {
    state.tick = tick_++;
    state.time_s = now_s;
    felt_time_.add(state, dt_s > 0.0 ? dt_s : 0.0);
    channels_->state_for_world.publish(state);
    channels_->state_for_lesson.publish(state);
    if (channels_->shares != nullptr) {
        channels_->shares->publish(shares_);
    }
}

Fault RoundTeller::record(const HapticState& state, const DeviceReading& told,
                          const ToldReading& reading) noexcept {
    const bool kept = channels_->record->push_by([&](RecordRound& round) {
        round.sample = {state.tick,         state.time_s,      told.stamp_s,      told.pose_D,
                        state.tool_twist_W, state.commanded_W, state.applied_W,   told.buttons,
                        state.faults,       state.gate,        state.touched_body};
        round.shares.n = shares_.n;
        std::copy_n(shares_.each_W.begin(), shares_.n, round.shares.each_W.begin());
    });
    const bool all_kept =
        (channels_->told == nullptr || channels_->told->keep(state.tick, reading)) && kept;
    return all_kept ? Fault::none : Fault::record_full;
}

}  // namespace fulcrum
