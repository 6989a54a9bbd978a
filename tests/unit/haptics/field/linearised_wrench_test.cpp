#include "haptics/field/linearised_wrench.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <vector>

using namespace fulcrum;

namespace {

constexpr double kDt_s = 0.001;
constexpr double kTimeout_s = 0.1;

LinearisedWrench make_model(double stamp_s) {
    LinearisedWrench model;
    model.stamp_s = stamp_s;
    model.force_W = Vector3(1.0, 2.0, 3.0);
    model.torque_W = Vector3(0.1, -0.2, 0.3);
    model.at_position_W = Vector3(0.1, 0.0, 0.0);
    model.at_velocity_W = Vector3(0.0, 0.2, 0.0);
    model.stiffness_N_per_m << -100.0, 5.0, 0.0, 5.0, -50.0, 0.0, 0.0, 0.0, -10.0;
    model.damping_Ns_per_m << -2.0, 0.0, 0.0, 0.0, -1.0, 0.5, 0.0, -0.5, -3.0;
    model.torque_stiffness_Nm_per_m << -4.0, 0.0, 2.0, 0.0, 3.0, 0.0, 1.0, 0.0, -5.0;
    return model;
}

// How far two wrenches are apart: newtons and newton metres added up.
double difference(const Wrench& a, const Wrench& b) {
    return (a.force - b.force).norm() + (a.torque - b.torque).norm();
}

Wrench scaled(double factor, const Wrench& wrench) {
    return {factor * wrench.force, factor * wrench.torque};
}

}  // namespace

TEST_CASE("linearised wrench: F0 + K (x - x0) + B (v - v0), T0 + S (x - x0)") {
    const LinearisedWrench model = make_model(0.0);
    const Wrench wrench =
        compute_linearised_wrench(model, Vector3(0.12, 0.01, 0.0), Vector3(0.0, 0.2, 0.4));
    const Wrench expected{Vector3(1.0 - 2.0 + 0.05, 2.0 + 0.1 - 0.5 + 0.2, 3.0 - 1.2),
                          Vector3(0.1 - 0.08, -0.2 + 0.03, 0.3 + 0.02)};
    CHECK(difference(wrench, expected) < 1e-12);
    const Wrench there = compute_linearised_wrench(model, model.at_position_W, model.at_velocity_W);
    CHECK(there.force == model.force_W);
    CHECK(there.torque == model.torque_W);
}

TEST_CASE("linearised wrench: no answer yet, no force; after the blend the law holds") {
    LinearisedWrenchStage stage(kTimeout_s);
    CHECK(difference(stage.step(LinearisedWrench{}, Vector3::Zero(), Vector3::Zero(), 0.0),
                     Wrench{}) == 0.0);
    const LinearisedWrench model = make_model(0.001);
    const Vector3 x(0.12, 0.01, 0.0);
    const Vector3 v(0.0, 0.2, 0.4);
    const Wrench full = compute_linearised_wrench(model, x, v);
    for (int k = 1; k < 60; ++k) {
        const double share = std::min((k - 1) * kDt_s / kBlend_s, 1.0);
        REQUIRE(difference(stage.step(model, x, v, k * kDt_s), scaled(share, full)) < 1e-12);
    }
    CHECK(stage.notes() == LinearisationNote::none);
}

TEST_CASE("linearised wrench: a linear spring torque is exact between answers, on a moving tool") {
    // T = S (x - c), answered 60 times a second; the tool goes round at 3 rad/s.
    Matrix3 slope_Nm_per_m;
    slope_Nm_per_m << -3.0, 1.0, 0.0, 0.5, -2.0, 0.0, 0.0, 4.0, -1.0;
    const Vector3 centre(0.02, 0.3, 0.0);
    const auto law = [&](const Vector3& x) { return Vector3(slope_Nm_per_m * (x - centre)); };
    LinearisedWrenchStage stage(kTimeout_s);
    LinearisedWrench model;
    double largest_Nm = 0.0;
    for (int k = 0; k < 2000; ++k) {
        const double now_s = k * kDt_s;
        const Vector3 x(0.05 * std::cos(3.0 * now_s), 0.3 + 0.05 * std::sin(3.0 * now_s), 0.01);
        if (k % 17 == 0) {
            model.stamp_s = now_s;
            model.at_position_W = x;
            model.torque_W = law(x);
            model.torque_stiffness_Nm_per_m = slope_Nm_per_m;
        }
        const Wrench wrench = stage.step(model, x, Vector3::Zero(), now_s);
        if (now_s > 2.0 * kBlend_s) {
            REQUIRE((wrench.torque - law(x)).norm() < 1e-12);
            REQUIRE(wrench.force.norm() == 0.0);
            largest_Nm = std::max(largest_Nm, wrench.torque.norm());
        }
    }
    CHECK(largest_Nm > 0.1);
}

