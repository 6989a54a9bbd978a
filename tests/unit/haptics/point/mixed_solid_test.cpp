// A point among meshes and shapes: where it rests on a shape is known exactly, whatever lies beside it.
#include "haptics/point/mixed_solid.h"

#include "haptics/collision/enclosure.h"
#include "haptics/collision/shape_gap.h"
#include "haptics/geometry/shape.h"
#include "haptics/point/god_object.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

using namespace fulcrum;

namespace {

using MixedGodObject = GodObjectAmong<MixedSolid>;

const Pose kPose{Vector3(0.7, -0.4, 1.2), Quaternion(AngleAxis(1.1, Vector3(0.6, 0.0, 0.8)))};
const Vector3 kAway(3.0, 0.0, 0.0);
const std::vector<SolidShape> kShapes{SphereShape{0.1}, CapsuleShape{0.05, 0.08},
                                      CylinderShape{0.06, 0.1}, BoxShape{{0.05, 0.1, 0.08}}};

// The shape, and a box of triangles that lies elsewhere.
std::vector<SolidPlan> beside_a_mesh(const SolidShape& shape, const Pose& pose_W) {
    std::vector<SolidPlan> solids = only_solid(touchable(make_box({0.1, 0.1, 0.1})));
    solids[0].initial_pose_W = Pose::at(kAway);
    solids.push_back({.body = 1, .shape = shape, .initial_pose_W = pose_W});
    return solids;
}

double gap_of(const SolidShape& shape, const Vector3& at_B) {
    return std::visit(
        [&](const auto& solid) -> double {
            if constexpr (requires { find_gap(solid, at_B); }) {
                return find_gap(solid, at_B).gap_m;
            }
            return 1.0;
        },
        shape);
}

// Comes straight in; places are in the body's frame.
ProxyContact press(const SolidShape& shape, const Vector3& start_B, const Vector3& hand_B) {
    MixedGodObject proxy(beside_a_mesh(shape, kPose));
    proxy.reset(kPose * start_B);
    for (int i = 1; i <= 60; ++i) {
        const double part = std::min(i / 50.0, 1.0);
        proxy.step(kPose * Vector3(start_B + (hand_B - start_B) * part), {});
    }
    ProxyContact contact = proxy.contact();
    contact.position_W = kPose.inverse() * contact.position_W;
    contact.normal_W = kPose.orientation.conjugate() * contact.normal_W;
    return contact;
}

}  // namespace

TEST_CASE("mixed solid: a point beside a mesh rests on a shape where the closed form says") {
    struct Pressed {
        SolidShape shape;
        Vector3 start, hand, place;
    };
    const std::vector<Pressed> cases{
        {SphereShape{0.1}, {0.5, 0.6, 0.1}, {0.048, 0.064, 0.0}, {0.06, 0.08, 0.0}},
        {SphereShape{0.1}, {0.0, 0.6, 0.0}, {0.003, 0.004, 0.0}, {0.06, 0.08, 0.0}},
        {CapsuleShape{0.1, 0.2}, {2.0, 0.3, 0.4}, {0.048, 0.1, 0.064}, {0.06, 0.1, 0.08}},
        {CapsuleShape{0.1, 0.2}, {1.0, 1.0, 0.0}, {0.03, 0.24, 0.0}, {0.06, 0.28, 0.0}},
        {CylinderShape{0.1, 0.2}, {1.0, 0.05, 0.0}, {0.048, 0.05, 0.064}, {0.06, 0.05, 0.08}},
        {CylinderShape{0.1, 0.2}, {0.0, 1.0, 0.0}, {0.02, 0.15, 0.01}, {0.02, 0.2, 0.01}},
        {BoxShape{{0.1, 0.2, 0.3}}, {1.0, 0.1, 0.2}, {0.05, 0.12, -0.2}, {0.1, 0.12, -0.2}}};
    for (const Pressed& pressed : cases) {
        const ProxyContact contact = press(pressed.shape, pressed.start, pressed.hand);
        INFO("at " << contact.position_W.x() << " " << contact.position_W.y() << " "
                   << contact.position_W.z());
        // Of the way that it is pressed in: the tangent plane's error is left at 1e-8 of the size.
        const double tolerance_m = 3.0e-3 * (pressed.place - pressed.hand).norm();
        CHECK((contact.position_W - pressed.place).norm() <= tolerance_m);
        CHECK(contact.solid == 1);
        CHECK(contact.n_constraints == 1);
        CHECK(contact.normal_W.dot((pressed.place - pressed.hand).normalized()) > 1.0 - 1e-5);
    }
}

