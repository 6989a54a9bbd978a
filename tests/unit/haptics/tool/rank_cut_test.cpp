#include "haptics/tool/rank_cut.h"

#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <vector>

using namespace fulcrum;

namespace {

std::vector<float> choose(const std::vector<float>& ranks, std::size_t room) {
    RankCut cut(ranks, room);
    std::vector<float> taken;
    std::copy_if(ranks.begin(), ranks.end(), std::back_inserter(taken),
                 [&](float rank) { return cut.takes(rank); });
    return taken;
}

}  // namespace

TEST_CASE("rank cut: takes exactly as many as there is room for, and none before a higher one") {
    Random random(1);
    for (const std::size_t n : {0U, 1U, 100U, 5000U}) {
        std::vector<float> ranks;
        for (std::size_t i = 0; i < n; ++i) {
            // Many are alike, as what touched is.
            const auto rank = static_cast<float>(1.0 + 1.2 * random.uniform());
            ranks.push_back(std::clamp(rank, 0.0F, RankCut::kFirst));
        }
        for (const std::size_t room : {0U, 1U, 7U, 99U, 100U, 101U, 4999U, 10000U}) {
            std::vector<float> taken = choose(ranks, room);
            REQUIRE(taken.size() == std::min(room, n));
            std::vector<float> best = ranks;
            std::sort(best.rbegin(), best.rend());
            std::sort(taken.rbegin(), taken.rend());
            for (std::size_t i = 0; i < taken.size(); ++i) {
                CHECK(taken[i] >= best[i] - RankCut::kFirst / 127.0F);
            }
        }
    }
}

TEST_CASE("rank cut: the first go before what is nearly first") {
    std::vector<float> ranks(50, 0.999F * RankCut::kFirst);
    ranks.insert(ranks.end(), 10, RankCut::kFirst);
    const std::vector<float> taken = choose(ranks, 12);
    CHECK(std::count(taken.begin(), taken.end(), RankCut::kFirst) == 10);
    CHECK(taken.size() == 12);
}
