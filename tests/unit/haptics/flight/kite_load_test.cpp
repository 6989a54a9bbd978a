// What air does to a plate (flat_plate.h), and to a kite made of them (kite_load.h).
#include "haptics/flight/kite_load.h"

#include "haptics/dynamics/integrator.h"
#include "haptics/dynamics/rigid_body.h"
#include "haptics/flight/flat_plate.h"
#include "haptics/math/length.h"
#include "haptics/math/rotation.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/differentiated_loads.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <string>

using namespace fulcrum;
using namespace fulcrum::test;

namespace {

RigidState make_state(Random& random) {
    RigidState state;
    state.pose_W = {random.in_cube(), random.turn(3.0)};
    state.velocity_W = {3.0 * random.in_cube(), 2.0 * random.in_cube()};
    return state;
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
                CHECK(find_jacobian_error(air, make_state(random)) < 1.0e-4);
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
        CHECK(find_jacobian_error(pull, make_state(random)) < 1.0e-6);
        CHECK(find_jacobian_error(LinePullLoad({0.1, 0.2, 0.3}, slackening), make_state(random)) <
              1.0e-6);
    }
    // At its place it pulls as told, with the knot's arm.
    RigidState state;
    state.pose_W.position = Vector3(0.3, 0.1, -0.2) - Vector3(0.1, 0.2, 0.3);
    const Vector6 wrench = find_wrench(pull, state);
    CHECK((wrench.head<3>() - Vector3(1.0, -4.0, 2.0)).norm() < 1.0e-12);
    CHECK((wrench.tail<3>() - Vector3(0.1, 0.2, 0.3).cross(Vector3(1.0, -4.0, 2.0))).norm() <
          1.0e-12);
}

TEST_CASE("kite load: with the wind nothing is felt; a flat plate has its terminal speed") {
    Random random(13);
    const Kite kite = make_kite(KiteSettings{});
    RigidState state = make_state(random);
    state.velocity_W.angular.setZero();
    CHECK(find_wrench(KiteAirLoad(kite, state.velocity_W.linear, 1.2), state).norm() == 0.0);
    const Vector3 wind_W(4.0, 1.0, -2.0);
    RigidState still = state;
    still.velocity_W.linear.setZero();
    const Vector6 moving = find_wrench(KiteAirLoad(kite, wind_W, 1.2), state);
    const Vector6 standing =
        find_wrench(KiteAirLoad(kite, wind_W - state.velocity_W.linear, 1.2), still);
    CHECK((moving - standing).norm() < 1.0e-12 * moving.norm());
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
    state = RigidState();
    for (int i = 0; i < 5000; ++i) {
        REQUIRE(step_rigid_body({}, sheet.inertia, loads, 0.0, 0.002, state).status ==
                StepStatus::done);
    }
    const double expected_m_per_s =
        std::sqrt(2.0 * 0.05 * 9.81 / (kAirDensity_kg_per_m3 * 0.25 * compute_broadside_drag(1.0)));
    CHECK(-state.velocity_W.linear.y() == Approx(expected_m_per_s).epsilon(1.0e-6));
    CHECK(state.velocity_W.angular.norm() < 1.0e-9);
}

TEST_CASE("kite load: the tail drags at the foot, along the wind") {
    KiteSettings settings;
    const Kite with = make_kite(settings);
    Kite without = with;
    without.tail_drag_m2 = 0.0;
    const Vector3 wind_W(6.0, 0.0, 0.0);
    RigidState state;
    state.pose_W.orientation = compute_exp(Vector3(0.3, 1.2, -0.4));
    const Vector6 tail = find_wrench(KiteAirLoad(with, wind_W, 1.2), state) -
                         find_wrench(KiteAirLoad(without, wind_W, 1.2), state);
    const Vector3 drag_W(0.5 * 1.2 * with.tail_drag_m2 * 36.0, 0.0, 0.0);
    CHECK((tail.head<3>() - drag_W).norm() < 1.0e-12);
    const Vector3 foot_W = state.pose_W.orientation * with.foot_B;
    CHECK((tail.tail<3>() - foot_W.cross(drag_W)).norm() < 1.0e-12);
}

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kAir = 1.2;
constexpr double kRounding = 1.0e-12;

