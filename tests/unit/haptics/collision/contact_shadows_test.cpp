#include "haptics/collision/contact_shadow.h"
#include "haptics/collision/contact_sweep.h"
#include "haptics/collision/find_contacts.h"
#include "haptics/collision/sampled_shape.h"
#include "haptics/collision/sampled_sweep.h"
#include "haptics/geometry/shape.h"
#include "haptics/math/rotation.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

using namespace fulcrum;

namespace {

Shadow make_polygon(const std::vector<Shadow::Place>& corners, double height) {
    Shadow shadow;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        shadow.corners[i] = corners[i];
    }
    shadow.count = static_cast<int>(corners.size());
    shadow.height = height;
    return shadow;
}

Shadow make_rectangle(double x, double y, double half_x, double half_y) {
    return make_polygon({{x - half_x, y - half_y},
                         {x + half_x, y - half_y},
                         {x + half_x, y + half_y},
                         {x - half_x, y + half_y}},
                        0.0);
}

double find_area(const SharedCorners& shared) {
    double twice = 0.0;
    for (int i = 0; i < shared.count; ++i) {
        const auto& a = shared.corners[static_cast<std::size_t>(i)].at;
        const auto& b = shared.corners[static_cast<std::size_t>((i + 1) % shared.count)].at;
        twice += a.x * b.y - a.y * b.x;
    }
    return 0.5 * twice;
}

SharedCorners share(const Shadow& upper, const Shadow& lower) {
    SharedCorners shared;
    find_shared_corners(upper, lower, shared);
    return shared;
}

constexpr double kNear_m = 1.0e-5;
constexpr double kNearThem_m = 1.0e-4;  // by samples
constexpr double kEnd_s = 1.0;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

ContactShape make_sampled(const SolidShape& solid) {
    ContactShape shape = make_contact_shape(solid).value();
    shape.sampled = SampledShape::make(solid).value();
    return shape;
}

MovingShape make_moving(const ContactShape& shape, const Pose& pose,
                        const Vector3& linear = Vector3::Zero(),
                        const Vector3& angular = Vector3::Zero()) {
    return {
        &shape, ContactPlace::of(pose), pose.position, {linear, angular}, shape.bounding_radius_m};
}

const ContactShape kBall = make_contact_shape(SphereShape{0.01}).value();
const ContactShape kBox = make_contact_shape(BoxShape{Vector3::Constant(0.05)}).value();

}  // namespace

TEST_CASE("contact shadow: two rectangles share their overlap, all but equal ones the whole") {
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const double x = random.uniform();
        const double y = random.uniform();
        const SharedCorners shared =
            share(make_rectangle(x, y, 0.5, 0.7), make_rectangle(0.0, 0.0, 0.6, 0.4));
        const double width = std::min(0.6, x + 0.5) - std::max(-0.6, x - 0.5);
        const double depth = std::min(0.4, y + 0.7) - std::max(-0.4, y - 0.7);
        const double area = std::max(width, 0.0) * std::max(depth, 0.0);
        REQUIRE(find_area(shared) == Approx(area).margin(1.0e-8));
    }
    for (const double off : {0.0, 1.0e-12, 1.0e-9, 1.0e-6, -1.0e-6}) {
        const SharedCorners shared =
            share(make_rectangle(off, -off, 0.5, 0.5), make_rectangle(0.0, 0.0, 0.5, 0.5));
        CHECK(shared.count >= 4);
        CHECK(find_area(shared) == Approx(1.0).margin(1.0e-5));
    }
    CHECK(share(make_rectangle(1.1, 0.0, 0.5, 0.5), make_rectangle(0.0, 0.0, 0.5, 0.5)).count == 0);
}

TEST_CASE("contact shadow: a segment is cut by a face, and heights are those of both") {
    Shadow segment = make_polygon({{-2.0, 0.1}, {2.0, 0.1}}, 1.0);
    segment.slope_x = 0.25;
    const Shadow face = make_rectangle(0.0, 0.0, 1.0, 0.5);
    const SharedCorners shared = share(segment, face);
    REQUIRE(shared.count == 2);
    CHECK(shared.corners[0].at.x == Approx(-1.0));
    CHECK(shared.corners[0].upper == Approx(0.75));
    CHECK(shared.corners[1].upper == Approx(1.25));
    CHECK(shared.corners[1].lower == 0.0);
    // The same with the face above.
    CHECK(share(face, segment).corners[1].lower == Approx(1.25));
    CHECK(share(make_polygon({{-2.0, 0.6}, {2.0, 0.6}}, 1.0), face).count == 0);
    CHECK(share(make_polygon({{0.0, 0.0}, {0.3, 0.2}}, 1.0), face).count == 2);
}

