// Cursors that turn with the hand, and bodies that turn under them.
#include "haptics/collision/convex_cursor.h"
#include "haptics/collision/convex_mesh_obstacle.h"
#include "haptics/geometry/height_field.h"
#include "haptics/geometry/shape.h"
#include "haptics/point/make_obstacle.h"
#include "haptics/point/make_proxy.h"
#include "haptics/point/virtual_proxy.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace fulcrum;

namespace {

constexpr double kRounded = 1.0e-3;  // of a cursor's least half size: its corners
// A box that a thing 1 mm in size is felt with, and bodies of some metres: what rounding leaves of places.
constexpr double kPlace_m = 1.0e-9;

std::vector<SolidPlan> of(const SolidShape& shape, const Pose& pose_W = {}) {
    return {SolidPlan{.body = 0, .shape = shape, .initial_pose_W = pose_W}};
}

CursorTurning reach_of(const CursorShape& cursor, double stiffness_N_per_m = 500.0) {
    const ConvexBody body = make_convex_cursor(*to_solid_shape(cursor));
    return {find_least_reach_m(body), body.core.bounding_radius_m(), stiffness_N_per_m, 0.001};
}

VirtualProxy make(const CursorShape& cursor, const std::vector<SolidPlan>& solids) {
    return VirtualProxy(make_obstacles(cursor, solids), reach_of(cursor));
}

// Where the cursor is then.
Pose go(VirtualProxy& proxy, const Pose& hand_W, std::span<const Pose> solids = {}) {
    const Quaternion turn_W = proxy.turn(hand_W.orientation);
    return {proxy.step(hand_W.position, solids).position_W, turn_W};
}

double turned_rad(const Pose& cursor_W, const Quaternion& from_W = Quaternion::Identity()) {
    return cursor_W.orientation.angularDistance(from_W);
}

// Asked of every triangle, by a cursor that knows of no turn before.
bool overlaps(const std::shared_ptr<const CollisionMesh>& mesh, const CursorShape& cursor,
              const Pose& cursor_B) {
    ConvexMeshObstacle fresh(mesh, make_convex_cursor(*to_solid_shape(cursor)));
    fresh.turn(cursor_B.orientation.toRotationMatrix().transpose());
    fresh.keep_turn();
    return fresh.find_nearest(cursor_B.position, 0.0) != -1;
}

std::vector<CursorShape> shaped_cursors() {
    const auto hull =
        make_hull_shape({{-0.01, 0, 0}, {0.01, 0, 0}, {0, 0, 0.01}, {0, -0.02, 0}, {0, 0.01, 0}});
    return {BoxShape{{0.01, 0.02, 0.015}}, CylinderShape{0.01, 0.02}, CapsuleShape{0.01, 0.02},
            hull.value()};
}

}  // namespace

TEST_CASE("turned cursor: in the air it is where the hand is, turned as that is") {
    const auto floor = of(touchable(make_plate(4.0, 4.0, 4)));
    VirtualProxy box = make(BoxShape{{0.01, 0.02, 0.03}}, floor);
    VirtualProxy ball = make(SphereShape{0.01}, floor);
    Random random(3);
    Pose hand = Pose::at(Vector3(0.0, 0.5, 0.0));
    box.reset(hand.position);
    for (int i = 0; i < 200; ++i) {
        hand.position += 0.001 * random.in_cube();
        hand.orientation = random.turn(0.09) * hand.orientation;
        const Pose cursor_W = go(box, hand);
        REQUIRE(cursor_W.position == hand.position);
        REQUIRE(turned_rad(cursor_W, hand.orientation) < 1.0e-12);
    }
    // From there a turn of half a circle takes 31 rounds, and one that is no number none.
    hand.orientation =
        Quaternion(AngleAxis(std::numbers::pi - 0.01, Vector3::UnitX())) * hand.orientation;
    double left_rad = std::numbers::pi - 0.01;
    while (left_rad > 0.0) {
        left_rad = std::max(left_rad - VirtualProxy::kMostTurn_rad, 0.0);
        REQUIRE(turned_rad(go(box, hand), hand.orientation) == Approx(left_rad).margin(1.0e-9));
    }
    CHECK(box.turn({kNan, 0.0, 0.0, 0.0}).angularDistance(hand.orientation) < 1.0e-12);
    // Put elsewhere it is turned at once.
    box.reset(Vector3(0.0, 1.0, 0.0));
    CHECK(turned_rad(go(box, Pose::at(Vector3(0.0, 1.0, 0.0)))) < 1.0e-12);
    // A ball is as the hand, at once.
    CHECK(turned_rad(go(ball, hand), hand.orientation) == 0.0);
}