TEST_CASE("mixed solid: a hand that wanders through all never gets the point into one") {
    // Each shape touches its neighbours and the box of triangles under them.
    std::vector<SolidPlan> solids = only_solid(touchable(make_box({0.8, 0.1, 0.3})));
    const double places[] = {-0.2, -0.06, 0.05, 0.16};
    for (std::size_t i = 0; i < kShapes.size(); ++i) {
        solids.push_back({.body = static_cast<std::int32_t>(i) + 1,
                          .shape = kShapes[i],
                          .initial_pose_W = {Vector3(places[i], 0.14, 0.0),
                                             Quaternion(AngleAxis(0.2, Vector3::UnitX()))}});
    }
    MixedGodObject proxy(solids);
    proxy.reset(Vector3(0.0, 0.5, 0.0));
    Wanderer wanderer(3, 0.01);
    int touched = 0;
    int n_cut = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vector3 hand = Vector3(0.0, 0.12, 0.0) + wanderer.next().cwiseProduct(Vector3(
                                                           0.3 + 0.1 * std::sin(0.013 * i),
                                                           0.14 + 0.1 * std::sin(0.017 * i), 0.1));
        const ProxyContact& contact = proxy.step(hand, {});
        touched |= contact.solid != kNoBody ? 1 << contact.solid : 0;
        n_cut += proxy.n_sweeps() >= 64 ? 1 : 0;
        for (std::size_t k = 1; k < solids.size(); ++k) {
            const Vector3 at_B = solids[k].initial_pose_W.inverse() * contact.position_W;
            REQUIRE(gap_of(solids[k].shape, at_B) > 0.0);
        }
        REQUIRE_FALSE(is_in_stuff(**find_mesh(solids[0].shape), contact.position_W));
    }
    CHECK(touched == 0b11111);
    CHECK(proxy.n_squeezed() == 0);
    CHECK(n_cut < 20);  // in the crevice under the ball, at up to 4 m/s
}

TEST_CASE("mixed solid: shapes that fly or turn take the point along, and none gets over it") {
    for (const SolidShape& shape : kShapes) {
        MixedGodObject proxy(beside_a_mesh(shape, kPose));
        const Vector3 hand(0.0, 0.3, 0.0);
        proxy.reset(hand);
        Random random(5);
        for (int i = 0; i < 2000; ++i) {
            const Pose pose{hand + 0.2 * random.in_cube(), random.turn(3.0)};
            const Pose poses[] = {Pose::at(kAway), pose};
            const ProxyContact& contact = proxy.step(hand, poses);
            REQUIRE(gap_of(shape, pose.inverse() * contact.position_W) > 0.0);
        }
    }
}

TEST_CASE("mixed solid: a hand that begins in a shape, or on which one is put, is let out once") {
    for (const SolidShape& shape : kShapes) {
        std::vector<SolidPlan> solids = beside_a_mesh(shape, Pose{});
        solids[1].lets_out = true;
        MixedGodObject proxy(solids);
        const auto felt_at = [&](const Vector3& hand) {
            return proxy.step(hand, {}).n_constraints > 0;
        };
        const Vector3 inside(0.01, 0.02, 0.01);
        proxy.reset(inside);
        CHECK_FALSE(felt_at(inside));
        CHECK_FALSE(felt_at(Vector3(0.5, 0.0, 0.0)));
        CHECK(felt_at(inside));
        CHECK_FALSE(felt_at(Vector3(0.5, 0.0, 0.0)));
        proxy.put_solid(1, Pose::at(Vector3(0.5, 0.0, 0.0)));
        CHECK_FALSE(felt_at(Vector3(0.51, 0.0, 0.0)));
        CHECK_FALSE(felt_at(Vector3(0.0, 0.0, 0.0)));
        CHECK(felt_at(Vector3(0.51, 0.0, 0.0)));
    }
}

TEST_CASE("mixed solid: a start in a surface gets the outside") {
    for (const SolidShape& shape : kShapes) {
        MixedGodObject proxy(beside_a_mesh(shape, Pose{}));
        // On the axis, where each has a face or a pole.
        const double top_m = -gap_of(shape, Vector3::Zero());
        const auto* capsule = std::get_if<CapsuleShape>(&shape);
        const Vector3 top = capsule != nullptr ? Vector3(0.05, 0.0, 0.0) : Vector3(top_m, 0.0, 0.0);
        proxy.reset(top);
        CHECK(gap_of(shape, proxy.contact().position_W) > 0.0);
        CHECK(proxy.step(0.5 * top, {}).n_constraints == 1);
        CHECK((proxy.contact().position_W - top).norm() < 1e-9);
    }
}

TEST_CASE(
    "mixed solid: a bead on a floor ten thousand times its size takes a bounded number of rounds") {
    constexpr double kFloor_m = 10.0;
    constexpr double kBead_m = 0.001;
    for (int trial = 0; trial < 400; ++trial) {
        std::vector<SolidPlan> solids =
            only_solid(touchable(make_box(Vector3::Constant(kFloor_m))));
        solids[0].initial_pose_W = Pose::at({0.0, -0.5 * kFloor_m, 0.0});
        solids.push_back({.body = 1,
                          .shape = SphereShape{kBead_m},
                          .initial_pose_W = Pose::at({0.0, 0.2 * kBead_m, 0.0})});
        MixedGodObject proxy(solids);
        const double angle = 0.7 * trial;
        const double deep_m = 0.4 * kBead_m * (trial % 17) / 17.0;
        const auto at = [&](double radii, double turn, double height_m) {
            return Vector3(radii * kBead_m * std::cos(angle + turn), height_m,
                           radii * kBead_m * std::sin(angle + turn));
        };
        proxy.reset(at(1.6, 0.0, 0.3 * kBead_m));
        int most = 0;
        const auto step = [&](const Vector3& hand_W) {
            proxy.step(hand_W, {});
            most = std::max(most, proxy.n_sweeps());
        };
        for (double height_m = 0.3 * kBead_m; height_m > -deep_m; height_m -= 0.05 * kBead_m) {
            step(at(1.6, 0.0, height_m));
        }
        for (double radii = 1.6; radii > 0.4; radii -= 0.02) {
            step(at(radii, 0.0, -deep_m));
        }
        for (double turn = 0.0; turn < 2.0; turn += 0.03) {
            step(at(0.4, turn, -deep_m));
        }
        CHECK(most <= 64);
    }
}