// Half a metre long, chord along x, normal along z.
FlatPlate make_plate(double aspect_ratio = 1.0) {
    FlatPlate plate;
    plate.chord_m = 0.5;
    plate.area_m2 = 0.3;
    plate.aspect_ratio = aspect_ratio;
    return plate;
}

Vector3 stream(double angle_rad, double speed_m_per_s) {
    return speed_m_per_s * Vector3(std::cos(angle_rad), 0.0, std::sin(angle_rad));
}

// The force over the dynamic pressure and the area.
Vector3 coefficient(PlateLaw law, double aspect_ratio, double angle_rad) {
    const FlatPlate plate = make_plate(aspect_ratio);
    return compute_plate_force(law, plate, kAir, stream(angle_rad, 7.0)).force /
           (0.5 * kAir * plate.area_m2 * 49.0);
}

}  // namespace

TEST_CASE("flat plate: along, across and between in closed form, with Helmbold's slope") {
    for (const PlateLaw law : kPlateLaws) {
        const PlateForce felt = compute_plate_force(law, make_plate(), kAir, stream(0.0, 7.0));
        CHECK(felt.force.x() == Approx(0.5 * kAir * 0.3 * 49.0 * kPlateFriction));
        CHECK(std::abs(felt.force.z()) < kRounding);
        CHECK(felt.torque.norm() < kRounding);
    }
    // Viterna and Corrigan: 1.128 of a square plate; 2.01 of an endless one.
    CHECK(compute_broadside_drag(1.0) == Approx(1.128));
    CHECK(compute_broadside_drag(1.0e9) == Approx(2.01));
    for (const PlateLaw law : {PlateLaw::cross_flow, PlateLaw::separated}) {
        CHECK(coefficient(law, 1.0, 0.5 * kPi).z() == Approx(1.128));
        const PlateForce felt =
            compute_plate_force(law, make_plate(), kAir, stream(0.5 * kPi, 7.0));
        CHECK(felt.torque.norm() < 1.0e-9);
    }
    CHECK(compute_lift_slope(1.0e6) == Approx(2.0 * kPi).epsilon(1.0e-5));
    CHECK(compute_lift_slope(1.0e-3) == Approx(0.5 * kPi * 1.0e-3).epsilon(1.0e-3));
    constexpr double kSmall_rad = 1.0e-6;
    CHECK(coefficient(PlateLaw::cross_flow, 2.0, kSmall_rad).z() / kSmall_rad ==
          Approx(compute_lift_slope(2.0)).epsilon(1.0e-5));
    const double a = 0.4;
    const double K = 4.0 * kPi / (2.0 + std::sqrt(8.0));
    const double cross = K * std::sin(a) * std::cos(a) + 1.146 * std::sin(a) * std::sin(a);
    CHECK(coefficient(PlateLaw::cross_flow, 2.0, a).z() == Approx(cross));
    CHECK(coefficient(PlateLaw::separated, 2.0, a).z() == Approx(1.146 * std::sin(a)));
    // NASA's lift and drag, along and across the stream; friction, which it does not know, taken off.
    const double lift = 2.0 * kPi * a / (1.0 + a);
    const double drag = 1.28 * std::sin(a) + lift * lift / (0.7 * kPi * 2.0);
    const Vector3 c = coefficient(PlateLaw::thin_plate, 2.0, a) -
                      Vector3(kPlateFriction * std::cos(a) * std::cos(a), 0.0, 0.0);
    CHECK(c.x() * std::cos(a) + c.z() * std::sin(a) == Approx(drag));
    CHECK(c.z() * std::cos(a) - c.x() * std::sin(a) == Approx(lift));
    CHECK(compute_normal_coefficient(PlateLaw::cross_flow, 2.0, a) == Approx(cross));
}

