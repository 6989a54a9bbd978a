#include "haptics/device/hid/rate_control.h"
#include "haptics/device/hid/space_mouse.h"
#include "haptics/device/hid/stick.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/told.h"
#include "tests/support/virtual_hid.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

using namespace fulcrum;
using namespace fulcrum::hid;
using test_support::Bytes;
using test_support::cap_report;
using namespace fulcrum::test_support;

namespace {

Expected<Stick> stick_of(const Bytes& bytes) {
    const auto descriptor = ReportDescriptor::parse(bytes);
    REQUIRE(descriptor);
    return Stick::find(*descriptor);
}

Cap cap_of(const Bytes& bytes) {
    const auto descriptor = ReportDescriptor::parse(bytes);
    REQUIRE(descriptor);
    const auto cap = Cap::find(*descriptor);
    REQUIRE(cap);
    return *cap;
}

constexpr double kDt_s = 0.001;

CapState pushed(const Vector3& push_D) {
    CapState cap;
    cap.push_D = push_D;
    return cap;
}

CapState turned(const Vector3& turn_D) {
    CapState cap;
    cap.turn_D = turn_D;
    return cap;
}

}  // namespace

TEST_CASE("space mouse: pushes and turns, in two reports or one, in our frame, not mirrored") {
    const Cap two = cap_of(space_mouse_descriptor(false));
    CapState cap;
    CHECK(two.take_report(cap_report(1, {350, -175, 70}), cap));
    // Right is right; towards the user is +z; down is -y.
    CHECK(cap.push_D == Vector3(1.0, -0.2, -0.5));
    CHECK(cap.turn_D == Vector3::Zero());
    CHECK(two.take_report(cap_report(2, {35, 0, -350}), cap));
    CHECK(cap.turn_D == Vector3(0.1, 1.0, 0.0));
    CHECK(cap.push_D == Vector3(1.0, -0.2, -0.5));
    const Cap one = cap_of(space_mouse_descriptor(true));
    cap = CapState();
    CHECK(one.take_report(cap_report(1, {0, 0, -350, 0, 350, 0}), cap));
    CHECK(cap.push_D == Vector3(0.0, 1.0, 0.0));
    CHECK(cap.turn_D == Vector3(0.0, 0.0, 1.0));
    // Some fill their report up.
    Bytes longer = cap_report(1, {0, 0, -350, 0, 350, 0});
    longer.resize(20);
    CHECK(one.take_report(longer, cap));
    // x cross y is z in either.
    CapState x, y, z;
    CHECK(two.take_report(cap_report(1, {350, 0, 0}), x));
    CHECK(two.take_report(cap_report(1, {0, 350, 0}), y));
    CHECK(two.take_report(cap_report(1, {0, 0, 350}), z));
    CHECK(x.push_D.cross(y.push_D) == z.push_D);
}

TEST_CASE("space mouse: buttons, and the end of the cap, also beyond what is told of it") {
    const Cap two = cap_of(space_mouse_descriptor(false));
    CHECK(two.n_axes() == 6);
    CHECK(two.n_buttons() == 2);
    CapState cap;
    CHECK(two.take_report(Bytes{3, 2, 0}, cap));
    CHECK(cap.buttons == 2);
    CHECK(two.take_report(Bytes{3, 1}, cap));
    CHECK(cap.buttons == 1);
    CHECK(two.take_report(Bytes{3, 0, 0xFF}, cap));
    CHECK(cap.buttons == 0);
    CHECK(two.take_report(cap_report(1, {32767, -32768, 351}), cap));
    CHECK(cap.push_D == Vector3(1.0, -1.0, -1.0));
}

