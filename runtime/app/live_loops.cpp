#include "runtime/app/live_loops.h"

namespace fulcrum::runtime {

Expected<void> LiveLoops::start(LessonRun& run, double epoch_s) {
    RealtimeSettings settings;
    settings.epoch_s = epoch_s;
    settings.rate_Hz = run.plan().haptic.rate_hz;
    settings.lock_memory = true;
    if (auto started = haptic_.start(run.haptic_loop(), settings); !started) {
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

void LiveLoops::stop() noexcept {
    haptic_.stop();
    world_.stop();
    kite_.stop();
}

}  // namespace fulcrum::runtime