TEST_CASE("linearised wrench: velocity moves the force, never the torque") {
    const LinearisedWrench model = make_model(0.0);
    const Wrench slow = compute_linearised_wrench(model, Vector3::Zero(), Vector3::Zero());
    const Wrench fast = compute_linearised_wrench(model, Vector3::Zero(), Vector3(1.0, 2.0, 3.0));
    CHECK(fast.torque == slow.torque);
    CHECK((fast.force - slow.force - model.damping_Ns_per_m * Vector3(1.0, 2.0, 3.0)).norm() <
          1e-12);
}

TEST_CASE("linearised wrench: nothing jumps when a new answer comes") {
    LinearisedWrenchStage stage(kTimeout_s);
    const Vector3 x(0.1, 0.0, 0.0);
    LinearisedWrench model = make_model(0.0);
    Wrench before = stage.step(model, x, Vector3::Zero(), 0.0);
    double largest_N = 0.0;
    double largest_Nm = 0.0;
    for (int k = 1; k < 200; ++k) {
        if (k % 16 == 0) {
            model.stamp_s = k * kDt_s;
            model.force_W *= -1.0;
            model.torque_W *= -1.0;
        }
        const Wrench now = stage.step(model, x, Vector3::Zero(), k * kDt_s);
        largest_N = std::max(largest_N, (now.force - before.force).norm());
        largest_Nm = std::max(largest_Nm, (now.torque - before.torque).norm());
        before = now;
    }
    // The answers jump by 7.5 N and 0.75 Nm each time; a sixtieth of a second spreads that over 17 rounds, twice that while
    // blends overlap.
    CHECK(largest_N < 2.0 * 7.5 * kDt_s / kBlend_s);
    CHECK(largest_N > 0.1);
    CHECK(largest_Nm < 2.0 * 0.75 * kDt_s / kBlend_s);
    CHECK(largest_Nm > 0.01);
}

TEST_CASE("linearised wrench: an answer past its time fades in a straight line to zero") {
    LinearisedWrenchStage stage(kTimeout_s);
    const LinearisedWrench model = make_model(0.0);
    const Wrench full{model.force_W, model.torque_W};
    for (int k = 0; k < 300; ++k) {
        const double now_s = k * kDt_s;
        const Wrench wrench = stage.step(model, model.at_position_W, model.at_velocity_W, now_s);
        if (now_s > 2.0 * kBlend_s) {
            const double fresh = std::clamp(2.0 - now_s / kTimeout_s, 0.0, 1.0);
            REQUIRE(difference(wrench, scaled(fresh, full)) < 1e-9);
        }
    }
}

TEST_CASE("linearised wrench: what is not finite is refused, and the former answer goes on") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<void (*)(LinearisedWrench&, double)> spoil = {
        [](LinearisedWrench& m, double bad) { m.force_W(0) = bad; },
        [](LinearisedWrench& m, double bad) { m.torque_W(2) = bad; },
        [](LinearisedWrench& m, double bad) { m.at_position_W(1) = bad; },
        [](LinearisedWrench& m, double bad) { m.at_velocity_W(2) = bad; },
        [](LinearisedWrench& m, double bad) { m.stiffness_N_per_m(0, 1) = bad; },
        [](LinearisedWrench& m, double bad) { m.damping_Ns_per_m(2, 2) = bad; },
        [](LinearisedWrench& m, double bad) { m.torque_stiffness_Nm_per_m(1, 0) = bad; }};
    for (const auto& entry : spoil) {
        for (const double value : {nan, std::numeric_limits<double>::infinity(), -1e300, 1e6}) {
            LinearisedWrenchStage stage(kTimeout_s);
            const LinearisedWrench good = make_model(0.0);
            for (int k = 0; k < 30; ++k) {
                (void)stage.step(good, good.at_position_W, good.at_velocity_W, k * kDt_s);
            }
            LinearisedWrench bad = make_model(0.03);
            entry(bad, value);
            const Wrench wrench = stage.step(bad, good.at_position_W, good.at_velocity_W, 0.03);
            CHECK(difference(wrench, {good.force_W, good.torque_W}) < 1e-12);
            CHECK(has(stage.notes(), LinearisationNote::refused_not_finite));
        }
    }
}

