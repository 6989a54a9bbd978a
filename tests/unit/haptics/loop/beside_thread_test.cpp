#include "haptics/loop/beside_thread.h"

#include "haptics/base/clock.h"

#include <catch2/catch.hpp>

#include <atomic>
#include <chrono>
#include <thread>

using namespace fulcrum;

namespace {

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

template <class Condition>
bool await(Condition condition) {
    for (int i = 0; i < 20'000; ++i) {
        if (condition()) {
            return true;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
}

}  // namespace

TEST_CASE("beside thread: it looks twice a haptic round, and no oftener than a thread can") {
    CHECK(BesideThread::compute_looks_Hz(1000.0) == 2000.0);
    CHECK(BesideThread::compute_looks_Hz(5000.0) == 10000.0);
    CHECK(BesideThread::compute_looks_Hz(8000.0) == 10000.0);
}

TEST_CASE("beside thread: rounds with something to do are counted, looks are not") {
    EveryThird task;
    BesideThread thread;
    CHECK_FALSE(thread.status().running);
    CHECK(thread.status().rate_Hz == 0.0);
    const double began_s = monotonic_now_s();
    REQUIRE(thread.start(task, 2000.0, began_s));
    CHECK(thread.status().running);
    REQUIRE(await([&] { return task.n_done.load() >= 20; }));
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
    REQUIRE(await([&] { return task.n_done.load() >= 2; }));
    thread.stop();
    const std::uint64_t rounds = thread.status().rounds;
    REQUIRE(thread.start(task, 1000.0, 0.0));
    REQUIRE(await([&] { return task.n_done.load() >= rounds + 2; }));
    thread.stop();
    CHECK(thread.status().rounds == task.n_done.load());
    CHECK(thread.status().rounds >= rounds + 2);
}
