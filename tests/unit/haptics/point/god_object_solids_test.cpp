// Several solids, solids that move, and bad input.
#include "haptics/geometry/shape.h"
#include "haptics/point/god_object.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/touchable.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

namespace fulcrum {
namespace {

constexpr double kExact = 1.0e-9;

SolidPlan box_plan(const Vector3& size_m, const Pose& pose_W = {}) {
    return {.body = 0, .shape = touchable(make_box(size_m)), .initial_pose_W = pose_W};
}
SolidPlan plate_plan(const Pose& pose_W = {}) {
    return {.body = 1, .shape = touchable(make_plate(4.0, 4.0, 3)), .initial_pose_W = pose_W};
}

TEST_CASE("god object: the corner between two solids holds it, and it says which pushes most") {
    GodObject proxy({plate_plan(), box_plan(Vector3::Ones())});
    const std::array<Pose, 2> poses{Pose::at(Vector3::Zero()), Pose::at(Vector3(0.0, 0.5, 0.0))};
    proxy.reset(Vector3(1.0, 0.7, 0.2));
    proxy.step(Vector3(1.0, 0.7, 0.2), poses);
    // Down onto the plate, then into the box's side.
    proxy.step(Vector3(1.0, -0.2, 0.2), poses);
    CHECK(proxy.contact().solid == 0);
    CHECK(proxy.contact().n_constraints == 1);
    const ProxyContact& contact = proxy.step(Vector3(0.1, -0.2, 0.3), poses);
    CHECK((contact.position_W - Vector3(0.5, 0.0, 0.3)).norm() <= 4.0 * kExact);
    CHECK(contact.n_constraints == 2);
    CHECK(contact.solid == 1);  // 0.4 m deep in the box, 0.2 m in the plate
}

TEST_CASE("god object: standing on a solid that moves sideways it stays under the hand") {
    GodObject proxy({plate_plan()});
    proxy.reset(Vector3(0.0, 0.1, 0.0));
    for (int i = 0; i < 200; ++i) {
        const std::array<Pose, 1> poses{Pose::at(Vector3(0.005 * i, 0.001 * i, 0.0))};
        const ProxyContact& contact = proxy.step(Vector3(0.0, -0.1, 0.0), poses);
        REQUIRE((contact.position_W - Vector3(0.0, 0.001 * i, 0.0)).norm() <= 4.0 * kExact);
    }
}

TEST_CASE("god object: two plates that close like scissors push it out of their corner") {
    // The blades cross on a line along z and open towards +x. Each turns about a line further out, so that the corner
    // moves out past the hand.
    const auto blade = [](double opening, double side) {
        const Quaternion turn(AngleAxis(side * opening, Vector3::UnitZ()));
        const Vector3 pivot(1.0, side * 0.3, 0.0);
        return Pose{pivot - turn * Vector3(1.0, 0.0, 0.0), turn};
    };
    GodObject proxy({plate_plan(blade(0.2, -1.0)), plate_plan(blade(0.2, 1.0))});
    const Vector3 hand(0.2, 0.0, 0.05);
    proxy.reset(hand);
    for (double opening = 0.2; opening < 0.7; opening += 0.003) {
        const std::array<Pose, 2> poses{blade(opening, -1.0), blade(opening, 1.0)};
        const ProxyContact& contact = proxy.step(hand, poses);
        REQUIRE((poses[0].inverse() * contact.position_W).y() > 0.0);
        REQUIRE((poses[1].inverse() * contact.position_W).y() < 0.0);
        // The blades meet where 0.3 = (1 - x) tan(opening).
        const double corner = 1.0 - 0.3 / std::tan(opening);
        REQUIRE((contact.position_W - Vector3(std::max(corner, 0.2), 0.0, 0.05)).norm() <= 1e-7);
    }
    CHECK(proxy.contact().n_constraints == 2);
    CHECK(proxy.n_squeezed() == 0);
}

TEST_CASE("god object: an edge that comes down on it above a plate pushes it out of the gap") {
    const Quaternion edge_down(AngleAxis(std::numbers::pi / 4.0, Vector3::UnitZ()));
    const auto above = [&edge_down](double height) {
        return Pose{Vector3(0.0, height, 0.0), edge_down};
    };
    GodObject proxy({box_plan(Vector3::Ones(), above(1.5)), plate_plan()});
    const Vector3 hand(0.05, 0.02, 0.0);
    proxy.reset(hand);
    const double edge_height = std::sqrt(0.5);
    for (double height = 1.5; height > edge_height + 1e-3; height -= 0.011) {
        const std::array<Pose, 2> poses{above(height), Pose::at(Vector3::Zero())};
        const ProxyContact& contact = proxy.step(hand, poses);
        REQUIRE(contact.position_W.y() > 0.0);
        REQUIRE((poses[0].inverse() * contact.position_W).cwiseAbs().maxCoeff() > 0.5);
        // The side above the hand is y = height - edge_height + x: out along its normal, down to the plate at most.
        const double too_high = hand.y() - (height - edge_height + hand.x());
        const Vector3 expected =
            too_high > 0.0 ? Vector3(hand + 0.5 * too_high * Vector3(1.0, -1.0, 0.0)) : hand;
        REQUIRE((contact.position_W - expected).norm() <= 1e-8);
    }
    CHECK(proxy.n_squeezed() == 0);
}

TEST_CASE("god object: pressed flat between two solids it lets one pass, counts it, stays finite") {
    GodObject proxy({plate_plan(Pose::at(Vector3(0.0, -1.0, 0.0))),
                     plate_plan(Pose::at(Vector3(0.0, 1.0, 0.0)))});
    proxy.reset(Vector3::Zero());
    std::array<Pose, 2> poses{Pose::at(Vector3(0.0, -1.0, 0.0)), Pose::at(Vector3(0.0, 1.0, 0.0))};
    proxy.step(Vector3::Zero(), poses);
    for (int i = 0; i < 400; ++i) {
        poses = {Pose::at(Vector3(0.0, -1.0 + 0.005 * i, 0.0)),
                 Pose::at(Vector3(0.0, 1.0 - 0.005 * i, 0.0))};
        REQUIRE(is_finite(proxy.step(Vector3::Zero(), poses).position_W));
    }
    CHECK(proxy.n_squeezed() >= 1);
    CHECK(proxy.n_squeezed() <= 2);
}

TEST_CASE("god object: a hand that is not finite or absurdly far leaves it where it was") {
    GodObject proxy({plate_plan()});
    proxy.reset(Vector3(0.1, 0.3, 0.2));
    proxy.step(Vector3(0.1, -0.3, 0.2), {});
    const ProxyContact before = proxy.contact();
    REQUIRE(before.solid == 0);
    for (const double bad : {kNan, kInfinity, -1e300}) {
        for (int axis = 0; axis < 3; ++axis) {
            Vector3 hand(0.1, 0.5, 0.2);
            hand[axis] = bad;
            const ProxyContact& contact = proxy.step(hand, {});
            CHECK(contact.position_W == before.position_W);
            CHECK(contact.solid == before.solid);
            proxy.reset(hand);
            CHECK(proxy.contact().position_W == before.position_W);
        }
    }
    // And goes on as if nothing had been.
    CHECK(proxy.step(Vector3(0.1, 0.5, 0.2), {}).position_W == Vector3(0.1, 0.5, 0.2));
}

TEST_CASE("god object: a pose that is not finite is ignored, one not of unit length is made so") {
    GodObject proxy({plate_plan()});
    proxy.reset(Vector3(0.1, 0.3, 0.2));
    const Vector3 below(0.1, -0.3, 0.2);
    proxy.step(below, std::array{Pose::at(Vector3(0.0, 0.1, 0.0))});
    CHECK(proxy.contact().position_W.y() == Approx(0.1).epsilon(1e-8));
    std::array<Pose, 4> bad{Pose::at(Vector3(0.0, kNan, 0.0)), Pose::at(Vector3::Zero()),
                            Pose::at(Vector3::Zero()), Pose::at(Vector3::Zero())};
    bad[1].orientation.w() = kNan;
    bad[2].orientation.coeffs().setZero();
    bad[3].orientation.coeffs().setConstant(kInfinity);
    for (const Pose& pose : bad) {
        CHECK(proxy.step(below, std::span(&pose, 1)).position_W.y() == Approx(0.1).epsilon(1e-8));
    }
    Pose doubled = Pose::at(Vector3(0.0, 0.2, 0.0));
    doubled.orientation.coeffs() *= 2.0;
    CHECK(proxy.step(below, std::span(&doubled, 1)).position_W.y() == Approx(0.2).epsilon(1e-8));
    // No poses at all: as they were.
    CHECK(proxy.step(below, {}).position_W.y() == Approx(0.2).epsilon(1e-8));
}

TEST_CASE("god object: which side a start is on, a reset lets in or out; no solids, no proxy") {
    const SolidPlan plan = box_plan(Vector3::Ones());
    for (const Vector3& start : {Vector3(0.2, 0.5, 0.1), Vector3(0.0, 0.5, 0.0),
                                 Vector3(0.5, 0.5, 0.1), Vector3(0.5, 0.5, 0.5)}) {
        GodObject proxy({plan});
        proxy.reset(start);
        CHECK((proxy.contact().position_W - start).norm() <= 1e-7);
        // Out of the box it follows freely, into it not at all.
        CHECK(proxy.step(0.9 * start, {}).position_W.cwiseAbs().maxCoeff() > 0.5);
        CHECK(proxy.step(1.5 * start, {}).position_W == Vector3(1.5 * start));
    }
    GodObject proxy({box_plan(Vector3::Ones())});
    proxy.reset(Vector3(0.1, 0.2, 0.3));
    CHECK((proxy.step(Vector3(0.1, 0.9, 0.3), {}).position_W - Vector3(0.1, 0.5, 0.3)).norm() <=
          kExact);
    proxy.reset(Vector3(0.1, 0.9, 0.3));
    CHECK(proxy.contact().n_constraints == 0);
    CHECK(proxy.step(Vector3(0.1, 0.8, 0.3), {}).position_W == Vector3(0.1, 0.8, 0.3));
    GodObject other(std::vector<SolidPlan>{});
    CHECK(other.step(Vector3(1.0, 2.0, 3.0), {}).position_W == Vector3(1.0, 2.0, 3.0));
}

}  // namespace
}  // namespace fulcrum
