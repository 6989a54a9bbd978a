#include "haptics/dynamics/islands.h"

#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace fulcrum {
namespace {

using Links = std::vector<std::pair<std::int32_t, std::int32_t>>;

// Numbers spread along links until nothing changes: the least body of each island.
std::vector<std::int32_t> spread(const std::vector<std::uint8_t>& moves, const Links& links) {
    std::vector<std::int32_t> least(moves.size());
    for (std::size_t i = 0; i < least.size(); ++i) {
        least[i] = moves[i] != 0 ? static_cast<std::int32_t>(i) : -1;
    }
    for (bool changes = true; changes;) {
        changes = false;
        for (const auto& [a, b] : links) {
            auto& at_a = least[static_cast<std::size_t>(a)];
            auto& at_b = least[static_cast<std::size_t>(b)];
            if (at_a >= 0 && at_b >= 0 && at_a != at_b) {
                at_a = at_b = std::min(at_a, at_b);
                changes = true;
            }
        }
    }
    return least;
}

TEST_CASE(
    "islands: what links reach, in whatever order they are told, and nothing through what stands "
    "still") {
    Random random(1);
    Islands islands(30);
    for (int trial = 0; trial < 200; ++trial) {
        std::vector<std::uint8_t> moves;
        for (int i = 0; i < 30; ++i) {
            moves.push_back(random.uniform() > -0.7 ? 1 : 0);
        }
        Links links;
        for (int i = 0; i < trial % 40; ++i) {
            links.emplace_back(random.integer() % 30, random.integer() % 30);
        }
        const auto least = spread(moves, links);
        std::vector<std::int32_t> first;
        for (int order = 0; order < 2; ++order) {
            islands.begin(moves);
            for (const auto& [a, b] : links) {
                islands.link(a, b);
                islands.link(-1, b);
            }
            islands.finish();
            std::vector<std::int32_t> told;
            int n_bodies = 0;
            for (int i = 0; i < islands.count(); ++i) {
                const auto bodies = islands.bodies(i);
                REQUIRE(std::ranges::is_sorted(bodies));
                for (const std::int32_t body : bodies) {
                    REQUIRE(least[static_cast<std::size_t>(body)] == bodies.front());
                    REQUIRE(islands.island_of(body) == i);
                    told.push_back(body);
                    ++n_bodies;
                }
            }
            REQUIRE(n_bodies == std::ranges::count_if(moves, [](auto m) { return m != 0; }));
            REQUIRE((order == 0 || told == first));
            first = told;
            std::ranges::reverse(links);
        }
    }
    CHECK(islands.island_of(-1) == -1);
}

TEST_CASE("islands: groups keep numbers ascending, leave out what is in none, and may be empty") {
    Groups groups(6, 3);
    groups.sort(std::vector<std::int32_t>{2, 0, -1, 2, 0, 2}, 3);
    CHECK(std::ranges::equal(groups.group(0), std::vector<std::int32_t>{1, 4}));
    CHECK(groups.group(1).empty());
    CHECK(std::ranges::equal(groups.group(2), std::vector<std::int32_t>{0, 3, 5}));
    groups.sort({}, 0);
    groups.sort(std::vector<std::int32_t>{0}, 1);
    CHECK(groups.group(0).size() == 1);
}

}  // namespace
}  // namespace fulcrum
