#include "haptics/device/hid/force_effects.h"

#include "tests/support/virtual_hid.h"

#include <catch2/catch.hpp>

#include <chrono>
#include <limits>
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

}  // namespace

TEST_CASE("force effects: a force is felt as it was meant, on devices of every shape") {
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
}

TEST_CASE("force effects: along one axis only that of the device") {
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
    const double nan = std::numeric_limits<double>::quiet_NaN();
    REQUIRE(bench.effects.set(*bench.link, nan, nan));
    CHECK(bench.stick->felt().right == 0.0);
    CHECK(bench.stick->felt().away == 0.0);
}

TEST_CASE("force effects: the gain as it was set") {
    Bench bench({}, {.device_gain = 0.5});
    REQUIRE(bench.effects.begin(*bench.link));
    CHECK(bench.stick->device_gain() == Approx(0.5).margin(0.002));
    REQUIRE(bench.effects.set(*bench.link, 1.0, 1.0));
    CHECK(bench.stick->felt().right == Approx(0.5).margin(0.003));
    CHECK(bench.stick->felt().away == Approx(0.5).margin(0.003));
}

TEST_CASE("force effects: only what has changed is sent") {
    Bench bench({});
    REQUIRE(bench.effects.begin(*bench.link));
    REQUIRE(bench.effects.set(*bench.link, 0.5, 0.5));
    const int before = bench.stick->orders();
    for (int i = 0; i < 100; ++i) {
        REQUIRE(bench.effects.set(*bench.link, 0.5 + i * 1e-7, 0.5));
    }
    CHECK(bench.stick->orders() == before);
    REQUIRE(bench.effects.set(*bench.link, 0.6, 0.5));
    CHECK(bench.stick->orders() == before + 1);
}

TEST_CASE("force effects: a force that nobody renews ends by itself; renewed, it goes on") {
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
}

TEST_CASE("force effects: at the end nothing is felt, nothing is kept, and nothing more is sent") {
    Bench bench({});
    REQUIRE(bench.effects.begin(*bench.link));
    REQUIRE(bench.effects.set(*bench.link, 1.0, 1.0));
    bench.effects.end(*bench.link);
    CHECK(bench.stick->felt().right == 0.0);
    CHECK(bench.stick->felt().away == 0.0);
    CHECK(bench.stick->n_effects() == 0);
    const int before = bench.stick->orders();
    REQUIRE(bench.effects.set(*bench.link, 1.0, 1.0));
    REQUIRE(bench.effects.renew(*bench.link));
    CHECK(bench.stick->orders() == before);
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
    const auto refused = full.effects.begin(*full.link);
    REQUIRE_FALSE(refused);
    CHECK(to_sentence(refused.error()) ==
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
