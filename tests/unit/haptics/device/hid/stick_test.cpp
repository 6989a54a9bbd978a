#include "haptics/device/hid/stick.h"

#include "tests/support/virtual_hid.h"

#include <catch2/catch.hpp>

using namespace fulcrum;
using namespace fulcrum::hid;
using namespace fulcrum::test_support;

namespace {

Expected<Stick> stick_of(const Bytes& bytes) {
    const auto descriptor = ReportDescriptor::parse(bytes);
    REQUIRE(descriptor);
    return Stick::find(*descriptor);
}

}  // namespace

TEST_CASE(
    "stick: axes, throttle and buttons as the descriptor places them, up away from the user") {
    const ForceStickShape shape{.first_report = 7};
    const auto stick = stick_of(force_stick_descriptor(shape));
    REQUIRE(stick);
    CHECK(stick->n_axes() == 3);
    CHECK(stick->n_buttons() == 8);
    CHECK(stick->steps() == 1023.0);
    StickState state;
    CHECK(stick->take_report(stick_report(shape, 511, -512, 255, 0x81), state));
    CHECK(state.place == Vector3(1.0, 1.0, 1.0));
    CHECK(state.buttons == 0x81);
    CHECK(stick->take_report(stick_report(shape, -512, 511, 0, 0), state));
    CHECK(state.place == Vector3(-1.0, -1.0, -1.0));
    CHECK(state.buttons == 0);
}

TEST_CASE("stick: unnumbered reports begin with data") {
    const auto stick = stick_of(plain_stick_descriptor());
    REQUIRE(stick);
    CHECK(stick->n_buttons() == 4);
    StickState state;
    CHECK(stick->take_report(Bytes{255, 0, 0, 0x02}, state));
    CHECK(state.place == Vector3(1.0, 1.0, -1.0));
    CHECK(state.buttons == 2);
}

TEST_CASE(
    "stick: what is out of range, cut off or of another report leaves the axes where they were") {
    const ForceStickShape shape;
    const auto stick = stick_of(force_stick_descriptor(shape));
    REQUIRE(stick);
    StickState state;
    REQUIRE(stick->take_report(stick_report(shape, 511, 511, 0, 1), state));
    const StickState before = state;
    CHECK_FALSE(stick->take_report({}, state));
    CHECK_FALSE(stick->take_report(Bytes{1}, state));
    CHECK_FALSE(stick->take_report(Bytes{9, 0, 0, 0, 0, 0, 0}, state));
    CHECK(state.place == before.place);
    CHECK(state.buttons == before.buttons);
    // X beyond its logical range says that it has no value; Y is there.
    CHECK(stick->take_report(stick_report(shape, 30000, -512, 0, 1), state));
    CHECK(state.place == Vector3(1.0, 1.0, -1.0));
}

TEST_CASE("stick: a gamepad's second stick goes near and far, not its trigger") {
    DescriptorBuilder d;
    d.page(1).usage(5).open(1).logical(0, 255).fields(8, 4);
    d.usage(0x30).usage(0x31).usage(0x32).usage(0x35).input(2).close();
    const auto pad = stick_of(d.bytes());
    REQUIRE(pad);
    StickState state;
    CHECK(pad->take_report(Bytes{0, 0, 0, 255}, state));
    CHECK(state.place.z() == 1.0);
}

TEST_CASE("stick: without two absolute axes of one application there is none") {
    DescriptorBuilder relative;
    relative.page(1).usage(2).open(1).logical(-127, 127).fields(8, 2).usage(0x30).usage(0x31);
    CHECK_FALSE(stick_of(relative.input(6).close().bytes()));
    DescriptorBuilder apart;
    apart.page(1).usage(4).open(1).logical(0, 255).fields(8, 1).usage(0x30).input(2).close();
    apart.usage(5).open(1).usage(0x31).input(2).close();
    const auto none = stick_of(apart.bytes());
    REQUIRE_FALSE(none);
    CHECK(to_sentence(none.error()) ==
          "the device has no two axes; use a joystick, a gamepad or a SpaceMouse.");
    DescriptorBuilder dead;
    dead.page(1).usage(4).open(1).logical(3, 3).fields(8, 2).usage(0x30).usage(0x31).input(2);
    CHECK_FALSE(stick_of(dead.close().bytes()));
}
