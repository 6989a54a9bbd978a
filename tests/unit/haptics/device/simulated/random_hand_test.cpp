#include "haptics/device/simulated/random_hand.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace fulcrum;

namespace {

constexpr double kDt_s = 0.001;

std::vector<HandTarget> play(std::uint64_t seed, double seconds, RandomHand* kept = nullptr) {
    RandomHand hand(seed);
    std::vector<HandTarget> wanted;
    HandTarget planned;
    planned.buttons = 1;
    for (double now_s = 0.0; now_s < seconds; now_s += kDt_s) {
        planned.pose_D.position = Vector3(0.1 * std::sin(now_s), 0.2, 0.0);
        wanted.push_back(hand.step(now_s, planned));
        wanted.back().pose_D.position -= planned.pose_D.position;
        REQUIRE(wanted.back().buttons == (hand.holds() ? 1U : 0U));
    }
    if (kept != nullptr) {
        *kept = hand;
    }
    return wanted;
}

}  // namespace

TEST_CASE("random hand: in two minutes it does all that it can, and stays near and whole") {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        RandomHand hand(0);
        const auto wanted = play(seed, 120.0, &hand);
        CAPTURE(seed);
        CHECK(*std::ranges::min_element(hand.done()) >= 2);
        double farthest_m = 0.0;
        for (const HandTarget& target : wanted) {
            REQUIRE(is_usable(target));
            farthest_m = std::max(farthest_m, target.pose_D.position.norm());
        }
        CHECK(farthest_m <= RandomHand::kFarthest_m + 1e-12);
        CHECK(farthest_m > 0.05);
    }
}

TEST_CASE(
    "random hand: it follows at least as often as it does not, and one deed leads to the next") {
    RandomHand hand(0);
    const auto wanted = play(5, 120.0, &hand);
    std::uint64_t others = 0;
    for (std::size_t i = 1; i < kHandDeeds; ++i) {
        others += hand.done()[i];
    }
    CHECK(hand.done()[0] >= others);
    // No leap: the fastest is a jerk, 2 pi 8 Hz 4 cm, and what it cut short, on top of the quickest way there.
    constexpr double kFastest_m_per_s = 2.1 + 6.0;
    for (std::size_t i = 1; i < wanted.size(); ++i) {
        const Vector3 way = wanted[i].pose_D.position - wanted[i - 1].pose_D.position;
        REQUIRE(way.norm() <= kFastest_m_per_s * kDt_s);
    }
}

TEST_CASE("random hand: one seed is one hand, another is another") {
    const auto once = play(7, 20.0);
    const auto again = play(7, 20.0);
    const auto other = play(8, 20.0);
    bool is_other = false;
    for (std::size_t i = 0; i < once.size(); ++i) {
        REQUIRE(once[i].pose_D.position == again[i].pose_D.position);
        is_other = is_other || once[i].pose_D.position != other[i].pose_D.position;
    }
    CHECK(is_other);
}
