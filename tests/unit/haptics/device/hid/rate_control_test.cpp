#include "haptics/device/hid/rate_control.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace fulcrum;
using namespace fulcrum::hid;

namespace {

constexpr double kDt_s = 0.001;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

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
    CHECK(shape_cap(settings, kNaN) == 0.0);
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
    CHECK(way_against(kNaN) == Approx(free_m));
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
    for (const double dt_s : {3600.0, 1e300, std::numeric_limits<double>::infinity()}) {
        RateControl control(settings);
        control.step(pushed({1.0, 0.0, 0.0}), Vector3::Zero(), dt_s);
        CHECK(control.pose_D().position.x() <=
              settings.max_speed_m_per_s * kLongestRateStep_s * (1.0 + 1e-12));
    }
    RateControl control(settings);
    for (const double dt_s : {0.0, -1.0, kNaN}) {
        CHECK(control.step(pushed({1.0, 0.0, 0.0}), Vector3::Zero(), dt_s).position.x() == 0.0);
    }
    control.step(pushed({kNaN, 1.0, 0.0}), Vector3::Zero(), kDt_s);
    CHECK(is_finite(control.pose_D()));
    control.step(turned({kNaN, kNaN, kNaN}), Vector3::Zero(), kDt_s);
    CHECK(is_finite(control.pose_D()));
}
