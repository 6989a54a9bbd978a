// Two threads at once on each kind of hand-over: nothing torn, nothing lost that must not be, nothing out of order. Under
// the thread sanitizer a race here is an error.
#include "haptics/handover/channels.h"

#include <catch2/catch.hpp>

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <thread>

using namespace fulcrum;

namespace {

#ifdef FULCRUM_SANITIZED
constexpr std::uint64_t kRounds = 50'000;
#else
constexpr std::uint64_t kRounds = 1'000'000;
#endif

// A value whose every word must be the same: 512 bytes cannot be written at once.
struct Wide {
    std::array<std::uint64_t, 64> words{};
};

Wide make_wide(std::uint64_t n) {
    Wide wide;
    wide.words.fill(n);
    return wide;
}

bool is_whole(const Wide& wide) {
    for (const std::uint64_t word : wide.words) {
        if (word != wide.words[0]) {
            return false;
        }
    }
    return true;
}

}  // namespace

TEST_CASE(
    "handover: a reader of newest values sees whole ones, never an older one again, and the last") {
    auto value = std::make_unique<LatestValue<Wide>>();
    std::thread writer([&] {
        for (std::uint64_t n = 1; n <= kRounds; ++n) {
            value->publish(make_wide(n));
        }
    });
    std::uint64_t newest = 0;
    std::uint64_t n_torn = 0;
    std::uint64_t n_backwards = 0;
    while (newest < kRounds) {
        if (value->take()) {
            n_torn += !is_whole(value->value());
            n_backwards += value->value().words[0] <= newest;
            newest = value->value().words[0];
        }
    }
    writer.join();
    CHECK(n_torn == 0);
    CHECK(n_backwards == 0);
    CHECK(newest == kRounds);
    CHECK_FALSE(value->take());
}

TEST_CASE("handover: what is only refreshed is whole as well, and as old as its writer says") {
    struct Dated {
        std::uint64_t n = 0;
        Wide wide;
    };
    auto value = std::make_unique<LatestValue<Dated>>();
    std::thread writer([&] {
        ThriftyWriter<Dated> thrifty(*value);
        for (std::uint64_t n = 1; n <= kRounds; ++n) {
            const std::uint64_t revision = 1 + n / 16;  // stays for sixteen rounds
            thrifty.publish(
                revision, [&](Dated& to) { to.wide = make_wide(revision); },
                [&](Dated& to) { to.n = n; });
        }
    });
    std::uint64_t newest = 0;
    std::uint64_t n_torn = 0;
    while (newest < kRounds) {
        if (value->take()) {
            const Dated& taken = value->value();
            n_torn += !is_whole(taken.wide) || taken.wide.words[0] != 1 + taken.n / 16 ||
                      taken.n <= newest;
            newest = taken.n;
        }
    }
    writer.join();
    CHECK(n_torn == 0);
    CHECK(newest == kRounds);
}

TEST_CASE(
    "handover: a ring gives every pushed event once, whole and in order; the rest are counted as "
    "dropped") {
    auto ring = std::make_unique<EventRing<Wide, 64>>();
    std::atomic<bool> done{false};
    std::uint64_t n_pushed = 0;
    std::thread producer([&] {
        for (std::uint64_t n = 1; n <= kRounds; ++n) {
            n_pushed += ring->push(make_wide(n));
        }
        done.store(true, std::memory_order_release);
    });
    std::uint64_t n_popped = 0;
    std::uint64_t last = 0;
    std::uint64_t n_torn = 0;
    std::uint64_t n_backwards = 0;
    Wide wide;
    for (bool finished = false; !finished;) {
        finished = done.load(std::memory_order_acquire);
        while (ring->pop(wide)) {
            ++n_popped;
            n_torn += !is_whole(wide);
            n_backwards += wide.words[0] <= last;
            last = wide.words[0];
        }
    }
    producer.join();
    CHECK(n_torn == 0);
    CHECK(n_backwards == 0);
    CHECK(n_popped == n_pushed);
    CHECK(n_pushed + ring->dropped() == kRounds);
}

TEST_CASE("handover: a slow consumer that waits for room loses nothing") {
    auto ring = std::make_unique<EventRing<std::uint64_t, 16>>();
    std::thread producer([&] {
        for (std::uint64_t n = 1; n <= kRounds; ++n) {
            while (!ring->push(n)) {
                std::this_thread::yield();
            }
        }
    });
    std::uint64_t expected = 1;
    std::uint64_t n_wrong = 0;
    while (expected <= kRounds) {
        std::uint64_t n = 0;
        if (ring->pop(n)) {
            n_wrong += n != expected;
            ++expected;
        } else {
            std::this_thread::yield();  // on a busy machine the producer waits for a core
        }
    }
    producer.join();
    CHECK(n_wrong == 0);
}
