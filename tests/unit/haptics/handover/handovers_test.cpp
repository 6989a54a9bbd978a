#include "haptics/handover/event_ring.h"
#include "haptics/handover/latest_value.h"

#include <catch2/catch.hpp>

#include <cstdint>
#include <deque>
#include <rapidcheck.h>

using namespace fulcrum;

namespace {

struct Dated {
    int time = 0;
    int content = 0;
    int n_fills = 0;  // of this slot
};

// What a thrifty writer tells: `content` under the revision of the same number.
void publish(ThriftyWriter<Dated>& writer, int time, std::uint64_t revision, int content) {
    writer.publish(
        revision,
        [&](Dated& to) {
            to.content = content;
            ++to.n_fills;
        },
        [&](Dated& to) { to.time = time; });
}

}  // namespace

TEST_CASE("event ring: first in, first out; a full one drops the newest and counts it") {
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
    for (int i = 0; i < 7; ++i) {
        CHECK(ring.push(i) == (i < 4));
    }
    CHECK(ring.dropped() == 3);
    out = -1;
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

TEST_CASE("latest value: nothing before the first publish; then the newest, once, still readable") {
    LatestValue<int> value;
    CHECK_FALSE(value.take());
    CHECK(value.value() == 0);
    value.publish(1);
    value.publish(2);
    value.publish(3);
    CHECK(value.take());
    CHECK(value.value() == 3);
    CHECK_FALSE(value.take());
    CHECK(value.value() == 3);
    value.publish(4);
    CHECK(value.value() == 3);
    CHECK(value.take());
    CHECK(value.value() == 4);
}

TEST_CASE("latest value: publish and take in every order of three never lose the newest") {
    // Each bit of `order`: 1 publish, 0 take; all orders of twelve operations.
    for (unsigned order = 0; order < (1U << 12); ++order) {
        LatestValue<unsigned> value;
        unsigned published = 0;
        unsigned taken = 0;
        for (unsigned i = 0; i < 12; ++i) {
            if ((order >> i & 1U) != 0) {
                value.publish(++published);
            } else {
                REQUIRE(value.take() == (published != taken));
                taken = published;
                REQUIRE(value.value() == published);
            }
        }
    }
}

TEST_CASE("thrifty writer: in every order of takes the newest is whole, however often filled") {
    // Two bits a step: publish the same revision, publish the next, take, take.
    for (unsigned order = 0; order < (1U << 16); ++order) {
        LatestValue<Dated> value;
        ThriftyWriter<Dated> writer(value);
        int time = 0;
        int content = 1;
        for (unsigned i = 0; i < 8; ++i) {
            const unsigned what = order >> (2 * i) & 3U;
            if (what < 2) {
                content += static_cast<int>(what);
                publish(writer, ++time, static_cast<std::uint64_t>(content), content);
            } else if (value.take()) {
                REQUIRE(value.value().time == time);
                REQUIRE(value.value().content == content);
            }
        }
    }
}

TEST_CASE("thrifty writer: a revision is filled once a slot, none is filled each time") {
    LatestValue<Dated> value;
    ThriftyWriter<Dated> writer(value);
    for (int time = 1; time <= 30; ++time) {
        publish(writer, time, 7, 70);
        REQUIRE(value.take());
        REQUIRE(value.value().content == 70);
        REQUIRE(value.value().n_fills == 1);
    }
    // Another content of no revision is the newest at once, and leaves no slot that passes for the seventh.
    publish(writer, 31, ThriftyWriter<Dated>::kNoRevision, 0);
    REQUIRE(value.take());
    CHECK(value.value().content == 0);
    for (int time = 32; time <= 40; ++time) {
        publish(writer, time, 7, 70);
        REQUIRE(value.take());
        REQUIRE(value.value().content == 70);
        REQUIRE(value.value().time == time);
    }
    publish(writer, 41, ThriftyWriter<Dated>::kNoRevision, 1);
    publish(writer, 42, ThriftyWriter<Dated>::kNoRevision, 2);
    publish(writer, 43, ThriftyWriter<Dated>::kNoRevision, 3);
    REQUIRE(value.take());
    CHECK(value.value().content == 3);
}

TEST_CASE("thrifty writer: what another writer left behind counts for nothing") {
    LatestValue<Dated> value;
    for (int round = 1; round <= 3; ++round) {
        ThriftyWriter<Dated> writer(value);
        for (int time = 0; time < 4; ++time) {
            publish(writer, time, 1, 10 * round);
            REQUIRE(value.take());
            REQUIRE(value.value().content == 10 * round);
        }
    }
}
