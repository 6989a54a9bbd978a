// A Haply arm, as its loop reads and writes it while its port's thread reads messages.
#include "haptics/base/clock.h"
#include "runtime/arms/arm_device.h"
#include "runtime/arms/haply/haply_port.h"
#include "tests/realtime/allocation_trap.h"
#include "tests/support/eventually.h"
#include "tests/support/haply_service.h"

#include <catch2/catch.hpp>

namespace fulcrum {

TEST_CASE("realtime: the loop of a Haply arm allocates nothing, and the arm is felt meanwhile") {
    test_support::HaplyService service;
    runtime::HaplySettings settings;
    settings.port = service.port();
    settings.centre_A = test_support::HaplyService::centre_A();
    auto port = runtime::open_haply(settings);
    REQUIRE(port);
    runtime::ArmDevice device(std::move(*port));
    std::uint64_t read = 0;
    std::uint64_t allocations = 0;
    const auto step = [&] {
        const double now_s = monotonic_now_s();
        DeviceReading reading;
        read += device.read(now_s, reading) ? 1 : 0;
        (void)device.write(now_s, {.force = Vector3(0.0, 0.5, 0.0)});
    };
    const bool is_felt = test_support::eventually([&] {
        allocations += count_allocations(step);
        return read > 1000 && service.felt().force_D.y() > 0.4;
    });
    CHECK(is_felt);
    CHECK(allocations == 0);
}

}  // namespace fulcrum
