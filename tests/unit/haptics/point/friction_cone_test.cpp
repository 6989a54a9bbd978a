#include "haptics/point/friction_cone.h"

#include "haptics/geometry/shape.h"
#include "haptics/point/make_proxy.h"
#include "tests/support/touchable.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <memory>
#include <vector>

using namespace fulcrum;

namespace {

constexpr double kExact = 2.0e-9;  // clearance of a plate of some metres, and rounding
constexpr FrictionSettings kFriction{0.6, 0.4, 0.0};

SolidPlan plate(const FrictionSettings& friction = kFriction) {
    return {.body = 1, .shape = touchable(make_plate(4.0, 4.0, 3)), .friction = friction};
}
std::unique_ptr<Proxy> cone(const std::vector<SolidPlan>& solids, double stiffness = 500.0) {
    return make_proxy({.kind = ProxyKind::friction_cone}, solids,
                      {{.stiffness_N_per_m = stiffness}, 0.001});
}
Vector3 lying(const ProxyContact& contact) {
    Vector3 sum = Vector3::Zero();
    for (const SolidTouch& touch : contact.active()) {
        sum += touch.push_m * touch.normal_W + touch.drag_W;
    }
    return sum;
}

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

}  // namespace

TEST_CASE("friction cone: sliding turns into sticking when the hand turns back, unwound first") {
    const auto proxy = cone({plate()});
    proxy->reset({0.0, 0.01, 0.0});
    proxy->step({0.0, -0.01, 0.0}, {});
    proxy->step({0.02, -0.01, 0.0}, {});
    const double held_x = proxy->step({0.02, -0.01, 0.0}, {}).position_W.x();
    CHECK(std::abs(held_x - 0.016) <= kExact);
    // From +0.4 through to -0.6 of the push nothing moves.
    for (const double x : {0.018, 0.014, 0.0101}) {
        CHECK(std::abs(proxy->step({x, -0.01, 0.0}, {}).position_W.x() - held_x) <= kExact);
    }
    CHECK(proxy->step({0.0098, -0.01, 0.0}, {}).position_W.x() < held_x - 1.0e-3);
}

TEST_CASE("friction cone: with viscosity alone the drag is b times the speed of the slip") {
    const double viscous = 5.0;
    const double stiffness = 500.0;
    const auto proxy = cone({plate({0.0, 0.0, viscous})}, stiffness);
    proxy->reset({0.0, 0.01, 0.0});
    proxy->step({0.0, -0.01, 0.0}, {});
    const double speed_m_per_s = 0.1;
    double lag_m = 0.0;
    double told_m = 0.0;
    for (int i = 1; i <= 1000; ++i) {
        const double x = 0.001 * speed_m_per_s * i;
        const ProxyContact& contact = proxy->step({x, -0.01, 0.0}, {});
        lag_m = x - contact.position_W.x();
        told_m = contact.touches[0].viscous_m;
    }
    CHECK(std::abs(stiffness * lag_m - viscous * speed_m_per_s) <= 1.0e-6);
    CHECK(told_m == Approx(lag_m));
}

TEST_CASE("friction cone: what turns under a still hand carries it round to the circle's edge") {
    const auto proxy = cone({plate({0.5, 0.5, 0.0})});
    const Vector3 hand(0.5, -0.01, 0.0);
    proxy->reset({0.5, 0.01, 0.0});
    proxy->step(hand, {});
    for (int i = 1; i <= 200; ++i) {
        const Pose pose{Vector3::Zero(), Quaternion(AngleAxis(1.0e-3 * i, Vector3::UnitY()))};
        const Vector3 p = proxy->step(hand, {&pose, 1}).position_W;
        REQUIRE(std::hypot(p.x() - 0.5, p.z()) <= 0.005 + kExact);
    }
    const Pose pose{Vector3::Zero(), Quaternion(AngleAxis(0.2, Vector3::UnitY()))};
    CHECK(std::abs(proxy->step(hand, {&pose, 1}).position_W.z() + 0.005) <= 1.0e-4);
}

