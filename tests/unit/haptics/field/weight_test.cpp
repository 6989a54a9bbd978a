#include "haptics/field/weight.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace fulcrum;

namespace {

constexpr double kDt_s = 0.001;
constexpr double kRounding = 1e-9;

}  // namespace

TEST_CASE("weight: from rest it is the minimum-jerk curve in closed form") {
    WeightRamp ramp(0.3);
    const Vector3 target(0.0, -4.0, 1.0);
    for (int k = 1; k <= 300; ++k) {
        const double s = k * kDt_s / 0.3;
        const double share = s * s * s * (10.0 - 15.0 * s + 6.0 * s * s);
        const double slope = 30.0 * s * s * (1.0 - s) * (1.0 - s) / 0.3;
        REQUIRE((ramp.step(target, kDt_s) - share * target).norm() < kRounding);
        REQUIRE((ramp.rate_W() - slope * target).norm() < 1e-7);
    }
    (void)ramp.step(target, kDt_s);
    CHECK(ramp.force_W() == target);
    CHECK(ramp.rate_W().norm() == 0.0);
}

TEST_CASE("weight: it never passes a target that it started to from rest") {
    WeightRamp ramp(0.2);
    double before = 0.0;
    for (int k = 0; k < 250; ++k) {
        const double now = ramp.step(Vector3(0, 3.0, 0), kDt_s).y();
        REQUIRE(now >= before);
        REQUIRE(now <= 3.0 + kRounding);
        before = now;
    }
    // Leaving is the same curve backwards.
    for (int k = 0; k < 250; ++k) {
        const double now = ramp.step(Vector3::Zero(), kDt_s).y();
        REQUIRE(now <= before);
        REQUIRE(now >= -kRounding);
        before = now;
    }
    CHECK(before == 0.0);
}

TEST_CASE("weight: value, rate and acceleration stay continuous when the target changes midway") {
    WeightRamp ramp(0.3);
    const double fine_s = 1e-5;
    // Bounds from the quintic's own maxima for a way of at most 8 N: rate 15/8 D/T, acceleration 5.8 D/T^2, jerk 60 D/T^3;
    // doubled for a change in motion.
    const double rate_bound = 2.0 * 1.875 * 8.0 / 0.3;
    const double acceleration_bound = 2.0 * 5.8 * 8.0 / 0.09;
    const double jerk_bound = 2.0 * 60.0 * 8.0 / 0.027;
    Vector3 force = Vector3::Zero();
    Vector3 rate = Vector3::Zero();
    Vector3 acceleration = Vector3::Zero();
    for (int k = 0; k < 70000; ++k) {
        const double t_s = k * fine_s;
        const Vector3 target = t_s < 0.1    ? Vector3(0, -4, 0)
                               : t_s < 0.17 ? Vector3(2, 4, 0)
                               : t_s < 0.25 ? Vector3(0, 0, 0)
                                            : Vector3(0, -2, 1);
        (void)ramp.step(target, fine_s);
        REQUIRE((ramp.force_W() - force).norm() <= rate_bound * fine_s);
        REQUIRE((ramp.rate_W() - rate).norm() <= acceleration_bound * fine_s);
        REQUIRE((ramp.acceleration_W() - acceleration).norm() <= jerk_bound * fine_s);
        // The rate is the force's slope.
        REQUIRE((ramp.force_W() - force - 0.5 * fine_s * (rate + ramp.rate_W())).norm() < 1e-9);
        force = ramp.force_W();
        rate = ramp.rate_W();
        acceleration = ramp.acceleration_W();
    }
    CHECK(force == Vector3(0, -2, 1));
}

TEST_CASE("weight: begun again midway it leaves the span between the targets by 7 % at most") {
    double lowest = 0.0;
    double highest = 0.0;
    for (int turn = 1; turn < 300; ++turn) {
        for (const double target_N : {0.0, 0.5, 1.0 + 1e-6}) {
            WeightRamp ramp(0.3);
            for (int k = 0; k < 700; ++k) {
                const double f = ramp.step(Vector3(k < turn ? 1.0 : target_N, 0, 0), kDt_s).x();
                lowest = std::min(lowest, f);
                highest = std::max(highest, f);
            }
        }
    }
    CHECK(highest > 1.06);
    CHECK(highest < 1.07);
    CHECK(lowest > -0.07);
}

TEST_CASE("weight: bad targets and times move nothing") {
    WeightRamp ramp(0.3);
    for (int k = 0; k < 100; ++k) {
        (void)ramp.step(Vector3(0, -4, 0), kDt_s);
    }
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Vector3 before = ramp.force_W();
    CHECK(ramp.step(Vector3(0, -4, 0), nan) == before);
    CHECK(ramp.step(Vector3(0, -4, 0), -1.0) == before);
    const double inf = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 400; ++k) {
        (void)ramp.step(k % 2 == 0 ? Vector3(nan, 0, 0) : Vector3(0, inf, 0), kDt_s);
    }
    CHECK(ramp.force_W() == Vector3(0, -4, 0));
    // An onset of nothing is still an onset.
    WeightRamp sudden(0.0);
    CHECK(sudden.step(Vector3(0, -4, 0), kDt_s).norm() < 0.1);
}
