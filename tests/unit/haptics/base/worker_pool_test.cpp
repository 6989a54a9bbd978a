#include "haptics/base/worker_pool.h"

#include <catch2/catch.hpp>

#include <array>
#include <atomic>
#include <pthread.h>
#include <vector>

using namespace fulcrum;

TEST_CASE("worker pool: each piece is done once, round after round, and all before it returns") {
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
}

TEST_CASE("worker pool: no two pieces at a time have one worker") {
    WorkerPool pool(4);
    std::array<std::atomic<int>, 4> at_work{};
    std::atomic<int> n_clashes{0};
    pool.run(4000, [&](int, int worker) noexcept {
        auto& mine = at_work[static_cast<std::size_t>(worker)];
        n_clashes += mine.fetch_add(1) == 0 ? 0 : 1;
        mine.fetch_sub(1);
    });
    CHECK(n_clashes == 0);
}

TEST_CASE("worker pool: a number of workers out of range is brought into it") {
    CHECK(WorkerPool(0).n_workers() == 1);
    CHECK(WorkerPool(1000).n_workers() == WorkerPool::kMostWorkers);
}

TEST_CASE("worker pool: pools come and go in a row, used or not, and none waits for ever") {
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
