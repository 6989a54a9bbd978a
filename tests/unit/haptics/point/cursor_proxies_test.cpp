#include "haptics/collision/mesh_obstacle.h"
#include "haptics/geometry/height_field.h"
#include "haptics/geometry/shape.h"
#include "haptics/point/friction_cone.h"
#include "haptics/point/god_object.h"
#include "haptics/point/make_obstacle.h"
#include "haptics/point/make_proxy.h"
#include "haptics/point/moving_obstacle.h"
#include "haptics/point/moving_solid.h"
#include "haptics/point/proxy_frame.h"
#include "haptics/point/virtual_proxy.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/distance_bodies.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace fulcrum;

namespace {

const Pose kPose{Vector3(3.0, -2.0, 1.0), Quaternion(AngleAxis(0.8, Vector3(0.6, 0.0, 0.8)))};

constexpr double kRadius_m = 0.01;

VirtualProxy make_ball(const std::vector<SolidPlan>& solids) {
    return VirtualProxy(make_obstacles(SphereShape{kRadius_m}, solids));
}

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

SolidPlan plate() {
    return {.body = 1, .shape = touchable(make_plate(4.0, 4.0, 3))};
}
bool fits(const std::vector<SolidPlan>& solids, const ProxySettings& settings = {}) {
    return validate(settings, solids).has_value();
}

// Each kind at `kPose`, the proxy put at `p` in its frame.
template <class Law>
void for_each_frame(const Law& law) {
    const auto plate = touchable(make_plate(1.0, 1.0, 1));
    ProxyFrame bare;
    MovingSolid solid(only_solid(plate).front(), 2);
    MovingObstacle obstacle(std::make_unique<MeshObstacle>(plate, 0.1), 2, Pose{});
    law("bare", bare);
    law("solid", solid);
    law("obstacle", obstacle);
}

}  // namespace

TEST_CASE("virtual proxy: a start in a surface is pushed out of it, NaN and the far are ignored") {
    VirtualProxy proxy(
        make_obstacles(SphereShape{0.1}, only_solid(touchable(make_box(Vector3::Ones())))));
    proxy.reset(Vector3(0.0, 0.52, 0.0));
    CHECK((proxy.contact().position_W - Vector3(0.0, 0.6, 0.0)).norm() < 1.0e-9);
    const Vector3 hand(0.0, 0.4, 0.0);
    const Vector3 before = proxy.step(hand, {}).position_W;
    CHECK(proxy.step(Vector3(kNan, 0.0, 0.0), {}).position_W == before);
    CHECK(proxy.step(Vector3(0.0, 1.0e31, 0.0), {}).position_W == before);
    const Pose nowhere = Pose::at(Vector3(0.0, kNan, 0.0));
    CHECK(proxy.step(hand, std::span(&nowhere, 1)).position_W == before);
}

TEST_CASE("virtual proxy: it meets a plate on its way, however far the hand jumps") {
    const auto plate = touchable(make_plate(4.0, 4.0, 40));
    for (const double side : {1.0, -1.0}) {
        VirtualProxy proxy = make_ball(only_solid(plate));
        for (const double jump_m : {0.02, 0.3, 5.0, 1.0e6}) {
            proxy.reset(Vector3(0.1, 0.015 * side, 0.2));
            const Vector3 hand(0.3, -jump_m * side, 0.2);
            const ProxyContact& contact = proxy.step(hand, {});
            CHECK(contact.position_W.y() * side == Approx(0.01).epsilon(1e-6));
        }
    }
}

TEST_CASE("virtual proxy: a plate that moves takes a still hand's proxy along") {
    const auto plate = touchable(make_box(Vector3(0.2, 1.0e-4, 0.2)));
    for (const double speed_m : {1.0e-4, 1.0e-3, 5.0e-3, -5.0e-3, 0.2}) {
        VirtualProxy proxy = make_ball(
            only_solid(plate, Pose::at(Vector3(0.0, -0.05 * speed_m / std::abs(speed_m), 0.0))));
        proxy.reset(Vector3::Zero());
        const double side = speed_m > 0.0 ? 1.0 : -1.0;
        for (int i = 1; i <= 100; ++i) {
            const double at_m = -0.05 * side + i * speed_m;
            const Pose pose = Pose::at(Vector3(0.0, at_m, 0.0));
            const ProxyContact& contact = proxy.step(Vector3::Zero(), std::span(&pose, 1));
            const double in_front_m = side * at_m + 0.5e-4 + kRadius_m;
            INFO("speed " << speed_m << " step " << i);
            REQUIRE(
                (contact.position_W - Vector3(0.0, side * std::max(in_front_m, 0.0), 0.0)).norm() <=
                1.0e-9);
        }
    }
}

