#include "haptics/collision/contact_sweep.h"

#include "haptics/math/rotation.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

namespace fulcrum {
namespace {

constexpr double kNear_m = 1.0e-5;
constexpr double kEnd_s = 1.0;

MovingShape make_moving(const ContactShape& shape, const Pose& pose, const Twist& velocity) {
    return {&shape, ContactPlace::of(pose), pose.position, velocity, shape.bounding_radius_m};
}

Twist going(const Vector3& linear, const Vector3& angular = Vector3::Zero()) {
    return {linear, angular};
}

TEST_CASE("contact sweep: a ball meets a box, a ball and the ground when the way says so") {
    const ContactShape ball = make_contact_shape(SphereShape{0.01}).value();
    const ContactShape box = make_contact_shape(BoxShape{Vector3::Constant(0.05)}).value();
    const ContactShape ground = make_half_space();
    const Vector3 down(0.0, -2.0, 0.0);
    const MovingShape falling = make_moving(ball, Pose::at({0.0, 0.5, 0.0}), going(down));
    const auto meets = [&](const ContactShape& shape) {
        return find_meeting_s(falling, make_moving(shape, Pose{}, going(Vector3::Zero())), kNear_m,
                              kEnd_s);
    };
    CHECK(meets(box) == Approx(0.44 / 2.0).margin(kNear_m));
    CHECK(meets(ball) == Approx(0.48 / 2.0).margin(kNear_m));
    CHECK(meets(ground) == Approx(0.49 / 2.0).margin(kNear_m));
    // Not before the end, and not where both go the same way.
    const MovingShape below = make_moving(box, Pose{}, going(Vector3::Zero()));
    CHECK(std::isinf(find_meeting_s(falling, below, kNear_m, 0.2)));
    CHECK(std::isinf(
        find_meeting_s(falling, make_moving(box, Pose{}, going(down)), kNear_m, kEnd_s)));
    CHECK(find_meeting_s(below, falling, kNear_m, kEnd_s) == meets(box));
}

TEST_CASE("contact sweep: what passes by a hair does not meet, however fast") {
    const ContactShape ball = make_contact_shape(SphereShape{0.01}).value();
    const ContactShape box = make_contact_shape(BoxShape{Vector3::Constant(0.05)}).value();
    const MovingShape still = make_moving(box, Pose{}, going(Vector3::Zero()));
    for (const double speed : {1.0, 100.0, 1.0e4}) {
        for (const double clear_m : {1.0e-4, -1.0e-4}) {
            CAPTURE(speed, clear_m);
            const MovingShape passing =
                make_moving(ball, Pose::at({-0.9, 0.06 + clear_m, 0.01}), going({speed, 0.0, 0.0}));
            const double met_s = find_meeting_s(passing, still, kNear_m, 2.0 / speed);
            CHECK(std::isinf(met_s) == (clear_m > 0.0));
        }
    }
}

TEST_CASE("contact sweep: a wall of a tenth of a millimetre is met") {
    const ContactShape box = make_contact_shape(BoxShape{{0.02, 0.03, 0.05}}).value();
    const ContactShape wall = make_contact_shape(BoxShape{{5.0e-5, 1.0, 1.0}}).value();
    const MovingShape still = make_moving(wall, Pose{}, going(Vector3::Zero()));
    const MovingShape flung =
        make_moving(box, Pose::at({-0.5, 0.0, 0.0}), going({1000.0, 0.0, 0.0}, {0.0, 0.0, 0.0}));
    CHECK(find_meeting_s(flung, still, kNear_m, 1.0e-3) ==
          Approx((0.48 - 5.0e-5) / 1000.0).margin(1.0e-7));
}

TEST_CASE("contact sweep: a rod that turns meets what its end comes to") {
    const ContactShape rod = make_contact_shape(BoxShape{{0.1, 0.001, 0.001}}).value();
    const ContactShape ball = make_contact_shape(SphereShape{0.01}).value();
    const MovingShape turning = make_moving(rod, Pose{}, going(Vector3::Zero(), {0.0, 0.0, 2.0}));
    const MovingShape still = make_moving(ball, Pose::at({0.0, 0.08, 0.0}), going(Vector3::Zero()));
    const double met_s = find_meeting_s(turning, still, kNear_m, 2.0);
    // Its edge, 1 mm beside the middle, comes to 1 cm from the ball's centre.
    CHECK(met_s == Approx((0.5 * M_PI - std::asin(0.011 / 0.08)) / 2.0).margin(1.0e-4));
    const MovingShape beyond =
        make_moving(ball, Pose::at({0.0, 0.12, 0.0}), going(Vector3::Zero()));
    CHECK(std::isinf(find_meeting_s(turning, beyond, kNear_m, 2.0)));
}

TEST_CASE("contact sweep: never later than the bodies are that near") {
    Random random(17);
    const ContactShape box = make_contact_shape(BoxShape{{0.02, 0.05, 0.03}}).value();
    const ContactShape can = make_contact_shape(CylinderShape{0.03, 0.02}).value();
    for (int i = 0; i < 200; ++i) {
        const MovingShape a = make_moving(box, {Vector3(0.3 * random.in_cube()), random.turn(3.0)},
                                          going(random.in_cube(), Vector3(5.0 * random.in_cube())));
        const MovingShape b = make_moving(can, {Vector3(0.3 * random.in_cube()), random.turn(3.0)},
                                          going(random.in_cube(), Vector3(5.0 * random.in_cube())));
        const double met_s = find_meeting_s(a, b, 1.0e-4, 0.5);
        for (double at_s = 0.0; at_s < std::min(met_s, 0.5); at_s += 0.01) {
            ContactManifold manifold;
            find_contacts(*a.shape, a.find_place(at_s), *b.shape, b.find_place(at_s), 0.0,
                          manifold);
            CHECK(manifold.count == 0);
        }
    }
}

TEST_CASE("contact sweep: what is no number meets nothing") {
    const ContactShape ball = make_contact_shape(SphereShape{0.01}).value();
    MovingShape lost = make_moving(ball, Pose{}, going({1.0, 0.0, 0.0}));
    lost.place.position_W.x() = std::numeric_limits<double>::quiet_NaN();
    const MovingShape still = make_moving(ball, Pose::at({0.1, 0.0, 0.0}), going(Vector3::Zero()));
    CHECK(std::isinf(find_meeting_s(lost, still, kNear_m, kEnd_s)));
}

}  // namespace
}  // namespace fulcrum