TEST_CASE("contact shadow: segments cross in one place, or share a stretch where parallel") {
    const Shadow along_x = make_polygon({{-1.0, 0.0}, {1.0, 0.0}}, 1.0);
    const SharedCorners crossing = share(along_x, make_polygon({{0.3, -1.0}, {0.3, 1.0}}, 0.0));
    REQUIRE(crossing.count == 1);
    CHECK(crossing.corners[0].at.x == Approx(0.3));
    const SharedCorners stretch = share(along_x, make_polygon({{2.0, 0.01}, {0.2, 0.0}}, 0.0));
    REQUIRE(stretch.count == 2);
    CHECK(std::abs(stretch.corners[0].at.x - stretch.corners[1].at.x) == Approx(0.8).margin(1e-3));
    CHECK(share(along_x, make_polygon({{2.0, 0.0}, {3.0, 0.0}}, 0.0)).count == 0);
}

TEST_CASE("contact shadow: of shadows that miss each other the nearest corner is told") {
    const Shadow segment = make_polygon({{-2.0, 0.50001}, {3.0, 0.50001}}, 1.0);
    Shadow face = make_polygon({{0.3, 0.5}, {-0.5, 0.2}, {0.4, -0.5}}, 0.25);
    REQUIRE(share(segment, face).count == 0);
    const SharedCorner nearest = find_nearest_corner(segment, face);
    CHECK(nearest.at.x == 0.3);
    CHECK(nearest.upper == 1.0);
    CHECK(nearest.lower == 0.25);
    CHECK(find_nearest_corner(face, segment).at.y == 0.5);
    const Shadow point = make_polygon({{1.0, 0.0}}, 0.0);
    CHECK(find_nearest_corner(point, make_rectangle(0.0, 0.0, 0.9, 0.9)).at.x == 1.0);
}

TEST_CASE("contact shadow: a place of the plane is over the place of the face that casts it") {
    Random random(2);
    for (int i = 0; i < 500; ++i) {
        SupportFeature feature;
        const Vector3 half(0.5, 0.3, 0.4);
        const auto box = make_contact_shape(BoxShape{half}).value();
        const Vector3 normal = random.direction();
        const Matrix3 turn = random.turn(3.0).toRotationMatrix();
        const Vector3 place = random.in_cube();
        const ShadowFrame frame = ShadowFrame::across(normal);
        REQUIRE(frame.u.cross(frame.v).dot(normal) == Approx(1.0));
        for (const double sign : {-1.0, 1.0}) {
            find_feature(box, turn.transpose() * (sign * normal), feature);
            Shadow shadow;
            make_shadow(feature, turn, place, frame, sign, shadow);
            double area = 0.0;
            for (std::size_t k = 0; k < 4; ++k) {
                const auto& at = shadow.corners[k];
                const Vector3 there =
                    at.x * frame.u + at.y * frame.v + shadow.height_over(at) * normal;
                const Vector3 corner = turn.transpose() * (there - place);
                REQUIRE((corner.cwiseAbs() - half).norm() < 1.0e-12);
                const auto& next = shadow.corners[(k + 1) % 4];
                area += at.x * next.y - at.y * next.x;
            }
            REQUIRE(area > 0.0);
        }
    }
}

TEST_CASE("contact shadow: a segment seen end on is its end, a face edge on its farthest corner") {
    SupportFeature feature;
    feature.corners_B[0] = {0.0, -1.0, 0.0};
    feature.corners_B[1] = {0.0, 1.0, 0.0};
    feature.count = 2;
    Shadow shadow;
    make_shadow(feature, Matrix3::Identity(), {0.0, 5.0, 0.0},
                ShadowFrame::across(Vector3::UnitY()), -1.0, shadow);
    CHECK(shadow.count == 1);
    CHECK(shadow.height == Approx(4.0));
    feature.corners_B[2] = {1.0, 0.0, 0.0};
    feature.count = 3;
    feature.normal_B = Vector3::UnitZ();
    make_shadow(feature, Matrix3::Identity(), Vector3::Zero(),
                ShadowFrame::across(Vector3::UnitY()), 1.0, shadow);
    CHECK(shadow.count == 1);
    CHECK(shadow.height == Approx(1.0));
}

