#include "haptics/collision/sampled_sweep.h"

#include "haptics/collision/sampled_shape.h"
#include "haptics/geometry/shape.h"
#include "tests/support/touchable.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <numbers>

namespace fulcrum {
namespace {

constexpr double kNearThem_m = 1.0e-4;

ContactShape make_sampled(const SolidShape& solid) {
    ContactShape shape = make_contact_shape(solid).value();
    shape.sampled = SampledShape::make(solid).value();
    return shape;
}

ContactShape make_ring() {
    return make_sampled(SolidShape(touchable(make_torus(0.06, 0.02, 48, 24))));
}

MovingShape make_moving(const ContactShape& shape, const Pose& pose, const Vector3& linear,
                        const Vector3& angular = Vector3::Zero()) {
    return {
        &shape, ContactPlace::of(pose), pose.position, {linear, angular}, shape.bounding_radius_m};
}

TEST_CASE("sampled sweep: a ball meets a plate of triangles when the way says so, however fast") {
    const ContactShape plate = make_sampled(SolidShape(touchable(make_box({0.3, 0.01, 0.3}))));
    const ContactShape ball = make_sampled(SphereShape{0.02});
    const MovingShape still = make_moving(plate, Pose{}, Vector3::Zero());
    for (const double speed : {0.5, 10.0, 100.0, 1.0e3}) {
        CAPTURE(speed);
        const MovingShape falling =
            make_moving(ball, Pose::at({0.03, 0.5, -0.02}), {0.0, -speed, 0.0});
        const double met_s = find_sampled_meeting_s(falling, still, kNearThem_m, 1.0 / speed);
        // To what samples and a field of 3 mm tell of a flat face.
        CHECK(speed * met_s == Approx(0.475).margin(3.0e-4));
        CHECK(find_sampled_meeting_s(still, falling, kNearThem_m, 1.0 / speed) ==
              Approx(met_s).epsilon(1.0e-3));
        CHECK(std::isinf(find_sampled_meeting_s(falling, still, kNearThem_m, 0.4 / speed)));
    }
}

TEST_CASE("sampled sweep: what goes through a ring or passes it does not meet it") {
    const ContactShape ring = make_ring();
    const ContactShape ball = make_sampled(SphereShape{0.02});
    const MovingShape still = make_moving(ring, Pose{}, Vector3::Zero());
    const auto meets_at_m = [&](const Vector3& from, const Vector3& way) {
        return find_sampled_meeting_s(make_moving(ball, Pose::at(from), way), still, kNearThem_m,
                                      1.0);
    };
    // Its hole is 0.04 wide about the axis; the tube reaches out to 0.08.
    CHECK(std::isinf(meets_at_m({0.0, 0.5, 0.0}, {0.0, -1.0, 0.0})));
    CHECK(std::isinf(meets_at_m({0.018, 0.5, 0.0}, {0.0, -1.0, 0.0})));
    CHECK(std::isinf(meets_at_m({0.102, 0.5, 0.0}, {0.0, -1.0, 0.0})));
    // On the tube's top, and from beside: both surfaces are round.
    CHECK(meets_at_m({0.06, 0.5, 0.0}, {0.0, -1.0, 0.0}) == Approx(0.46).margin(5.0e-4));
    CHECK(meets_at_m({0.5, 0.0, 0.0}, {-1.0, 0.0, 0.0}) == Approx(0.4).margin(5.0e-4));
    // Within the hole it meets the other side.
    CHECK(meets_at_m({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}) == Approx(0.02).margin(5.0e-4));
}

TEST_CASE("sampled sweep: a bar that turns meets what its end sweeps over, and not before") {
    const ContactShape bar = make_sampled(SolidShape(touchable(make_box({0.4, 0.02, 0.02}))));
    const ContactShape ball = make_sampled(SphereShape{0.01});
    const MovingShape turning =
        make_moving(bar, Pose{}, Vector3::Zero(), {0.0, 0.5 * std::numbers::pi, 0.0});
    // A quarter turn about y a second: the end goes from x to -z. Its side is 0.01 before its middle, the ball's 0.01.
    const MovingShape below = make_moving(ball, Pose::at({0.0, 0.0, -0.18}), Vector3::Zero());
    const double ahead = std::asin(0.02 / 0.18) / (0.5 * std::numbers::pi);
    CHECK(find_sampled_meeting_s(turning, below, kNearThem_m, 2.0) ==
          Approx(1.0 - ahead).margin(2.0e-3));
    const MovingShape beyond = make_moving(ball, Pose::at({0.0, 0.0, -0.23}), Vector3::Zero());
    CHECK(std::isinf(find_sampled_meeting_s(turning, beyond, kNearThem_m, 2.0)));
}

TEST_CASE("sampled sweep: what touches meets at once, what is no number never") {
    const ContactShape ring = make_ring();
    const ContactShape ball = make_sampled(SphereShape{0.02});
    const MovingShape still = make_moving(ring, Pose{}, Vector3::Zero());
    const MovingShape on = make_moving(ball, Pose::at({0.06, 0.04, 0.0}), {0.0, 1.0, 0.0});
    CHECK(find_sampled_meeting_s(on, still, kNearThem_m, 1.0) == 0.0);
    const MovingShape beside = make_moving(ball, Pose::at({0.06, 0.05, 0.0}), Vector3::Zero());
    CHECK(std::isinf(find_sampled_meeting_s(beside, still, kNearThem_m, 1.0)));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const MovingShape lost = make_moving(ball, Pose::at({nan, 0.0, 0.0}), {1.0, 0.0, 0.0});
    CHECK(std::isinf(find_sampled_meeting_s(lost, still, kNearThem_m, 1.0)));
}

}  // namespace
}  // namespace fulcrum
