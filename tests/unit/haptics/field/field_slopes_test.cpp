#include "haptics/field/linearised_wrench.h"
#include "haptics/field/weight.h"
#include "tests/support/bad_numbers.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace fulcrum;

namespace {

constexpr double kDt_s = 0.001;

constexpr double kRounding = 1e-9;

}  // namespace

// What a lesson's wrench tells the passivity stage.

TEST_CASE("linearised wrench: what it tells of its elastic part is all but B v, now and held") {
    LinearisedWrenchStage stage{LinearisedWrenchSettings{}};
    LinearisedWrench model;
    model.stamp_s = 0.0;
    model.force_W = Vector3(0.5, 0.0, -0.2);
    model.torque_W = Vector3(0.02, 0.0, 0.0);
    model.stiffness_N_per_m = -40.0 * Matrix3::Identity();
    model.damping_Ns_per_m = -2.0 * Matrix3::Identity();
    model.torque_stiffness_Nm_per_m = 0.7 * Matrix3::Identity();
    const Vector3 v(0.1, -0.3, 0.2);
    Vector3 x(0.001, 0.002, 0.0);
    for (int k = 0; k < 30; ++k) {
        (void)stage.step(model, x, v, k * kDt_s);
    }
    // Moved along its own slopes, nothing else changed.
    const Vector3 d(1e-4, -2e-4, 3e-4);
    const Vector3 before_N = stage.elastic_force().now_W;
    const Vector3 before_Nm = stage.elastic_torque().now_W;
    x += d;
    const Wrench wrench = stage.step(model, x, v, 0.03);
    CHECK((wrench.force - stage.elastic_force().now_W + 2.0 * v).norm() < 1e-12);
    CHECK((stage.elastic_torque().now_W - wrench.torque).norm() == 0.0);
    CHECK((stage.elastic_force().held_W - (before_N - 40.0 * d)).norm() < 1e-12);
    CHECK((stage.elastic_force().now_W - stage.elastic_force().held_W).norm() < 1e-12);
    CHECK((stage.elastic_torque().held_W - (before_Nm + 0.7 * d)).norm() < 1e-12);
    // A new answer with other slopes: held is the former one at the new place.
    LinearisedWrench other = model;
    other.stamp_s = 0.031;
    other.force_W = Vector3(-3.0, 0.0, 0.0);
    other.stiffness_N_per_m = 500.0 * Matrix3::Identity();
    const Vector3 last_N = stage.elastic_force().now_W;
    x += d;
    (void)stage.step(other, x, v, 0.031);
    CHECK((stage.elastic_force().held_W - (last_N - 40.0 * d)).norm() < 1e-12);
    // Where a limit or its age shortens an answer, its slopes are shortened alike.
    LinearisedWrenchSettings tight;
    tight.max_force_N = 0.25;
    LinearisedWrenchStage limited(tight);
    model.damping_Ns_per_m.setZero();
    (void)limited.step(model, model.at_position_W, v, 0.0);
    for (int k = 1; k < 50; ++k) {
        (void)limited.step(model, model.at_position_W, v, k * kDt_s);
    }
    const double share = 0.25 / model.force_W.norm();
    const Vector3 held_N = limited.elastic_force().now_W;
    (void)limited.step(model, model.at_position_W + d, v, 0.05);
    CHECK((limited.elastic_force().held_W - (held_N - 40.0 * share * d)).norm() < 1e-12);
}

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

TEST_CASE("weight: begun again midway it leaves the span by 7 % at most; bad input moves nothing") {
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
    WeightRamp ramp(0.3);
    for (int k = 0; k < 100; ++k) {
        (void)ramp.step(Vector3(0, -4, 0), kDt_s);
    }
    const Vector3 before = ramp.force_W();
    CHECK(ramp.step(Vector3(0, -4, 0), kNan) == before);
    CHECK(ramp.step(Vector3(0, -4, 0), -1.0) == before);
    for (int k = 0; k < 400; ++k) {
        (void)ramp.step(k % 2 == 0 ? Vector3(kNan, 0, 0) : Vector3(0, kInfinity, 0), kDt_s);
    }
    CHECK(ramp.force_W() == Vector3(0, -4, 0));
    // An onset of nothing is still an onset.
    WeightRamp sudden(0.0);
    CHECK(sudden.step(Vector3(0, -4, 0), kDt_s).norm() < 0.1);
}
