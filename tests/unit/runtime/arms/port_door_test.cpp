#include "runtime/arms/port_door.h"

#include "tests/support/eventually.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {

TEST_CASE("port door: nobody is inside once it is shut, nor comes in") {
    for (int trial = 0; trial < 200; ++trial) {
        PortDoor door;
        // What the port would own: of one that has gone, false.
        std::atomic<bool> is_port_there{true};
        std::atomic<int> passed{0};
        std::atomic<int> touched_after{0};
        std::thread thread([&] {
            while (door.pass([&] {
                touched_after += is_port_there ? 0 : 1;
                ++passed;
            })) {
            }
        });
        REQUIRE(test_support::eventually([&] { return passed > trial % 7; }));
        door.shut();
        is_port_there = false;
        thread.join();
        REQUIRE(touched_after == 0);
        REQUIRE_FALSE(door.pass([] { FAIL("it is shut"); }));
    }
}

}  // namespace fulcrum::runtime
