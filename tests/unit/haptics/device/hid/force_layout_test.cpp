#include "haptics/device/hid/force_layout.h"

#include "tests/support/hid_descriptors.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace fulcrum;
using namespace fulcrum::hid;
using namespace fulcrum::test_support;

namespace {

Expected<ForceLayout> layout_of(const Bytes& bytes) {
    const auto descriptor = ReportDescriptor::parse(bytes);
    REQUIRE(descriptor);
    return ForceLayout::find(*descriptor);
}

// The descriptor with one usage of the physical page made another one.
Bytes without(std::uint8_t usage) {
    Bytes bytes = force_stick_descriptor({});
    for (std::size_t i = 0; i + 1 < bytes.size(); ++i) {
        if (bytes[i] == 0x09 && bytes[i + 1] == usage) {
            bytes[i + 1] = 0xEE;
        }
        // Above 0x7F a usage takes two bytes.
        if (i + 2 < bytes.size() && bytes[i] == 0x0A && bytes[i + 1] == usage) {
            bytes[i + 1] = 0xEE;
        }
    }
    return bytes;
}

}  // namespace

TEST_CASE("force layout: numbers, places and ranges come from the descriptor") {
    const ForceStickShape shape{.first_report = 20, .magnitude = 10000};
    const auto layout = layout_of(force_stick_descriptor(shape));
    REQUIRE(layout);
    CHECK(layout->effect_index.report_id == 21);
    CHECK(layout->magnitude.report_id == 22);
    CHECK(layout->magnitude.bit_offset == 8);
    CHECK(layout->magnitude.logical_min == -10000);
    CHECK(layout->start.field.report_id == 23);
    CHECK(layout->start.value == 1);
    CHECK(layout->stop.value == 3);
    REQUIRE(layout->stop_all);
    CHECK(layout->stop_all->value == 3);
    REQUIRE(layout->enable_actuators);
    CHECK(layout->enable_actuators->value == 1);
    REQUIRE(layout->reset);
    CHECK(layout->reset->value == 4);
    CHECK(layout->create_constant.field.type == ReportType::feature);
    CHECK(layout->create_constant.field.report_id == 27);
    CHECK(layout->create_constant.value == 1);
    CHECK(layout->loaded_index.report_id == 28);
    CHECK(layout->load_success.value == 1);
    REQUIRE(layout->direction);
    CHECK(layout->direction->logical_max == 35999);
    CHECK(layout->direction->unit_exponent == -2);
    CHECK(layout->duration.unit == 0x1003);
    CHECK(layout->has_x);
    CHECK(layout->has_y);
    REQUIRE(layout->freed_index);
    REQUIRE(layout->device_gain);
}

TEST_CASE("force layout: a wheel pushes along one axis") {
    const auto wheel = layout_of(force_stick_descriptor({.has_y = false}));
    REQUIRE(wheel);
    CHECK(wheel->has_x);
    CHECK_FALSE(wheel->has_y);
}

TEST_CASE(
    "force layout: what is missing is told by name, and no force is better than one that cannot be "
    "ended") {
    const auto sentence = [](const Bytes& bytes) {
        const auto layout = layout_of(bytes);
        REQUIRE_FALSE(layout);
        return to_sentence(layout.error());
    };
    CHECK(sentence(without(0x50)) ==
          "its force cannot be used: it has not a duration, so that its forces would never end; "
          "use it without force, or a joystick with HID PID constant force.");
    CHECK(sentence(without(0x70)).find("a magnitude") != std::string::npos);
    CHECK(sentence(without(0x26)).find("constant force") != std::string::npos);
    CHECK(sentence(without(0x7B)).find("Stop") != std::string::npos);
    CHECK(sentence(without(0x79)).find("Start") != std::string::npos);
    CHECK(sentence(without(0x8C)).find("Block Load") != std::string::npos);
    CHECK(sentence(without(0x89)).find("Block Load") != std::string::npos);
    CHECK(sentence(without(0xAB)).find("constant force") != std::string::npos);
    CHECK(sentence(without(0x73)).find("Set Constant Force") != std::string::npos);
    CHECK(sentence(without(0x77)).find("Effect Operation") != std::string::npos);
    CHECK(sentence(plain_stick_descriptor()).find("it has not") != std::string::npos);
    // Optional ones may be missing.
    for (const int usage : {0x7C, 0x95, 0x7D, 0x90, 0x52}) {
        CHECK(layout_of(without(static_cast<std::uint8_t>(usage))));
    }
}

TEST_CASE("force layout: a magnitude with one sign and a device without directions are refused") {
    CHECK_FALSE(layout_of(force_stick_descriptor({.magnitude = 0})));
    Bytes one_sign = force_stick_descriptor({});
    // Logical Minimum -255 of the magnitude becomes 0.
    const Bytes minimum{0x09, 0x70, 0x16, 0x01, 0xFF};
    const auto at = std::search(one_sign.begin(), one_sign.end(), minimum.begin(), minimum.end());
    REQUIRE(at != one_sign.end());
    at[3] = 0;
    at[4] = 0;
    const auto refused = layout_of(one_sign);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().message.find("one sign only") != std::string::npos);
    CHECK(layout_of(without(0x57)));  // by axes then
    Bytes lost = without(0x57);
    for (std::size_t i = 0; i + 1 < lost.size(); ++i) {
        if (lost[i] == 0x09 && lost[i + 1] == 0x55) {
            lost[i + 1] = 0xEE;
        }
    }
    const auto none = layout_of(lost);
    REQUIRE_FALSE(none);
    CHECK(none.error().message.find("no directions") != std::string::npos);
}

TEST_CASE("force layout: who speaks of forces is told from who does not") {
    const auto speaks = [](const Bytes& bytes) {
        return mentions_force(*ReportDescriptor::parse(bytes));
    };
    CHECK(speaks(force_stick_descriptor({})));
    CHECK_FALSE(speaks(plain_stick_descriptor()));
    CHECK_FALSE(speaks(space_mouse_descriptor(true)));
}
