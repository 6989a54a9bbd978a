// How often the ports read and order, and how old poses are where a loop reads them: told, not judged, for it is the machine's doing.
// FULCRUM_ARM_SECONDS=3 measures for three seconds; without it a moment shows that there is something to tell.
#include "runtime/arms/arm_device.h"
#include "runtime/arms/dhd/dhd_port.h"
#include "runtime/arms/hd/hd_port.h"
#include "tests/support/eventually.h"
#include "tests/support/maker_stand_in.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>
#include <vector>

namespace fulcrum::runtime {
namespace {

double measured_s() {
    constexpr double kMoment_s = 0.1;
    const char* given = std::getenv("FULCRUM_ARM_SECONDS");
    return given != nullptr ? std::strtod(given, nullptr) : kMoment_s;
}

// Reads and writes once a millisecond, as a loop does; the ages of what it read, each as it was read.
std::vector<double> read_ages_s(ArmDevice& device, double seconds) {
    std::vector<double> ages_s;
    DeviceReading reading;
    auto next = std::chrono::steady_clock::now();
    for (const double end_s = monotonic_now_s() + seconds; monotonic_now_s() < end_s;) {
        const double now_s = monotonic_now_s();
        if (device.read(now_s, reading)) {
            ages_s.push_back(now_s - reading.stamp_s);
        }
        (void)device.write(now_s, {.force = {0.5, 0.0, 0.0}});
        next += std::chrono::milliseconds(1);
        std::this_thread::sleep_until(next);
    }
    return ages_s;
}

void tell_freshness(const char* maker, const test_support::MakerStandIn& stand_in,
                    ArmDevice& device) {
    DeviceReading reading;
    REQUIRE(test_support::eventually([&] { return device.read(0.0, reading); }));
    const double orders = stand_in.get("orders");
    const double begun_s = monotonic_now_s();
    std::vector<double> ages_s = read_ages_s(device, measured_s());
    const double rate_Hz = (stand_in.get("orders") - orders) / (monotonic_now_s() - begun_s);
    REQUIRE(rate_Hz > 0.0);
    REQUIRE_FALSE(ages_s.empty());
    std::sort(ages_s.begin(), ages_s.end());
    const auto at = [&](double share) {
        return 1e3 *
               ages_s[static_cast<std::size_t>(share * static_cast<double>(ages_s.size() - 1))];
    };
    std::printf(
        "%s: %.0f rounds a second; age when read: %.2f ms median, %.2f ms at 99 %%, "
        "%.2f ms at most\n",
        maker, rate_Hz, at(0.5), at(0.99), at(1.0));
}

}  // namespace

TEST_CASE("port freshness: of Force Dimension's library poses come, and how old is told") {
    const test_support::MakerStandIn stand_in(FULCRUM_DHD_STAND_IN);
    auto port = open_dhd({.library = stand_in.path()});
    REQUIRE(port);
    ArmDevice device(std::move(*port));
    tell_freshness("dhd", stand_in, device);
}

TEST_CASE("port freshness: of OpenHaptics poses come, and how old is told") {
    const test_support::MakerStandIn stand_in(FULCRUM_HD_STAND_IN);
    auto port = open_hd({.library = stand_in.path()});
    REQUIRE(port);
    ArmDevice device(std::move(*port));
    tell_freshness("hd", stand_in, device);
}

}  // namespace fulcrum::runtime
