#include "haptics/device/watched/sensor_guard.h"

#include "haptics/device/simulated/simulated_arm.h"
#include "haptics/math/split_mix.h"
#include "tests/support/bad_numbers.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>

using namespace fulcrum;

namespace {

constexpr SensorLife kTrembling{.trembles_within_s = 0.05};
constexpr SensorLife kPushed{.moves_at_N = 1.0};
constexpr SensorLife kHandle{.most_m_per_s2 = 300.0};

const Vector3 kPush(1.0, 0.0, 0.0);

// When the first fault was told, in seconds from the beginning; infinity for never.
struct Told {
    double at_s = kInfinity;
    Fault fault = Fault::none;
};
Told watch(SensorGuard& guard, const std::function<Vector3(double)>& position,
           const std::function<Vector3(double)>& force, double seconds, double rate_Hz = 1000.0) {
    Told told;
    for (int i = 0; i <= static_cast<int>(seconds * rate_Hz); ++i) {
        const double now_s = i / rate_Hz;
        const Fault fault = guard.step(position(now_s), 10.0 + now_s, force(now_s));
        if (any(fault) && !any(told.fault)) {
            told = {now_s, fault};
        }
    }
    return told;
}
Vector3 at_rest(double) {
    return {0.1, 0.2, 0.3};
}
std::function<Vector3(double)> along_x(const std::function<double(double)>& x) {
    return [x](double t_s) { return Vector3(x(t_s), 0.0, 0.0); };
}
Vector3 push(double) {
    return kPush;
}

}  // namespace

TEST_CASE("sensor guard: a sensor that trembles and stands still under a force is frozen") {
    SensorGuard guard(kTrembling, 0.0);
    const Told told = watch(guard, at_rest, push, 0.2);
    CHECK(told.fault == Fault::device_stale);
    CHECK(told.at_s == Approx(0.0505).margin(6e-4));
    // It is, until it tells something else; what lies before counts no more.
    CHECK(guard.step({0.1, 0.2, 0.3}, 10.3, Vector3::Zero()) == Fault::device_stale);
    CHECK(guard.step({0.1, 0.2, 0.3000001}, 10.301, kPush) == Fault::none);
    CHECK_FALSE(guard.is_frozen());
}

TEST_CASE("sensor guard: a handle that no change of force moves has a frozen sensor") {
    const auto rises = along_x([](double t_s) { return 4.0 * t_s; });
    SensorGuard guard(kPushed, 0.0);
    const Told told = watch(guard, at_rest, rises, 1.0);
    CHECK(told.fault == Fault::device_stale);
    CHECK(told.at_s == Approx(0.25 + SensorGuard::kAnswer_s).margin(2.1e-3));
}

TEST_CASE("sensor guard: an error that alternates is told within eight rounds, at 1 and 2 kHz") {
    for (const double rate_Hz : {1000.0, 2000.0}) {
        for (const double size_m : {0.4e-3, 1.0e-3, 8.0e-3}) {
            CAPTURE(rate_Hz, size_m);
            SensorGuard guard(kHandle, 5.5e-5);
            const auto alternates = along_x(
                [&](double t_s) { return std::lround(t_s * rate_Hz) % 2 == 0 ? 0.0 : size_m; });
            const Told told = watch(guard, alternates, push, 0.1, rate_Hz);
            CHECK(told.fault == Fault::device_invalid);
            CHECK(told.at_s <= 8.0 / rate_Hz);
        }
    }
    // And one that stands for some rounds between.
    SensorGuard guard(kHandle, 0.0);
    const auto square =
        along_x([](double t_s) { return std::lround(t_s * 1000.0) % 8 < 4 ? 0.0 : 1.0e-3; });
    CHECK(watch(guard, square, push, 0.1).fault == Fault::device_invalid);
}