TEST_CASE("flat plate: the centre of pressure goes from the quarter chord to the middle") {
    const auto upstream_share = [](PlateLaw law, double angle_rad) {
        const PlateForce felt =
            compute_plate_force(law, make_plate(), kAir, stream(angle_rad, 7.0));
        // A force up at -x turns about +y.
        return felt.torque.y() / felt.force.z() / 0.5;
    };
    CHECK(upstream_share(PlateLaw::cross_flow, 1.0e-6) == Approx(0.25).epsilon(1.0e-5));
    CHECK(upstream_share(PlateLaw::thin_plate, 0.3) == Approx(0.25));
    CHECK(upstream_share(PlateLaw::separated, 1.0e-6) == Approx(3.0 / 16.0).epsilon(1.0e-5));
    // Rayleigh's and the flow's own in between, from the plate's coefficients: K/4 sin a cos a / C_N, 3 cos a / (16 + 4 pi sin a).
    for (const double a : {0.2, 0.6, 1.1}) {
        const double attached = compute_lift_slope(1.0) * std::sin(a) * std::cos(a);
        CHECK(upstream_share(PlateLaw::cross_flow, a) ==
              Approx(0.25 * attached / (attached + 1.128 * std::sin(a) * std::sin(a))));
        CHECK(upstream_share(PlateLaw::separated, a) ==
              Approx(3.0 * std::cos(a) / (16.0 + 4.0 * kPi * std::sin(a))));
    }
    double last = 0.25;
    for (double angle_rad = 0.1; angle_rad < 0.5 * kPi; angle_rad += 0.1) {
        const double share = upstream_share(PlateLaw::cross_flow, angle_rad);
        CHECK(share < last);
        CHECK(share > 0.0);
        last = share;
    }
    // From behind it lies on the other side of the middle.
    CHECK(upstream_share(PlateLaw::cross_flow, kPi - 0.3) ==
          Approx(-upstream_share(PlateLaw::cross_flow, 0.3)));
}

TEST_CASE("flat plate: air only takes energy, alike from behind, and still air nothing") {
    Random random(3);
    for (int i = 0; i < 3000; ++i) {
        const FlatPlate plate = make_plate(std::exp(2.0 * random.uniform()));
        const Vector3 flow = 10.0 * random.in_cube();
        for (const PlateLaw law : kPlateLaws) {
            const PlateForce felt = compute_plate_force(law, plate, kAir, flow);
            const PlateForce behind = compute_plate_force(law, plate, kAir, -flow);
            CHECK(felt.force.dot(flow) > 0.0);
            CHECK((felt.force + behind.force).norm() < kRounding * felt.force.norm());
        }
    }
    for (const Vector3& flow : {Vector3(0, 0, 0), Vector3(kNan, 0, 1)}) {
        const PlateForce felt = compute_plate_force(PlateLaw::cross_flow, make_plate(), kAir, flow);
        CHECK(felt.force == Vector3::Zero());
        CHECK(felt.torque == Vector3::Zero());
    }
    CHECK(std::string(to_string(PlateLaw::thin_plate)) == "thin plate");
}

TEST_CASE("flat plate: slopes of cross flow are its differences; none of still air") {
    FlatPlate plate;
    plate.normal = Vector3(0.2, -0.3, 1.0).normalized();
    plate.chord = plate.normal.cross(Vector3(0.1, 1.0, 0.4)).normalized();
    plate.chord_m = 0.4;
    plate.area_m2 = 0.3;
    plate.aspect_ratio = 1.7;
    for (int i = 0; i < 48; ++i) {
        const double angle_rad = 0.05 + 0.13 * i;
        const Vector3 flow =
            6.0 * (std::sin(angle_rad) * plate.normal +
                   std::cos(angle_rad) * (plate.chord + 0.4 * plate.chord.cross(plate.normal)));
        const PlateSlopes slopes = compute_cross_flow_slopes(plate, 1.2, flow);
        constexpr double kStep = 1.0e-5;
        for (int axis = 0; axis < 3; ++axis) {
            const Vector3 step = kStep * Vector3::Unit(axis);
            const PlateForce more =
                compute_plate_force(PlateLaw::cross_flow, plate, 1.2, flow + step);
            const PlateForce less =
                compute_plate_force(PlateLaw::cross_flow, plate, 1.2, flow - step);
            constexpr double kRounding = 1.0e-8;  // of some newtons, over the step
            CHECK((slopes.force.col(axis) - (more.force - less.force) / (2.0 * kStep)).norm() <
                  kRounding);
            CHECK((slopes.torque.col(axis) - (more.torque - less.torque) / (2.0 * kStep)).norm() <
                  kRounding);
        }
    }
    const PlateSlopes still = compute_cross_flow_slopes(plate, 1.2, Vector3::Zero());
    CHECK(still.force.isZero());
    CHECK(still.torque.isZero());
    // Broadside, where the flow along the plate has no direction.
    CHECK(compute_cross_flow_slopes(plate, 1.2, 5.0 * plate.normal).force.allFinite());
}
