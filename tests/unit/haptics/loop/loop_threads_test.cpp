#include "haptics/base/clock.h"
#include "haptics/base/flush_to_zero.h"
#include "haptics/loop/beside_thread.h"
#include "haptics/loop/latency_histogram.h"
#include "haptics/loop/realtime_thread.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/eventually.h"

#include <catch2/catch.hpp>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

using namespace fulcrum;
using test_support::eventually;

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

// Work that is there every third time it is asked for.
class EveryThird final : public BesideTask {
  public:
    bool run_once() noexcept override {
        const int n = n_asked.fetch_add(1) + 1;
        n_done += n % 3 == 0;
        return n % 3 == 0;
    }
    std::atomic<int> n_asked{0};
    std::atomic<std::uint64_t> n_done{0};
};

}  // namespace

TEST_CASE("realtime thread: it counts its rounds and silences last, after a throw as well") {
    CountingTask task;
    RealtimeThread thread;
    RealtimeSettings settings;
    settings.epoch_s = monotonic_now_s();
    REQUIRE(thread.start(task, settings));
    REQUIRE(eventually([&] { return task.rounds.load() >= 50; }));
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
    CountingTask thrower;
    thrower.throw_at = 5;
    RealtimeThread failing;
    REQUIRE(failing.start(thrower, RealtimeSettings{}));
    REQUIRE(eventually([&] { return thrower.silenced.load() == 1; }));
    failing.stop();
    CHECK(thrower.rounds.load() == 5);
    CHECK(failing.status().failed);
    CHECK(failing.status().sentence.find("stopped by an error") != std::string::npos);
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
    REQUIRE(eventually([&] { return task.rounds.load() >= 10; }));
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
    REQUIRE(eventually([&] { return task.rounds.load() >= 20; }));
    const std::uint64_t before =
        thread.status().pauses;  // of a test machine that itself stood still
    CHECK(static_cast<std::uint64_t>(task.silenced.load()) == before);
    // What is less than the clocks may differ is no sleep; half an hour is one, once.
    asleep_s = 100.0005;
    const int calm = task.rounds.load();
    REQUIRE(eventually([&] { return task.rounds.load() >= calm + 20; }));
    const std::uint64_t after = thread.status().pauses;
    asleep_s = 1900.0;
    REQUIRE(eventually([&] { return thread.status().pauses > after; }));
    const int woken = task.rounds.load();
    REQUIRE(eventually([&] { return task.rounds.load() >= woken + 20; }));
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
    REQUIRE(eventually([&] { return task.rounds.load() >= 30; }));
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
    REQUIRE(eventually([&] { return task.rounds.load() > before; }));
}

TEST_CASE("beside thread: twice a haptic round at most, and rounds with work are counted") {
    CHECK(BesideThread::compute_looks_Hz(1000.0) == 2000.0);
    CHECK(BesideThread::compute_looks_Hz(5000.0) == 10000.0);
    CHECK(BesideThread::compute_looks_Hz(8000.0) == 10000.0);
    EveryThird task;
    BesideThread thread;
    CHECK_FALSE(thread.status().running);
    CHECK(thread.status().rate_Hz == 0.0);
    const double began_s = monotonic_now_s();
    REQUIRE(thread.start(task, 2000.0, began_s));
    CHECK(thread.status().running);
    REQUIRE(eventually([&] { return task.n_done.load() >= 20; }));
    thread.stop();
    const double took_s = monotonic_now_s() - began_s;
    const BesideStatus status = thread.status();
    CHECK_FALSE(status.running);
    CHECK_FALSE(status.failed);
    CHECK(status.rounds == task.n_done.load());
    CHECK(task.n_asked.load() >= 3 * static_cast<int>(status.rounds));
    // Over the time that it ran, which is no longer than ours and goes on no more.
    CHECK(status.rate_Hz >= static_cast<double>(status.rounds) / took_s);
    CHECK(thread.status().rate_Hz == status.rate_Hz);
    CHECK(status.rate_Hz < 2000.0);
    CHECK(status.median_s <= status.p99_s);
    CHECK(status.p99_s <= status.most_s);
}

TEST_CASE("beside thread: a second start and a bad rate are refused, a new start counts on") {
    EveryThird task;
    BesideThread thread;
    CHECK_FALSE(thread.start(task, 0.0, 0.0));
    REQUIRE(thread.start(task, 1000.0, 0.0));
    CHECK_FALSE(thread.start(task, 1000.0, 0.0));
    REQUIRE(eventually([&] { return task.n_done.load() >= 2; }));
    thread.stop();
    const std::uint64_t rounds = thread.status().rounds;
    REQUIRE(thread.start(task, 1000.0, 0.0));
    REQUIRE(eventually([&] { return task.n_done.load() >= rounds + 2; }));
    thread.stop();
    CHECK(thread.status().rounds == task.n_done.load());
    CHECK(thread.status().rounds >= rounds + 2);
}

TEST_CASE("latency: quantiles of known counts lie in the right bin, an eighth wide at most") {
    LatencyHistogram histogram;
    CHECK(histogram.compute_quantile_s(0.5) == 0.0);
    for (int i = 1; i <= 1000; ++i) {
        histogram.add(i * 1e-6);
    }
    CHECK(histogram.count() == 1000);
    CHECK(histogram.max_s() == Approx(1000e-6).epsilon(1e-5));
    for (const double share : {0.01, 0.5, 0.9, 0.99, 1.0}) {
        const double quantile_s = histogram.compute_quantile_s(share);
        CHECK(quantile_s >= share * 1000e-6 * (1.0 - 1e-5));
        CHECK(quantile_s <= share * 1000e-6 * 1.126);
        CHECK(quantile_s <= histogram.max_s());
    }
}

TEST_CASE("latency: every nanosecond's bin contains it, borders too") {
    for (std::uint64_t ns = 1; ns < 100000; ns += ns < 100 ? 1 : 97) {
        LatencyHistogram histogram;
        histogram.add(static_cast<double>(ns) * 1e-9 + 1e-13);
        histogram.add(1.0);
        const double quantile_s = histogram.compute_quantile_s(0.5);
        REQUIRE(quantile_s >= static_cast<double>(ns) * 1e-9 * (1.0 - 1e-9));
        REQUIRE(quantile_s <= static_cast<double>(ns) * 1e-9 * 1.1251 + 1e-12);
    }
}

TEST_CASE("latency: times that are none count as zero, endless ones as very long") {
    LatencyHistogram histogram;
    histogram.add(-1.0);
    histogram.add(kNan);
    CHECK(histogram.max_s() == 0.0);
    CHECK(histogram.compute_quantile_s(1.0) == 0.0);
    histogram.add(kInfinity);
    CHECK(histogram.count() == 3);
    CHECK(histogram.max_s() > 1e9);
}
