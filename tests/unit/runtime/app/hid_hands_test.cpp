#include "runtime/app/hid_hands.h"

#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

TEST_CASE("HID hands: hid and hid:PATH ask for one, nothing else does") {
    CHECK(asks_for_hid("hid"));
    CHECK(asks_for_hid("hid:/dev/hidraw3"));
    CHECK_FALSE(asks_for_hid("hidden.lua"));
    CHECK_FALSE(asks_for_hid("mouse"));
    CHECK_FALSE(asks_for_hid(""));
}

TEST_CASE("HID hands: what is not there is told") {
    CHECK(refusal_of(choose_hid_hand("hid:")) ==
          "--hand hid: names no device; give --hand hid, or hid: and a path that fulcrum devices "
          "lists.");
    CHECK(refusal_of(choose_hid_hand("hid:/nowhere/hidraw0")) ==
          "/nowhere/hidraw0: there is no device to be opened: No such file or directory; fulcrum "
          "devices lists what is there.");
}

TEST_CASE("HID hands: settings are valid at every scale, and a cap reaches what the mouse does") {
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

TEST_CASE("HID hands: a stick's sensor is watched by what its motors do, a SpaceMouse's is not") {
    const Vector3 reach_D = Vector3::Constant(0.15);
    DeviceTraits traits;
    traits.position_resolution_m = 0.0003;
    const SensorWatch cap = sensor_watch(traits, reach_D);
    CHECK(cap.life.moves_at_N == 0.0);
    CHECK(cap.life.trembles_within_s == 0.0);
    CHECK(cap.life.most_m_per_s2 == 0.0);
    traits.renders_force = true;
    const SensorWatch stick = sensor_watch(traits, reach_D);
    CHECK(validate(stick.life));
    CHECK(stick.life.moves_at_N > 0.0);
    CHECK(stick.life.moves_at_N < hid::HidHandSettings{}.full_force_N);
    // Its motors push to the right and up; the throttle has none.
    CHECK(stick.pushed_D == Vector3(1.0, 1.0, 0.0));
    CHECK(all_below(stick.stop_D, reach_D));
}

TEST_CASE("HID hands: a plan is held to what a stick's motors can do, where there are any") {
    HidChoice choice;
    CHECK(std::isinf(force_limit_N(choice)));
    choice.has_force = true;
    CHECK(force_limit_N(choice) == hid::HidHandSettings{}.full_force_N);
}
