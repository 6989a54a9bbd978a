#include "runtime/app/run_rounds.h"

namespace fulcrum::runtime {

void RunRounds::build(const RunHands& hands) {
    one_ = hands.front()->loop.get();
    if (hands.size() > 1) {
        std::vector<HandInRound> round;
        for (const auto& hand : hands) {
            round.push_back({hand->loop.get(), &hand->loop_channels()});
        }
        all_ = std::make_unique<HandsLoop>(round);
    }
    if (hands.front()->told) {
        std::vector<ToldReplay::Hand> told;
        for (const auto& hand : hands) {
            told.push_back(
                {hand->replayed, hand->loop.get(), &hand->loop_channels(), &hand->channels});
        }
        told_ = std::make_unique<ToldReplay>(std::move(told));
        return;
    }
    std::vector<ReplayedStops::Hand> stopped;
    for (const auto& hand : hands) {
        if (hand->replayed) {
            stopped.push_back({hand->replayed, &hand->channels});
        }
    }
    if (!stopped.empty()) {
        stops_ = std::make_unique<ReplayedStops>(std::move(stopped), task());
    }
}

PeriodicTask& RunRounds::task() {
    return told_    ? static_cast<PeriodicTask&>(*told_)
           : stops_ ? static_cast<PeriodicTask&>(*stops_)
           : all_   ? static_cast<PeriodicTask&>(*all_)
                    : *one_;
}

std::optional<double> RunRounds::replay_end_s(const Record& record, double rate_hz) const {
    if (record.samples.empty()) {
        return std::nullopt;
    }
    // Half a round behind the last one, so that it is the last here too.
    constexpr double kHalf = 0.5;
    return told_ ? (static_cast<double>(told_->n_rounds()) - kHalf) / rate_hz
                 : record.samples.back().time_s + kHalf / rate_hz;
}

void RunRounds::step(double now_s, StageListener& listener) {
    if (told_) {
        return told_->step_observed(now_s, listener);
    }
    if (stops_) {
        stops_->repeat(now_s);
    }
    if (all_) {
        all_->step_observed(now_s, listener);
    } else {
        one_->step_observed(now_s, listener);
    }
}

}  // namespace fulcrum::runtime
