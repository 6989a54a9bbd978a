#include "haptics/flight/kite_load.h"

#include "haptics/dynamics/integrator.h"
#include "haptics/dynamics/loads.h"
#include "haptics/dynamics/rigid_body.h"
#include "haptics/math/rotation.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace fulcrum;

namespace {

RigidState make_state(Random& random) {
    RigidState state;
    state.pose_W = {random.in_cube(), random.turn(3.0)};
    state.velocity_W = {3.0 * random.in_cube(), 2.0 * random.in_cube()};
    return state;
}

// The state after a small change: dx, dtheta, dv, dw.
RigidState move(const RigidState& state, const Matrix<double, 12, 1>& change) {
    RigidState moved = state;
    moved.pose_W.position += change.block<3, 1>(0, 0);
    moved.pose_W.orientation = compute_exp(change.block<3, 1>(3, 0)) * moved.pose_W.orientation;
    moved.velocity_W.linear += change.block<3, 1>(6, 0);
    moved.velocity_W.angular += change.block<3, 1>(9, 0);
    return moved;
}

Vector6 compute_wrench(const Load& load, const RigidState& state) {
    Wrench wrench;
    load.add_wrench(state, 0.0, wrench);
    Vector6 all;
    all << wrench.force, wrench.torque;
    return all;
}

// The largest difference between a load's derivatives and central differences of it, over the largest of them.
double compute_slope_error(const Load& load, const RigidState& state) {
    constexpr double kStep = 1.0e-6;
    Wrench wrench;
    WrenchJacobian jacobian;
    load.add_linearised_wrench(state, 0.0, wrench, jacobian);
    double worst = (compute_wrench(load, state).head<3>() - wrench.force).norm();
    double largest = 1.0e-9;
    for (int i = 0; i < 12; ++i) {
        Matrix<double, 12, 1> change = Matrix<double, 12, 1>::Zero();
        change[i] = kStep;
        const Vector6 slope = (compute_wrench(load, move(state, change)) -
                               compute_wrench(load, move(state, -change))) /
                              (2.0 * kStep);
        const Vector6 told = i < 6 ? jacobian.pose.col(i) : jacobian.velocity.col(i - 6);
        worst = std::max(worst, (slope - told).cwiseAbs().maxCoeff());
        largest = std::max(largest, slope.cwiseAbs().maxCoeff());
    }
    return worst / largest;
}

}  // namespace

TEST_CASE("kite load: its derivatives are those of its wrench, for every shape and law") {
    Random random(11);
    for (const KiteShape shape : kKiteShapes) {
        for (const PlateLaw law : kPlateLaws) {
            KiteSettings settings;
            settings.shape = shape;
            settings.law = law;
            settings.strips = 2;
            const Kite kite = make_kite(settings);
            for (int i = 0; i < 10; ++i) {
                const KiteAirLoad air(kite, 8.0 * random.direction(), 1.2);
                CHECK(compute_slope_error(air, make_state(random)) < 1.0e-4);
            }
        }
    }
}

TEST_CASE("kite load: the line's pull likewise, at the knot") {
    Random random(12);
    Matrix3 slope = -20.0 * Matrix3::Identity();
    slope(0, 1) = slope(1, 0) = 3.0;
    const LinePullLoad pull({0.1, 0.2, 0.3}, {{1.0, -4.0, 2.0}, slope, {0.3, 0.1, -0.2}});
    LinePull slackening{{1.0, -4.0, 2.0}, slope, {0.3, 0.1, -0.2}};
    slackening.along_W = Vector3(-1.0, 4.0, -2.0).normalized();
    slackening.load_W = {0.0, -0.1, 0.02};
    slackening.load_slope_W = -0.5 * Matrix3::Identity();
    for (int i = 0; i < 10; ++i) {
        CHECK(compute_slope_error(pull, make_state(random)) < 1.0e-6);
        CHECK(compute_slope_error(LinePullLoad({0.1, 0.2, 0.3}, slackening), make_state(random)) <
              1.0e-6);
    }
    // At its place it pulls as told, with the knot's arm.
    RigidState state;
    state.pose_W.position = Vector3(0.3, 0.1, -0.2) - Vector3(0.1, 0.2, 0.3);
    const Vector6 wrench = compute_wrench(pull, state);
    CHECK((wrench.head<3>() - Vector3(1.0, -4.0, 2.0)).norm() < 1.0e-12);
    CHECK((wrench.tail<3>() - Vector3(0.1, 0.2, 0.3).cross(Vector3(1.0, -4.0, 2.0))).norm() <
          1.0e-12);
}

TEST_CASE("kite load: what moves with the wind feels nothing, and only the difference counts") {
    Random random(13);
    const Kite kite = make_kite(KiteSettings{});
    RigidState state = make_state(random);
    state.velocity_W.angular.setZero();
    CHECK(compute_wrench(KiteAirLoad(kite, state.velocity_W.linear, 1.2), state).norm() == 0.0);
    const Vector3 wind_W(4.0, 1.0, -2.0);
    RigidState still = state;
    still.velocity_W.linear.setZero();
    const Vector6 moving = compute_wrench(KiteAirLoad(kite, wind_W, 1.2), state);
    const Vector6 standing =
        compute_wrench(KiteAirLoad(kite, wind_W - state.velocity_W.linear, 1.2), still);
    CHECK((moving - standing).norm() < 1.0e-12 * moving.norm());
}

TEST_CASE("kite load: the tail drags at the foot, along the wind") {
    KiteSettings settings;
    const Kite with = make_kite(settings);
    Kite without = with;
    without.tail_drag_m2 = 0.0;
    const Vector3 wind_W(6.0, 0.0, 0.0);
    RigidState state;
    state.pose_W.orientation = compute_exp(Vector3(0.3, 1.2, -0.4));
    const Vector6 tail = compute_wrench(KiteAirLoad(with, wind_W, 1.2), state) -
                         compute_wrench(KiteAirLoad(without, wind_W, 1.2), state);
    const Vector3 drag_W(0.5 * 1.2 * with.tail_drag_m2 * 36.0, 0.0, 0.0);
    CHECK((tail.head<3>() - drag_W).norm() < 1.0e-12);
    const Vector3 foot_W = state.pose_W.orientation * with.foot_B;
    CHECK((tail.tail<3>() - foot_W.cross(drag_W)).norm() < 1.0e-12);
}

TEST_CASE("kite load: a plate that falls flat reaches its terminal speed") {
    Kite sheet;
    sheet.inertia = {0.05, Vector3(1.0e-3, 1.0e-3, 2.0e-3)};
    FlatPlate plate;
    plate.normal = Vector3::UnitY();
    plate.area_m2 = 0.25;
    plate.chord_m = 0.5;
    sheet.plates.push_back(plate);
    const KiteAirLoad air(sheet, Vector3::Zero(), kAirDensity_kg_per_m3);
    const ConstantLoad weight({.force = Vector3(0.0, -0.05 * 9.81, 0.0)});
    const Loads<KiteAirLoad, ConstantLoad> loads(air, weight);
    RigidState state;
    for (int i = 0; i < 5000; ++i) {
        REQUIRE(step_rigid_body({}, sheet.inertia, loads, 0.0, 0.002, state).status ==
                StepStatus::done);
    }
    const double expected_m_per_s =
        std::sqrt(2.0 * 0.05 * 9.81 / (kAirDensity_kg_per_m3 * 0.25 * compute_broadside_drag(1.0)));
    CHECK(-state.velocity_W.linear.y() == Approx(expected_m_per_s).epsilon(1.0e-6));
    CHECK(state.velocity_W.angular.norm() < 1.0e-9);
}
