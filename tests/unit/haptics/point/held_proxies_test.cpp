#include "haptics/geometry/shape.h"
#include "haptics/point/god_object.h"
#include "haptics/point/let_through.h"
#include "haptics/point/make_obstacle.h"
#include "haptics/point/make_proxy.h"
#include "haptics/point/virtual_proxy.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/touchable.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <string>

using namespace fulcrum;

namespace {

constexpr double kExact = 1.0e-9;

// One proxy on one mesh, moved along straight lines; without a radius it is the god-object's point.
class Hand {
  public:
    Hand(std::shared_ptr<const CollisionMesh> mesh, double radius_m, const Vector3& start_W,
         const Pose& pose_W = {})
        : at_W_(start_W) {
        const std::vector<SolidPlan> solids = only_solid(std::move(mesh), pose_W);
        if (radius_m > 0.0) {
            proxy_ = std::make_unique<VirtualProxy>(make_obstacles(SphereShape{radius_m}, solids));
        } else {
            proxy_ = std::make_unique<GodObject>(solids);
        }
        proxy_->reset(start_W);
    }
    const ProxyContact& go_to(const Vector3& to_W, int n_steps = 50) {
        const Vector3 from_W = at_W_;
        for (int i = 1; i <= n_steps; ++i) {
            at_W_ = i == n_steps ? to_W : Vector3(from_W + (to_W - from_W) * i / n_steps);
            proxy_->step(at_W_, {});
        }
        // At rest what a round leaves of a ball's error is gone after a few.
        for (int i = 0; i < 5; ++i) {
            proxy_->step(at_W_, {});
        }
        return proxy_->contact();
    }

  private:
    std::unique_ptr<SurfaceObject> proxy_;
    Vector3 at_W_;
};

// Radii of a unit, and the largest scale at which a proxy is tried.
struct Ball {
    double radius_m;
    double largest;
};
const Ball kBalls[] = {{0.0, 1e4}, {0.1, 1e3}, {0.2, 1e3}};

constexpr double kHalf_m = 0.1;
const Vector3 kFar_W(0.0, 1.0, 0.0);

SolidPlan mesh_plan() {
    return {.body = 0, .shape = touchable(make_box(Vector3::Constant(2.0 * kHalf_m)))};
}
SolidPlan shape_plan() {
    return {.body = 0, .shape = BoxShape{Vector3::Constant(kHalf_m)}};
}

struct Rig {
    std::string name;
    std::unique_ptr<Proxy> proxy;
    double radius_m;  // of the cursor
};
std::vector<Rig> make_rigs(bool lets_out = true) {
    std::vector<Rig> rigs;
    for (SolidPlan solid : {mesh_plan(), shape_plan()}) {
        solid.lets_out = lets_out;
        const std::string of = find_mesh(solid.shape) != nullptr ? " in a mesh" : " in a box";
        const auto add = [&](const std::string& name, const ProxySettings& settings, double r) {
            rigs.push_back({name + of, make_proxy(settings, {solid}, {}), r});
        };
        ProxySettings settings;
        settings.kind = ProxyKind::god_object;
        add("a point", settings, 0.0);
        settings.kind = ProxyKind::friction_cone;
        add("a point with friction", settings, 0.0);
        settings.kind = ProxyKind::virtual_proxy;
        settings.cursor = SphereShape{0.02};
        add("a ball", settings, 0.02);
        settings.cursor = BoxShape{Vector3::Constant(0.02)};
        add("a box", settings, 0.02);
    }
    return rigs;
}

// The hand goes straight there; how far the proxy was from it at most.
double follow(Proxy& proxy, const Vector3& from_W, const Vector3& to_W, const Pose& pose_W) {
    double worst_m = 0.0;
    for (int i = 0; i <= 100; ++i) {
        const Vector3 hand_W = from_W + 0.01 * i * (to_W - from_W);
        worst_m =
            std::max(worst_m, (proxy.step(hand_W, std::array{pose_W}).position_W - hand_W).norm());
    }
    return worst_m;
}

}  // namespace

// A point as a god-object and a ball as a virtual proxy on one mesh: where either comes to rest is known exactly.

