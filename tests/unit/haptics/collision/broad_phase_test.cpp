// Which bodies may meet, and what is remembered of those that do: broad_phase.h, contact_pairs.h.
#include "haptics/collision/broad_phase.h"

#include "haptics/collision/contact_pairs.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

namespace fulcrum {
namespace {

std::vector<BodyPair> try_all(const std::vector<Box>& boxes,
                              const std::vector<std::uint8_t>& moves) {
    std::vector<BodyPair> pairs;
    for (std::size_t a = 0; a < boxes.size(); ++a) {
        for (std::size_t b = a + 1; b < boxes.size(); ++b) {
            if (boxes[a].overlaps(boxes[b]) && (moves[a] != 0 || moves[b] != 0)) {
                pairs.push_back({static_cast<std::int32_t>(a), static_cast<std::int32_t>(b)});
            }
        }
    }
    return pairs;
}
Box make_box_round(const Vector3& middle, const Vector3& half) {
    return {middle - half, middle + half};
}
TEST_CASE("broad phase: exactly the pairs that overlap, while boxes wander, jump, come and go") {
    Random random(1);
    BroadPhase broad_phase(100, 5000);
    std::vector<Vector3> places(100);
    std::size_t n_found = 0;
    for (int step = 0; step < 300; ++step) {
        // Spread along one axis after another; now and then all jump.
        const Vector3 spread = Vector3::Constant(0.3) + 4.0 * Vector3::Unit(step / 50 % 3);
        std::vector<Box> boxes;
        std::vector<std::uint8_t> moves;
        const std::size_t n = step % 7 == 0 ? 60 : 100;
        for (std::size_t i = 0; i < n; ++i) {
            const bool jumps = step % 50 == 0;
            places[i] = jumps ? Vector3(spread.cwiseProduct(random.in_cube()))
                              : Vector3(places[i] + 0.02 * random.in_cube());
            boxes.push_back(
                make_box_round(places[i], Vector3::Constant(0.1 + 0.001 * static_cast<double>(i))));
            moves.push_back(i % 5 == 0 ? 0 : 1);
            if (step % 3 == 0 && i % 20 == 7) {
                boxes.back().lower.setConstant(std::nan(""));
            }
        }
        const auto pairs = broad_phase.find_pairs(boxes, moves);
        const auto expected = try_all(boxes, moves);
        REQUIRE(std::ranges::equal(pairs, expected));
        REQUIRE(broad_phase.n_dropped() == 0);
        n_found += pairs.size();
    }
    CHECK(n_found > 3000);
}
TEST_CASE("broad phase: touching boxes, equal ones and one without end meet whom they should") {
    constexpr double kEndless = std::numeric_limits<double>::infinity();
    const std::vector<Box> boxes{{Vector3::Constant(-kEndless), Vector3::Constant(kEndless)},
                                 make_box_round({0.0, 0.5, 0.0}, Vector3::Constant(0.5)),
                                 make_box_round({0.0, 1.5, 0.0}, Vector3::Constant(0.5)),
                                 make_box_round({0.0, 1.5, 0.0}, Vector3::Constant(0.5))};
    const std::vector<std::uint8_t> moves{0, 1, 1, 1};
    BroadPhase broad_phase(4, 10);
    CHECK(std::ranges::equal(broad_phase.find_pairs(boxes, moves), try_all(boxes, moves)));
    CHECK(broad_phase.find_pairs(boxes, moves).size() == 6);
}
TEST_CASE("broad phase: of more pairs than there is room for the nearest stay, reaches left out") {
    Random random(4);
    constexpr std::size_t kRoom = 40;
    BroadPhase few(60, static_cast<int>(kRoom));
    for (int trial = 0; trial < 20; ++trial) {
        std::vector<Box> bodies;
        std::vector<Box> boxes;
        std::vector<double> reaches_m;
        const std::vector<std::uint8_t> moves(60, 1);
        for (int i = 0; i < 60; ++i) {
            bodies.push_back(make_box_round(2.0 * random.in_cube(), Vector3::Constant(0.1)));
            reaches_m.push_back(random.uniform() + 1.0);
            const Vector3 reach = Vector3::Constant(reaches_m.back());
            boxes.push_back({bodies.back().lower - reach, bodies.back().upper + reach});
        }
        const auto gap_of = [&](const BodyPair& pair) {
            const Box& a = bodies[static_cast<std::size_t>(pair.first)];
            const Box& b = bodies[static_cast<std::size_t>(pair.second)];
            return (a.lower - b.upper).cwiseMax(b.lower - a.upper).maxCoeff();
        };
        auto expected = try_all(boxes, moves);
        REQUIRE(expected.size() > 2 * kRoom);
        const auto n_dropped = static_cast<int>(expected.size() - kRoom);
        std::ranges::sort(expected, {}, gap_of);
        expected.resize(kRoom);
        std::sort(expected.begin(), expected.end());
        REQUIRE(std::ranges::equal(few.find_pairs(boxes, moves, reaches_m), expected));
        REQUIRE(few.n_dropped() == n_dropped);
    }
}
TEST_CASE("broad phase: what has no room is counted, and a box that is none meets nobody") {
    std::vector<Box> boxes(5, make_box_round(Vector3::Zero(), Vector3::Ones()));
    const std::vector<std::uint8_t> moves(5, 1);
    BroadPhase few(5, 4);
    CHECK(few.find_pairs(boxes, moves).size() == 4);
    CHECK(few.n_dropped() == 6);
    boxes[2].lower.setConstant(std::nan(""));
    boxes[2].upper.setConstant(std::nan(""));
    BroadPhase enough(5, 10);
    CHECK(std::ranges::equal(enough.find_pairs(boxes, moves), try_all(boxes, moves)));
    CHECK(enough.find_pairs(boxes, moves).size() == 6);
    BroadPhase small(3, 10);
    CHECK(small.find_pairs(boxes, moves).size() == 1);
}
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