TEST_CASE("friction cone: off the edge of a box nothing holds the proxy back") {
    const SolidPlan box{
        .body = 0, .shape = touchable(make_box(Vector3::Ones())), .friction = {2.0, 2.0, 0.0}};
    const auto proxy = cone({box});
    proxy->reset({0.0, 0.6, 0.0});
    proxy->step({0.0, 0.45, 0.0}, {});
    const Vector3 beside(0.7, 0.45, 0.0);
    const ProxyContact& contact = proxy->step(beside, {});
    CHECK(contact.solid == kNoBody);
    CHECK((contact.position_W - beside).norm() == 0.0);
}

TEST_CASE("friction cone: on a ball of triangles drag is a share of the push all the way round") {
    const SolidPlan ball{
        .body = 0, .shape = touchable(make_sphere(1.0, 60)), .friction = {0.3, 0.3, 0.0}};
    const auto proxy = cone({ball});
    proxy->reset({1.2, 0.0, 0.0});
    double worst = 0.0;
    for (int i = 0; i < 4000; ++i) {
        const double angle = 0.002 * i;
        const Vector3 hand =
            0.98 * Vector3(std::cos(angle), 0.3 * std::sin(angle), std::sin(angle)).normalized();
        const ProxyContact& contact = proxy->step(hand, {});
        const Vector3 radial = contact.position_W.normalized();
        const Vector3 pull = contact.position_W - hand;
        const double push_m = pull.dot(radial);
        if (i > 100) {
            worst = std::max(worst, std::abs((pull - push_m * radial).norm() / push_m - 0.3));
        }
    }
    // A facet leans up to 0.6 degrees away from the ball.
    CHECK(worst <= 0.015);
}

TEST_CASE("friction cone: two solids at once each get their own push and drag") {
    SolidPlan floor = plate({0.5, 0.5, 0.0});
    SolidPlan wall{.body = 7,
                   .shape = touchable(make_box(Vector3::Ones())),
                   .initial_pose_W = Pose::at({0.5, 0.5, 0.0}),
                   .friction = {0.1, 0.1, 0.0}};
    const auto proxy = cone({floor, wall});
    const std::array poses{Pose{}, wall.initial_pose_W};
    proxy->reset({-0.2, 0.2, 0.0});
    proxy->step({-0.2, 0.2, 0.0}, poses);
    proxy->step({-0.01, -0.02, 0.0}, poses);
    // On the way it goes from one triangle of the floor to the next: whose drag it is does not depend on that.
    for (int i = 0; i <= 1600; ++i) {
        const ProxyContact& there = proxy->step({0.01, -0.02, -0.4 + 0.0005 * i}, poses);
        for (const SolidTouch& touch : i < 10 ? std::span<const SolidTouch>() : there.active()) {
            const double coefficient = touch.solid == 0 ? 0.5 : 0.1;
            REQUIRE(touch.drag_W.norm() <= coefficient * touch.push_m + 1.0e-6);
        }
    }
    proxy->step({0.01, -0.02, 0.1}, poses);
    for (int i = 0; i <= 100; ++i) {
        proxy->step({0.01, -0.02, 0.1 + 0.0005 * i}, poses);
    }
    const ProxyContact& contact = proxy->step({0.01, -0.02, 0.1505}, poses);
    REQUIRE(contact.n_constraints == 2);
    const SolidTouch& on_floor = contact.touches[contact.touches[0].solid == 0 ? 0 : 1];
    const SolidTouch& on_wall = contact.touches[contact.touches[0].solid == 0 ? 1 : 0];
    CHECK(on_wall.solid == 1);
    CHECK(contact.solid == 0);
    CHECK(std::abs(on_floor.drag_W.z() + 0.5 * on_floor.push_m) <= 1.0e-6);
    CHECK(std::abs(on_wall.drag_W.z() + 0.1 * on_wall.push_m) <= 1.0e-6);
    CHECK((lying(contact) - (contact.position_W - Vector3(0.01, -0.02, 0.1505))).norm() <= kExact);
}