TEST_CASE("virtual proxy: a body that tumbles never gets over it") {
    const auto box = touchable(make_box(Vector3(0.1, 0.06, 0.08)));
    Random random(5);
    for (int run = 0; run < 20; ++run) {
        VirtualProxy proxy = make_ball(only_solid(box));
        const Vector3 spin = 30.0 * random.direction();  // rad/s
        const Vector3 hand = 0.03 * random.in_cube();
        proxy.reset(0.2 * random.direction());
        Pose pose;
        for (int i = 0; i < 2000; ++i) {
            pose.orientation = Quaternion(AngleAxis(1.0e-3 * spin.norm() * i, spin.normalized()));
            pose.position = 0.02 * Vector3(std::sin(0.01 * i), 0.0, std::cos(0.013 * i));
            const ProxyContact& contact = proxy.step(hand, std::span(&pose, 1));
            const Vector3 at_B = pose.inverse() * contact.position_W;
            const Vector3 outside = (at_B.cwiseAbs() - Vector3(0.05, 0.03, 0.04)).cwiseMax(0.0);
            REQUIRE(outside.norm() >= kRadius_m * (1.0 - 1.0e-9));
        }
        CHECK(proxy.n_squeezed() == 0);
    }
}

TEST_CASE("virtual proxy: two plates that close on it push it out sideways") {
    const auto plate = touchable(make_box(Vector3(0.2, 0.02, 0.2)));
    const double tilt = 0.3;
    std::vector<Pose> poses(2);
    poses[1].orientation = Quaternion(AngleAxis(tilt, Vector3::UnitZ()));
    VirtualProxy proxy = make_ball(
        {SolidPlan{.body = 0, .shape = plate, .initial_pose_W = Pose::at(Vector3(0.0, -0.05, 0.0))},
         SolidPlan{.body = 1,
                   .shape = plate,
                   .initial_pose_W = {Vector3(0.0, 0.05, 0.0), poses[1].orientation}}});
    proxy.reset(Vector3::Zero());
    double last = 0.0;
    for (int i = 0; i < 76; ++i) {
        const double half_m = 0.05 - 0.0005 * i;
        poses[0].position = Vector3(0.0, -half_m, 0.0);
        poses[1].position = Vector3(0.0, half_m, 0.0);
        const ProxyContact& contact = proxy.step(Vector3::Zero(), poses);
        for (const Pose& pose : poses) {
            const Vector3 at_B = pose.inverse() * contact.position_W;
            const Vector3 outside = (at_B.cwiseAbs() - Vector3(0.1, 0.01, 0.1)).cwiseMax(0.0);
            REQUIRE(outside.norm() >= kRadius_m * (1.0 - 1.0e-9));
        }
        last = contact.position_W.x();
    }
    CHECK(proxy.n_squeezed() == 0);
    CHECK(last > 0.01);  // where they gape
}

// Cursors that are no balls.

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