TEST_CASE("turned cursor: a box on a plane is as high as it reaches down, however it turns") {
    const Vector3 half(0.001, 0.0006, 0.0008);
    const double rounded_m = kRounded * half.minCoeff();
    const std::vector<SolidShape> floors{
        touchable(make_plate(4.0, 4.0, 20)), SolidShape(BoxShape{{2.0, 1.0e-12, 2.0}}),
        *make_height_field_shape({.width_m = 4.0,
                                  .depth_m = 4.0,
                                  .n_x = 9,
                                  .n_z = 9,
                                  .heights_m = std::vector<double>(81, 0.0)})};
    for (const SolidShape& floor : floors) {
        VirtualProxy proxy = make(BoxShape{half}, of(floor));
        Random random(17);
        Pose hand = Pose::at(Vector3(0.01, 0.003, 0.02));
        proxy.reset(hand.position);
        for (int i = 0; i < 2000; ++i) {
            const bool is_in = i >= 30;
            hand.position.y() = is_in ? -0.0005 : 0.003 - 1.2e-4 * i;
            if (is_in) {
                hand.orientation = random.turn(0.09) * hand.orientation;
            }
            const Pose cursor_W = go(proxy, hand);
            if (!is_in) {
                continue;
            }
            const Vector3 down = hand.orientation.conjugate() * Vector3::UnitY();
            const double sharp_m = half.dot(down.cwiseAbs());
            const double reach_m =
                (half - Vector3::Constant(rounded_m)).dot(down.cwiseAbs()) + rounded_m;
            INFO("floor " << floor.index() << ", round " << i);
            REQUIRE(turned_rad(cursor_W, hand.orientation) < 1.0e-9);
            REQUIRE(cursor_W.position.y() == Approx(reach_m).margin(kPlace_m));
            REQUIRE(cursor_W.position.y() == Approx(sharp_m).margin(1.0e-6));
            REQUIRE((proxy.contact().normal_W - Vector3::UnitY()).norm() < 1.0e-6);
            // It is pushed straight up.
            REQUIRE((cursor_W.position - hand.position).cwiseProduct(Vector3(1, 0, 1)).norm() <
                    kPlace_m);
        }
    }
}

TEST_CASE("turned cursor: turned as fast as may be beside a wall it is never in it nor behind") {
    const auto wall = touchable(make_box(Vector3(0.4, 1.0e-4, 0.4)));
    for (const CursorShape& cursor : shaped_cursors()) {
        Random random(21);
        for (int run = 0; run < 10; ++run) {
            VirtualProxy proxy = make(cursor, of(wall));
            const Vector3 axis = random.direction();
            const double turn_rad = run % 2 == 0 ? 0.1 : 0.013;
            Pose hand = Pose::at(Vector3(0.0, 0.05, 0.0));
            proxy.reset(hand.position);
            double last_m = 0.05;
            for (int i = 0; i < 400; ++i) {
                hand.position = Vector3(0.02 * std::sin(0.03 * i),
                                        0.012 + 0.02 * std::cos(0.05 * i), 0.01 * random.uniform());
                hand.orientation = Quaternion(AngleAxis(turn_rad * i, axis));
                const Pose cursor_W = go(proxy, hand);
                INFO("cursor " << cursor.index() << ", run " << run << ", round " << i);
                REQUIRE(cursor_W.position.y() > 0.0);
                REQUIRE_FALSE(overlaps(wall, cursor, cursor_W));
                last_m = cursor_W.position.y();
            }
            CHECK(last_m > 0.0);
            CHECK(proxy.n_squeezed() == 0);
        }
    }
}

