#include "haptics/point/virtual_proxy.h"

#include "haptics/geometry/shape.h"
#include "haptics/point/make_obstacle.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/nearest_point.h"
#include "tests/support/touchable.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

namespace fulcrum {
namespace {

// The claim: places are those of geometry to this part of the solid's size.
constexpr double kExact = 1.0e-9;

// One ball on one mesh, moved along straight lines.
class Hand {
  public:
    Hand(std::shared_ptr<const CollisionMesh> mesh, double radius_m, const Vector3& start_W,
         const Pose& pose_W = {})
        : pose_W_(pose_W),
          proxy_(make_obstacles(SphereShape{radius_m}, only_solid(std::move(mesh), pose_W))),
          at_W_(start_W) {
        proxy_.reset(start_W);
    }
    const ProxyContact& go_to(const Vector3& to_W, int n_steps = 50) {
        const Vector3 from_W = at_W_;
        for (int i = 1; i <= n_steps; ++i) {
            at_W_ = i == n_steps ? to_W : Vector3(from_W + (to_W - from_W) * i / n_steps);
            proxy_.step(at_W_, std::span(&pose_W_, 1));
        }
        // At rest what a round leaves of the error is gone after a few.
        for (int i = 0; i < 5; ++i) {
            proxy_.step(at_W_, std::span(&pose_W_, 1));
        }
        return proxy_.contact();
    }
    VirtualProxy& proxy() { return proxy_; }