TEST_CASE("contact shadow: edges that coincide to rounding share no corner outside both") {
    // Equal squares moved by as little as counts for the edge: each edge of one lies along one of the other.
    Random random(6);
    for (int i = 0; i < 20000; ++i) {
        const double part = 1.0e-9 * (1.0 + 1.0e-6 * random.uniform());
        const SharedCorners shared = share(
            make_rectangle(part * random.uniform(), part * (i % 2 == 0 ? 1.0 : -1.0), 0.5, 0.5),
            make_rectangle(0.0, 0.0, 0.5, 0.5));
        REQUIRE(find_area(shared) == Approx(1.0).margin(1.0e-6));
        for (int k = 0; k < shared.count; ++k) {
            const Shadow::Place& at = shared.corners[static_cast<std::size_t>(k)].at;
            REQUIRE(std::max(std::abs(at.x), std::abs(at.y)) <= 0.5 + 1.0e-8);
        }
    }
    // Turned a little against each other, about a corner that lies just outside.
    for (int i = 0; i < 20000; ++i) {
        const double turn = 2.0e-9 * random.uniform();
        const double away = 1.0e-9 * random.uniform();
        const SharedCorners shared =
            share(make_polygon({{-0.5 + turn * 0.5, -0.5 - turn * 0.5 - away},
                                {0.5 + turn * 0.5, -0.5 + turn * 0.5 - away},
                                {0.5 - turn * 0.5, 0.5 + turn * 0.5 - away},
                                {-0.5 - turn * 0.5, 0.5 - turn * 0.5 - away}},
                               0.0),
                  make_rectangle(0.0, 0.0, 0.5, 0.5));
        for (int k = 0; k < shared.count; ++k) {
            const Shadow::Place& at = shared.corners[static_cast<std::size_t>(k)].at;
            REQUIRE(std::max(std::abs(at.x), std::abs(at.y)) <= 0.5 + 1.0e-7);
        }
        REQUIRE(find_area(shared) == Approx(1.0).margin(1.0e-6));
    }
}

// When bodies in motion meet: contact_sweep.h in closed form, sampled_sweep.h where a mesh is one of them.

TEST_CASE("contact sweep: a ball meets a box, a ball and the ground when the way says so") {
    const ContactShape ground = make_half_space();
    const Vector3 down(0.0, -2.0, 0.0);
    const MovingShape falling = make_moving(kBall, Pose::at({0.0, 0.5, 0.0}), down);
    const auto meets = [&](const ContactShape& shape) {
        return find_meeting_s(falling, make_moving(shape, Pose{}), kNear_m, kEnd_s);
    };
    CHECK(meets(kBox) == Approx(0.44 / 2.0).margin(kNear_m));
    CHECK(meets(kBall) == Approx(0.48 / 2.0).margin(kNear_m));
    CHECK(meets(ground) == Approx(0.49 / 2.0).margin(kNear_m));
    // Not before the end, and not where both go the same way.
    const MovingShape below = make_moving(kBox, Pose{});
    CHECK(std::isinf(find_meeting_s(falling, below, kNear_m, 0.2)));
    CHECK(std::isinf(find_meeting_s(falling, make_moving(kBox, Pose{}, down), kNear_m, kEnd_s)));
    CHECK(find_meeting_s(below, falling, kNear_m, kEnd_s) == meets(kBox));
}

TEST_CASE("contact sweep: what passes by a hair, a thin wall, and a rod that turns") {
    for (const double speed : {1.0, 100.0, 1.0e4}) {
        for (const double clear_m : {1.0e-4, -1.0e-4}) {
            CAPTURE(speed, clear_m);
            const MovingShape passing =
                make_moving(kBall, Pose::at({-0.9, 0.06 + clear_m, 0.01}), {speed, 0.0, 0.0});
            const double met_s =
                find_meeting_s(passing, make_moving(kBox, Pose{}), kNear_m, 2.0 / speed);
            CHECK(std::isinf(met_s) == (clear_m > 0.0));
        }
    }
    const ContactShape box = make_contact_shape(BoxShape{{0.02, 0.03, 0.05}}).value();
    const ContactShape wall = make_contact_shape(BoxShape{{5.0e-5, 1.0, 1.0}}).value();
    const MovingShape flung = make_moving(box, Pose::at({-0.5, 0.0, 0.0}), {1000.0, 0.0, 0.0});
    CHECK(find_meeting_s(flung, make_moving(wall, Pose{}), kNear_m, 1.0e-3) ==
          Approx((0.48 - 5.0e-5) / 1000.0).margin(1.0e-7));
    const ContactShape rod = make_contact_shape(BoxShape{{0.1, 0.001, 0.001}}).value();
    const MovingShape turning = make_moving(rod, Pose{}, Vector3::Zero(), {0.0, 0.0, 2.0});
    const auto meets_at = [&](double y) {
        return find_meeting_s(turning, make_moving(kBall, Pose::at({0.0, y, 0.0})), kNear_m, 2.0);
    };
    // Its edge, 1 mm beside the middle, comes to 1 cm from the ball's centre.
    CHECK(meets_at(0.08) == Approx((0.5 * M_PI - std::asin(0.011 / 0.08)) / 2.0).margin(1.0e-4));
    CHECK(std::isinf(meets_at(0.12)));
}

