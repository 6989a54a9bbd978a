#include "haptics/base/flush_to_zero.h"
#include "haptics/base/load_progress.h"
#include "haptics/base/parallel_for.h"
#include "haptics/base/processor.h"
#include "haptics/base/worker_pool.h"

#include <catch2/catch.hpp>

#include <array>
#include <atomic>
#include <chrono>
#include <new>
#include <pthread.h>
#include <string>
#include <thread>
#include <vector>

using namespace fulcrum;
using namespace std::chrono_literals;

TEST_CASE("load pulse: it asks now and then, however often it is asked itself") {
    std::vector<double> told;
    const LoadProgress progress = [&](double share) {
        told.push_back(share);
        return true;
    };
    LoadPulse pulse(progress);
    const auto begun = std::chrono::steady_clock::now();
    int n_asked = 0;
    while (std::chrono::steady_clock::now() - begun < 300ms) {
        CHECK(pulse.goes_on(0.25));
        std::this_thread::sleep_for(1ms);
        ++n_asked;
    }
    CHECK(told.size() >= 2);
    CHECK(told.size() <= 6);
    CHECK(told.front() == 0.25);
    const std::size_t n_told = told.size();
    CHECK(pulse.goes_on_now(0.5));
    CHECK(told.size() == n_told + 1);
    CHECK(told.back() == 0.5);
}

TEST_CASE("load pulse: once stopped it stays stopped, and asks no more") {
    int n_told = 0;
    const LoadProgress progress = [&](double) {
        ++n_told;
        return false;
    };
    LoadPulse pulse(progress);
    CHECK(pulse.goes_on(0.0));  // not yet asked
    std::this_thread::sleep_for(60ms);
    CHECK_FALSE(pulse.goes_on(0.1));
    CHECK_FALSE(pulse.goes_on(0.2));
    CHECK_FALSE(pulse.goes_on_now(0.3));
    CHECK(n_told == 1);
    const LoadProgress nobody;
    CHECK(LoadPulse(nobody).goes_on_now(0.5));
}

TEST_CASE("parallel for: what a piece throws on any thread is thrown to the caller, and ends it") {
    for (const std::size_t fails_at : {std::size_t{0}, std::size_t{999}}) {
        std::atomic<std::size_t> n_done{0};
        const auto work = [&](std::size_t piece) {
            if (piece == fails_at) {
                throw std::bad_alloc();
            }
            n_done.fetch_add(1);
        };
        CHECK_THROWS_AS(parallel_for(1000, 3, work), std::bad_alloc);
        CHECK(n_done.load() < 1000);
    }
}

TEST_CASE(
    "parallel for: each piece is done once, the share done rises, and it stops when told to") {
    for (const std::size_t n_threads : {1U, 2U, 5U}) {
        for (const std::size_t n : {0U, 1U, 63U, 64U, 65U, 10000U}) {
            std::vector<int> done(n, 0);
            parallel_for(n, n_threads, [&](std::size_t i) noexcept { ++done[i]; });
            CHECK(std::count(done.begin(), done.end(), 1) == static_cast<std::ptrdiff_t>(n));
        }
    }
    std::vector<double> told;
    parallel_for(
        100000, 1, [](std::size_t) noexcept {},
        [&](double share) {
            told.push_back(share);
            return true;
        });
    REQUIRE(told.size() > 5);
    CHECK(std::is_sorted(told.begin(), told.end()));
    CHECK(told.front() > 0.0);
    CHECK(told.back() <= 1.0);
    for (const std::size_t n_threads : {1U, 3U}) {
        std::atomic<std::size_t> n_done{0};
        int n_asked = 0;
        CHECK_FALSE(parallel_for(
            10'000'000, n_threads, [&](std::size_t) noexcept { ++n_done; },
            [&](double) { return ++n_asked < 3; }));
        CHECK(n_asked == 3);
        CHECK(n_done < 10'000'000);
    }
    CHECK(parallel_for(
        10, 1, [](std::size_t) noexcept {}, [](double) { return true; }));
}

