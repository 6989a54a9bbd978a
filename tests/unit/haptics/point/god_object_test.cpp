#include "haptics/point/god_object.h"

#include "haptics/geometry/shape.h"
#include "tests/support/edited_meshes.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

using namespace fulcrum;

namespace {

constexpr double kExact = 1.0e-9;
constexpr double kClearance = 1.0e-10;

SolidPlan solid_of(const Expected<TriangleMesh>& mesh, const Pose& pose_W = {}) {
    return only_solid(touchable(mesh), pose_W).front();
}

}  // namespace

TEST_CASE("god object: the whole path scales to the last bit: no tolerance is absolute") {
    const auto trace = [](double scale) {
        GodObject proxy(only_solid(touchable(make_bumpy_sphere(scale, 20, 0.05, 12.0))));
        proxy.reset(scale * Vector3(1.3, 0.0, 0.0));
        std::vector<Vector3> path;
        for (int i = 0; i < 3000; ++i) {
            const double turn = 0.004 * i;
            const Vector3 wish = Vector3(std::cos(turn), std::sin(turn) * std::cos(0.3 * turn),
                                         std::sin(turn) * std::sin(0.3 * turn));
            path.push_back(proxy.step(scale * (0.97 * wish), {}).position_W / scale);
        }
        return path;
    };
    const std::vector<Vector3> reference = trace(1.0);
    for (const int power : {-14, -40, 13, 40}) {  // 6e-5, 1e-12, 8e3 and 1e12 metres
        const std::vector<Vector3> scaled = trace(std::ldexp(1.0, power));
        for (std::size_t i = 0; i < reference.size(); ++i) {
            REQUIRE(scaled[i] == reference[i]);
        }
    }
}

TEST_CASE("god object: a plate that moves or turns through a still hand takes the proxy along") {
    const auto plate = touchable(make_plate(1.0, 1.0, 5));
    for (const double side : {1.0, -1.0}) {
        for (const double speed : {1e-3, 0.037, 0.5}) {
            const Vector3 still(0.1, 0.0, 0.07);
            GodObject proxy(only_solid(plate, Pose::at(Vector3(0.0, -0.9 * side, 0.0))));
            proxy.reset(still);
            for (double height = -0.9; height < 0.9; height += speed) {
                const Pose pose = Pose::at(Vector3(0.0, height * side, 0.0));
                const ProxyContact& contact = proxy.step(still, std::span(&pose, 1));
                // Never on the plate's other side; free until it comes, on it after.
                REQUIRE(side * (contact.position_W.y() - pose.position.y()) > 0.0);
                const double expected = height < 0.0 ? 0.0 : side * height;
                REQUIRE((contact.position_W - Vector3(0.1, expected, 0.07)).norm() <= kExact);
            }
            CHECK(proxy.n_squeezed() == 0);
        }
    }
}

TEST_CASE("god object: a turning plate sweeps the proxy round, in small and in large turns") {
    const auto plate = touchable(make_plate(2.0, 2.0, 3));
    for (const double turn_a_step : {0.003, 0.1, 0.7}) {
        const Vector3 still(0.5, 0.2, 0.03);
        GodObject proxy(only_solid(plate));
        proxy.reset(still);
        for (double turn = 0.0; turn < 1.5; turn += turn_a_step) {
            const Pose pose{Vector3::Zero(), Quaternion(AngleAxis(turn, Vector3::UnitZ()))};
            const Vector3 in_plate =
                pose.inverse() * proxy.step(still, std::span(&pose, 1)).position_W;
            REQUIRE(in_plate.y() > 0.0);
            const Vector3 wish_in_plate = pose.inverse() * still;
            REQUIRE((in_plate - Vector3(wish_in_plate.x(), std::max(wish_in_plate.y(), 0.0),
                                        wish_in_plate.z()))
                        .norm() <= 2.0 * kExact);
        }
    }
}

TEST_CASE("god object: whichever structure finds the triangles, it goes the same way to the bit") {
    const auto mesh = touchable(make_bumpy_sphere(1.0, 12, 0.05, 9.0));
    GodObject by_tree(only_solid(mesh));
    GodObject by_grid(only_solid(mesh), SegmentStructureKind::h_collide);
    GodObject by_all(only_solid(mesh), SegmentStructureKind::brute_force);
    Random random(77);
    Vector3 hand(1.2, 0.0, 0.0);
    int n_touching = 0;
    for (GodObject* const proxy : {&by_tree, &by_grid, &by_all}) {
        proxy->reset(hand);
    }
    for (int i = 0; i < 3000; ++i) {
        hand = 0.98 * hand + 0.03 * random.vector();
        Pose pose;
        pose.position = 0.1 * Vector3(std::sin(0.01 * i), 0.0, 0.0);
        const Vector3 place = by_tree.step(hand, std::span(&pose, 1)).position_W;
        REQUIRE(by_grid.step(hand, std::span(&pose, 1)).position_W == place);
        REQUIRE(by_all.step(hand, std::span(&pose, 1)).position_W == place);
        n_touching += by_all.contact().solid == 0 ? 1 : 0;
    }
    CHECK(n_touching > 300);
}

