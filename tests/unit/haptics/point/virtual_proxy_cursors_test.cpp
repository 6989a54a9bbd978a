// Cursors that are no balls.
#include "haptics/geometry/height_field.h"
#include "haptics/geometry/shape.h"
#include "haptics/point/make_obstacle.h"
#include "haptics/point/make_proxy.h"
#include "haptics/point/virtual_proxy.h"
#include "tests/support/distance_bodies.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace fulcrum {
namespace {

std::vector<SolidPlan> of(const SolidShape& shape, const Pose& pose_W = {}) {
    return {SolidPlan{.body = 0, .shape = shape, .initial_pose_W = pose_W}};
}

const ProxyContact& go_down(VirtualProxy& proxy, const Vector3& start_W, const Vector3& hand_W) {
    proxy.reset(start_W);
    for (int i = 1; i <= 50; ++i) {
        proxy.step(start_W + (hand_W - start_W) * i / 50.0, {});
    }
    for (int i = 0; i < 10; ++i) {
        proxy.step(hand_W, {});
    }
    return proxy.contact();
}

TEST_CASE("virtual proxy: a box, a cylinder, a capsule and a hull rest by their own height") {
    const auto hull =
        make_hull_shape({{-0.1, 0, 0}, {0.1, 0, 0}, {0, 0, 0.1}, {0, -0.2, 0}, {0, 0.1, 0}});
    REQUIRE(hull);
    const double hull_down_m = 0.2 + 1.0e-3 * 0.2;  // grown by a thousandth of its radius
    const std::vector<std::pair<CursorShape, double>> cursors{{BoxShape{{0.1, 0.05, 0.1}}, 0.05},
                                                              {CylinderShape{0.1, 0.07}, 0.07},
                                                              {CapsuleShape{0.02, 0.1}, 0.12},
                                                              {*hull, hull_down_m}};
    const std::vector<SolidShape> floors{
        touchable(make_plate(4.0, 4.0, 20)), SolidShape(BoxShape{{2.0, 1.0e-12, 2.0}}),
        *make_height_field_shape({.width_m = 4.0,
                                  .depth_m = 4.0,
                                  .n_x = 9,
                                  .n_z = 9,
                                  .heights_m = std::vector<double>(81, 0.0)})};
    for (const auto& [cursor, height_m] : cursors) {
        for (const SolidShape& floor : floors) {
            VirtualProxy proxy(make_obstacles(cursor, of(floor)));
            const ProxyContact& contact =
                go_down(proxy, Vector3(0.0, 1.0, 0.1), Vector3(0.33, -0.2, 0.21));
            CHECK((contact.position_W - Vector3(0.33, height_m, 0.21)).norm() <= 1.0e-8);
            CHECK(contact.n_constraints == 1);
            CHECK((contact.normal_W - Vector3::UnitY()).norm() < 1e-7);
        }
    }
}

TEST_CASE("virtual proxy: a box cursor in the corner of a box touches all three walls") {
    const auto room = touchable(make_box(Vector3(1.0, 2.0, 3.0)));
    VirtualProxy proxy(make_obstacles(BoxShape{{0.1, 0.2, 0.3}}, of(room)));
    const ProxyContact& contact = go_down(proxy, Vector3::Zero(), Vector3(0.7, 1.2, 1.9));
    CHECK((contact.position_W - Vector3(0.4, 0.8, 1.2)).norm() <= 1.0e-8);
    CHECK(contact.n_constraints == 3);
}

TEST_CASE("virtual proxy: a capsule without length is a ball") {
    const auto mesh = touchable(make_bumpy_sphere(1.0, 10, 0.05, 8.0));
    VirtualProxy capsule(make_obstacles(CapsuleShape{0.1, 0.0}, of(mesh)));
    VirtualProxy ball(make_obstacles(SphereShape{0.1}, of(mesh)));
    Wanderer wanderer(7);
    const Vector3 start = 1.4 * wanderer.next();
    capsule.reset(start);
    ball.reset(start);
    for (int i = 0; i < 2000; ++i) {
        const Vector3 hand = 1.05 * wanderer.next();
        const Vector3 here = capsule.step(hand, {}).position_W;
        const Vector3 there = ball.step(hand, {}).position_W;
        REQUIRE(std::abs((here - hand).norm() - (there - hand).norm()) <= 1.0e-4);
    }
}

TEST_CASE("virtual proxy: plates that turn and fly at 5 m/s pass through no cursor of any shape") {
    const auto plate = touchable(make_box(Vector3(0.4, 1.0e-4, 0.4)));
    for (const CursorShape& cursor :
         {CursorShape(BoxShape{{0.01, 0.02, 0.015}}), CursorShape(CylinderShape{0.01, 0.02}),
          CursorShape(CapsuleShape{0.01, 0.02})}) {
        Random random(9);
        for (int run = 0; run < 20; ++run) {
            const Quaternion turn = random.turn(0.4);
            const Vector3 axis = random.direction();
            Pose pose{Vector3(0.0, -0.1, 0.0), turn};
            VirtualProxy proxy(make_obstacles(cursor, of(plate, pose)));
            proxy.reset(Vector3::Zero());
            for (int i = 0; i < 40; ++i) {
                pose.position.y() = -0.1 + 0.005 * i;
                pose.orientation = Quaternion(AngleAxis(0.01 * i, axis)) * turn;
                const ProxyContact& contact = proxy.step(Vector3::Zero(), std::span(&pose, 1));
                const Vector3 at_B = pose.inverse() * contact.position_W;
                // Over the plate, by a cursor's least half size; or past its border.
                const bool is_over = at_B.y() > 0.01 * (1.0 - 1.0e-6);
                REQUIRE((is_over || at_B.cwiseAbs().maxCoeff() > 0.2));
            }
        }
    }
}

TEST_CASE("proxy: a convex cursor touches all but a distance function") {
    const DistanceShape ball{std::make_shared<BallFunction>(0.1)};
    const ProxySettings settings{.kind = ProxyKind::friction_cone, .cursor = BoxShape{}};
    CHECK(validate(settings, of(SphereShape{})));
    CHECK(validate(settings, of(touchable(make_plate(1.0, 1.0, 1)))));
    CHECK_FALSE(validate(settings, of(ball)));
    CHECK(validate({.kind = ProxyKind::virtual_proxy, .cursor = SphereShape{}}, of(ball)));
    CHECK_FALSE(validate({.kind = ProxyKind::virtual_proxy, .cursor = BoxShape{{1.0, 0.0, 1.0}}},
                         of(SphereShape{})));
    CHECK_FALSE(
        validate({.kind = ProxyKind::virtual_proxy, .cursor = HullShape{}}, of(SphereShape{})));
    CHECK(make_proxy(settings, of(CylinderShape{}), {}) != nullptr);
}

}  // namespace
}  // namespace fulcrum