TEST_CASE(
    "virtual proxy: a box cursor in a corner touches three walls; a point of a capsule is a ball") {
    const auto room = touchable(make_box(Vector3(1.0, 2.0, 3.0)));
    VirtualProxy proxy(make_obstacles(BoxShape{{0.1, 0.2, 0.3}}, of(room)));
    const ProxyContact& contact = go_down(proxy, Vector3::Zero(), Vector3(0.7, 1.2, 1.9));
    CHECK((contact.position_W - Vector3(0.4, 0.8, 1.2)).norm() <= 1.0e-8);
    CHECK(contact.n_constraints == 3);
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

TEST_CASE("proxy: a list of solids that cannot be touched is refused") {
    CHECK(fits({}));
    CHECK(fits({plate()}));
    CHECK_FALSE(fits(std::vector<SolidPlan>(17, plate())));
    CHECK(fits(std::vector<SolidPlan>(16, plate())));
    CHECK_FALSE(fits({SolidPlan{.body = 3, .shape = MeshShape{}}}));
    SolidPlan nowhere = plate();
    nowhere.initial_pose_W.position.x() = kNan;
    CHECK_FALSE(fits({nowhere}));
    SolidPlan slippery = plate();
    slippery.friction.dynamic_coefficient = 0.5;  // more than the static one
    CHECK_FALSE(fits({slippery}));
    slippery.friction.static_coefficient = 0.5;
    CHECK(fits({slippery}));
    slippery.coupling = CouplingSettings{.stiffness_N_per_m = -1.0};
    CHECK_FALSE(fits({slippery}));
    CHECK_FALSE(fits({plate()}, {.friction_rounds = 0}));
}

TEST_CASE("proxy: a kind takes the cursor made for it, and touches the bodies made for it") {
    const SphereShape ball{0.01};
    CHECK(fits({plate()}, {.kind = ProxyKind::virtual_proxy, .cursor = ball}));
    CHECK_FALSE(fits({plate()}, {.kind = ProxyKind::virtual_proxy}));
    CHECK_FALSE(fits({plate()}, {.kind = ProxyKind::virtual_proxy, .cursor = SphereShape{-0.01}}));
    CHECK_FALSE(fits({plate()}, {.kind = ProxyKind::god_object, .cursor = ball}));
    CHECK(fits({plate()}, {.kind = ProxyKind::friction_cone, .cursor = ball}));
    const auto hull = make_hull_shape({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    const auto ground = make_height_field_shape({});
    REQUIRE(hull);
    REQUIRE(ground);
    const auto of = [](const SolidShape& shape) { return SolidPlan{.body = 1, .shape = shape}; };
    const auto is_god_object = [](const std::vector<SolidPlan>& solids) {
        return dynamic_cast<GodObject*>(make_proxy({}, solids, {}).get()) != nullptr;
    };
    CHECK(is_god_object({plate(), of(*hull), of(*ground)}));
    for (const SolidShape& shape :
         {SolidShape(SphereShape{}), SolidShape(BoxShape{}), SolidShape(CapsuleShape{}),
          SolidShape(CylinderShape{}),
          SolidShape(DistanceShape{std::make_shared<BallFunction>(0.1)})}) {
        CHECK(fits({plate(), of(shape)}));
        CHECK_FALSE(is_god_object({plate(), of(shape)}));
    }
    CHECK_FALSE(fits({of(SphereShape{0.0})}));
    CHECK_FALSE(fits({of(BoxShape{{1.0, -1.0, 1.0}})}));
    CHECK_FALSE(fits({of(CapsuleShape{0.1, -0.1})}));
    CHECK_FALSE(fits({of(CylinderShape{0.1, kNan})}));
    CHECK_FALSE(fits({of(HullShape{})}));
    CHECK_FALSE(fits({of(HeightFieldShape{})}));
    CHECK_FALSE(fits({of(DistanceShape{})}));
    CHECK_FALSE(fits({of(DistanceShape{std::make_shared<BallFunction>(-1.0)})}));
    CHECK_FALSE(fits({of(DistanceShape{std::make_shared<BallFunction>(1.0, -1.0)})}));
    CHECK_FALSE(make_hull_shape({{0, 0, 0}}));
    CHECK_FALSE(make_height_field_shape({.n_x = 7}));
}

TEST_CASE("proxy: the plan's kind is what is made, and nothing where nothing is solid") {
    CHECK(make_proxy({}, {}, {}) == nullptr);
    CHECK(dynamic_cast<GodObject*>(make_proxy({}, {plate()}, {}).get()) != nullptr);
    const ProxySettings ball{.kind = ProxyKind::virtual_proxy, .cursor = SphereShape{0.01}};
    CHECK(dynamic_cast<VirtualProxy*>(make_proxy(ball, {plate()}, {}).get()) != nullptr);
    const auto cone = make_proxy({.kind = ProxyKind::friction_cone}, {plate()}, {});
    CHECK(dynamic_cast<FrictionCone*>(cone.get()) != nullptr);
}

// What every solid of a proxy does with its poses: by itself, as a mesh, and as an obstacle.

TEST_CASE("proxy frame: the proxy goes where the solid takes it, and the same pose takes it not") {
    for_each_frame([](const char* name, auto& frame) {
        CAPTURE(name);
        CHECK_FALSE(frame.take_pose({}));
        frame.put_proxy({0.1, 0.2, 0.3});
        CHECK(frame.take_pose(kPose));
        CHECK((frame.carried_proxy_W() - kPose * Vector3(0.1, 0.2, 0.3)).norm() < 1e-15);
        CHECK_FALSE(frame.take_pose(kPose));
        frame.put_proxy({5.0, 5.0, 5.0});
        CHECK((frame.carried_proxy_W() - Vector3(5.0, 5.0, 5.0)).norm() <= 1.0e-14);
    });
}

TEST_CASE("proxy frame: a pose that is none is ignored, a turn not of unit length is that turn") {
    for_each_frame([](const char* name, auto& frame) {
        CAPTURE(name);
        CHECK(frame.take_pose(kPose));
        frame.put_proxy(kPose * Vector3(0.2, 0.35, 0.1));
        for (const double bad : {std::nan(""), kInfinity}) {
            Pose broken = kPose;
            broken.position.x() = bad;
            CHECK_FALSE(frame.take_pose(broken));
        }
        Pose flat = kPose;
        flat.orientation.coeffs().setZero();
        CHECK_FALSE(frame.take_pose(flat));
        for (const double length : {1e-3, 7.0, 1e6}) {
            Pose longer = kPose;
            longer.orientation.coeffs() *= length;
            CHECK(frame.take_pose(longer));
            CHECK((frame.carried_proxy_W() - kPose * Vector3(0.2, 0.35, 0.1)).norm() < 1e-14);
        }
    });
}