TEST_CASE("god object: triangles are at hand from step to step, as often at any scale and speed") {
    std::array<std::uint64_t, 3> n_searches{};
    for (const double step_rad : {0.0004, 0.004}) {
        for (std::size_t i = 0; i < 3; ++i) {
            // Powers of two, so that the ways are the same but for the scale.
            const double scale = std::ldexp(1.0, 10 * (static_cast<int>(i) - 1));
            const auto mesh = touchable(make_sphere(scale, 32));
            GodObject proxy(only_solid(mesh));
            Wanderer wanderer(3, step_rad);
            proxy.reset(1.2 * scale * wanderer.next());
            for (int k = 0; k < 4000; ++k) {
                proxy.step(0.98 * scale * wanderer.next(), {});
            }
            n_searches[i] = proxy.n_searches();
        }
        CHECK(n_searches[0] == n_searches[1]);
        CHECK(n_searches[2] == n_searches[1]);
        CHECK(n_searches[1] > 0);
        CHECK(n_searches[1] < 200);
    }
}

// The god-object at the limits of its own lengths: clearance, slack, gain; and where one answer hides another.

TEST_CASE("god object: pressed by less than its clearance it stands still and costs no search") {
    GodObject proxy({solid_of(make_plate(1.0, 1.0, 3))});
    const double clearance_m = kClearance * std::sqrt(0.5);
    proxy.reset(Vector3(0.1, 0.2, 0.03));
    proxy.step(Vector3(0.1, -0.2, 0.03), {});
    for (const double depth : {2.0, 0.4, 0.1, 0.4, 2.0}) {
        const ProxyContact& contact = proxy.step(Vector3(0.1, -depth * clearance_m, 0.03), {});
        CHECK(contact.n_constraints == 1);
        CHECK(contact.position_W.y() == Approx(clearance_m).epsilon(1e-3));
        CHECK(proxy.n_sweeps() <= 2);
    }
}

TEST_CASE("god object: past an edge it lets go however little there is to gain") {
    GodObject proxy({solid_of(make_box(Vector3::Ones()))});
    proxy.reset(Vector3(0.45, 0.6, 0.1));
    // Five thousand-millionths of a metre below the top: some fifty clearances.
    for (const double x : {0.45, 0.49, 0.5001, 0.52}) {
        proxy.step(Vector3(x, 0.5 - 5.0e-9, 0.1), {});
        CHECK(proxy.contact().solid == (x < 0.5 ? 0 : kNoBody));
    }
    CHECK(proxy.contact().position_W == Vector3(0.52, 0.5 - 5.0e-9, 0.1));
}

TEST_CASE("god object: in a gap narrower than its clearances it slides along, and stays between") {
    constexpr double kGap_m = 0.5e-10;  // the plates' clearances are 0.7e-10 each
    const auto plate = make_plate(1.0, 1.0, 3);
    const std::array<Pose, 2> poses{Pose::at(Vector3::Zero()), Pose::at(Vector3(0.0, kGap_m, 0.0))};
    GodObject proxy({solid_of(plate, poses[0]), solid_of(plate, poses[1])});
    proxy.reset(Vector3(-0.3, 0.5 * kGap_m, 0.05));
    for (int i = 0; i <= 100; ++i) {
        const Vector3 hand(-0.3 + 0.006 * i, i % 2 == 0 ? -0.1 : 0.1, 0.05 + 0.001 * i);
        const ProxyContact& contact = proxy.step(hand, poses);
        REQUIRE(contact.position_W.x() == Approx(hand.x()).margin(1e-12));
        REQUIRE(contact.position_W.z() == Approx(hand.z()).margin(1e-12));
        REQUIRE(contact.position_W.y() > 0.0);
        REQUIRE(contact.position_W.y() < kGap_m);
    }
}

TEST_CASE("god object: what it touches takes it along, and over nothing that stands on it") {
    // A tray with a low wall across its middle; the proxy stands left of the wall, pressed down.
    const auto tray = TriangleMesh::build(
        {Vector3(-1, 0, -1), Vector3(1, 0, -1), Vector3(1, 0, 1), Vector3(-1, 0, 1),
         Vector3(0, 0, -1), Vector3(0, 0, 1), Vector3(0, 0.1, -1), Vector3(0, 0.1, 1)},
        {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {5, 7, 6}});
    GodObject proxy({solid_of(tray)});
    const Vector3 hand(-0.1, -0.5, 0.0);
    proxy.reset(Vector3(-0.1, 0.5, 0.0));
    proxy.step(hand, std::array{Pose::at(Vector3::Zero())});
    REQUIRE(proxy.contact().solid == 0);
    // Down and left in one step: a proxy that stayed where it was would fly over the wall, and the hand is beyond it.
    const Pose moved = Pose::at(Vector3(-0.2, -0.3, 0.0));
    const ProxyContact& contact = proxy.step(hand, std::array{moved});
    CHECK((contact.position_W - moved.position).norm() < 1e-9);
    CHECK(contact.n_constraints == 2);
}

