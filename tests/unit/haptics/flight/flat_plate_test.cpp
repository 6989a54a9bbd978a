#include "haptics/flight/flat_plate.h"

#include "haptics/math/length.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

using namespace fulcrum;

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

TEST_CASE("flat plate: along the stream it is only rubbed") {
    for (const PlateLaw law : kPlateLaws) {
        const PlateForce felt = compute_plate_force(law, make_plate(), kAir, stream(0.0, 7.0));
        CHECK(felt.force.x() == Approx(0.5 * kAir * 0.3 * 49.0 * kPlateFriction));
        CHECK(std::abs(felt.force.z()) < kRounding);
        CHECK(felt.torque.norm() < kRounding);
    }
}

TEST_CASE("flat plate: across the stream it has the drag of a broad side, in its middle") {
    // Viterna and Corrigan: 1.128 of a square plate; 2.01 of an endless one.
    CHECK(compute_broadside_drag(1.0) == Approx(1.128));
    CHECK(compute_broadside_drag(1.0e9) == Approx(2.01));
    for (const PlateLaw law : {PlateLaw::cross_flow, PlateLaw::separated}) {
        CHECK(coefficient(law, 1.0, 0.5 * kPi).z() == Approx(1.128));
        const PlateForce felt =
            compute_plate_force(law, make_plate(), kAir, stream(0.5 * kPi, 7.0));
        CHECK(felt.torque.norm() < 1.0e-9);
    }
}

TEST_CASE(
    "flat plate: the lift's slope is Helmbold's, 2 pi of an endless wing and pi AR / 2 of a "
    "slender one") {
    CHECK(compute_lift_slope(1.0e6) == Approx(2.0 * kPi).epsilon(1.0e-5));
    CHECK(compute_lift_slope(1.0e-3) == Approx(0.5 * kPi * 1.0e-3).epsilon(1.0e-3));
    constexpr double kSmall_rad = 1.0e-6;
    CHECK(coefficient(PlateLaw::cross_flow, 2.0, kSmall_rad).z() / kSmall_rad ==
          Approx(compute_lift_slope(2.0)).epsilon(1.0e-5));
}

TEST_CASE("flat plate: in between, the three laws in closed form") {
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

TEST_CASE(
    "flat plate: air only takes energy from what moves through it, and pushes back alike from "
    "behind") {
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
}

TEST_CASE(
    "flat plate: slopes of cross flow are its differences, at every angle, and none of still air") {
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

TEST_CASE("flat plate: still air, no plate's fault, does nothing") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Vector3& flow : {Vector3(0, 0, 0), Vector3(nan, 0, 1)}) {
        const PlateForce felt = compute_plate_force(PlateLaw::cross_flow, make_plate(), kAir, flow);
        CHECK(felt.force == Vector3::Zero());
        CHECK(felt.torque == Vector3::Zero());
    }
    CHECK(std::string(to_string(PlateLaw::thin_plate)) == "thin plate");
}
