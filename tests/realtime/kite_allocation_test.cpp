// No round of a kite's loop allocates, nor of what the hand feels of its line: in gusts, snapped, and on the ground.
#include "haptics/flight/kite_loop.h"
#include "tests/realtime/allocation_trap.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

using namespace fulcrum;

TEST_CASE("no allocation: two thousand rounds of a kite, launched, let out, snapped and fallen") {
    KiteFlightSettings settings;
    settings.wind.gustiness = 1.0;
    settings.line.strength_N = 4.0;
    const auto channels = std::make_unique<KiteChannels>();
    KiteLoop loop(settings, 500.0, *channels);
    LineFeel feel(LineFeelSettings{});
    double most_N = 0.0;
    const auto fly = [&] {
        KiteOrders orders;
        for (int i = 0; i < 2000; ++i) {
            const Vector3 hand_W(0.1 * std::sin(0.02 * i), 1.0, 0.0);
            orders.line_m = 20.0 + 0.001 * i;
            orders.wind_m_per_s = 0.005 * i;
            orders.n_launches = i > 1500 ? 1U : 0U;
            channels->orders.publish(orders);
            channels->hand_W.publish(hand_W);
            loop.step(0.002 * i);
            (void)channels->line.take();
            const Wrench felt =
                feel.step(channels->line.value(), Pose::at(hand_W), 0.002 * i, 0.002);
            most_N = std::max(most_N, felt.force.norm());
        }
        loop.silence(4.0);
    };
    CHECK(count_allocations(fly) == 0);
    CHECK(most_N > 0.1);
}