TEST_CASE("god object: carried into a second solid it stays rather than go with that") {
    // The plate slides under it, towards a wall that moves sideways with a rib on it.
    const auto wall =
        TriangleMesh::build({Vector3(0.2, -1, -1), Vector3(0.2, 1, -1), Vector3(0.2, 1, 1),
                             Vector3(0.2, -1, 1), Vector3(0.05, -1, -0.15), Vector3(0.2, -1, -0.15),
                             Vector3(0.2, 1, -0.15), Vector3(0.05, 1, -0.15)},
                            {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}});
    GodObject proxy({solid_of(make_plate(4.0, 4.0, 3)), solid_of(wall)});
    proxy.reset(Vector3(0.0, 0.1, 0.0));
    proxy.step(Vector3(0.0, -0.1, 0.0),
               std::array{Pose::at(Vector3::Zero()), Pose::at(Vector3::Zero())});
    REQUIRE(proxy.contact().solid == 0);
    const ProxyContact& contact =
        proxy.step(Vector3(0.19, -0.1, 0.0),
                   std::array{Pose::at(Vector3(0.3, 0.0, 0.0)), Pose::at(Vector3(0.0, 0.0, 0.3))});
    // From there the way to the hand is free; from where the wall would have taken it the rib is before the hand.
    CHECK((contact.position_W - Vector3(0.19, 0.0, 0.0)).norm() < 1e-9);
    CHECK(contact.n_constraints == 1);
}

TEST_CASE("god object: on a floor beside a ridge only what it stands on holds it") {
    // Three roofs that meet in a spike, cut by a floor.
    const auto spike = TriangleMesh::build(
        {Vector3(0, 0.4, 0), Vector3(1, 0.4, 0), Vector3(-0.5, -0.4, 0.8),
         Vector3(-0.5, -0.2, -0.8), Vector3(-3, 0, -3), Vector3(3, 0, -3), Vector3(0, 0, 4)},
        {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {4, 6, 5}});
    GodObject proxy({solid_of(spike)});
    proxy.reset(Vector3(0.1, 1.0, -0.15));
    // In the groove of the first roof, y + z = 0.4, and the floor.
    proxy.step(Vector3(-0.05, -0.35, 0.3), {});
    CHECK((proxy.contact().position_W - Vector3(-0.05, 0.0, 0.4)).norm() < 1e-9);
    CHECK(proxy.contact().n_constraints == 2);
    // Along the groove's line, but past the ridge where that roof ends: the floor alone.
    proxy.step(Vector3(-0.3, 0.0, 0.4), {});
    CHECK((proxy.contact().position_W - Vector3(-0.3, 0.0, 0.4)).norm() < 1e-9);
    CHECK(proxy.contact().n_constraints == 1);
    // And on to the foot on the second roof.
    const Vector3 hand(0.1, -0.1, -0.35);
    const Vector3 normal = Vector3(-0.5, -0.6, -0.8).cross(Vector3(-0.5, -0.8, 0.8)).normalized();
    const Vector3 foot = hand - normal.dot(hand - Vector3(0.0, 0.4, 0.0)) * normal;
    proxy.step(hand, {});
    CHECK((proxy.contact().position_W - foot).norm() < 1e-9);
}

TEST_CASE("god object: a start in a face with another right before it goes behind the face") {
    const SolidPlan lower = solid_of(make_plate(1.0, 1.0, 3));
    const Vector3 start(0.1, 0.0, 0.03);
    MovingSolid solid(lower, 0);
    solid.put_proxy(start);
    const double clearance_m = solid.find_plane(solid.find_touching().triangle, 1).clearance_m;
    SolidPlan upper = lower;
    upper.initial_pose_W = Pose::at(Vector3(0.0, clearance_m, 0.0));
    GodObject proxy({lower, upper});
    proxy.reset(start);
    CHECK(proxy.contact().position_W == Vector3(0.1, -clearance_m, 0.03));
}

TEST_CASE("god object: a hand up to 1e30 m away is followed, and the smallest mesh touched") {
    GodObject proxy({solid_of(make_plate(1.0, 1.0, 3))});
    CHECK(proxy.step(Vector3(0.0, 1.0e30, 0.0), {}).position_W.y() == 1.0e30);
    CHECK(proxy.step(Vector3(0.0, 1.001e30, 0.0), {}).position_W.y() == 1.0e30);
    constexpr double kScale = 1.0e-30;
    GodObject other({solid_of(test::move_corners(
        *make_box(Vector3::Ones()), [](const Vector3& v) { return Vector3(kScale * v); }))});
    other.reset(kScale * Vector3(0.1, 0.9, -0.2));
    const ProxyContact& contact = other.step(kScale * Vector3(0.13, 0.3, -0.22), {});
    CHECK((contact.position_W / kScale - Vector3(0.13, 0.5, -0.22)).norm() < 1e-9);
    CHECK(contact.n_constraints == 1);
}
