#include "haptics/flight/kite_swap.h"

#include <catch2/catch.hpp>

#include <atomic>
#include <memory>
#include <thread>

using namespace fulcrum;

namespace {

std::unique_ptr<KiteFlight> make_flight(double tail_m) {
    KiteFlightSettings settings;
    settings.kite.tail_m = tail_m;
    return std::make_unique<KiteFlight>(settings);
}

}  // namespace

TEST_CASE("kite swap: what is put is taken once, and the newest of two") {
    KiteSwap swap;
    std::unique_ptr<KiteFlight> flown = make_flight(1.0);
    CHECK(swap.take(flown.get()) == nullptr);
    swap.put(make_flight(2.0));
    swap.put(make_flight(3.0));
    KiteFlight* next = swap.take(flown.get());
    REQUIRE(next != nullptr);
    const std::unique_ptr<KiteFlight> own(next);
    (void)flown.release();  // the swap's now
    CHECK(next->kite().inertia.mass_kg == make_flight(3.0)->kite().inertia.mass_kg);
    CHECK(swap.take(next) == nullptr);
}

TEST_CASE("kite swap: nothing is taken before what came back is freed, and the next put frees it") {
    KiteSwap swap;
    swap.put(make_flight(1.0));
    KiteFlight* first = swap.take(make_flight(0.5).release());
    REQUIRE(first != nullptr);
    swap.put(make_flight(2.0));  // frees what came back
    KiteFlight* second = swap.take(first);
    REQUIRE(second != nullptr);
    const std::unique_ptr<KiteFlight> own(second);
    CHECK(swap.take(second) == nullptr);
}

TEST_CASE("kite swap: two threads hand over hundreds, and each kite is whole") {
    KiteSwap swap;
    std::atomic<bool> ended{false};
    int n_taken = 0;
    std::thread flier([&] {
        KiteFlight* flown = make_flight(0.0).release();
        while (!ended.load(std::memory_order_acquire)) {
            if (KiteFlight* next = swap.take(flown)) {
                flown = next;
                ++n_taken;
                flown->step(0.002, {0.0, 1.0, 0.0});
            }
        }
        const std::unique_ptr<KiteFlight> own(flown);
        CHECK(is_finite(own->report().pose_W));
    });
    for (int i = 0; i < 300; ++i) {
        swap.put(make_flight(0.01 * i));
    }
    ended.store(true, std::memory_order_release);
    flier.join();
    CHECK(n_taken <= 300);
}
