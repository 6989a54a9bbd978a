// Friction of cursors, a point and such that have a shape: they stick, slide and are carried alike, for friction knows planes alone.
#include "haptics/geometry/shape.h"
#include "haptics/point/make_proxy.h"
#include "tests/support/touchable.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <memory>
#include <vector>

namespace fulcrum {
namespace {

constexpr double kExact_m = 1.0e-8;  // clearances of a floor of some metres, and rounding

struct Cursor {
    CursorShape shape;
    double height_m;  // its middle's when it stands on a floor
    double width_m;   // its middle's from a wall across x
    double slides_m = 1.0e-6;
};

std::vector<Cursor> cursors() {
    return {{CursorShape{}, 0.0, 0.0, 2.0e-9},
            {SphereShape{0.03}, 0.03, 0.03},
            {BoxShape{{0.05, 0.02, 0.04}}, 0.02, 0.05},
            {CapsuleShape{0.02, 0.06}, 0.08, 0.02},
            {CylinderShape{0.05, 0.02}, 0.02, 0.05}};
}

std::vector<SolidShape> floors() {
    return {touchable(make_plate(4.0, 4.0, 7)), BoxShape{{2.0, 1.0e-12, 2.0}}};
}

SolidPlan rough(const SolidShape& shape, double mu_static, double mu_dynamic,
                const Pose& pose_W = {}) {
    return {.body = 0,
            .shape = shape,
            .initial_pose_W = pose_W,
            .friction = {mu_static, mu_dynamic, 0.0}};
}

std::unique_ptr<Proxy> make_cone(const CursorShape& cursor, const std::vector<SolidPlan>& solids) {
    return make_proxy({.kind = ProxyKind::friction_cone, .cursor = cursor}, solids, {});
}

Vector3 held_off(const ProxyContact& contact) {
    Vector3 sum = Vector3::Zero();
    for (const SolidTouch& touch : contact.active()) {
        sum += touch.push_m * touch.normal_W + touch.drag_W;
    }
    return sum;
}

TEST_CASE("friction cone: a cursor of any shape sticks up to the static circle, then slides") {
    constexpr double kDepth_m = 0.01;
    for (const Cursor& cursor : cursors()) {
        for (const SolidShape& floor : floors()) {
            const auto proxy = make_cone(cursor.shape, {rough(floor, 0.6, 0.4)});
            const double press_y = cursor.height_m - kDepth_m;
            proxy->reset({0.2, 0.3, 0.1});
            proxy->step({0.2, press_y, 0.1}, {});
            double largest_stuck = 0.0;
            for (int i = 1; i <= 1500; ++i) {
                const Vector3 hand(0.2 + 0.6e-5 * i, press_y, 0.1 - 0.8e-5 * i);
                const ProxyContact& contact = proxy->step(hand, {});
                const Vector3 drag = contact.position_W - hand;
                const double ratio = std::hypot(drag.x(), drag.z()) / drag.y();
                REQUIRE((contact.normal_W - Vector3::UnitY()).norm() <= 1.0e-12);
                REQUIRE(std::abs(drag.y() - kDepth_m) <= kExact_m);
                REQUIRE((held_off(contact) - drag).norm() <= kExact_m);
                if (std::hypot(contact.position_W.x() - 0.2, contact.position_W.z() - 0.1) <
                    kExact_m) {
                    largest_stuck = ratio;
                } else {
                    // Against the slip, and of the dynamic coefficient.
                    REQUIRE(std::abs(ratio - 0.4) <= 1.0e-6);
                    REQUIRE(std::abs(drag.x() / drag.z() + 0.75) <= 1.0e-5);
                }
            }
            CHECK(largest_stuck > 0.598);
            CHECK(largest_stuck <= 0.6002);
        }
    }
}

TEST_CASE("friction cone: a floor that moves takes a cursor of any shape along") {
    for (const Cursor& cursor : cursors()) {
        for (const SolidShape& floor : floors()) {
            for (const double coefficient : {0.0, 0.3}) {
                const auto proxy =
                    make_cone(cursor.shape, {rough(floor, coefficient, coefficient)});
                const Vector3 hand(0.0, cursor.height_m - 0.01, 0.0);
                proxy->reset({0.0, 0.3, 0.0});
                proxy->step(hand, {});
                for (int i = 1; i <= 100; ++i) {
                    const Pose pose = Pose::at({0.0, 0.0, -1.0e-4 * i});
                    const Vector3 at_W = proxy->step(hand, std::span(&pose, 1)).position_W;
                    REQUIRE(std::abs(at_W.z() + std::min(1.0e-4 * i, 0.01 * coefficient)) <=
                            cursor.slides_m);
                    REQUIRE(std::abs(at_W.x()) <= kExact_m);
                }
            }
        }
    }
}

TEST_CASE("friction cone: a cursor of any shape slides along floor and wall by the drags of both") {
    for (const Cursor& cursor : cursors()) {
        const SolidPlan floor = rough(BoxShape{{2.0, 1.0, 2.0}}, 0.5, 0.5, Pose::at({0, -1.0, 0}));
        SolidPlan wall = rough(BoxShape{{1.0, 2.0, 2.0}}, 0.1, 0.1, Pose::at({1.0, 0.0, 0.0}));
        wall.body = 1;
        const std::array poses{floor.initial_pose_W, wall.initial_pose_W};
        const auto proxy = make_cone(cursor.shape, {floor, wall});
        proxy->reset({-0.4, 0.4, 0.0});
        proxy->step({-0.3, 0.3, 0.0}, poses);
        // 0.02 m under the floor, 0.01 m behind the wall.
        const Vector3 press(-cursor.width_m + 0.01, cursor.height_m - 0.02, 0.0);
        ProxyContact contact;
        Vector3 hand;
        for (int i = 0; i <= 400; ++i) {
            hand = press + 2.0e-4 * i * Vector3::UnitZ();
            contact = proxy->step(hand, poses);
        }
        REQUIRE(contact.n_constraints == 2);
        CHECK(
            (contact.position_W - (hand + Vector3(-0.01, 0.02, -0.5 * 0.02 - 0.1 * 0.01))).norm() <=
            1.0e-6);
        for (const SolidTouch& touch : contact.active()) {
            const double coefficient = touch.solid == 0 ? 0.5 : 0.1;
            CHECK(std::abs(touch.drag_W.norm() - coefficient * touch.push_m) <= 1.0e-6);
        }
    }
}

TEST_CASE("friction cone: on the side of a capsule cursor's edge friction is that of the slope") {
    // A ridge along z, both sides at 45 degrees, and a capsule laid over one of them by its lower end.
    const double slope = 0.25 * 3.14159265358979323846;
    const Quaternion turn(AngleAxis(slope, Vector3::UnitZ()));
    const SolidPlan ramp = rough(BoxShape{{2.0, 1.0, 2.0}}, 0.3, 0.3, Pose{Vector3::Zero(), turn});
    const Vector3 normal = turn * Vector3::UnitY();
    const Vector3 down = -(turn * Vector3::UnitX());
    const CapsuleShape capsule{0.02, 0.06};
    // Its lower end's centre is a radius over the ramp.
    const Vector3 on_ramp =
        normal * (1.0 + capsule.radius_m) + capsule.half_length_m * Vector3::UnitY();
    const auto proxy = make_cone(capsule, {ramp});
    const std::array poses{ramp.initial_pose_W};
    proxy->reset(on_ramp + 0.1 * normal);
    for (int i = 0; i <= 200; ++i) {
        const Vector3 hand = on_ramp - 0.01 * normal + 5.0e-5 * i * down;
        const ProxyContact& contact = proxy->step(hand, poses);
        const Vector3 off = contact.position_W - hand;
        REQUIRE(std::abs(off.dot(normal) - 0.01) <= 1.0e-7);
        REQUIRE(std::abs(off.dot(down) + std::min(5.0e-5 * i, 0.003)) <= 1.0e-6);
    }
}

}  // namespace
}  // namespace fulcrum