TEST_CASE("contact sweep: never later than the bodies are that near") {
    Random random(17);
    const ContactShape box = make_contact_shape(BoxShape{{0.02, 0.05, 0.03}}).value();
    const ContactShape can = make_contact_shape(CylinderShape{0.03, 0.02}).value();
    const auto draw = [&](const ContactShape& shape) {
        const Pose pose{Vector3(0.3 * random.in_cube()), random.turn(3.0)};
        const Vector3 linear = random.in_cube();
        return make_moving(shape, pose, linear, Vector3(5.0 * random.in_cube()));
    };
    for (int i = 0; i < 200; ++i) {
        const MovingShape a = draw(box);
        const MovingShape b = draw(can);
        const double met_s = find_meeting_s(a, b, 1.0e-4, 0.5);
        for (double at_s = 0.0; at_s < std::min(met_s, 0.5); at_s += 0.01) {
            ContactManifold manifold;
            find_contacts(*a.shape, a.find_place(at_s), *b.shape, b.find_place(at_s), 0.0,
                          manifold);
            CHECK(manifold.count == 0);
        }
    }
}

TEST_CASE("sampled sweep: a ball meets a plate of triangles when the way says so, however fast") {
    const ContactShape plate = make_sampled(SolidShape(touchable(make_box({0.3, 0.01, 0.3}))));
    const ContactShape ball = make_sampled(SphereShape{0.02});
    const MovingShape still = make_moving(plate, Pose{});
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

TEST_CASE("sampled sweep: a ball meets a ring where it touches, and not what it passes") {
    const ContactShape ring = make_sampled(SolidShape(touchable(make_torus(0.06, 0.02, 48, 24))));
    const ContactShape ball = make_sampled(SphereShape{0.02});
    const auto meets_at_m = [&](const Vector3& from, const Vector3& way) {
        return find_sampled_meeting_s(make_moving(ball, Pose::at(from), way),
                                      make_moving(ring, Pose{}), kNearThem_m, 1.0);
    };
    // Its hole is 0.04 wide about the axis; the tube reaches out to 0.08.
    const Vector3 down(0.0, -1.0, 0.0);
    for (const double x : {0.0, 0.018, 0.102}) {
        CHECK(std::isinf(meets_at_m({x, 0.5, 0.0}, down)));
    }
    // On the tube's top, and from beside: both surfaces are round.
    CHECK(meets_at_m({0.06, 0.5, 0.0}, down) == Approx(0.46).margin(5.0e-4));
    CHECK(meets_at_m({0.5, 0.0, 0.0}, {-1.0, 0.0, 0.0}) == Approx(0.4).margin(5.0e-4));
    // Within the hole it meets the other side.
    CHECK(meets_at_m({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}) == Approx(0.02).margin(5.0e-4));
    // What touches meets at once.
    CHECK(meets_at_m({0.06, 0.04, 0.0}, {0.0, 1.0, 0.0}) == 0.0);
    CHECK(std::isinf(meets_at_m({0.06, 0.05, 0.0}, Vector3::Zero())));
    CHECK(std::isinf(meets_at_m({kNaN, 0.0, 0.0}, {1.0, 0.0, 0.0})));
}

TEST_CASE("sampled sweep: a bar that turns meets what its end sweeps over, and not before") {
    const ContactShape bar = make_sampled(SolidShape(touchable(make_box({0.4, 0.02, 0.02}))));
    const ContactShape ball = make_sampled(SphereShape{0.01});
    const MovingShape turning =
        make_moving(bar, Pose{}, Vector3::Zero(), {0.0, 0.5 * std::numbers::pi, 0.0});
    const auto meets_at = [&](double z) {
        return find_sampled_meeting_s(turning, make_moving(ball, Pose::at({0.0, 0.0, z})),
                                      kNearThem_m, 2.0);
    };
    // A quarter turn about y a second: the end goes from x to -z. Its side is 0.01 before its middle, the ball's 0.01.
    const double ahead = std::asin(0.02 / 0.18) / (0.5 * std::numbers::pi);
    CHECK(meets_at(-0.18) == Approx(1.0 - ahead).margin(2.0e-3));
    CHECK(std::isinf(meets_at(-0.23)));
}

TEST_CASE("contact sweep: what is no number meets nothing") {
    MovingShape lost = make_moving(kBall, Pose{}, {1.0, 0.0, 0.0});
    lost.place.position_W.x() = kNaN;
    const MovingShape still = make_moving(kBall, Pose::at({0.1, 0.0, 0.0}));
    CHECK(std::isinf(find_meeting_s(lost, still, kNear_m, kEnd_s)));
}
