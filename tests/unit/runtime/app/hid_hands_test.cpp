#include "runtime/app/hid_hands.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace fulcrum;
using namespace fulcrum::runtime;

TEST_CASE("HID hands: hid and hid:PATH ask for one, nothing else does") {
    CHECK(asks_for_hid("hid"));
    CHECK(asks_for_hid("hid:/dev/hidraw3"));
    CHECK_FALSE(asks_for_hid("hidden.lua"));
    CHECK_FALSE(asks_for_hid("mouse"));
    CHECK_FALSE(asks_for_hid(""));
}

TEST_CASE("HID hands: what is not there is told") {
    const auto nameless = choose_hid_hand("hid:");
    REQUIRE_FALSE(nameless);
    CHECK(to_sentence(nameless.error()) ==
          "--hand hid: names no device; give --hand hid, or hid: and a path that fulcrum devices "
          "lists.");
    const auto none = choose_hid_hand("hid:/nowhere/hidraw0");
    REQUIRE_FALSE(none);
    CHECK(to_sentence(none.error()) ==
          "/nowhere/hidraw0: there is no device to be opened: No such file or directory; fulcrum "
          "devices lists what is there.");
}

TEST_CASE(
    "HID hands: at every scale of a lesson the settings are valid, and a cap reaches what the "
    "mouse does") {
    for (double scale = 0.01; scale <= 100.0; scale *= 1.3) {
        Workspace workspace;
        workspace.scale = scale;
        const hid::HidHandSettings settings = hid_settings(workspace);
        INFO("scale " << scale);
        CHECK(hid::validate(settings));
        if (scale >= 0.3 && scale <= 50.0) {
            CHECK(settings.rate.half_extent_m * scale == Approx(1.0));
            CHECK(settings.rate.max_speed_m_per_s * scale == Approx(0.5));
            CHECK(settings.cap_pointer.half_extent_D.x() * scale == Approx(1.0));
        }
    }
}

TEST_CASE(
    "HID hands: a plan is held to what a stick's motors can do, and to nothing where there are "
    "none") {
    HidChoice choice;
    CHECK(std::isinf(force_limit_N(choice)));
    choice.has_force = true;
    CHECK(force_limit_N(choice) == hid::HidHandSettings{}.full_force_N);
}
