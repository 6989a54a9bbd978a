// What a lesson's wrench tells the passivity stage.
#include "haptics/field/linearised_wrench.h"

#include <catch2/catch.hpp>

using namespace fulcrum;

namespace {

constexpr double kDt_s = 0.001;

}  // namespace

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