  private:
    Pose pose_W_;
    VirtualProxy proxy_;
    Vector3 at_W_;
};

TEST_CASE("virtual proxy: in free space the proxy is the hand, to the bit") {
    Hand hand(touchable(make_box(Vector3::Ones())), 0.1, Vector3(2.0, 0.1, 0.3));
    for (const Vector3& place :
         {Vector3(0.7, 0.7, 0.1), Vector3(-3.0, 0.9, 1e-7), Vector3(0.1, 0.6000001, 0.2)}) {
        const ProxyContact& contact = hand.go_to(place);
        CHECK(contact.position_W == place);
        CHECK(contact.solid == kNoBody);
        CHECK(contact.n_constraints == 0);
        CHECK(contact.normal_W == Vector3::Zero());
    }
}

TEST_CASE("virtual proxy: over a face it is a radius above the foot of the perpendicular") {
    for (const double scale : {1e-4, 1.0, 1e3}) {
        Hand hand(touchable(make_box(scale * Vector3::Ones())), 0.1 * scale,
                  scale * Vector3(0.1, 0.9, -0.2));
        const ProxyContact& contact = hand.go_to(scale * Vector3(0.13, 0.3, -0.22));
        CHECK((contact.position_W - scale * Vector3(0.13, 0.6, -0.22)).norm() <= kExact * scale);
        CHECK(contact.solid == 0);
        CHECK(contact.n_constraints == 1);
        CHECK((contact.normal_W - Vector3::UnitY()).norm() < 1e-8);
        CHECK(contact.touches[0].push_m == Approx(0.3 * scale).epsilon(1e-8));
        CHECK(contact.position_W.y() > 0.6 * scale);
    }
}

TEST_CASE("virtual proxy: inside a box wall, edge and corner hold it at the analytic place") {
    for (const double scale : {1e-4, 1.0, 1e3}) {
        Hand hand(touchable(make_box(scale * Vector3(1.0, 2.0, 3.0))), 0.2 * scale,
                  Vector3::Zero());
        const auto expect = [&](const Vector3& wish, const Vector3& position, int n_constraints) {
            const ProxyContact& contact = hand.go_to(scale * wish);
            CHECK((contact.position_W - scale * position).norm() <= kExact * scale);
            CHECK(contact.n_constraints == n_constraints);
            CHECK((contact.normal_W - (position - wish).normalized()).norm() < 1e-7);
        };
        expect(Vector3(0.8, 0.1, 0.2), Vector3(0.3, 0.1, 0.2), 1);
        expect(Vector3(0.9, 1.3, -0.7), Vector3(0.3, 0.8, -0.7), 2);
        expect(Vector3(0.7, 1.2, 1.9), Vector3(0.3, 0.8, 1.3), 3);
        expect(Vector3(0.7, 0.2, 1.9), Vector3(0.3, 0.2, 1.3), 2);
        expect(Vector3(-0.7, -1.1, -1.6), Vector3(-0.3, -0.8, -1.3), 3);
        CHECK(hand.go_to(scale * Vector3(0.1, 0.2, 0.3)).n_constraints == 0);
    }
}

TEST_CASE("virtual proxy: round an edge and a corner it is a radius from them, towards the hand") {
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

TEST_CASE("virtual proxy: a turned and moved box gives the turned and moved place") {
    const Pose pose{Vector3(0.7, -0.4, 1.2),
                    Quaternion(AngleAxis(1.1, Vector3(1.0, -2.0, 0.5).normalized()))};
    Hand hand(touchable(make_box(Vector3(1.0, 2.0, 3.0))), 0.2, pose * Vector3::Zero(), pose);
    const ProxyContact& contact = hand.go_to(pose * Vector3(0.7, 1.2, 1.9));
    CHECK((contact.position_W - pose * Vector3(0.3, 0.8, 1.3)).norm() <= kExact);
    CHECK(contact.n_constraints == 3);
}

TEST_CASE("virtual proxy: a groove holds it a radius over both walls, however finely divided") {
    constexpr double kRadius = 0.05;
    for (const double angle : {1.2, 0.5, 0.05}) {
        for (const int n : {1, 7, 200}) {
            Hand hand(touchable(make_trench(angle, n)), kRadius, Vector3(0.0, 0.7, -0.6));
            for (const double z : {-0.5, 0.313, 0.7, -0.477}) {
                const ProxyContact& contact = hand.go_to(Vector3(0.0, -0.4, z), 100);
                INFO("angle " << angle << " strips " << n << " z " << z);
                CHECK((contact.position_W - Vector3(0.0, kRadius / std::cos(angle), z)).norm() <=
                      kExact / std::cos(angle));
                CHECK(contact.n_constraints == 2);
            }
            // And lets go up the slope: a radius over the foot on the right wall.
            const Vector3 wish(0.6 * std::cos(angle), 0.6 * std::sin(angle) - 0.1, 0.1);
            const Vector3 normal(-std::sin(angle), std::cos(angle), 0.0);
            const ProxyContact& contact = hand.go_to(wish, 200);
            CHECK((contact.position_W - (wish + (kRadius - normal.dot(wish)) * normal)).norm() <=
                  2.0 * kExact);
        }
    }
}

TEST_CASE("virtual proxy: a start in a surface is pushed out of it, NaN and the far are ignored") {
    Hand hand(touchable(make_box(Vector3::Ones())), 0.1, Vector3(0.0, 0.52, 0.0));
    CHECK((hand.proxy().contact().position_W - Vector3(0.0, 0.6, 0.0)).norm() < kExact);
    const Vector3 before = hand.go_to(Vector3(0.0, 0.4, 0.0)).position_W;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(hand.proxy().step(Vector3(nan, 0.0, 0.0), {}).position_W == before);
    CHECK(hand.proxy().step(Vector3(0.0, 1.0e31, 0.0), {}).position_W == before);
    const Pose nowhere = Pose::at(Vector3(0.0, nan, 0.0));
    CHECK(hand.proxy().step(Vector3(0.0, 0.4, 0.0), std::span(&nowhere, 1)).position_W == before);
}

TEST_CASE("virtual proxy: it meets a plate on its way, however far the hand jumps") {
    const auto plate = touchable(make_plate(4.0, 4.0, 40));
    for (const double side : {1.0, -1.0}) {
        VirtualProxy proxy(make_obstacles(SphereShape{0.01}, only_solid(plate)));
        for (const double jump_m : {0.02, 0.3, 5.0, 1.0e6}) {
            proxy.reset(Vector3(0.1, 0.015 * side, 0.2));
            const Vector3 hand(0.3, -jump_m * side, 0.2);
            const ProxyContact& contact = proxy.step(hand, {});
            CHECK(contact.position_W.y() * side == Approx(0.01).epsilon(1e-6));
        }
    }
}

}  // namespace
}  // namespace fulcrum
