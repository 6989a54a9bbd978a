#include "haptics/loop/realtime_thread.h"

#include "haptics/base/clock.h"
#include "haptics/base/flush_to_zero.h"
#include "tests/support/bad_numbers.h"

#include <catch2/catch.hpp>

#include <atomic>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <thread>

using namespace fulcrum;

namespace {

// Counts its rounds, checks that time never goes back, and throws when told to.
struct CountingTask final : PeriodicTask {
    void step(double now_s) override {
        went_back = went_back || now_s < last_s;
        last_s = now_s;
        denormal = denormal * 0.5;
        if (++rounds == throw_at) {
            throw std::runtime_error("the task has had enough");
        }
    }
    void silence(double /*now_s*/) noexcept override { ++silenced; }

    std::atomic<int> rounds{0};
    std::atomic<int> silenced{0};
    int throw_at = -1;
    double last_s = -1.0;
    bool went_back = false;
    volatile double denormal = 4e-308;
};

// Waits for a condition that a thread will bring about, however slow the machine is.
template <class Condition>
void wait_for(Condition condition) {
    while (!condition()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

}  // namespace

TEST_CASE("realtime thread: calls its task, keeps count, and silences it last") {
    CountingTask task;
    RealtimeThread thread;
    RealtimeSettings settings;
    settings.epoch_s = monotonic_now_s();
    REQUIRE(thread.start(task, settings));
    wait_for([&] { return task.rounds.load() >= 50; });
    CHECK(task.silenced.load() == 0);
    CHECK(thread.status().running);
    thread.stop();
    CHECK(task.silenced.load() == 1);
    const RealtimeStatus status = thread.status();
    CHECK_FALSE(status.running);
    CHECK_FALSE(status.failed);
    CHECK(status.rounds == static_cast<std::uint64_t>(task.rounds.load()));
    CHECK(thread.lateness().count() == status.rounds);
    CHECK(thread.duration().count() == status.rounds);
    CHECK_FALSE(task.went_back);
    CHECK(task.last_s >= 0.0);
    CHECK(status.sentence.find("1000 Hz") != std::string::npos);
    CHECK(status.sentence.find("SCHED_FIFO") != std::string::npos);
    // Denormals vanished in the thread: 4e-308 halved is below the smallest normal number.
#ifdef FULCRUM_FLUSHES_TO_ZERO
    CHECK(task.denormal == 0.0);
#endif
    thread.stop();
    CHECK(task.silenced.load() == 1);
}

TEST_CASE("realtime thread: a task that throws ends the thread, silenced") {
    CountingTask task;
    task.throw_at = 5;
    RealtimeThread thread;
    REQUIRE(thread.start(task, RealtimeSettings{}));
    wait_for([&] { return task.silenced.load() == 1; });
    thread.stop();
    CHECK(task.rounds.load() == 5);
    CHECK(thread.status().failed);
    CHECK(thread.status().sentence.find("stopped by an error") != std::string::npos);
}

TEST_CASE("realtime thread: rounds that take too long are skipped and counted, not made up") {
    struct SlowTask final : PeriodicTask {
        void step(double now_s) override {
            if (rounds++ < 3) {
                while (monotonic_now_s() - epoch_s < now_s + 0.0105) {
                }
            }
        }
        void silence(double /*now_s*/) noexcept override {}
        std::atomic<int> rounds{0};
        double epoch_s = monotonic_now_s();
    } task;
    RealtimeThread thread;
    RealtimeSettings settings;
    settings.epoch_s = task.epoch_s;
    settings.fifo_priority = 0;
    REQUIRE(thread.start(task, settings));
    wait_for([&] { return task.rounds.load() >= 10; });
    thread.stop();
    CHECK(thread.status().misses >= 30);
    CHECK(thread.duration().max_s() >= 0.0105);
    CHECK_FALSE(thread.status().has_fifo);
}

TEST_CASE("realtime thread: a machine that slept, or a program that was stopped, begins silent") {
    static std::atomic<double> asleep_s{100.0};
    asleep_s = 100.0;
    CountingTask task;
    RealtimeThread thread;
    RealtimeSettings settings;
    settings.slept_s = []() noexcept { return asleep_s.load(); };
    REQUIRE(thread.start(task, settings));
    wait_for([&] { return task.rounds.load() >= 20; });
    const std::uint64_t before =
        thread.status().pauses;  // of a test machine that itself stood still
    CHECK(static_cast<std::uint64_t>(task.silenced.load()) == before);
    // What is less than the clocks may differ is no sleep; half an hour is one, once.
    asleep_s = 100.0005;
    const int calm = task.rounds.load();
    wait_for([&] { return task.rounds.load() >= calm + 20; });
    const std::uint64_t after = thread.status().pauses;
    asleep_s = 1900.0;
    wait_for([&] { return thread.status().pauses > after; });
    const int woken = task.rounds.load();
    wait_for([&] { return task.rounds.load() >= woken + 20; });
    thread.stop();
    CHECK(thread.status().pauses >= after + 1);
    CHECK(static_cast<std::uint64_t>(task.silenced.load()) == thread.status().pauses + 1);
    CHECK(thread.status().sentence.find("asleep") != std::string::npos);
    settings.slept_s = nullptr;
    CHECK_FALSE(thread.start(task, settings));
    // The machine's own clocks: it did not sleep since the last line.
    const double slept_s = machine_slept_s();
    CHECK(slept_s >= -kSleptWithin_s);
    CHECK(machine_slept_s() - slept_s < 1.0);
}

TEST_CASE("realtime thread: a program that stood still for long begins silent") {
    struct StandingTask final : PeriodicTask {
        void step(double /*now_s*/) override {
            if (++rounds == 10) {
                // As after SIGSTOP and SIGCONT: the next round begins later by more than kLongestPause_s.
                std::this_thread::sleep_for(std::chrono::milliseconds(1200));
            }
        }
        void silence(double /*now_s*/) noexcept override { silenced_after = rounds.load(); }
        std::atomic<int> rounds{0};
        std::atomic<int> silenced_after{0};
    } task;
    RealtimeThread thread;
    REQUIRE(thread.start(task, RealtimeSettings{}));
    wait_for([&] { return task.rounds.load() >= 30; });
    CHECK(task.silenced_after.load() >= 10);
    CHECK(thread.status().pauses >= 1);
}

TEST_CASE("realtime thread: bad settings and a second start are refused; after a stop it starts") {
    CountingTask task;
    RealtimeThread thread;
    RealtimeSettings settings;
    settings.spin_s = 0.01;
    CHECK_FALSE(thread.start(task, settings));
    settings = {};
    settings.rate_Hz = kNan;
    CHECK_FALSE(thread.start(task, settings));
    settings = {};
    settings.fifo_priority = 100;
    CHECK_FALSE(thread.start(task, settings));
    CHECK(task.rounds.load() == 0);
    settings = {};
    REQUIRE(thread.start(task, settings));
    CHECK_FALSE(thread.start(task, settings));
    thread.stop();
    REQUIRE(thread.start(task, settings));
    const int before = task.rounds.load();
    wait_for([&] { return task.rounds.load() > before; });
}