TEST_CASE("space mouse: a self-built one says where its numbers lie, how wide and how far") {
    // Reports without numbers; four axes of 10 bits from 0 to 1023, that rest in the middle; a button.
    DescriptorBuilder d;
    d.page(1).usage(8).open(1).usage(0x30).usage(0x31).usage(0x32).usage(0x35);
    d.logical(0, 1023).fields(10, 4).input(2);
    d.page(9).usages(1, 1).logical(0, 1).fields(1, 1).input(2).fields(7, 1).input(1).close();
    const Cap own = cap_of(d.bytes());
    CHECK(own.n_axes() == 4);
    CHECK(own.n_buttons() == 1);
    // x 1023, y 0, z 511, Rz 1023, button down: 10 bits each, the lowest first.
    const std::uint64_t bits = 1023ULL | 511ULL << 20U | 1023ULL << 30U | 1ULL << 40U;
    Bytes report;
    for (unsigned i = 0; i < 6; ++i) {
        report.push_back(static_cast<std::uint8_t>(bits >> (8 * i)));
    }
    CapState cap;
    REQUIRE(own.take_report(report, cap));
    CHECK(cap.push_D.x() == 1.0);
    CHECK(cap.push_D.z() == -1.0);
    CHECK(std::abs(cap.push_D.y()) < 1.0e-3);
    // About their z, which is down.
    CHECK(cap.turn_D == Vector3(0.0, -1.0, 0.0));
    CHECK(cap.buttons == 1);
}

TEST_CASE(
    "space mouse: a Multi-axis Controller without X, Y and Z is none; a stick's axes are not its") {
    DescriptorBuilder d;
    d.page(1).usage(8).open(1).usage(0x30).usage(0x31).logical(-350, 350).fields(16, 2).input(2);
    d.close();
    d.page(1).usage(4).open(1).usage(0x32).logical(-350, 350).fields(16, 1).input(2).close();
    const auto descriptor = ReportDescriptor::parse(d.bytes());
    REQUIRE(descriptor);
    CHECK(refusal_of(Cap::find(*descriptor)) ==
          "it calls itself a Multi-axis Controller, and does not tell X, Y and Z; use a SpaceMouse "
          "or a joystick.");
}

TEST_CASE("space mouse: reports of no known kind or length change nothing") {
    const Cap two = cap_of(space_mouse_descriptor(false));
    CapState cap;
    REQUIRE(two.take_report(cap_report(1, {100, 100, 100}), cap));
    REQUIRE(two.take_report(cap_report(2, {50, 50, 50}), cap));
    REQUIRE(two.take_report(Bytes{3, 1}, cap));
    const CapState before = cap;
    const std::vector<Bytes> garbage{
        {},  {1},        {1, 2, 3, 4, 5, 6},    {2, 9, 9, 9},
        {3}, {23, 1, 2}, {0, 9, 9, 9, 9, 9, 9}, {255, 1, 2, 3, 4, 5, 6}};
    for (const Bytes& report : garbage) {
        CHECK_FALSE(two.take_report(report, cap));
        CHECK(cap.push_D == before.push_D);
        CHECK(cap.turn_D == before.turn_D);
        CHECK(cap.buttons == before.buttons);
    }
}

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
    CHECK(refusal_of(stick_of(apart.bytes())) ==
          "the device has no two axes; use a joystick, a gamepad or a SpaceMouse.");
    DescriptorBuilder dead;
    dead.page(1).usage(4).open(1).logical(3, 3).fields(8, 2).usage(0x30).usage(0x31).input(2);
    CHECK_FALSE(stick_of(dead.close().bytes()));
}

TEST_CASE("rate control: a cap held moves the hand evenly, in closed form; let go, it stays") {
    const RateSettings settings;
    RateControl control(settings);
    const double u = 0.5;
    const double share = std::pow((u - settings.dead_zone) / (1.0 - settings.dead_zone), 2.0);
    for (int k = 1; k <= 300; ++k) {
        const Vector3 at = control.step(pushed({0.0, u, 0.0}), Vector3::Zero(), kDt_s).position;
        REQUIRE(at.y() == Approx(k * kDt_s * settings.max_speed_m_per_s * share).epsilon(1e-9));
        REQUIRE(at.x() == 0.0);
    }
    const Vector3 there = control.pose_D().position;
    for (int k = 0; k < 100; ++k) {
        REQUIRE(control.step({}, Vector3(0.0, -5.0, 0.0), kDt_s).position == there);
    }
}

