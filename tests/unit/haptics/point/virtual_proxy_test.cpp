#include "haptics/point/virtual_proxy.h"

#include "haptics/geometry/shape.h"
#include "haptics/point/make_obstacle.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace fulcrum {
namespace {

constexpr double kRadius_m = 0.01;

VirtualProxy make_ball(const std::vector<SolidPlan>& solids) {
    return VirtualProxy(make_obstacles(SphereShape{kRadius_m}, solids));
}

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

}  // namespace
}  // namespace fulcrum
