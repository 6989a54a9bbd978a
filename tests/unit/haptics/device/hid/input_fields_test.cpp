#include "haptics/device/hid/input_fields.h"

#include "tests/support/hid_descriptors.h"

#include <catch2/catch.hpp>

using namespace fulcrum::hid;
using fulcrum::test_support::DescriptorBuilder;

namespace {

constexpr Usage kStick = usage_of(0x01, 0x04);
constexpr Usage kPad = usage_of(0x01, 0x05);

// A joystick with buttons 1, 2 and 4 in report 1, and a pad with button 1 in report 2.
ReportDescriptor two_devices() {
    DescriptorBuilder d;
    d.page(1).usage(4).open(1).number(1).usage(0x30).logical(0, 255).fields(8, 1).input(2);
    d.page(9).usages(1, 2).usage(4).logical(0, 1).fields(1, 3).input(2).fields(5, 1).input(1);
    d.close();
    d.page(1).usage(5).open(1).number(2).page(9).usage(1).logical(0, 1).fields(1, 1).input(2);
    d.fields(7, 1).input(1).close();
    return *ReportDescriptor::parse(d.bytes());
}

}  // namespace

TEST_CASE("input fields: an axis is found where its application has it") {
    const ReportDescriptor descriptor = two_devices();
    const Usage x = usage_of(0x01, 0x30);
    REQUIRE(find_input(descriptor, x, 0));
    CHECK(find_input(descriptor, x, 0)->report_id == 1);
    CHECK(find_input(descriptor, x, kStick));
    CHECK_FALSE(find_input(descriptor, x, kPad));
    CHECK_FALSE(find_input(descriptor, usage_of(0x01, 0x31), 0));
}

TEST_CASE("input fields: buttons up to the first that is missing, each in its own report") {
    const ReportDescriptor descriptor = two_devices();
    const auto stick = find_buttons(descriptor, kStick);
    const auto pad = find_buttons(descriptor, kPad);
    REQUIRE(stick.size() == 2);
    REQUIRE(pad.size() == 1);
    std::uint32_t buttons = 0;
    const std::uint8_t data[] = {0x80, 0x02};
    CHECK(take_buttons(stick, 1, data, buttons));
    CHECK(buttons == 2);
    CHECK_FALSE(take_buttons(pad, 1, data, buttons));
    CHECK_FALSE(take_buttons(stick, 1, std::span(data, 1), buttons));
    CHECK(buttons == 2);
}
