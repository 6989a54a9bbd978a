#include "haptics/loop/beside_thread.h"

#include "haptics/base/clock.h"

#include <algorithm>
#include <thread>

namespace fulcrum {
namespace {

constexpr double kLooksEachStep = 2.0;
constexpr double kMostLooks_Hz = 10000.0;  // of RealtimeSettings
constexpr int kPriority = 40;              // the haptic thread's is 80

}  // namespace

double BesideThread::compute_looks_Hz(double haptic_rate_Hz) noexcept {
    return std::min(kLooksEachStep * haptic_rate_Hz, kMostLooks_Hz);
}

void BesideThread::Counted::step(double /*now_s*/) {
    const double began_s = monotonic_now_s();
    if (task->run_once()) {
        duration.add(monotonic_now_s() - began_s);
        rounds.store(rounds.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
    }
}

Expected<void> BesideThread::start(BesideTask& task, double looks_Hz, double epoch_s) {
    if (thread_.status().running) {
        return fail("the thread runs already", {}, "stop it first");
    }
    RealtimeSettings settings;
    settings.rate_Hz = looks_Hz;
    settings.epoch_s = epoch_s;
    settings.spin_s = 0.0;
    settings.fifo_priority = std::thread::hardware_concurrency() > 1 ? kPriority : 0;
    counted_.task = &task;
    started_s_ = started_s_ > 0.0 ? started_s_ : monotonic_now_s();
    stopped_s_ = 0.0;
    return thread_.start(counted_, settings);
}

void BesideThread::stop() noexcept {
    thread_.stop();
    stopped_s_ = stopped_s_ > 0.0 ? stopped_s_ : monotonic_now_s();
}

BesideStatus BesideThread::status() const {
    const RealtimeStatus thread = thread_.status();
    const double ran_s = (stopped_s_ > 0.0 ? stopped_s_ : monotonic_now_s()) - started_s_;
    const std::uint64_t rounds = counted_.rounds.load(std::memory_order_relaxed);
    return {.running = thread.running,
            .failed = thread.failed,
            .rounds = rounds,
            .rate_Hz = started_s_ > 0.0 && ran_s > 0.0 ? static_cast<double>(rounds) / ran_s : 0.0,
            .median_s = counted_.duration.compute_quantile_s(0.5),
            .p99_s = counted_.duration.compute_quantile_s(0.99),
            .most_s = counted_.duration.max_s()};
}

}  // namespace fulcrum
