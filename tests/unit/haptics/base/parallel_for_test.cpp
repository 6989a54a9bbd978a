#include "haptics/base/parallel_for.h"

#include <catch2/catch.hpp>

#include <atomic>
#include <chrono>
#include <thread>

using namespace fulcrum;

TEST_CASE("parallel for: each piece is done once, whatever the threads, and none of none") {
    for (const std::size_t n_threads : {1U, 2U, 5U}) {
        for (const std::size_t n : {0U, 1U, 63U, 64U, 65U, 10000U}) {
            std::vector<int> done(n, 0);
            parallel_for(n, n_threads, [&](std::size_t i) noexcept { ++done[i]; });
            CHECK(std::count(done.begin(), done.end(), 1) == static_cast<std::ptrdiff_t>(n));
        }
    }
}

TEST_CASE("parallel for: the share done rises and stays within 0 and 1") {
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
}

TEST_CASE("parallel for: it stops where it is told to, and says so") {
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
