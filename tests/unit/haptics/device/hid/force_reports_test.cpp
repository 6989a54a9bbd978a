#include "haptics/device/hid/force_effects.h"
#include "haptics/device/hid/force_layout.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/hid_descriptors.h"
#include "tests/support/refused.h"
#include "tests/support/told.h"
#include "tests/support/virtual_hid.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <memory>
#include <thread>

using namespace fulcrum;
using namespace fulcrum::hid;
using namespace fulcrum::test_support;

namespace {

constexpr const char* kPath = "stick";

// A joystick on a bus in memory, and who gives it orders.
struct Bench {
    explicit Bench(const ForceStickShape& made, const ForceEffectSettings& settings = {})
        : shape(made),
          descriptor(*ReportDescriptor::parse(force_stick_descriptor(made))),
          effects(descriptor, *ForceLayout::find(descriptor), settings) {
        bus.plug(make_hid_node(kPath, force_stick_descriptor(made), 1, 2, "stick"), stick);
        link = std::move(*bus.open(kPath));
    }

    ForceStickShape shape;
    std::shared_ptr<ForceStick> stick = std::make_shared<ForceStick>(shape);
    MemoryBus bus;
    std::unique_ptr<HidLink> link;
    ReportDescriptor descriptor;
    ForceEffects effects;
};

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

TEST_CASE("force effects: a force is felt as it was meant, on every shape, along one axis only") {
    const ForceStickShape shapes[] = {{},
                                      {.first_report = 40, .magnitude = 10000},
                                      {.magnitude = 127, .by_axes = true},
                                      {.has_units = false},
                                      {.features_made = false}};
    for (const ForceStickShape& shape : shapes) {
        Bench bench(shape);
        INFO("first report " << int(shape.first_report) << ", magnitude " << shape.magnitude
                             << ", by axes " << shape.by_axes << ", units " << shape.has_units);
        REQUIRE(bench.effects.begin(*bench.link));
        CHECK(bench.stick->n_effects() == 2);
        CHECK(bench.stick->felt().right == 0.0);
        const struct {
            double x, y;
        } forces[] = {{1.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}, {0.5, -0.25}, {0.0, 0.0}};
        for (const auto& force : forces) {
            REQUIRE(bench.effects.set(*bench.link, force.x, force.y));
            const ForceStick::Felt felt = bench.stick->felt();
            // Half a step of the magnitude; a bearing without units is coarse by 360 / 65535 degrees.
            const double step = 0.5 / shape.magnitude + 1e-4;
            CHECK(felt.right == Approx(force.x).margin(step));
            CHECK(felt.away == Approx(force.y).margin(step));
        }
    }
    Bench wheel({.has_y = false});
    REQUIRE(wheel.effects.begin(*wheel.link));
    CHECK(wheel.stick->n_effects() == 1);
    REQUIRE(wheel.effects.set(*wheel.link, 0.5, 1.0));
    CHECK(wheel.stick->felt().right == Approx(0.5).margin(0.005));
    CHECK(wheel.stick->felt().away == Approx(0.0).margin(1e-9));
}

TEST_CASE("force effects: what is not a number is no force, what is too much is the most") {
    Bench bench({});
    REQUIRE(bench.effects.begin(*bench.link));
    REQUIRE(bench.effects.set(*bench.link, 1e9, -1e9));
    CHECK(bench.stick->felt().right == Approx(1.0));
    CHECK(bench.stick->felt().away == Approx(-1.0));
    REQUIRE(bench.effects.set(*bench.link, kNan, kNan));
    CHECK(bench.stick->felt().right == 0.0);
    CHECK(bench.stick->felt().away == 0.0);
}

TEST_CASE("force effects: the gain as it was set, and only what has changed is sent") {
    Bench bench({}, {.device_gain = 0.5});
    REQUIRE(bench.effects.begin(*bench.link));
    CHECK(bench.stick->device_gain() == Approx(0.5).margin(0.002));
    REQUIRE(bench.effects.set(*bench.link, 1.0, 1.0));
    CHECK(bench.stick->felt().right == Approx(0.5).margin(0.003));
    CHECK(bench.stick->felt().away == Approx(0.5).margin(0.003));
    Bench other({});
    REQUIRE(other.effects.begin(*other.link));
    REQUIRE(other.effects.set(*other.link, 0.5, 0.5));
    const int before = other.stick->orders();
    for (int i = 0; i < 100; ++i) {
        REQUIRE(other.effects.set(*other.link, 0.5 + i * 1e-7, 0.5));
    }
    CHECK(other.stick->orders() == before);
    REQUIRE(other.effects.set(*other.link, 0.6, 0.5));
    CHECK(other.stick->orders() == before + 1);
}

TEST_CASE("force effects: what nobody renews ends, and at the end nothing is felt, kept or sent") {
    Bench bench({}, {.duration_s = 0.1});
    REQUIRE(bench.effects.begin(*bench.link));
    REQUIRE(bench.effects.set(*bench.link, 1.0, 0.0));
    for (int i = 0; i < 8; ++i) {
        REQUIRE(bench.effects.renew(*bench.link));
        CHECK(bench.stick->felt().right == Approx(1.0));
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    CHECK(bench.effects.renew_every_s() < 0.05);
    std::this_thread::sleep_for(std::chrono::milliseconds(120));
    CHECK(bench.stick->felt().right == 0.0);
    Bench bench_again({});
    REQUIRE(bench_again.effects.begin(*bench_again.link));
    REQUIRE(bench_again.effects.set(*bench_again.link, 1.0, 1.0));
    bench_again.effects.end(*bench_again.link);
    CHECK(bench_again.stick->felt().right == 0.0);
    CHECK(bench_again.stick->felt().away == 0.0);
    CHECK(bench_again.stick->n_effects() == 0);
    const int before = bench_again.stick->orders();
    REQUIRE(bench_again.effects.set(*bench_again.link, 1.0, 1.0));
    REQUIRE(bench_again.effects.renew(*bench_again.link));
    CHECK(bench_again.stick->orders() == before);
}

TEST_CASE("force effects: no button of the stick sets a force off") {
    Bench bench({});
    REQUIRE(bench.effects.begin(*bench.link));
    REQUIRE(bench.effects.set(*bench.link, 1.0, 0.0));
    bench.effects.end(*bench.link);
    bench.stick->press_trigger();
    CHECK(bench.stick->felt().right == 0.0);
    REQUIRE(bench.effects.begin(*bench.link));
    std::this_thread::sleep_for(std::chrono::milliseconds(220));
    bench.stick->press_trigger();
    REQUIRE(bench.effects.set(*bench.link, 1.0, 0.0));
    CHECK(bench.stick->felt().right == 0.0);
}

TEST_CASE(
    "force effects: a device that takes its time is waited for, one that is full or silent is told "
    "of") {
    Bench slow({});
    slow.stick->be_slow(20);
    CHECK(slow.effects.begin(*slow.link));

    // Room for the first axis alone: what was made is ended.
    Bench full({});
    full.stick->make_room(1);
    CHECK(refusal_of(full.effects.begin(*full.link)) ==
          "the device did not have room for a constant force; unplug it and plug it in again, or "
          "use it without force.");
    CHECK(full.stick->n_effects() == 0);
    CHECK(full.stick->felt().right == 0.0);

    Bench silent({});
    silent.stick->be_slow(1000);
    CHECK_FALSE(silent.effects.begin(*silent.link));

    Bench gone({});
    gone.bus.unplug(kPath);
    CHECK_FALSE(gone.effects.begin(*gone.link));
}

TEST_CASE("force effects: an order that was lost is sent again") {
    Bench bench({});
    REQUIRE(bench.effects.begin(*bench.link));
    REQUIRE(bench.effects.set(*bench.link, 1.0, 0.0));
    bench.bus.unplug(kPath);
    CHECK_FALSE(bench.effects.set(*bench.link, 0.0, 0.0));
    CHECK_FALSE(bench.effects.renew(*bench.link));
    // The same device again, which still holds what it was told.
    bench.bus.plug(make_hid_node(kPath, {}, 1, 2, ""), bench.stick);
    bench.link = std::move(*bench.bus.open(kPath));
    CHECK(bench.stick->felt().right == Approx(1.0));
    REQUIRE(bench.effects.set(*bench.link, 0.0, 0.0));
    CHECK(bench.stick->felt().right == 0.0);
}

TEST_CASE("force layout: numbers, places and ranges are the descriptor's, a wheel has one axis") {
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

TEST_CASE("force layout: what cannot be used is refused, and who speaks of forces is told apart") {
    CHECK_FALSE(layout_of(force_stick_descriptor({.magnitude = 0})));
    Bytes one_sign = force_stick_descriptor({});
    // Logical Minimum -255 of the magnitude becomes 0.
    const Bytes minimum{0x09, 0x70, 0x16, 0x01, 0xFF};
    const auto at = std::search(one_sign.begin(), one_sign.end(), minimum.begin(), minimum.end());
    REQUIRE(at != one_sign.end());
    at[3] = 0;
    at[4] = 0;
    CHECK(is_refused(layout_of(one_sign), "one sign only"));
    CHECK(layout_of(without(0x57)));  // by axes then
    Bytes lost = without(0x57);
    for (std::size_t i = 0; i + 1 < lost.size(); ++i) {
        if (lost[i] == 0x09 && lost[i + 1] == 0x55) {
            lost[i + 1] = 0xEE;
        }
    }
    CHECK(is_refused(layout_of(lost), "no directions"));
    const auto speaks = [](const Bytes& bytes) {
        return mentions_force(*ReportDescriptor::parse(bytes));
    };
    CHECK(speaks(force_stick_descriptor({})));
    CHECK_FALSE(speaks(plain_stick_descriptor()));
    CHECK_FALSE(speaks(space_mouse_descriptor(true)));
}
