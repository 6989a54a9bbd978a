#include "runtime/app/live_loops.h"

#include <array>
#include <cstdio>

namespace fulcrum::runtime {

Expected<void> LiveLoops::start(LessonRun& run, double epoch_s) {
    RealtimeSettings settings;
    settings.epoch_s = epoch_s;
    settings.rate_Hz = run.plan().haptic.rate_hz;
    settings.lock_memory = true;
    if (auto started = haptic_.start(run.hands_loop(), settings); !started) {
        return started;
    }
    settings.spin_s = 0.0;  // a late world is felt as a held force; it needs no spinning
    settings.fifo_priority = 0;
    settings.lock_memory = false;
    if (run.world_loop() != nullptr) {
        settings.rate_Hz = run.plan().world_rate_hz();
        if (auto started = world_.start(*run.world_loop(), settings); !started) {
            return started;
        }
    }
    if (run.kite_loop() != nullptr) {
        settings.rate_Hz = run.plan().kite->rate_hz;
        return kite_.start(*run.kite_loop(), settings);
    }
    return {};
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
    return text.data();
}

void LiveLoops::stop() noexcept {
    haptic_.stop();
    world_.stop();
    kite_.stop();
}

}  // namespace fulcrum::runtime