TEST_CASE("parallel for: an end is heard between slow pieces, and within one that asks") {
    using namespace std::chrono_literals;
    for (const std::size_t n_threads : {1U, 3U}) {
        // 300 pieces of 20 ms: more than 64 of them would be a second.
        std::atomic<std::size_t> n_done{0};
        CHECK_FALSE(parallel_for(
            300, n_threads,
            [&](std::size_t) noexcept {
                std::this_thread::sleep_for(20ms);
                ++n_done;
            },
            [](double) { return false; }));
        CHECK(n_done < 60);
    }
    // One piece that would never end by itself.
    double share = -1.0;
    CHECK_FALSE(parallel_for(
        1, 1,
        [](std::size_t, WorkWatch& watch) noexcept {
            while (watch.goes_on()) {
            }
        },
        [&](double now) {
            share = now;
            return false;
        }));
    CHECK(share == 1.0);
}

TEST_CASE(
    "worker pool: each piece once, a worker for each, any number of workers, pools in a row") {
    for (const int n_workers : {1, 2, 3, 5}) {
        WorkerPool pool(n_workers);
        REQUIRE(pool.n_workers() == n_workers);
        for (int round = 0; round < 2000; ++round) {
            const int n_pieces = round % 23;
            std::vector<int> done(static_cast<std::size_t>(n_pieces), 0);
            pool.run(n_pieces, [&](int piece, int) noexcept {
                done[static_cast<std::size_t>(piece)] += round + 1;
            });
            for (const int times : done) {
                REQUIRE(times == round + 1);
            }
        }
    }
    WorkerPool four(4);
    std::array<std::atomic<int>, 4> at_work{};
    std::atomic<int> n_clashes{0};
    four.run(4000, [&](int, int worker) noexcept {
        auto& mine = at_work[static_cast<std::size_t>(worker)];
        n_clashes += mine.fetch_add(1) == 0 ? 0 : 1;
        mine.fetch_sub(1);
    });
    CHECK(n_clashes == 0);
    CHECK(WorkerPool(0).n_workers() == 1);
    CHECK(WorkerPool(1000).n_workers() == WorkerPool::kMostWorkers);
    std::atomic<int> n_done{0};
    for (int i = 0; i < 400; ++i) {
        WorkerPool pool(2 + i % 3);
        if (i % 2 == 0) {
            pool.run(3, [&](int, int) noexcept { ++n_done; });
        }
    }
    CHECK(n_done == 3 * 200);
}

TEST_CASE("worker pool: where the system gives no thread the caller does all by itself") {
    pthread_attr_t before;
    pthread_attr_t huge;
    REQUIRE(pthread_getattr_default_np(&before) == 0);
    REQUIRE(pthread_attr_init(&huge) == 0);
    // More than there are addresses: no stack, no thread.
    REQUIRE(pthread_attr_setstacksize(&huge, std::size_t{1} << 50) == 0);
    REQUIRE(pthread_setattr_default_np(&huge) == 0);
    int n_done = 0;
    {
        WorkerPool pool(4);
        CHECK(pthread_setattr_default_np(&before) == 0);
        CHECK(pool.n_workers() == 1);
        pool.run(10, [&](int, int) noexcept { ++n_done; });
    }
    CHECK(n_done == 10);
    CHECK(pthread_attr_destroy(&huge) == 0);
    CHECK(pthread_attr_destroy(&before) == 0);
}

TEST_CASE(
    "processor: the last version that there is, the plain one at least; names fit what it has") {
    const int plain = 0;
    const int wide = 0;
    const int wider = 0;
    const int* const none = nullptr;
    CHECK(widest_of(std::array{&plain, none, none}) == &plain);
    CHECK(widest_of(std::array{&plain, &wide, none}) == &wide);
    CHECK(widest_of(std::array{&plain, none, &wider}) == &wider);
    CHECK(widest_of(std::array{&plain, &wide, &wider}) == &wider);
    CHECK((has_avx2() || !has_avx512()));
    CHECK(std::string(name_kernels()) == (has_avx512() ? "AVX-512"
                                          : has_avx2() ? "AVX2"
                                                       : "plain"));
}

TEST_CASE("flush to zero: denormals vanish within the scope and live again after it") {
    volatile double small = 4e-308;
    CHECK(small * 0.5 != 0.0);
#ifdef FULCRUM_FLUSHES_TO_ZERO
    {
        const ScopedFlushToZero flush_to_zero;
        CHECK(small * 0.5 == 0.0);
    }
#endif
    CHECK(small * 0.5 != 0.0);
}