TEST_CASE(
    "held proxy: in free space the hand, over a face a radius above the perpendicular's foot") {
    for (const double radius_m : {0.0, 0.1}) {
        Hand hand(touchable(make_box(Vector3::Ones())), radius_m, Vector3(2.0, 0.1, 0.3));
        for (const Vector3& place : {Vector3(0.7, 0.7, 0.1), Vector3(-3.0, 0.9, 1e-7),
                                     Vector3(0.1, 0.5 + radius_m + 1.0e-7, 0.2)}) {
            const ProxyContact& contact = hand.go_to(place);
            CHECK(contact.position_W == place);
            CHECK(contact.solid == kNoBody);
            CHECK(contact.n_constraints == 0);
            CHECK(contact.normal_W == Vector3::Zero());
        }
    }
    for (const Ball& ball : kBalls) {
        for (const double scale : {1e-4, 1.0, ball.largest}) {
            CAPTURE(ball.radius_m, scale);
            Hand hand(touchable(make_box(scale * Vector3::Ones())), ball.radius_m * scale,
                      scale * Vector3(0.1, 0.9, -0.2));
            const double height = 0.5 + ball.radius_m;
            const ProxyContact& contact = hand.go_to(scale * Vector3(0.13, 0.3, -0.22));
            CHECK((contact.position_W - scale * Vector3(0.13, height, -0.22)).norm() <=
                  kExact * scale);
            CHECK(contact.solid == 0);
            CHECK(contact.n_constraints == 1);
            CHECK((contact.normal_W - Vector3::UnitY()).norm() < 1e-8);
            CHECK(contact.touches[0].push_m == Approx((height - 0.3) * scale).epsilon(1e-8));
            // Never nearer to the face, not even by rounding.
            CHECK(contact.position_W.y() > height * scale);
        }
    }
}

TEST_CASE("held proxy: inside a box wall, edge and corner hold it at the analytic place") {
    for (const Ball& ball : kBalls) {
        for (const double scale : {1e-4, 1.0, ball.largest}) {
            CAPTURE(ball.radius_m, scale);
            Hand hand(touchable(make_box(scale * Vector3(1.0, 2.0, 3.0))), ball.radius_m * scale,
                      Vector3::Zero());
            const Vector3 room = Vector3(0.5, 1.0, 1.5) - Vector3::Constant(ball.radius_m);
            for (const Vector3& wish :
                 {Vector3(0.8, 0.1, 0.2), Vector3(0.9, 1.3, -0.7), Vector3(0.7, 1.2, 1.9),
                  Vector3(0.7, 0.2, 1.9), Vector3(-0.7, -1.1, -1.6)}) {
                const Vector3 place = wish.cwiseMin(room).cwiseMax(-room);
                int n_walls = 0;
                for (int axis = 0; axis < 3; ++axis) {
                    n_walls += place[axis] != wish[axis] ? 1 : 0;
                }
                const ProxyContact& contact = hand.go_to(scale * wish);
                CHECK((contact.position_W - scale * place).norm() <= kExact * scale);
                CHECK(contact.n_constraints == n_walls);
                CHECK((contact.normal_W - (place - wish).normalized()).norm() < 1e-7);
            }
            CHECK(hand.go_to(scale * Vector3(0.1, 0.2, 0.3)).n_constraints == 0);
        }
    }
}

TEST_CASE("held proxy: a turned and moved box gives the turned and moved place") {
    const Pose pose{Vector3(0.7, -0.4, 1.2),
                    Quaternion(AngleAxis(1.1, Vector3(1.0, -2.0, 0.5).normalized()))};
    for (const Ball& ball : kBalls) {
        Hand hand(touchable(make_box(Vector3(1.0, 2.0, 3.0))), ball.radius_m,
                  pose * Vector3::Zero(), pose);
        const Vector3 place = Vector3(0.5, 1.0, 1.5) - Vector3::Constant(ball.radius_m);
        const ProxyContact& contact = hand.go_to(pose * Vector3(0.7, 1.2, 1.9));
        CHECK((contact.position_W - pose * place).norm() <= kExact);
        CHECK(contact.n_constraints == 3);
    }
}

