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

double DeadlineWatch::period_of(Deadline what) const noexcept {
    switch (what) {
        case Deadline::world:
            return periods_.world_s;
        case Deadline::kite:
            return periods_.kite_s;
        case Deadline::frame:
            return periods_.frame_s + periods_.hands_s;  // it waits for the tick behind it
        default:
            return periods_.hands_s;
    }
}

void DeadlineWatch::hands_stepped(double now_s, double jumped_s, const HapticState& state,
                                  double quiet_s) noexcept {
    double& last_s = last_s_[static_cast<std::size_t>(Deadline::hands)];
    if (last_s >= 0.0) {
        judge(Deadline::hands, now_s - last_s <= periods_.hands_s + jumped_s + kRounding_s, now_s);
    }
    last_s = now_s;
    if (quiet_s >= kSettle_s) {
        judge(Deadline::command, !any(state.faults & kLate), now_s);
    }
}

void DeadlineWatch::passed(Deadline what, double now_s, double quiet_s) noexcept {
    const double last_s = std::exchange(last_s_[static_cast<std::size_t>(what)], now_s);
    const double period_s = period_of(what);
    if (last_s >= 0.0 && quiet_s > period_s) {
        judge(what, now_s - last_s <= period_s + kRounding_s, now_s);
    }
}

}  // namespace fulcrum::runtime
