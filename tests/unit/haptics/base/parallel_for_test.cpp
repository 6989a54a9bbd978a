#include "haptics/base/parallel_for.h"

#include <catch2/catch.hpp>

#include <atomic>

using namespace fulcrum;

TEST_CASE(
    "parallel for: each piece is done once, whatever the threads, and none where there is none") {
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