TEST_CASE("held proxy: a groove holds it a radius over both walls, however finely divided") {
    for (const double radius_m : {0.0, 0.05}) {
        for (const double angle : {1.2, 0.5, 0.05, 1e-3}) {
            if (radius_m > 0.0 && angle < 0.05) {
                continue;  // a ball finds both walls to a root of rounding alone
            }
            for (const int n : {1, 7, 200}) {
                const bool is_point = radius_m == 0.0;
                Hand hand(
                    touchable(make_trench(angle, n)), radius_m,
                    Vector3(is_point ? 0.2 * std::cos(angle) : 0.0, 0.7, is_point ? -0.9 : -0.6));
                // Below the middle, or for a point beside it: on the line, wherever along it.
                for (const double z :
                     {-0.5, 0.313, is_point ? 0.8 : 0.7, -0.777 + 6.0 * radius_m}) {
                    const Vector3 wish(is_point ? 0.05 * std::sin(angle) : 0.0, -0.4, z);
                    const ProxyContact& contact = hand.go_to(wish, is_point ? 50 : 100);
                    CAPTURE(radius_m, angle, n, z);
                    // Clearances are kept over both slopes, so the line lies that much over sin(angle) higher and aside.
                    CHECK(
                        (contact.position_W - Vector3(0.0, radius_m / std::cos(angle), z)).norm() <=
                        kExact / std::cos(angle));
                    CHECK(contact.n_constraints == 2);
                }
                // And lets go up the slope: a radius over the foot on the right wall.
                const Vector3 wish(0.6 * std::cos(angle), 0.6 * std::sin(angle) - 0.1, 0.1);
                const Vector3 normal(-std::sin(angle), std::cos(angle), 0.0);
                const ProxyContact& contact = hand.go_to(wish, 200);
                const Vector3 place = wish + (radius_m - normal.dot(wish)) * normal;
                CHECK((contact.position_W - place).norm() <= 2.0 * kExact);
            }
        }
    }
}

TEST_CASE("held proxy: a convex edge lets go when the foot leaves the first face") {
    Hand hand(touchable(make_box(Vector3::Ones())), 0.0, Vector3(0.0, 0.8, 0.1));
    hand.go_to(Vector3(0.0, 0.45, 0.1));
    // Nearer to the side x = 0.5 already, but the foot is on the top still: there it stays.
    CHECK((hand.go_to(Vector3(0.49, 0.45, 0.1)).position_W - Vector3(0.49, 0.5, 0.1)).norm() <=
          kExact);
    // Past the edge the hand is free.
    CHECK(hand.go_to(Vector3(0.51, 0.45, 0.1)).position_W == Vector3(0.51, 0.45, 0.1));
    // Back in from the side.
    CHECK((hand.go_to(Vector3(0.45, 0.4, 0.1)).position_W - Vector3(0.5, 0.4, 0.1)).norm() <=
          kExact);
}

TEST_CASE("held proxy: round an edge and a corner it is a radius from them, towards the hand") {
    for (const double scale : {1e-4, 1.0, 1e3}) {
        // Hands that are over no face, nearer than a radius to an edge and to a corner.
        for (const Vector3& wish : {Vector3(0.53, 0.54, 0.1), Vector3(0.51, 0.5101, -0.3),
                                    Vector3(0.52, 0.53, 0.54), Vector3(0.505, 0.52, 0.501)}) {
            Hand hand(touchable(make_box(scale * Vector3::Ones())), 0.1 * scale,
                      2.0 * scale * wish);
            const Vector3 nearest = wish.cwiseMin(0.5);
            const Vector3 place = nearest + 0.1 * (wish - nearest).normalized();
            const ProxyContact& contact = hand.go_to(scale * wish);
            CAPTURE(scale, wish);
            CHECK((contact.position_W - scale * place).norm() <= 3.0e-8 * scale);
            CHECK(contact.n_constraints == 1);
        }
    }
}

TEST_CASE("held proxy: deep in a convex body it goes round the edge to the nearer face") {
    // A roof whose ridge is shallow: from one slope over the ridge to the other, deep below both.
    auto vertices = make_trench(0.2, 9)->vertices_B();
    for (Vector3& vertex : vertices) {
        vertex.y() = -vertex.y();
    }
    const auto roof = touchable(TriangleMesh::build(vertices, make_trench(0.2, 9)->triangles()));
    Hand hand(roof, 0.0, Vector3(-0.4, 0.5, 0.07));
    hand.go_to(Vector3(-0.4, -0.3, 0.07));
    const Vector3 wish(0.4, -0.3, 0.07);
    const ProxyContact& contact = hand.go_to(wish, 400);
    const Vector3 normal(std::sin(0.2), std::cos(0.2), 0.0);
    CHECK((contact.position_W - (wish - normal.dot(wish) * normal)).norm() <= kExact);
    CHECK(contact.n_constraints == 1);
}

TEST_CASE("held proxy: a sheet is solid from both sides, at any speed") {
    for (const double scale : {1e-4, 1.0, 1e4}) {
        const auto plate = touchable(make_plate(scale, scale, 11));
        for (const double side : {1.0, -1.0}) {
            for (const int n_steps : {1, 3, 1000}) {
                // Through faces, through corners of the grid and through the diagonals.
                for (const Vector3& at :
                     {Vector3(0.013, 0.0, -0.22), Vector3(0.5 / 11.0, 0.0, 0.5 / 11.0),
                      Vector3(1e-3, 0.0, 1e-3)}) {
                    Hand hand(plate, 0.0, scale * (at + side * 0.4 * Vector3::UnitY()));
                    const ProxyContact& contact =
                        hand.go_to(scale * (at - side * 0.3 * Vector3::UnitY()), n_steps);
                    CHECK((contact.position_W - scale * at).norm() <= kExact * scale);
                    CHECK(side * contact.position_W.y() > 0.0);
                }
            }
        }
    }
}

