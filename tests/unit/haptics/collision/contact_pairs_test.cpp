#include "haptics/collision/contact_pairs.h"

#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <map>
#include <vector>

namespace fulcrum {
namespace {

TEST_CASE("contact pairs: what was remembered of a pair stays while it is named, and no longer") {
    Random random(1);
    ContactPairs pairs(40);
    std::map<BodyPair, std::uint32_t> told;
    std::uint32_t next = 1;
    for (int step = 0; step < 500; ++step) {
        std::vector<BodyPair> named;
        for (std::int32_t a = 0; a < 8; ++a) {
            for (std::int32_t b = a + 1; b < 8; ++b) {
                if (random.uniform() > 0.2) {
                    named.push_back({a, b});
                }
            }
        }
        pairs.update(named);
        REQUIRE(pairs.count() == static_cast<int>(named.size()));
        std::map<BodyPair, std::uint32_t> now;
        for (int i = 0; i < pairs.count(); ++i) {
            ContactPair& pair = pairs.at(i);
            REQUIRE(pair.bodies == named[static_cast<std::size_t>(i)]);
            const auto old = told.find(pair.bodies);
            if (old == told.end()) {
                REQUIRE(pair.n_memories == 0);
                REQUIRE(pair.manifold.count == 0);
            } else {
                REQUIRE(pair.recall(old->second) != nullptr);
                REQUIRE(pair.recall(old->second)->impulse_W.x() == old->second);
                REQUIRE(pair.recall(old->second + 1) == nullptr);
            }
            pair.forget();
            pair.remember({.id = next, .impulse_W = Vector3(next, 0.0, 0.0)});
            now[pair.bodies] = next;
            next += 2;
        }
        told = now;
    }
}

TEST_CASE("contact pairs: more than there is room for are left out, and one pair remembers four") {
    ContactPairs pairs(2);
    const std::vector<BodyPair> three{{0, 1}, {0, 2}, {1, 2}};
    pairs.update(three);
    CHECK(pairs.count() == 2);
    pairs.update(std::vector<BodyPair>{{1, 2}});
    REQUIRE(pairs.count() == 1);
    for (std::uint32_t id = 1; id < 7; ++id) {
        pairs.at(0).remember({.id = id});
    }
    CHECK(pairs.at(0).recall(4) != nullptr);
    CHECK(pairs.at(0).recall(5) == nullptr);
}

}  // namespace
}  // namespace fulcrum