TEST_CASE("rate control: a turn about an axis is its rate times time, and stays a rotation") {
    RateSettings settings;
    settings.dead_zone = 0.0;
    settings.exponent = 1.0;
    RateControl control(settings);
    for (int k = 0; k < 1000; ++k) {
        control.step(turned({0.0, 0.0, 1.0}), Vector3::Zero(), kDt_s);
    }
    const AngleAxis turn(Quaternion(control.pose_D().orientation));
    CHECK(turn.angle() == Approx(settings.max_turn_rad_per_s).epsilon(1e-9));
    CHECK(turn.axis().z() == Approx(1.0));
    CHECK(control.pose_D().orientation.norm() == Approx(1.0).epsilon(1e-14));
}

TEST_CASE(
    "rate control: within the dead zone nothing moves, beyond it begins at zero, the end is full "
    "speed") {
    RateSettings settings;
    settings.dead_zone = 0.1;
    CHECK(shape_cap(settings, 0.1) == 0.0);
    CHECK(shape_cap(settings, -0.1) == 0.0);
    CHECK(shape_cap(settings, 0.1001) > 0.0);
    CHECK(shape_cap(settings, 0.1001) < 1e-6);
    CHECK(shape_cap(settings, 1.0) == 1.0);
    CHECK(shape_cap(settings, -1.0) == -1.0);
    CHECK(shape_cap(settings, 50.0) == 1.0);
    CHECK(shape_cap(settings, kNan) == 0.0);
    double before = 0.0;
    for (double u = 0.0; u <= 1.0; u += 0.01) {
        const double now = shape_cap(settings, u);
        CHECK(now >= before);
        CHECK(shape_cap(settings, -u) == -now);
        before = now;
    }
}

TEST_CASE(
    "rate control: what opposes the way slows it, in proportion, to rest; what helps does not "
    "push") {
    RateSettings settings;
    settings.full_push_N = 4.0;
    const double free_m = settings.max_speed_m_per_s * kDt_s;
    const auto way_against = [&](double force_N) {
        RateControl control(settings);
        return control.step(pushed({1.0, 0.0, 0.0}), Vector3(force_N, 3.0, 0.0), kDt_s)
            .position.x();
    };
    CHECK(way_against(0.0) == Approx(free_m));
    CHECK(way_against(-1.0) == Approx(0.75 * free_m));
    CHECK(way_against(-4.0) == 0.0);
    CHECK(way_against(-40.0) == 0.0);
    CHECK(way_against(2.0) == Approx(free_m));
    CHECK(way_against(kNan) == Approx(free_m));
}

TEST_CASE("rate control: the hand stays in its box, and comes back from its side at once") {
    const RateSettings settings;
    RateControl control(settings);
    for (int k = 0; k < 5000; ++k) {
        control.step(pushed({1.0, -1.0, 0.3}), Vector3::Zero(), kDt_s);
        REQUIRE(control.pose_D().position.cwiseAbs().maxCoeff() <= settings.half_extent_m);
    }
    CHECK(control.pose_D().position.x() == settings.half_extent_m);
    control.step(pushed({-1.0, 0.0, 0.0}), Vector3::Zero(), kDt_s);
    CHECK(control.pose_D().position.x() ==
          Approx(settings.half_extent_m - settings.max_speed_m_per_s * kDt_s));
}

TEST_CASE("rate control: no pause, no clock and no number makes it leap") {
    const RateSettings settings;
    for (const double dt_s : {3600.0, 1e300, kInfinity}) {
        RateControl control(settings);
        control.step(pushed({1.0, 0.0, 0.0}), Vector3::Zero(), dt_s);
        CHECK(control.pose_D().position.x() <=
              settings.max_speed_m_per_s * kLongestRateStep_s * (1.0 + 1e-12));
    }
    RateControl control(settings);
    for (const double dt_s : {0.0, -1.0, kNan}) {
        CHECK(control.step(pushed({1.0, 0.0, 0.0}), Vector3::Zero(), dt_s).position.x() == 0.0);
    }
    control.step(pushed({kNan, 1.0, 0.0}), Vector3::Zero(), kDt_s);
    CHECK(is_finite(control.pose_D()));
    control.step(turned({kNan, kNan, kNan}), Vector3::Zero(), kDt_s);
    CHECK(is_finite(control.pose_D()));
}
