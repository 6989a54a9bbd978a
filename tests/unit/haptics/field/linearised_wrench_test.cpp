#include "haptics/field/linearised_wrench.h"

#include "tests/support/bad_numbers.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace fulcrum;

namespace {

constexpr double kDt_s = 0.001;
constexpr double kTimeout_s = 0.1;  // the default

LinearisedWrench make_model(double stamp_s) {
    LinearisedWrench model;
    model.stamp_s = stamp_s;
    model.force_W = Vector3(1.0, 2.0, 3.0);
    model.torque_W = Vector3(0.05, -0.1, 0.15);
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

// A hand that rests at the origin.
Wrench step_still(LinearisedWrenchStage& stage, const LinearisedWrench& model, double now_s) {
    return stage.step(model, Vector3::Zero(), Vector3::Zero(), now_s);
}

}  // namespace

TEST_CASE("linearised wrench: F0 + K (x - x0) + B (v - v0), T0 + S (x - x0)") {
    const LinearisedWrench model = make_model(0.0);
    const Wrench wrench =
        compute_linearised_wrench(model, Vector3(0.12, 0.01, 0.0), Vector3(0.0, 0.2, 0.4));
    const Wrench expected{Vector3(1.0 - 2.0 + 0.05, 2.0 + 0.1 - 0.5 + 0.2, 3.0 - 1.2),
                          Vector3(0.05 - 0.08, -0.1 + 0.03, 0.15 + 0.02)};
    CHECK(difference(wrench, expected) < 1e-12);
    const Wrench there = compute_linearised_wrench(model, model.at_position_W, model.at_velocity_W);
    CHECK(there.force == model.force_W);
    CHECK(there.torque == model.torque_W);
}

TEST_CASE("linearised wrench: no answer yet, no force; after the blend the law holds") {
    LinearisedWrenchStage stage{LinearisedWrenchSettings{}};
    CHECK(difference(step_still(stage, LinearisedWrench{}, 0.0), Wrench{}) == 0.0);
    const LinearisedWrench model = make_model(0.001);
    const Vector3 x(0.12, 0.01, 0.0);
    const Vector3 v(0.0, 0.2, 0.4);
    const Wrench full = compute_linearised_wrench(model, x, v);
    const double blend_s = std::max(full.force.norm() / 50.0, full.torque.norm() / 3.0);
    for (int k = 1; k < 90; ++k) {
        const double share = std::min((k - 1) * kDt_s / blend_s, 1.0);
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
    LinearisedWrenchStage stage{LinearisedWrenchSettings{}};
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
        if (now_s > 0.1) {
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
    LinearisedWrenchStage stage{LinearisedWrenchSettings{}};
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
    // The answers jump by 7.5 N and 0.37 Nm each time; 50 N/s or 3 Nm/s is the faster that each may go, and the torque
    // needs longer here.
    CHECK(largest_N <= 50.0 * kDt_s + 1e-12);
    CHECK(largest_Nm <= 3.0 * kDt_s + 1e-12);
    CHECK(largest_Nm > 0.8 * 3.0 * kDt_s);
}

TEST_CASE("linearised wrench: an answer past its time fades in a straight line to zero") {
    LinearisedWrenchStage stage{LinearisedWrenchSettings{}};
    const LinearisedWrench model = make_model(0.0);
    const Wrench full{model.force_W, model.torque_W};
    for (int k = 0; k < 300; ++k) {
        const double now_s = k * kDt_s;
        const Wrench wrench = stage.step(model, model.at_position_W, model.at_velocity_W, now_s);
        if (now_s > 0.08) {
            const double fresh = std::clamp(2.0 - now_s / kTimeout_s, 0.0, 1.0);
            REQUIRE(difference(wrench, scaled(fresh, full)) < 1e-9);
        }
    }
}

TEST_CASE("linearised wrench: what is not finite is refused, and the former answer goes on") {
    const std::vector<void (*)(LinearisedWrench&, double)> spoil = {
        [](LinearisedWrench& m, double bad) { m.force_W(0) = bad; },
        [](LinearisedWrench& m, double bad) { m.torque_W(2) = bad; },
        [](LinearisedWrench& m, double bad) { m.at_position_W(1) = bad; },
        [](LinearisedWrench& m, double bad) { m.at_velocity_W(2) = bad; },
        [](LinearisedWrench& m, double bad) { m.stiffness_N_per_m(0, 1) = bad; },
        [](LinearisedWrench& m, double bad) { m.damping_Ns_per_m(2, 2) = bad; },
        [](LinearisedWrench& m, double bad) { m.torque_stiffness_Nm_per_m(1, 0) = bad; }};
    for (const auto& entry : spoil) {
        for (const double value : {kNan, kInfinity, -1e300, 1e6}) {
            LinearisedWrenchStage stage{LinearisedWrenchSettings{}};
            const LinearisedWrench good = make_model(0.0);
            for (int k = 0; k < 95; ++k) {
                (void)stage.step(good, good.at_position_W, good.at_velocity_W, k * kDt_s);
            }
            LinearisedWrench bad = make_model(0.095);
            entry(bad, value);
            const Wrench wrench = stage.step(bad, good.at_position_W, good.at_velocity_W, 0.095);
            CHECK(difference(wrench, {good.force_W, good.torque_W}) < 1e-12);
            CHECK(has(stage.notes(), LinearisationNote::refused_not_finite));
        }
    }
}

TEST_CASE("linearised wrench: gains are bounded and the reasons are told") {
    LinearisedWrench stiff = make_model(0.0);
    stiff.stiffness_N_per_m *= 100.0;
    const Matrix3 direction = stiff.stiffness_N_per_m.normalized();
    CHECK(bound_gains(stiff, {}) == LinearisationNote::stiffness_clamped);
    CHECK(stiff.stiffness_N_per_m.norm() == Approx(2000.0));
    CHECK((stiff.stiffness_N_per_m.normalized() - direction).norm() < 1e-12);
    LinearisedWrench thick = make_model(0.0);
    thick.damping_Ns_per_m *= 100.0;
    CHECK(bound_gains(thick, {}) == LinearisationNote::damping_clamped);
    CHECK(thick.damping_Ns_per_m.norm() == Approx(50.0));
    LinearisedWrench twisting = make_model(0.0);
    twisting.torque_stiffness_Nm_per_m *= 100.0;
    const Matrix3 twist = twisting.torque_stiffness_Nm_per_m.normalized();
    CHECK(bound_gains(twisting, {}) == LinearisationNote::torque_stiffness_clamped);
    CHECK(twisting.torque_stiffness_Nm_per_m.norm() == Approx(200.0));
    CHECK((twisting.torque_stiffness_Nm_per_m.normalized() - twist).norm() < 1e-12);
    LinearisedWrench fine = make_model(0.0);
    const Matrix3 damping = fine.damping_Ns_per_m;
    CHECK(bound_gains(fine, {}) == LinearisationNote::none);
    CHECK(fine.damping_Ns_per_m == damping);
}

TEST_CASE("linearised wrench: damping that would push is taken out, the rest of it stays") {
    LinearisedWrench model = make_model(0.0);
    // Pushes along (1, 1, 0), brakes along (1, -1, 0), and has a part that does no work.
    model.damping_Ns_per_m << 1.0, 3.0, 2.0, 3.0, 1.0, 0.0, -2.0, 0.0, -1.0;
    CHECK(has(bound_gains(model, {}), LinearisationNote::active_damping_removed));
    const Vector3 along(1.0, 1.0, 0.0);
    const Vector3 across(1.0, -1.0, 0.0);
    CHECK(along.dot(model.damping_Ns_per_m * along) == Approx(0.0).margin(1e-9));
    CHECK(across.dot(model.damping_Ns_per_m * across) == Approx(-4.0));
    CHECK(model.damping_Ns_per_m(0, 2) - model.damping_Ns_per_m(2, 0) == Approx(4.0));
    Random random(7);
    for (int i = 0; i < 1000; ++i) {
        const Vector3 v = random.in_cube();
        REQUIRE(v.dot(model.damping_Ns_per_m * v) <= 1e-9);
    }
}

TEST_CASE("linearised wrench: a small change takes the time of an answer, a large one its slew") {
    struct Case {
        Wrench answer;
        double blend_s;
        LinearisedWrenchSettings settings{};
    };
    const Wrench small{Vector3(0.1, 0, 0), Vector3(0, 0.01, 0)};
    for (const Case& entry : {Case{small, 1.0 / 60.0}, Case{small, 0.04, {.blend_s = 0.04}},
                              Case{{Vector3(0, 3, -4), Vector3(0, 0.03, 0)}, 0.1},
                              Case{{Vector3(0, 0.5, 0), Vector3(0, 0, 0.3)}, 0.1}}) {
        LinearisedWrenchStage stage{entry.settings};
        LinearisedWrench model;
        model.force_W = entry.answer.force;
        model.torque_W = entry.answer.torque;
        model.stamp_s = 0.0;
        for (int k = 0; k <= 100; ++k) {
            const Wrench wrench = step_still(stage, model, k * kDt_s);
            const double share = std::min(k * kDt_s / entry.blend_s, 1.0);
            REQUIRE(difference(wrench, scaled(share, entry.answer)) < 1e-9);
        }
    }
}

TEST_CASE(
    "linearised wrench: an answer that changes its mind each time does not shake a still hand") {
    LinearisedWrenchStage stage{LinearisedWrenchSettings{}};
    LinearisedWrench model;
    model.force_W = Vector3(10.0, 0, 0);
    model.torque_W = Vector3(0, 1.0, 0);
    model.stiffness_N_per_m(0, 0) = -2000.0;
    Wrench before{};
    double lowest_N = 10.0;
    double highest_N = -10.0;
    for (int k = 0; k < 3000; ++k) {
        const double now_s = k / 960.0;  // 16 rounds an answer
        if (k % 16 == 0) {
            model.stamp_s = now_s;
            model.force_W *= -1.0;
            model.torque_W *= -1.0;
            model.stiffness_N_per_m *= -1.0;
        }
        const Wrench now = step_still(stage, model, now_s);
        REQUIRE((now.force - before.force).norm() <= 50.0 / 960.0 + 1e-9);
        REQUIRE((now.torque - before.torque).norm() <= 3.0 / 960.0 + 1e-9);
        before = now;
        if (k > 1500) {
            lowest_N = std::min(lowest_N, now.force.x());
            highest_N = std::max(highest_N, now.force.x());
        }
    }
    // A triangle whose sides last one answer: 50 N/s / 60 Hz at most.
    CHECK(highest_N - lowest_N <= 50.0 / 60.0 + 1e-9);
    CHECK(highest_N - lowest_N > 0.3);
}

TEST_CASE("linearised wrench: what was asked for beyond the limits has not to be unwound") {
    LinearisedWrenchSettings settings;
    settings.max_force_N = 5.0;
    settings.max_torque_Nm = 0.3;
    LinearisedWrenchStage stage(settings);
    LinearisedWrench model;
    for (int k = 0; k < 2200; ++k) {
        const double now_s = k * kDt_s;
        model.stamp_s = k % 16 == 0 ? now_s : model.stamp_s;
        model.force_W = k < 2000 ? Vector3(3000.0, 4000.0, 0) : Vector3(Vector3::Zero());
        model.torque_W = k < 2000 ? Vector3(0, 0, 70.0) : Vector3(Vector3::Zero());
        const Wrench wrench = step_still(stage, model, now_s);
        REQUIRE(wrench.force.norm() <= 5.0 + 1e-9);
        REQUIRE(wrench.torque.norm() <= 0.3 + 1e-9);
        if (k == 1999) {
            CHECK((wrench.force - Vector3(3.0, 4.0, 0.0)).norm() < 1e-9);
            CHECK((wrench.torque - Vector3(0.0, 0.0, 0.3)).norm() < 1e-9);
        }
        if (k >= 2000 + 140) {
            REQUIRE(difference(wrench, {}) < 0.1);
        }
    }
}

TEST_CASE("linearised wrench: an answer from the future waits for its time and keeps none out") {
    for (const double stamp_s : {60.0, 0.0011, kInfinity, kNan, -kInfinity}) {
        LinearisedWrenchStage stage{LinearisedWrenchSettings{}};
        LinearisedWrench model;
        model.force_W = Vector3(0.5, 0, 0);
        model.stamp_s = stamp_s;
        CHECK(difference(step_still(stage, model, 0.001), {}) == 0.0);
        CHECK(difference(step_still(stage, LinearisedWrench{}, 0.9), {}) == 0.0);
        model.stamp_s = 1.0;
        (void)step_still(stage, model, 1.0);
        CHECK((step_still(stage, model, 1.05).force - Vector3(0.5, 0, 0)).norm() < 1e-9);
    }
}

TEST_CASE("linearised wrench: an answer that is old when it comes takes no force away at once") {
    LinearisedWrenchStage stage{LinearisedWrenchSettings{}};
    LinearisedWrench model;
    model.force_W = Vector3(2.0, 0, 0);
    double before_N = 0.0;
    for (int k = 0; k < 400; ++k) {
        const double now_s = k * kDt_s;
        if (k % 16 == 0) {
            // From 0.2 s on each answer comes 149 ms late.
            model.stamp_s = std::max(now_s - (k < 200 ? 0.0 : 0.149), model.stamp_s);
        }
        const double now_N = step_still(stage, model, now_s).force.x();
        REQUIRE(std::abs(now_N - before_N) <= (50.0 + 2.0 / 0.1) * kDt_s);
        before_N = now_N;
    }
}

TEST_CASE("linearised wrench: gains keep to the settings; damping that pushes a little goes too") {
    LinearisedWrenchSettings settings;
    settings.max_stiffness_N_per_m = 20.0;
    settings.max_damping_Ns_per_m = 0.5;
    settings.max_torque_stiffness_Nm_per_m = 2.0;
    LinearisedWrench model = make_model(0.0);
    const LinearisationNote notes = bound_gains(model, settings);
    CHECK(has(notes, LinearisationNote::stiffness_clamped));
    CHECK(has(notes, LinearisationNote::damping_clamped));
    CHECK(has(notes, LinearisationNote::torque_stiffness_clamped));
    CHECK(model.stiffness_N_per_m.norm() == Approx(20.0));
    CHECK(model.damping_Ns_per_m.norm() == Approx(0.5));
    CHECK(model.torque_stiffness_Nm_per_m.norm() == Approx(2.0));
    LinearisedWrench weak;
    weak.damping_Ns_per_m(0, 0) = 0.05;
    CHECK(bound_gains(weak, {}) == LinearisationNote::active_damping_removed);
    CHECK(weak.damping_Ns_per_m.norm() < 1e-12);
    // A thousand kilonewtons are absurd; just less is not.
    LinearisedWrench large;
    large.force_W.x() = 0.999e6;
    CHECK(bound_gains(large, {}) == LinearisationNote::none);
    large.force_W.x() = 1.0e6;
    CHECK(bound_gains(large, {}) == LinearisationNote::refused_not_finite);
}

TEST_CASE(
    "linearised wrench: an answer that is too steep comes slower, by the square of how much") {
    LinearisedWrenchSettings settings;
    settings.timeout_s = 1.0;
    const std::vector<void (*)(LinearisedWrench&)> steepen = {
        [](LinearisedWrench& m) { m.stiffness_N_per_m(0, 1) = 2.0 * 2000.0; },
        [](LinearisedWrench& m) { m.damping_Ns_per_m(2, 2) = -2.0 * 50.0; },
        [](LinearisedWrench& m) { m.torque_stiffness_Nm_per_m(1, 0) = 2.0 * 200.0; }};
    for (const auto& entry : steepen) {
        LinearisedWrenchStage stage(settings);
        LinearisedWrench model;
        model.stamp_s = 0.0;
        model.force_W = Vector3(3.0, 0, 4.0);
        entry(model);
        for (int k = 0; k <= 500; ++k) {
            // 5 N at 50 N/s, four times as long.
            const double share = std::min(k * kDt_s / 0.4, 1.0);
            REQUIRE(difference(step_still(stage, model, k * kDt_s),
                               {share * model.force_W, Vector3::Zero()}) < 1e-9);
        }
    }
    // Where the fields leave nothing, an answer that asks for a slope changes nothing, and no number is broken.
    settings.max_stiffness_N_per_m = 0.0;
    LinearisedWrenchStage stage(settings);
    LinearisedWrench model;
    model.stamp_s = 0.0;
    model.force_W.x() = 1.0;
    model.stiffness_N_per_m(0, 0) = -1.0;
    for (int k = 0; k < 100; ++k) {
        REQUIRE(difference(step_still(stage, model, k * kDt_s), {}) == 0.0);
    }
}
