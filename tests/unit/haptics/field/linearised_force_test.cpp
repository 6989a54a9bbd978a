#include "haptics/field/linearised_force.h"

#include <catch2/catch.hpp>

#include <limits>

using namespace fulcrum;

namespace {

constexpr double kDt_s = 0.001;
constexpr double kTimeout_s = 0.1;

LinearisedForce make_model(double stamp_s) {
    LinearisedForce model;
    model.stamp_s = stamp_s;
    model.force_W = Vector3(1.0, 2.0, 3.0);
    model.at_position_W = Vector3(0.1, 0.0, 0.0);
    model.at_velocity_W = Vector3(0.0, 0.2, 0.0);
    model.stiffness_N_per_m << -100.0, 5.0, 0.0, 5.0, -50.0, 0.0, 0.0, 0.0, -10.0;
    model.damping_Ns_per_m << -2.0, 0.0, 0.0, 0.0, -1.0, 0.5, 0.0, -0.5, -3.0;
    return model;
}

}  // namespace

TEST_CASE("linearised force: F0 + K (x - x0) + B (v - v0)") {
    const LinearisedForce model = make_model(0.0);
    const Vector3 force =
        compute_linearised_force(model, Vector3(0.12, 0.01, 0.0), Vector3(0.0, 0.2, 0.4));
    CHECK((force - Vector3(1.0 - 2.0 + 0.05, 2.0 + 0.1 - 0.5 + 0.2, 3.0 - 1.2)).norm() < 1e-12);
    CHECK(compute_linearised_force(model, model.at_position_W, model.at_velocity_W) ==
          model.force_W);
}

TEST_CASE("linearised force: no answer yet, no force; after the blend the law holds") {
    LinearisedForceStage stage(kTimeout_s);
    CHECK(stage.step(LinearisedForce{}, Vector3::Zero(), Vector3::Zero(), 0.0).norm() == 0.0);
    const LinearisedForce model = make_model(0.001);
    const Vector3 x(0.12, 0.01, 0.0);
    const Vector3 v(0.0, 0.2, 0.4);
    const Vector3 full = compute_linearised_force(model, x, v);
    for (int k = 1; k < 60; ++k) {
        const double share = std::min((k - 1) * kDt_s / kBlend_s, 1.0);
        REQUIRE((stage.step(model, x, v, k * kDt_s) - share * full).norm() < 1e-12);
    }
    CHECK(stage.notes() == LinearisationNote::none);
}

TEST_CASE("linearised force: the force does not jump when a new answer comes") {
    LinearisedForceStage stage(kTimeout_s);
    const Vector3 x(0.1, 0.0, 0.0);
    LinearisedForce model = make_model(0.0);
    Vector3 before = stage.step(model, x, Vector3::Zero(), 0.0);
    double largest = 0.0;
    for (int k = 1; k < 200; ++k) {
        if (k % 16 == 0) {
            model.stamp_s = k * kDt_s;
            model.force_W *= -1.0;
        }
        const Vector3 now = stage.step(model, x, Vector3::Zero(), k * kDt_s);
        largest = std::max(largest, (now - before).norm());
        before = now;
    }
    // The answers jump by 7.5 N each time; a sixtieth of a second spreads that over 17 rounds, twice that while blends overlap.
    CHECK(largest < 2.0 * 7.5 * kDt_s / kBlend_s);
    CHECK(largest > 0.1);
}

TEST_CASE("linearised force: an answer past its time fades in a straight line to zero") {
    LinearisedForceStage stage(kTimeout_s);
    const LinearisedForce model = make_model(0.0);
    for (int k = 0; k < 300; ++k) {
        const double now_s = k * kDt_s;
        const Vector3 force = stage.step(model, model.at_position_W, model.at_velocity_W, now_s);
        if (now_s > 2.0 * kBlend_s) {
            const double fresh = std::clamp(2.0 - now_s / kTimeout_s, 0.0, 1.0);
            REQUIRE((force - fresh * model.force_W).norm() < 1e-9);
        }
    }
}

TEST_CASE("linearised force: what is not finite is refused, and the former answer goes on") {
    for (int entry = 0; entry < 5; ++entry) {
        LinearisedForceStage stage(kTimeout_s);
        const LinearisedForce good = make_model(0.0);
        for (int k = 0; k < 30; ++k) {
            (void)stage.step(good, good.at_position_W, good.at_velocity_W, k * kDt_s);
        }
        LinearisedForce bad = make_model(0.03);
        const double nan = std::numeric_limits<double>::quiet_NaN();
        (entry == 0   ? bad.force_W(0)
         : entry == 1 ? bad.at_position_W(1)
         : entry == 2 ? bad.at_velocity_W(2)
         : entry == 3 ? bad.stiffness_N_per_m(0, 1)
                      : bad.damping_Ns_per_m(2, 2)) = entry == 4 ? 1e300 : nan;
        const Vector3 force = stage.step(bad, good.at_position_W, good.at_velocity_W, 0.03);
        CHECK((force - good.force_W).norm() < 1e-12);
        CHECK(has(stage.notes(), LinearisationNote::refused_not_finite));
    }
}

TEST_CASE("linearised force: gains are bounded and the reasons are told") {
    LinearisedForce stiff = make_model(0.0);
    stiff.stiffness_N_per_m *= 100.0;
    const Matrix3 direction = stiff.stiffness_N_per_m.normalized();
    CHECK(bound_gains(stiff) == LinearisationNote::stiffness_clamped);
    CHECK(stiff.stiffness_N_per_m.norm() == Approx(kMaxLinearStiffness_N_per_m));
    CHECK((stiff.stiffness_N_per_m.normalized() - direction).norm() < 1e-12);
    LinearisedForce thick = make_model(0.0);
    thick.damping_Ns_per_m *= 100.0;
    CHECK(bound_gains(thick) == LinearisationNote::damping_clamped);
    CHECK(thick.damping_Ns_per_m.norm() == Approx(kMaxLinearDamping_Ns_per_m));
    LinearisedForce fine = make_model(0.0);
    const Matrix3 damping = fine.damping_Ns_per_m;
    CHECK(bound_gains(fine) == LinearisationNote::none);
    CHECK(fine.damping_Ns_per_m == damping);
}

TEST_CASE("linearised force: damping that would push is taken out, the rest of it stays") {
    LinearisedForce model = make_model(0.0);
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
