// No read and no write of the simulated WAM allocates: held, thrown about, let go, refused and late.
#include "haptics/device/arm/simulated_wam.h"
#include "tests/realtime/allocation_trap.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace fulcrum;

TEST_CASE("no allocation: five thousand reads and writes of the simulated WAM") {
    LatestValue<HandTarget> target;
    SimulatedWamSettings settings;
    settings.delay_s = 0.003;
    const auto wam = SimulatedWam::create(settings, target);
    REQUIRE(wam);
    double farthest_m = 0.0;
    const auto play = [&] {
        DeviceReading reading;
        for (int k = 0; k < 5000; ++k) {
            HandTarget wanted;
            wanted.pose_D.position =
                Vector3(0.3 * std::sin(0.01 * k), 0.2 * std::cos(0.007 * k), 0.0);
            wanted.velocity_D.x() = k % 500 == 0 ? std::numeric_limits<double>::quiet_NaN() : 0.0;
            target.publish(wanted);
            if (k % 1000 == 0) {
                (*wam)->take_hold(k % 2000 == 0 ? HandGrip{} : kNoGrip);
            }
            const double now_s = k % 700 == 0 ? 0.0 : 0.001 * k;
            (void)(*wam)->read(now_s, reading);
            const double force_N =
                k % 300 == 0 ? std::numeric_limits<double>::infinity() : 40.0 * std::sin(0.1 * k);
            (void)(*wam)->write(now_s, {Vector3(0.0, force_N, 0.0), Vector3::Zero()});
            farthest_m = std::max(farthest_m, reading.pose_D.position.norm());
        }
        (*wam)->reset();
    };
    CHECK(count_allocations(play) == 0);
    CHECK(farthest_m > 0.1);
}