TEST_CASE("turned cursor: among the bumps and edges of a mesh it is never in a triangle") {
    for (const auto& mesh : {touchable(make_bumpy_sphere(0.05, 8, 0.1, 8.0)),
                             touchable(make_box(Vector3(0.05, 0.03, 0.04)))}) {
        for (const CursorShape& cursor : shaped_cursors()) {
            Random random(33);
            Wanderer wanderer(5, 0.01);
            VirtualProxy proxy = make(cursor, of(mesh));
            Pose hand = Pose::at(0.12 * wanderer.next());
            Vector3 spin = 0.05 * random.direction();
            proxy.reset(hand.position);
            int n_turned = 0;
            int n_touching = 0;
            for (int i = 0; i < 1500; ++i) {
                hand.position = (0.04 + 0.02 * std::cos(0.01 * i)) * wanderer.next();
                if (i % 100 == 0) {
                    spin = (i % 200 == 0 ? 0.05 : 0.004) * random.direction();
                }
                hand.orientation =
                    Quaternion(AngleAxis(spin.norm(), spin.normalized())) * hand.orientation;
                const Pose cursor_W = go(proxy, hand);
                INFO("cursor " << cursor.index() << ", round " << i);
                REQUIRE_FALSE(overlaps(mesh, cursor, cursor_W));
                n_touching += proxy.contact().n_constraints > 0 ? 1 : 0;
                n_turned += turned_rad(cursor_W, hand.orientation) < 1.0e-9 ? 1 : 0;
            }
            CHECK(n_touching > 500);
            CHECK(n_turned > 1200);
            CHECK(proxy.n_squeezed() == 0);
        }
    }
}

TEST_CASE(
    "turned cursor: in a corridor too narrow it keeps its turn, and turns on where it is wide") {
    const Pose sides[] = {Pose::at(Vector3(0.0, 0.03, 0.0)), Pose::at(Vector3(0.0, -0.03, 0.0))};
    const SolidShape slab = BoxShape{{0.3, 0.01, 0.3}};
    std::vector<SolidPlan> corridor = of(slab, sides[0]);
    corridor.push_back({.body = 1, .shape = slab, .initial_pose_W = sides[1]});
    VirtualProxy proxy = make(BoxShape{{0.05, 0.005, 0.005}}, corridor);
    Pose hand;
    Pose cursor_W;
    proxy.reset(hand.position);
    double angle_rad = 0.0;
    for (int i = 0; i < 200; ++i) {
        angle_rad = std::min(0.01 * i, 1.2);
        hand.orientation = Quaternion(AngleAxis(angle_rad, Vector3::UnitZ()));
        cursor_W = go(proxy, hand);
        // 0.05 sin + 0.005 cos = 0.02
        REQUIRE(turned_rad(cursor_W) < 0.3098);
    }
    CHECK(turned_rad(cursor_W) > 0.305);
    CHECK(cursor_W.position.norm() < 1.0e-3);
    // Along, out of the corridor.
    for (int i = 0; i < 400; ++i) {
        hand.position.x() += 0.001;
        cursor_W = go(proxy, hand);
    }
    CHECK(turned_rad(cursor_W, hand.orientation) < 1.0e-9);
    CHECK((cursor_W.position - hand.position).norm() < 1.0e-9);
    CHECK(proxy.n_squeezed() == 0);
}

TEST_CASE("turned cursor: bodies that turn under it never come over it") {
    const auto box = touchable(make_box(Vector3(0.1, 0.06, 0.08)));
    for (const CursorShape& cursor : shaped_cursors()) {
        Random random(5);
        for (int run = 0; run < 4; ++run) {
            VirtualProxy proxy = make(cursor, of(box));
            const Vector3 spin = 10.0 * random.direction();  // rad/s
            Pose hand = Pose::at(0.03 * random.in_cube());
            proxy.reset(0.2 * random.direction());
            Pose pose;
            for (int i = 0; i < 1000; ++i) {
                pose.orientation =
                    Quaternion(AngleAxis(1.0e-3 * spin.norm() * i, spin.normalized()));
                hand.orientation = Quaternion(AngleAxis(0.01 * i, Vector3(0.6, 0.0, 0.8)));
                const Pose cursor_W = go(proxy, hand, std::span(&pose, 1));
                INFO("cursor " << cursor.index() << ", run " << run << ", round " << i);
                REQUIRE_FALSE(overlaps(box, cursor, pose.inverse() * cursor_W));
            }
            CHECK(proxy.n_squeezed() == 0);
        }
    }
}