TEST_CASE("linearised wrench: a reset forgets the torque too") {
    LinearisedWrenchStage stage(kTimeout_s);
    const LinearisedWrench model = make_model(0.0);
    for (int k = 0; k < 30; ++k) {
        (void)stage.step(model, model.at_position_W, model.at_velocity_W, k * kDt_s);
    }
    stage.reset();
    CHECK(difference(stage.step(LinearisedWrench{}, Vector3::Zero(), Vector3::Zero(), 0.03),
                     Wrench{}) == 0.0);
    CHECK(difference(stage.step(model, model.at_position_W, model.at_velocity_W, 0.03), Wrench{}) <
          1e-12);
}

TEST_CASE("linearised wrench: gains are bounded and the reasons are told") {
    LinearisedWrench stiff = make_model(0.0);
    stiff.stiffness_N_per_m *= 100.0;
    const Matrix3 direction = stiff.stiffness_N_per_m.normalized();
    CHECK(bound_gains(stiff) == LinearisationNote::stiffness_clamped);
    CHECK(stiff.stiffness_N_per_m.norm() == Approx(kMaxLinearStiffness_N_per_m));
    CHECK((stiff.stiffness_N_per_m.normalized() - direction).norm() < 1e-12);
    LinearisedWrench thick = make_model(0.0);
    thick.damping_Ns_per_m *= 100.0;
    CHECK(bound_gains(thick) == LinearisationNote::damping_clamped);
    CHECK(thick.damping_Ns_per_m.norm() == Approx(kMaxLinearDamping_Ns_per_m));
    LinearisedWrench twisting = make_model(0.0);
    twisting.torque_stiffness_Nm_per_m *= 100.0;
    const Matrix3 twist = twisting.torque_stiffness_Nm_per_m.normalized();
    CHECK(bound_gains(twisting) == LinearisationNote::torque_stiffness_clamped);
    CHECK(twisting.torque_stiffness_Nm_per_m.norm() == Approx(kMaxTorqueStiffness_Nm_per_m));
    CHECK((twisting.torque_stiffness_Nm_per_m.normalized() - twist).norm() < 1e-12);
    LinearisedWrench fine = make_model(0.0);
    const Matrix3 damping = fine.damping_Ns_per_m;
    CHECK(bound_gains(fine) == LinearisationNote::none);
    CHECK(fine.damping_Ns_per_m == damping);
}

TEST_CASE("linearised wrench: damping that would push is taken out, the rest of it stays") {
    LinearisedWrench model = make_model(0.0);
    // Pushes along (1, 1, 0), brakes along (1, -1, 0), and has a part that does no work.
    model.damping_Ns_per_m << 1.0, 3.0, 2.0, 3.0, 1.0, 0.0, -2.0, 0.0, -1.0;
    CHECK(has(bound_gains(model), LinearisationNote::active_damping_removed));
    const Vector3 along(1.0, 1.0, 0.0);
    const Vector3 across(1.0, -1.0, 0.0);
    CHECK(along.dot(model.damping_Ns_per_m * along) == Approx(0.0).margin(1e-9));
    CHECK(across.dot(model.damping_Ns_per_m * across) == Approx(-4.0));
    CHECK(model.damping_Ns_per_m(0, 2) - model.damping_Ns_per_m(2, 0) == Approx(4.0));
    for (int i = 0; i < 1000; ++i) {
        const Vector3 v = Vector3::Random();
        REQUIRE(v.dot(model.damping_Ns_per_m * v) <= 1e-9);
    }
}
