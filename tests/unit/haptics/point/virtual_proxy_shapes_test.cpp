// Point and ball on solids that are no meshes: where they come to rest is known exactly.
#include "haptics/collision/shape_gap.h"
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
#include <numbers>

namespace fulcrum {
namespace {

const Pose kPose{Vector3(0.7, -0.4, 1.2), Quaternion(AngleAxis(1.1, Vector3(0.6, 0.0, 0.8)))};

CursorShape cursor_of(double radius_m) {
    return radius_m > 0.0 ? CursorShape(SphereShape{radius_m}) : CursorShape();
}

// Comes straight in from `start_B` to the hand and rests; places are in the body's frame.
ProxyContact press(const SolidShape& shape, double radius_m, const Vector3& start_B,
                   const Vector3& hand_B) {
    VirtualProxy proxy(make_obstacles(
        cursor_of(radius_m), {SolidPlan{.body = 0, .shape = shape, .initial_pose_W = kPose}}));
    proxy.reset(kPose * start_B);
    for (int i = 1; i <= 50; ++i) {
        proxy.step(kPose * Vector3(start_B + (hand_B - start_B) * i / 50.0), {});
    }
    for (int i = 0; i < 20; ++i) {
        proxy.step(kPose * hand_B, {});
    }
    ProxyContact contact = proxy.contact();
    contact.position_W = kPose.inverse() * contact.position_W;
    return contact;
}

TEST_CASE("virtual proxy: round bodies hold it over the hand's direction, settled in one step") {
    for (const double radius_m : {0.0, 0.02, 0.5}) {
        const SphereShape sphere{0.1};
        Random random(2);
        for (int i = 0; i < 50; ++i) {
            const Vector3 hand = 0.09 * random.direction();
            const Vector3 start = 1.5 * (hand.normalized() + 0.5 * random.in_cube());
            const ProxyContact contact = press(sphere, radius_m, start, hand);
            CHECK((contact.position_W - (0.1 + radius_m) * hand.normalized()).norm() <= 1e-7);
        }
        // Beside the capsule's middle part, and round its end.
        const CapsuleShape capsule{0.1, 0.2};
        const ProxyContact beside = press(capsule, radius_m, {2.0, 0.3, 0.4}, {0.06, 0.1, 0.08});
        CHECK((beside.position_W - Vector3(0.6 * (0.1 + radius_m), 0.1, 0.8 * (0.1 + radius_m)))
                  .norm() <= 1e-7);
        const ProxyContact end = press(capsule, radius_m, {1.0, 1.0, 0.0}, {0.03, 0.24, 0.0});
        CHECK((end.position_W - Vector3(0.6 * (0.1 + radius_m), 0.2 + 0.8 * (0.1 + radius_m), 0.0))
                  .norm() <= 1e-7);
    }
    // What a tangent plane leaves of the error shrinks by depth over radius, 0.9, a round: alone, 150 rounds.
    for (const double radius_m : {0.0, 0.05}) {
        const double place_m = 0.1 + radius_m;
        VirtualProxy proxy(
            make_obstacles(cursor_of(radius_m), {SolidPlan{.body = 0, .shape = SphereShape{0.1}}}));
        proxy.reset(Vector3(0.0, 2.0 * place_m, 0.0));
        for (int i = 0; i < 20; ++i) {
            const Vector3 u(std::sin(0.05 * i), std::cos(0.05 * i), 0.0);
            const ProxyContact& contact = proxy.step(0.1 * place_m * u, {});
            REQUIRE((contact.position_W - place_m * u).norm() <= 1e-7 * place_m);
            REQUIRE(proxy.n_casts() <= 12);
        }
    }
}

TEST_CASE("virtual proxy: on a box and a cylinder it is over the face that it came through") {
    for (const double radius_m : {0.0, 0.02, 0.5}) {
        const BoxShape box{{0.1, 0.2, 0.3}};
        const ProxyContact face = press(box, radius_m, {1.0, 0.1, 0.2}, {0.05, 0.12, -0.2});
        CHECK((face.position_W - Vector3(0.1 + radius_m, 0.12, -0.2)).norm() <= 1e-9);
        CHECK(face.n_constraints == 1);
        CHECK((face.normal_W - kPose.orientation * Vector3::UnitX()).norm() < 1e-8);
        const CylinderShape cylinder{0.1, 0.2};
        const ProxyContact end = press(cylinder, radius_m, {0.0, 1.0, 0.0}, {0.02, 0.15, 0.01});
        CHECK((end.position_W - Vector3(0.02, 0.2 + radius_m, 0.01)).norm() <= 1e-9);
        const ProxyContact side = press(cylinder, radius_m, {1.0, 0.05, 0.0}, {0.03, 0.05, 0.04});
        CHECK((side.position_W - Vector3(0.6 * (0.1 + radius_m), 0.05, 0.8 * (0.1 + radius_m)))
                  .norm() <= 1e-7);
    }
    // Round the rim, by a ball whose middle is over neither.
    const ProxyContact rim =
        press(CylinderShape{0.1, 0.2}, 0.1, {0.5, 0.6, 0.0}, {0.13, 0.24, 0.0});
    CHECK((rim.position_W - Vector3(0.16, 0.28, 0.0)).norm() <= 1e-7);
}

TEST_CASE("virtual proxy: a box of its own and one of triangles hold it alike") {
    const Vector3 half(0.1, 0.15, 0.2);
    const auto mesh = touchable(make_box(2.0 * half));
    for (const double radius_m : {0.0, 0.03}) {
        VirtualProxy shape(
            make_obstacles(cursor_of(radius_m), {SolidPlan{.body = 0, .shape = BoxShape{half}}}));
        VirtualProxy triangles(make_obstacles(cursor_of(radius_m), only_solid(mesh)));
        Wanderer wanderer(3, 0.02);
        const Vector3 start = 0.5 * wanderer.next();
        shape.reset(start);
        triangles.reset(start);
        for (int i = 0; i < 4000; ++i) {
            const Vector3 hand = wanderer.next() * (0.2 + 0.1 * std::sin(0.01 * i));
            const Vector3 here = shape.step(hand, {}).position_W;
            const Vector3 there = triangles.step(hand, {}).position_W;
            // Where it goes round an edge the two may take it at different steps.
            REQUIRE(std::abs((here - hand).norm() - (there - hand).norm()) <= 2.0e-3);
            REQUIRE(find_gap(BoxShape{half}, here).gap_m >= radius_m * (1.0 - 1e-9));
            REQUIRE(find_gap(BoxShape{half}, there).gap_m >= radius_m * (1.0 - 1e-9));
        }
    }
}

TEST_CASE("virtual proxy: a thin shape that flies or turns at any speed never gets over it") {
    const std::vector<SolidShape> shapes{
        BoxShape{{0.2, 0.5e-4, 0.2}}, CylinderShape{0.2, 0.5e-4}, CapsuleShape{0.5e-4, 0.2},
        DistanceShape{std::make_shared<PlateFunction>(0.2, 0.5e-4)}};
    for (const SolidShape& shape : shapes) {
        for (const double radius_m : {0.0, 0.005}) {
            Random random(4);
            for (int run = 0; run < 30; ++run) {
                // From one side to the other through a still hand, at 5 m/s, tilted.
                const Quaternion turn = random.turn(0.3);
                const Vector3 normal_W = turn * Vector3::UnitY();
                std::vector<SolidPlan> plan{SolidPlan{
                    .body = 0, .shape = shape, .initial_pose_W = {-0.1 * Vector3::UnitY(), turn}}};
                VirtualProxy proxy(make_obstacles(cursor_of(radius_m), plan));
                proxy.reset(Vector3::Zero());
                bool touched = false;
                for (int i = 0; i < 40; ++i) {
                    const Pose pose{Vector3(0.0, -0.1 + 0.005 * i, 0.0), turn};
                    const ProxyContact& contact = proxy.step(Vector3::Zero(), std::span(&pose, 1));
                    touched = touched || contact.n_constraints > 0;
                    // A rod may go by; a plate may not.
                    if (!std::holds_alternative<CapsuleShape>(shape)) {
                        REQUIRE(normal_W.dot(contact.position_W - pose.position) >= radius_m);
                    }
                }
                CHECK((touched || radius_m == 0.0));
                CHECK(proxy.n_squeezed() == 0);
            }
        }
    }
}

TEST_CASE("virtual proxy: a distance function holds it where its surface is") {
    for (const double radius_m : {0.0, 0.02}) {
        for (const double bound : {1.0, 1.7, 5.0}) {
            if (bound > 1.0 && radius_m > 0.0) {
                continue;  // what a ball touches is known for distances only
            }
            const auto ball = std::make_shared<BallFunction>(0.1, 3.0, bound);
            Random random(6);
            for (int i = 0; i < 30; ++i) {
                const Vector3 hand = 0.08 * random.direction();
                const Vector3 start = 0.5 * (hand.normalized() + 0.5 * random.in_cube());
                const ProxyContact contact = press(DistanceShape{ball}, radius_m, start, hand);
                // The function tells slope times distance, so the ball of the cursor counts by that.
                const double place_m = 0.1 + radius_m;
                INFO("bound " << bound << " radius " << radius_m);
                CHECK((contact.position_W - place_m * hand.normalized()).norm() <= 1e-6);
            }
        }
        // In a ring's hole, on its inner side, and along it.
        const auto ring = std::make_shared<RingFunction>(1.0, 0.3);
        const ProxyContact inner =
            press(DistanceShape{ring}, radius_m, {0.1, 0.02, 0.0}, {0.9, 0.0, 0.0});
        CHECK((inner.position_W - Vector3(0.7 - radius_m, 0.0, 0.0)).norm() <= 1e-5);
    }
}

TEST_CASE("virtual proxy: it slides over a ring as its distance function says, and never gets in") {
    const auto ring = std::make_shared<RingFunction>(1.0, 0.3);
    VirtualProxy proxy(
        make_obstacles(SphereShape{0.05}, {SolidPlan{.body = 0, .shape = DistanceShape{ring}}}));
    proxy.reset(Vector3(1.0, 0.5, 0.0));
    double worst_m = 0.0;
    for (int i = 0; i < 6000; ++i) {
        const double round = 0.004 * i;
        const double about = 0.5 * std::numbers::pi + 0.0013 * i;
        const Vector3 out(std::cos(round), 0.0, std::sin(round));
        const Vector3 across = std::cos(about) * out + std::sin(about) * Vector3::UnitY();
        const Vector3 hand = out + 0.32 * across;
        const Vector3 place = out + 0.35 * across;
        const ProxyContact& contact = proxy.step(hand, {});
        REQUIRE(ring->at(contact.position_W).value >= 0.05);
        REQUIRE(contact.n_constraints == 1);
        worst_m = std::max(worst_m, (contact.position_W - place).norm());
    }
    CHECK(worst_m <= 2.0e-5);
}

TEST_CASE("virtual proxy: hulls and height fields are touched as their triangles") {
    const auto hull = make_hull_shape({{-1, 0, -1}, {1, 0, -1}, {0, 0, 1}, {0, 1, 0}, {0, 0.2, 0}});
    REQUIRE(hull);
    const ProxyContact below = press(*hull, 0.1, {0.0, -1.0, 0.0}, {0.1, 0.1, 0.1});
    CHECK((below.position_W - Vector3(0.1, -0.1, 0.1)).norm() <= 1e-9);
    const auto ground =
        make_height_field_shape({.n_x = 3, .n_z = 2, .heights_m = {0.5, 0, 0.5, 0.5, 0, 0.5}});
    REQUIRE(ground);
    // In the valley, on both slopes of 45 degrees; and hung up below it.
    const ProxyContact valley = press(*ground, 0.1, {0.0, 1.0, 0.0}, {0.0, -0.2, 0.1});
    CHECK((valley.position_W - Vector3(0.0, 0.1 * std::numbers::sqrt2, 0.1)).norm() <= 1e-8);
    const ProxyContact keel = press(*ground, 0.1, {0.0, -1.0, 0.0}, {0.0, -0.05, 0.1});
    CHECK((keel.position_W - Vector3(0.0, -0.1, 0.1)).norm() <= 1e-7);
}

}  // namespace
}  // namespace fulcrum
