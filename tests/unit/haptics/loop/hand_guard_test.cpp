#include "haptics/loop/hand_guard.h"

#include "tests/support/bad_numbers.h"

#include <catch2/catch.hpp>

using namespace fulcrum;

namespace {

constexpr double kTick_s = 0.001;

Wrench force_along_x(double newtons) {
    return {{newtons, 0.0, 0.0}, Vector3::Zero()};
}

}  // namespace

TEST_CASE("hand guard: a hand faster than its limit is a fault, a short jerk is none") {
    SafetySettings settings;
    settings.max_felt_speed_m_per_s = 3.0;
    HandGuard guard(settings);
    for (int i = 0; i < 1000; ++i) {
        REQUIRE(guard.step({}, {0.0029, 0.0, 0.0}, Vector3::Zero(), kTick_s) == Fault::none);
    }
    CHECK(guard.speed_m_per_s() == Approx(2.9).epsilon(1e-6));
    Fault seen = Fault::none;
    for (int i = 0; i < 200; ++i) {
        seen |= guard.step({}, {0.0, 0.0032, 0.0}, Vector3::Zero(), kTick_s);
    }
    CHECK(any(seen & Fault::hand_too_fast));
    // One reading that is 5 mm off is no fast hand.
    HandGuard calm(settings);
    CHECK(calm.step({}, {0.005, 0.0, 0.0}, Vector3::Zero(), kTick_s) == Fault::none);
    CHECK(calm.step({}, {-0.005, 0.0, 0.0}, Vector3::Zero(), kTick_s) == Fault::none);
}

TEST_CASE("hand guard: energy given in a second is bounded, in closed form") {
    SafetySettings settings;
    settings.max_energy_J = 2.0;
    HandGuard guard(settings);
    // 4 N along 1 m/s are 4 W: E(t) = 4 s (1 - e^-t), 2 J after ln 2 = 0.693 s.
    int ticks = 0;
    while (guard.step(force_along_x(4.0), {0.001, 0.0, 0.0}, Vector3::Zero(), kTick_s) ==
           Fault::none) {
        REQUIRE(++ticks < 2000);
    }
    CHECK(ticks * kTick_s == Approx(0.693).epsilon(0.01));
    // Given back, it counts no more; what the hand puts in is no credit.
    HandGuard even(settings);
    for (int i = 0; i < 20'000; ++i) {
        const double way_m = i / 200 % 2 == 0 ? 0.001 : -0.001;
        REQUIRE(even.step(force_along_x(5.0), {way_m, 0.0, 0.0}, Vector3::Zero(), kTick_s) ==
                Fault::none);
    }
    CHECK(even.energy_J() >= 0.0);
    // A torque gives as much.
    HandGuard turned(settings);
    Fault seen = Fault::none;
    for (int i = 0; i < 1000; ++i) {
        seen |= turned.step({Vector3::Zero(), {0.0, 0.0, 1.0}}, Vector3::Zero(), {0.0, 0.0, 0.004},
                            kTick_s);
    }
    CHECK(any(seen & Fault::too_much_energy));
}

TEST_CASE("hand guard: what is not finite, or takes no time, is not counted") {
    HandGuard guard(SafetySettings{});
    CHECK(guard.step(force_along_x(kNan), {0.001, 0.0, 0.0}, Vector3::Zero(), kTick_s) ==
          Fault::none);
    CHECK(guard.step({}, {kNan, 0.0, 0.0}, Vector3::Zero(), kTick_s) == Fault::none);
    CHECK(guard.step(force_along_x(9.0), {9.0, 0.0, 0.0}, Vector3::Zero(), 0.0) == Fault::none);
    CHECK(guard.step(force_along_x(9.0), {9.0, 0.0, 0.0}, Vector3::Zero(), kNan) == Fault::none);
    CHECK(guard.speed_m_per_s() == 0.0);
    CHECK(guard.energy_J() == 0.0);
}

TEST_CASE("hand guard: a new hand is not charged for the last") {
    SafetySettings settings;
    settings.max_energy_J = 0.5;
    HandGuard guard(settings);
    for (int i = 0; i < 1000; ++i) {
        (void)guard.step(force_along_x(5.0), {0.002, 0.0, 0.0}, Vector3::Zero(), kTick_s);
    }
    guard.forget();
    CHECK(guard.step(force_along_x(5.0), {0.001, 0.0, 0.0}, Vector3::Zero(), kTick_s) ==
          Fault::none);
}
