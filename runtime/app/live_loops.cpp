#include "runtime/app/live_loops.h"

#include <array>
#include <cstdio>

namespace fulcrum::runtime {

Expected<void> LiveLoops::start(LessonRun& run, double epoch_s) {
    RealtimeSettings settings;
    settings.epoch_s = epoch_s;
    settings.rate_Hz = run.plan().haptic.rate_hz;
    settings.lock_memory = true;
    if (auto started = haptic_.start(run.rounds().task(), settings); !started) {
        return started;
    }
    if (BesideTask* const beside = run.haptic_loop().beside()) {
        if (auto started =
                contact_.start(*beside, BesideThread::compute_looks_Hz(settings.rate_Hz), epoch_s);
            !started) {
            return started;
        }
        contact_of_ = &run.haptic_loop();
    }
    epoch_s_ = epoch_s;
    return go_on(run);
}

Expected<void> LiveLoops::go_on(LessonRun& run) {
    RealtimeSettings settings;
    settings.epoch_s = epoch_s_;
    settings.spin_s = 0.0;  // a late world is felt as a held force; it needs no spinning
    settings.fifo_priority = 0;
    for (const EffectLoop& loop : run.effects().loops()) {
        settings.rate_Hz = loop.rate_hz;
        if (auto started = effects_.emplace_back().start(*loop.task, settings); !started) {
            return started;
        }
    }
    return {};
}

void LiveLoops::stand_still() noexcept {
    for (RealtimeThread& effect : effects_) {
        effect.stop();
    }
    effects_.clear();
}

std::string LiveLoops::describe_pace() const {
    const RealtimeStatus status = haptic_.status();
    std::array<char, 400> text{};
    std::snprintf(text.data(), text.size(),
                  "Haptic loop: %llu rounds, late by %.0f us (median), %.0f us (99 %%) and %.0f us "
                  "(most), %llu missed; %s.",
                  static_cast<unsigned long long>(status.rounds),
                  1e6 * haptic_.lateness().compute_quantile_s(0.5),
                  1e6 * haptic_.lateness().compute_quantile_s(0.99),
                  1e6 * haptic_.lateness().max_s(), static_cast<unsigned long long>(status.misses),
                  status.sentence.c_str());
    return text.data() + describe_contact();
}

std::optional<ContactPace> LiveLoops::contact_pace() const {
    const ContactLateness* const late =
        contact_of_ != nullptr ? contact_of_->contact_lateness() : nullptr;
    if (late == nullptr) {
        return contact_was_;
    }
    const LatencyHistogram& age = late->age();
    return ContactPace{contact_.status(), age.compute_quantile_s(0.5), age.compute_quantile_s(0.99),
                       age.max_s()};
}

std::string LiveLoops::describe_contact() const {
    const auto pace = contact_pace();
    if (!pace) {
        return {};
    }
    const BesideStatus& thread = pace->thread;
    std::array<char, 400> text{};
    std::snprintf(text.data(), text.size(),
                  "\nContact thread: %llu rounds, %.0f a second, each %.0f us (median), %.0f us "
                  "(99 %%) and %.0f us (most); what it told was %.1f ms old (median), %.1f ms "
                  "(99 %%) and %.1f ms (most)%s.",
                  static_cast<unsigned long long>(thread.rounds), thread.rate_Hz,
                  1e6 * thread.median_s, 1e6 * thread.p99_s, 1e6 * thread.most_s,
                  1e3 * pace->median_age_s, 1e3 * pace->p99_age_s, 1e3 * pace->most_age_s,
                  thread.failed ? "; stopped by an error in its work" : "");
    return text.data();
}

// The force ends first; then what it was made of.
void LiveLoops::stop() noexcept {
    haptic_.stop();
    contact_.stop();
    contact_was_ = contact_pace();
    contact_of_ = nullptr;  // that may end too, now
    stand_still();
}

}  // namespace fulcrum::runtime
