#include "haptics/handover/event_ring.h"

#include <catch2/catch.hpp>

#include <deque>
#include <rapidcheck.h>

using namespace fulcrum;

TEST_CASE("event ring: first in, first out, and empty at the end") {
    EventRing<int, 4> ring;
    int out = 0;
    CHECK_FALSE(ring.pop(out));
    CHECK(ring.push(1));
    CHECK(ring.push(2));
    CHECK(ring.pop(out));
    CHECK(out == 1);
    CHECK(ring.pop(out));
    CHECK(out == 2);
    CHECK_FALSE(ring.pop(out));
}

TEST_CASE("event ring: a full ring drops the newest and counts it") {
    EventRing<int, 4> ring;
    for (int i = 0; i < 7; ++i) {
        CHECK(ring.push(i) == (i < 4));
    }
    CHECK(ring.dropped() == 3);
    int out = -1;
    for (int i = 0; i < 4; ++i) {
        CHECK(ring.pop(out));
        CHECK(out == i);
    }
    CHECK_FALSE(ring.pop(out));
    CHECK(ring.push(9));
    CHECK(ring.pop(out));
    CHECK(out == 9);
}

TEST_CASE("event ring: does what a bounded queue does, whatever the order of calls") {
    CHECK(rc::check([](const std::vector<bool>& pushes) {
        EventRing<int, 8> ring;
        std::deque<int> model;
        std::uint64_t dropped = 0;
        int next = 0;
        for (const bool push : pushes) {
            if (push) {
                const bool fits = model.size() < 8;
                RC_ASSERT(ring.push(next) == fits);
                if (fits) {
                    model.push_back(next);
                } else {
                    ++dropped;
                }
                ++next;
            } else {
                int out = -1;
                RC_ASSERT(ring.pop(out) == !model.empty());
                if (!model.empty()) {
                    RC_ASSERT(out == model.front());
                    model.pop_front();
                }
            }
        }
        RC_ASSERT(ring.dropped() == dropped);
    }));
}
