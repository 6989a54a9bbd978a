#include "haptics/link/replay_window.h"

#include <catch2/catch.hpp>

#include <rapidcheck.h>
#include <set>

using namespace fulcrum;

TEST_CASE("replay window: each number is taken once, in any order, as far back as it reaches") {
    ReplayWindow window;
    CHECK_FALSE(window.take(0));
    CHECK(window.take(5));
    CHECK_FALSE(window.take(5));
    CHECK(window.take(3));
    CHECK(window.take(5 + ReplayWindow::kReach));
    CHECK_FALSE(window.take(5));  // now too old
    CHECK(window.take(6));        // the oldest that may still come
    CHECK_FALSE(window.take(6));
    CHECK(window.newest() == 5 + ReplayWindow::kReach);
}

TEST_CASE("replay window: agrees with a set of all numbers that were taken") {
    CHECK(rc::check("replay window", [] {
        ReplayWindow window;
        std::set<std::uint64_t> taken;
        std::uint64_t newest = 0;
        const auto steps = *rc::gen::container<std::vector<std::uint64_t>>(
            400, rc::gen::inRange<std::uint64_t>(0, 700));
        std::uint64_t base = 0;
        for (const std::uint64_t step : steps) {
            // Sometimes far on, mostly near the newest.
            base += step == 699 ? 100'000 : step % 7;
            const std::uint64_t number = base + step > 350 ? base + step - 350 : 0;
            const bool is_new = number != 0 && !taken.contains(number) &&
                                (number > newest || newest - number < ReplayWindow::kReach);
            RC_ASSERT(window.take(number) == is_new);
            if (is_new) {
                taken.insert(number);
                newest = std::max(newest, number);
            }
        }
    }));
}

TEST_CASE("replay window: the largest numbers there are do not wrap it") {
    ReplayWindow window;
    const std::uint64_t last = ~std::uint64_t{0};
    CHECK(window.take(1));
    CHECK(window.take(last));
    CHECK_FALSE(window.take(last));
    CHECK(window.take(last - 1));
    CHECK_FALSE(window.take(1));
}