TEST_CASE("friction cone: in a groove of one solid push and drag are all that holds the proxy") {
    // Two plates that meet along z at right angles, both at 45 degrees.
    const double h = std::sqrt(0.5);
    const auto mesh = touchable(TriangleMesh::build(
        {{-h, h, -1.0}, {0.0, 0.0, -1.0}, {h, h, -1.0}, {-h, h, 1.0}, {0.0, 0.0, 1.0}, {h, h, 1.0}},
        {{0, 3, 4}, {0, 4, 1}, {1, 4, 5}, {1, 5, 2}}));
    const auto proxy = cone({SolidPlan{.body = 0, .shape = mesh, .friction = kFriction}});
    proxy->reset({0.0, 0.1, -0.5});
    int n_corner = 0;
    for (int i = 0; i < 1000; ++i) {
        const Vector3 hand(0.03 * std::sin(0.02 * i), -0.02 + 0.03 * std::sin(0.005 * i),
                           -0.5 + 0.001 * i);
        const ProxyContact& contact = proxy->step(hand, {});
        REQUIRE((lying(contact) - (contact.position_W - hand)).norm() <= kExact);
        for (const SolidTouch& touch : contact.active()) {
            // What slides along a groove has the drag of both its sides; each is within its own circle.
            REQUIRE(touch.drag_W.norm() <= 0.6 * touch.push_m + 5.0e-4);
        }
        n_corner += contact.n_constraints == 2 ? 1 : 0;
    }
    CHECK(n_corner > 100);
}

TEST_CASE("friction cone: without friction it is the god-object, to the bit") {
    const SolidPlan ball{.body = 0, .shape = touchable(make_sphere(1.0, 20))};
    const auto plain = make_proxy({}, {ball}, {});
    const auto proxy = cone({ball});
    plain->reset({0.0, 1.2, 0.0});
    proxy->reset({0.0, 1.2, 0.0});
    for (int i = 0; i < 1000; ++i) {
        const Vector3 hand = Vector3(std::sin(0.005 * i), 1.1 - 0.0003 * i, 0.1);
        REQUIRE(proxy->step(hand, {}).position_W == plain->step(hand, {}).position_W);
    }
}

TEST_CASE("friction cone: a hand that is not a number is not followed, and leaves no trace") {
    const auto proxy = cone({plate()});
    proxy->reset({0.0, 0.01, 0.0});
    const Vector3 before = proxy->step({0.0, -0.01, 0.0}, {}).position_W;
    const double nan = std::nan("");
    CHECK(proxy->step({nan, 0.0, 0.0}, {}).position_W == before);
    // What slid before goes on as what slid, and what stuck as what stuck.
    const auto& state = dynamic_cast<const FrictionCone&>(*proxy);
    CHECK(state.is_stuck(0));
    CHECK(proxy->step({0.001, -0.01, 0.0}, {}).position_W.allFinite());
    CHECK(std::abs(proxy->step({0.001, -0.01, 0.0}, {}).position_W.x()) <= kExact);
    proxy->step({0.02, -0.01, 0.0}, {});
    REQUIRE_FALSE(state.is_stuck(0));
    proxy->step({nan, 0.0, 0.0}, {});
    CHECK_FALSE(state.is_stuck(0));
}

// Friction of cursors, a point and such that have a shape: they stick, slide and are carried alike, for friction knows planes alone.

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
                REQUIRE((lying(contact) - drag).norm() <= kExact_m);
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

TEST_CASE(
    "friction cone: a cursor of any shape goes with a floor, slides by floor's and wall's drag") {
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