TEST_CASE("sensor guard: the smallest error it tells; uneven rounds are none") {
    // w alternates between +-2 A, and may be a T^2 + 4 n.
    const double noise_m = 2.0e-5;
    const double limit_m = 0.5 * 300.0e-6 + 2.0 * noise_m;
    for (const double share : {0.99, 1.01}) {
        SensorGuard guard(kHandle, noise_m);
        const auto alternates = along_x(
            [&](double t_s) { return std::lround(t_s * 1000.0) % 2 == 0 ? 0.0 : share * limit_m; });
        CAPTURE(share);
        CHECK(any(watch(guard, alternates, push, 0.2).fault) == (share > 1.0));
    }
    SensorGuard guard({.most_m_per_s2 = 300.0}, 5.5e-5);
    double stamp_s = 0.0;
    for (int i = 0; i < 20'000; ++i) {
        // Late, and the next right after it; now and then some are missing.
        stamp_s += i % 97 == 0 ? 0.009 : (i % 2 == 0 ? 1.95e-3 : 0.05e-3);
        const double x = std::round((0.5 * stamp_s) / 5.5e-5) * 5.5e-5;
        REQUIRE_FALSE(any(guard.step({x, 0.0, 0.0}, stamp_s, kPush)));
    }
}

TEST_CASE(
    "sensor guard: what hands, handles and friction do, and where nothing is known, is none of "
    "it") {
    const auto little = along_x([](double) { return 0.9 * kLeastFelt_N; });
    const auto swings = along_x([](double t_s) { return 5.0 * std::sin(30.0 * t_s); });
    const auto taken_up = along_x([](double t_s) { return 3.0 + 0.99 * std::sin(30.0 * t_s); });
    const auto steps = along_x([](double t_s) { return 1.0e-4 * std::floor(t_s / 0.04); });
    const auto answers = along_x([](double t_s) { return 1.0e-4 * std::floor(t_s / 0.09); });
    const auto pushes = along_x([](double t_s) { return std::fmod(t_s, 0.09) < 0.01 ? 0.0 : 3.0; });
    const auto turns =
        along_x([](double t_s) { return std::fmod(t_s - 0.001, 0.18) < 0.09 ? 0.0 : 3.0; });
    const auto comes_and_goes =
        along_x([](double t_s) { return std::fmod(t_s, 0.05) < 0.01 ? 0.0 : 3.0; });
    const auto by_hand = along_x([](double t_s) { return 0.1 * std::sin(2.0 * M_PI * 4.0 * t_s); });
    const auto rings =
        along_x([](double t_s) { return 0.005 * std::sin(2.0 * M_PI * 60.0 * t_s); });
    const auto into_stop = along_x([](double t_s) { return std::min(2.0 * t_s, 0.2); });
    const auto thrust = along_x([](double t_s) { return 300.0 * t_s * t_s; });
    const auto to_stop_and_back =
        along_x([](double t_s) { return 0.2 * std::abs(std::fmod(t_s, 0.2) - 0.1); });
    const struct {
        const char* what;
        SensorLife life;
        std::function<Vector3(double)> position, force;
        double seconds = 2.0;
    } sensors[] = {
        {"at rest without a force", kTrembling, at_rest, little, 10.0},
        {"one of which nothing is known", {}, at_rest, swings, 10.0},
        {"friction takes the change up", kPushed, at_rest, taken_up, 10.0},
        {"rests that steps end, however many", kTrembling, steps, push},
        {"pushed anew after each step, and moved within the time for that", kPushed, answers,
         pushes},
        {"the next push right after the step", kPushed, answers, turns},
        {"a force that goes between", kTrembling, at_rest, comes_and_goes},
        {"a push that goes between", kPushed, at_rest, comes_and_goes},
        {"as fast as a hand can", kHandle, by_hand, push},
        {"700 m/s^2 to and fro", kHandle, rings, push},
        {"run into a stop", kHandle, into_stop, push},
        {"600 m/s^2 one way", kHandle, thrust, push},
        {"against a stop and back, ten times a second", kHandle, to_stop_and_back, push},
    };
    for (const auto& one : sensors) {
        for (const double rate_Hz : {1000.0, 2000.0}) {
            CAPTURE(one.what, rate_Hz);
            SensorGuard guard(one.life, 0.0);
            CHECK_FALSE(any(watch(guard, one.position, one.force, one.seconds, rate_Hz).fault));
        }
    }
}

