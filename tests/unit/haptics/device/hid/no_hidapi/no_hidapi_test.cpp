#include "haptics/device/hid/hid_ability.h"
#include "haptics/device/hid/hidapi/hidapi_bus.h"
#include "tests/support/told.h"

#include <catch2/catch.hpp>

using namespace fulcrum;
using namespace fulcrum::hid;

TEST_CASE("no hidapi: nothing is listed, and a hand that is asked for is one sentence") {
    const auto bus = make_hidapi_bus();
    const std::string why =
        "this build has no HID devices; build with -DFULCRUM_HID=ON, or choose another hand.";
    CHECK(bus->list().empty());
    CHECK(refusal_of(choose_hand(*bus, {})) == why);
    CHECK(refusal_of(choose_hand(*bus, "/dev/hidraw0")) == why);
    CHECK(refusal_of(bus->open("/dev/hidraw0")) == why);
}