// A hand that begins in a solid, a solid that is put on the hand: for every kind of proxy and solid.

TEST_CASE("let through: a hand that begins in a solid leaves it freely, and then meets it") {
    for (Rig& rig : make_rigs()) {
        CAPTURE(rig.name);
        const Vector3 inside_W(0.01, 0.02, 0.03);
        const Vector3 outside_W(0.01, 0.3, 0.03);
        rig.proxy->reset(inside_W);
        CHECK(follow(*rig.proxy, inside_W, outside_W, {}) == 0.0);
        follow(*rig.proxy, outside_W, inside_W, {});
        const ProxyContact& contact = rig.proxy->step(inside_W, std::array{Pose{}});
        CHECK(contact.solid == 0);
        CHECK(contact.position_W.y() == Approx(kHalf_m + rig.radius_m).margin(2e-4));
    }
}

TEST_CASE("let through: a solid put on the hand does not push it, and is there once it has left") {
    for (Rig& rig : make_rigs()) {
        CAPTURE(rig.name);
        const Vector3 hand_W(0.01, 0.02, 0.03);
        rig.proxy->reset(hand_W + kFar_W);  // far from the solid
        rig.proxy->step(hand_W + kFar_W, std::array{Pose{}});
        rig.proxy->put_solid(0, Pose::at(kFar_W));
        const Pose there = Pose::at(kFar_W);
        CHECK((rig.proxy->step(hand_W + kFar_W, std::array{there}).position_W - (hand_W + kFar_W))
                  .norm() == 0.0);
        const Vector3 outside_W = kFar_W + Vector3(0.01, 0.3, 0.03);
        CHECK(follow(*rig.proxy, hand_W + kFar_W, outside_W, there) == 0.0);
        follow(*rig.proxy, outside_W, hand_W + kFar_W, there);
        CHECK(rig.proxy->step(hand_W + kFar_W, std::array{there}).solid == 0);
    }
}

TEST_CASE("let through: put away from the hand it lets go, put on the hand alone both go") {
    for (Rig& rig : make_rigs()) {
        CAPTURE(rig.name);
        const Vector3 above_W(0.0, 0.3, 0.0);
        const Vector3 pressed_W(0.0, 0.09, 0.0);
        rig.proxy->reset(above_W);
        CHECK(follow(*rig.proxy, above_W, pressed_W, {}) > 0.009);
        rig.proxy->put_solid(0, Pose::at(-kFar_W));
        const ProxyContact& contact = rig.proxy->step(pressed_W, std::array{Pose::at(-kFar_W)});
        CHECK(contact.solid == kNoBody);
        CHECK(contact.position_W == pressed_W);
    }
    for (Rig& rig : make_rigs()) {
        CAPTURE(rig.name);
        const Vector3 above_W(0.0, 0.3, 0.0);
        const Vector3 pressed_W(0.0, 0.02, 0.0);
        rig.proxy->reset(above_W);
        follow(*rig.proxy, above_W, pressed_W, {});
        // A little lower: the proxy would be outside, the hand still deep within.
        const Pose lower = Pose::at(Vector3(0.0, -0.03, 0.0));
        rig.proxy->put_solid(0, lower);
        CHECK(rig.proxy->step(pressed_W, std::array{lower}).position_W == pressed_W);
    }
}

TEST_CASE("let through: a mesh may keep the hand that begins inside; unknown solids are ignored") {
    std::vector<Rig> rigs = make_rigs(false);
    for (Rig& rig : rigs) {
        if (rig.name.find("mesh") == std::string::npos) {
            continue;
        }
        CAPTURE(rig.name);
        rig.proxy->reset(Vector3::Zero());
        follow(*rig.proxy, Vector3::Zero(), Vector3(0.0, 0.2, 0.0), {});
        const ProxyContact& contact = rig.proxy->step(Vector3(0.0, 0.2, 0.0), std::array{Pose{}});
        CHECK(contact.position_W.y() == Approx(kHalf_m - rig.radius_m).margin(2e-4));
    }
    for (Rig& rig : make_rigs()) {
        CAPTURE(rig.name);
        rig.proxy->reset(kFar_W);
        rig.proxy->put_solid(7, Pose{});
        CHECK(rig.proxy->step(kFar_W, std::array{Pose{}}).position_W == kFar_W);
    }
}
