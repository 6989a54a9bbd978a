#include "runtime/app/deadline_watch.h"

#include <utility>

namespace fulcrum::runtime {
namespace {

constexpr double kRounding_s = 1.0e-9;
// What is told of somebody who is late, or of something that got lost.
constexpr Fault kLate = Fault::device_read | Fault::device_stale | Fault::command_stale |
                        Fault::device_write | Fault::record_full;

}  // namespace

void DeadlineWatch::judge(Deadline what, bool is_met, double now_s) noexcept {
    met_[static_cast<std::size_t>(what)] += is_met ? 1 : 0;
    if (is_met) {
        return;
    }
    ++n_broken_;
    if (broken_ == Deadline::none) {
        broken_ = what;
        broken_at_s_ = now_s;
    }
}

void DeadlineWatch::hands_stepped(double now_s, double jumped_s, const HapticState& state,
                                  double quiet_s) noexcept {
    const double last_s = std::exchange(hands_last_s_, now_s);
    if (last_s >= 0.0) {
        judge(Deadline::hands, now_s - last_s <= periods_.hands_s + jumped_s + kRounding_s, now_s);
    }
    if (quiet_s >= kSettle_s) {
        judge(Deadline::command, !any(state.faults & kLate), now_s);
    }
}

// A frame waits for the tick behind it.
void DeadlineWatch::passed_frame(double now_s, double quiet_s) noexcept {
    passed(Deadline::frame, frame_last_s_, periods_.frame_s + periods_.hands_s, now_s, quiet_s);
}

void DeadlineWatch::passed_effect(std::size_t effect, double now_s, double quiet_s) noexcept {
    passed(Deadline::effect, effects_last_s_[effect], periods_.effects_s[effect], now_s, quiet_s);
}

void DeadlineWatch::passed(Deadline what, double& last_s, double period_s, double now_s,
                           double quiet_s) noexcept {
    const double before_s = std::exchange(last_s, now_s);
    if (before_s >= 0.0 && quiet_s > period_s) {
        judge(what, now_s - before_s <= period_s + kRounding_s, now_s);
    }
}

}  // namespace fulcrum::runtime