TEST_CASE("sensor guard: after a jump it begins anew, and nothing of before counts") {
    double now_s = 0.0;
    const auto step = [&now_s](SensorGuard& guard, double x, double force_N) {
        now_s += 0.001;
        return guard.step({x, 0.0, 0.0}, now_s, {force_N, 0.0, 0.0});
    };
    SensorGuard guard({0.05, 1.0, 300.0}, 0.0);
    for (int i = 0; i < 100; ++i) {
        (void)step(guard, 0.1, 0.5);
    }
    REQUIRE(guard.is_frozen());
    guard.forget();
    CHECK(step(guard, 0.1, 0.0) == Fault::none);
    CHECK(step(guard, 0.1, 0.0) == Fault::none);
    // A push that was not answered yet.
    SensorGuard pushed(kPushed, 0.0);
    (void)step(pushed, 0.1, 0.0);
    for (int i = 0; i < 90; ++i) {
        REQUIRE(step(pushed, 0.1, 3.0) == Fault::none);
    }
    pushed.forget();
    (void)step(pushed, 0.1, 0.0);
    for (int i = 0; i < 90; ++i) {
        REQUIRE(step(pushed, 0.1, 3.0) == Fault::none);
    }
    // Turns, and which way the last one was.
    SensorGuard shaken(kHandle, 0.0);
    for (int i = 0; i < 4; ++i) {
        (void)step(shaken, i % 2 == 0 ? 0.0 : 1.0e-3, 0.0);
    }
    REQUIRE(shaken.turns() > 0.9);
    shaken.forget();
    (void)step(shaken, 0.0, 0.0);
    CHECK(shaken.turns() == 0.0);
    (void)step(shaken, 1.0e-3, 0.0);
    (void)step(shaken, 0.0, 0.0);
    CHECK(shaken.turns() == 0.0);
}

TEST_CASE("sensor guard: what is no number or not later is not counted") {
    SensorGuard guard({0.05, 1.0, 300.0}, 0.0);
    for (int i = 0; i < 200; ++i) {
        REQUIRE_FALSE(any(guard.step({kNan, 0.0, 0.0}, 0.001 * i, kPush)));
        REQUIRE_FALSE(any(guard.step({0.0, 0.0, 0.0}, kNan, kPush)));
        REQUIRE_FALSE(any(guard.step({0.01 * (i % 2), 0.0, 0.0}, 1.0, kPush)));
    }
    CHECK(guard.turns() == 0.0);
    // After a jump it begins anew.
    SensorGuard other(kTrembling, 0.0);
    (void)watch(other, at_rest, push, 0.045);
    other.forget();
    CHECK_FALSE(any(watch(other, at_rest, push, 0.045).fault));
}

TEST_CASE("sensor guard: a simulated arm, with and without noise, rests and is pushed in peace") {
    // sqrt 3 (2 f_c + 3000 N/m 2 r) of the desktop arm: friction on three axes, the stiffest grip, two steps.
    constexpr SensorLife kDesktop{0.0, 1.5, 300.0};
    constexpr SensorLife kNoisy{0.05, 1.5, 300.0};
    for (const double noise_m : {0.0, 5.0e-6}) {
        for (const HumanImpedance& human : {kFingertip, kArm, kPosture, kNobody}) {
            SimulatedArmSettings settings = make_desktop_arm();
            settings.max_force_N = 10.0;
            settings.human = human;
            LatestValue<HandTarget> target;
            target.publish({});
            SimulatedArm arm(settings, target);
            SensorGuard guard(noise_m > 0.0 ? kNoisy : kDesktop, settings.position_resolution_m);
            SplitMix noise(1);
            Vector3 force_D = Vector3::Zero();
            for (int i = 0; i < 6000; ++i) {
                DeviceReading reading;
                REQUIRE(arm.read(0.001 * i, reading));
                reading.pose_D.position.x() += noise_m * noise.draw_chance();
                INFO("noise " << noise_m << ", " << human.stiffness_N_per_m << " N/m, round " << i);
                REQUIRE_FALSE(any(guard.step(reading.pose_D.position, reading.stamp_s, force_D)));
                // Rest; a force that stays; one that comes and goes.
                const double t_s = 0.001 * i;
                force_D.x() = t_s < 1.0 ? 0.0 : (t_s < 3.0 ? 3.0 : 3.0 * std::sin(9.0 * t_s));
                REQUIRE(arm.write(t_s, {force_D, Vector3::Zero()}));
            }
        }
    }
}