TEST_CASE("turned cursor: turning gives what is lent, once; turned to and fro it pays back") {
    constexpr double kStiffness_N_per_m = 500.0;
    const Vector3 half = Vector3::Constant(0.01);
    const CursorTurning turning = reach_of(BoxShape{half}, kStiffness_N_per_m);
    const double height_m = turning.farthest_m - turning.least_m;
    CHECK(height_m == Approx(0.01 * (std::sqrt(3.0) - 1.0)).epsilon(2.0e-3));
    VirtualProxy proxy(make_obstacles(BoxShape{half}, of(touchable(make_plate(1.0, 1.0, 2)))),
                       turning);
    Pose hand = Pose::at(Vector3(0.0, 0.02, 0.0));
    proxy.reset(hand.position);
    (void)go(proxy, hand);
    double given_J = 0.0;  // to the hand, by the spring on its way
    Vector3 force_W = Vector3::Zero();
    int n_kept = 0;
    const auto step = [&](double height, double angle_rad) {
        const Vector3 to_W(0.0, height, 0.0);
        given_J += force_W.dot(to_W - hand.position);
        hand.position = to_W;
        hand.orientation = Quaternion(AngleAxis(angle_rad, Vector3::UnitZ()));
        const Pose cursor_W = go(proxy, hand);
        force_W = kStiffness_N_per_m * (cursor_W.position - hand.position);
        n_kept += turned_rad(cursor_W, hand.orientation) > 1.0e-6 ? 1 : 0;
    };
    constexpr double kUp_rad = std::numbers::pi / 4.0;
    // A hand that rests, 2 mm in: to its edge and back, again and again.
    for (int i = 0; i <= 100; ++i) {
        step(0.02 - 0.00012 * i, 0.0);
    }
    for (int cycle = 0; cycle < 20; ++cycle) {
        for (int i = 1; i <= 400; ++i) {
            step(0.008, kUp_rad * 0.5 * (1.0 - std::cos(2.0 * std::numbers::pi * i / 400)));
        }
        // What fades of the debt half way is credit in the end, and fades too.
        REQUIRE(std::abs(proxy.loan().owed_J()) < 0.5 * proxy.loan().limit_J());
    }
    CHECK(n_kept == 0);
    // A crank: down flat, up on its edge, 100 times in 100 s.
    constexpr int kCycles = 100;
    given_J = 0.0;
    double first_J = 0.0;
    for (int cycle = 0; cycle < kCycles; ++cycle) {
        for (int i = 1; i <= 250; ++i) {
            step(0.008, kUp_rad * i / 250);
        }
        for (int i = 1; i <= 250; ++i) {
            step(0.008 + 0.008 * i / 250, kUp_rad);
        }
        for (int i = 1; i <= 250; ++i) {
            step(0.016, kUp_rad - kUp_rad * i / 250);
        }
        for (int i = 1; i <= 250; ++i) {
            step(0.016 - 0.008 * i / 250, 0.0);
        }
        first_J = cycle == 0 ? given_J : first_J;
    }
    const double limit_J = kStiffness_N_per_m * height_m * (0.0062 + 0.5 * height_m);
    INFO("given " << given_J << " J, in the first turn " << first_J << ", lent at most " << limit_J
                  << ", kept " << n_kept);
    CHECK(first_J > 2.0e-3);
    CHECK(given_J > first_J);
    CHECK(given_J < limit_J * (1.0 + kCycles / kDebtMemory_s));
    CHECK(given_J < 0.4 * kCycles * first_J);
    CHECK(n_kept > 1000);
}
