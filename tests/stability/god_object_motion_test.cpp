// The god-object under fast hands, tumbling bodies and meshes that are no surface.
#include "haptics/geometry/shape.h"
#include "haptics/point/god_object.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace fulcrum {
namespace {

// A star-shaped body: a point is outside when nothing lies between it and far away, straight from the centre.
bool is_outside(const CollisionMesh& mesh, const Vector3& p_B) {
    return p_B.norm() > 0.5 && !find_nearest_hit(mesh, p_B, 5.0 * p_B).found();
}

TEST_CASE("god object: a hand that jumps about wildly never gets the proxy into a closed body") {
    const auto mesh = touchable(make_bumpy_sphere(1.0, 20, 0.05, 12.0));
    for (const double jump : {1e-6, 1e-3, 0.1, 3.0}) {
        Random random(12);
        GodObject proxy({SolidPlan{.body = 0, .shape = mesh, .initial_pose_W = {}}});
        Vector3 hand(1.2, 0.0, 0.0);
        proxy.reset(hand);
        for (int i = 0; i < 20000; ++i) {
            hand += jump * random.vector();
            hand *= hand.norm() > 1.5 ? 0.5 : 1.0;
            REQUIRE(is_outside(*mesh, proxy.step(hand, {}).position_W));
        }
    }
}

TEST_CASE("god object: bodies that tumble and jump never pass over the proxy") {
    const auto mesh = touchable(make_bumpy_sphere(1.0, 12, 0.05, 12.0));
    for (const double motion : {1e-3, 0.05, 0.8}) {
        Random random(13);
        GodObject proxy({SolidPlan{.body = 0, .shape = mesh, .initial_pose_W = {}}});
        Pose pose;
        Vector3 hand(1.2, 0.0, 0.0);
        proxy.reset(hand);
        for (int i = 0; i < 10000; ++i) {
            pose.position = 0.9 * pose.position + motion * random.vector();
            pose.orientation = random.turn(motion) * pose.orientation;
            hand = 0.9 * hand + 0.3 * motion * random.vector();
            const ProxyContact& contact = proxy.step(hand, std::span(&pose, 1));
            REQUIRE(is_outside(*mesh, pose.inverse() * contact.position_W));
        }
        CHECK(proxy.n_squeezed() == 0);
    }
}

TEST_CASE("god object: two bodies that tumble together never pass over it, unless it says so") {
    const auto mesh = touchable(make_bumpy_sphere(1.0, 8, 0.05, 12.0));
    Random random(14);
    GodObject proxy(
        {SolidPlan{.body = 0,
                   .shape = mesh,
                   .initial_pose_W = {Vector3(-2.0, 0.0, 0.0), Quaternion::Identity()}},
         SolidPlan{.body = 1,
                   .shape = mesh,
                   .initial_pose_W = {Vector3(2.0, 0.0, 0.0), Quaternion::Identity()}}});
    std::array<Pose, 2> poses;
    proxy.reset(Vector3::Zero());
    std::uint64_t n_squeezed = 0;
    int n_clear = 0;
    for (int i = 0; i < 20000; ++i) {
        // They come together to a gap that closes now and then at its narrowest.
        const double apart = 1.15 + 0.2 * std::sin(0.003 * i);
        poses[0] = {Vector3(-apart, 0.0, 0.0), random.turn(0.02) * poses[0].orientation};
        poses[1] = {Vector3(apart, 0.0, 0.0), random.turn(0.02) * poses[1].orientation};
        const ProxyContact& contact =
            proxy.step(0.1 * Vector3(0.0, std::sin(0.01 * i), std::cos(0.013 * i)), poses);
        REQUIRE(is_finite(contact.position_W));
        if (proxy.n_squeezed() > n_squeezed) {
            n_squeezed = proxy.n_squeezed();
            proxy.reset(Vector3(0.0, 3.0, 0.0));  // out, and on
            continue;
        }
        ++n_clear;
        REQUIRE(is_outside(*mesh, poses[0].inverse() * contact.position_W));
        REQUIRE(is_outside(*mesh, poses[1].inverse() * contact.position_W));
    }
    CHECK(n_clear > 19000);
}

TEST_CASE("god object: triangle soups neither crash it nor make it move away from the hand") {
    for (unsigned seed = 0; seed < 30; ++seed) {
        Random random(200 + seed);
        std::vector<Vector3> vertices;
        std::vector<TriangleCorners> triangles;
        for (int i = 0; i < 120; ++i) {
            vertices.emplace_back(random.vector());
            if (i % 3 == 0) {
                vertices.back() =
                    vertices.back().cwiseRound();  // coplanar, coincident and crossing ones
            }
        }
        for (int i = 0; i < 400; ++i) {
            triangles.push_back({static_cast<std::int32_t>(random.integer() % 120),
                                 static_cast<std::int32_t>(random.integer() % 120),
                                 static_cast<std::int32_t>(random.integer() % 120)});
        }
        GodObject proxy({SolidPlan{.body = 0,
                                   .shape = touchable(TriangleMesh::build(vertices, triangles)),
                                   .initial_pose_W = {}}});
        Vector3 hand = Vector3::Zero();
        proxy.reset(hand);
        for (int i = 0; i < 2000; ++i) {
            const double before =
                (proxy.contact().position_W - (hand += 0.02 * random.vector())).norm();
            const ProxyContact& contact = proxy.step(hand, {});
            REQUIRE(is_finite(contact.position_W));
            REQUIRE((contact.position_W - hand).norm() <= before + 1e-8);
            REQUIRE(proxy.n_sweeps() <= 200);
        }
    }
}

}  // namespace
}  // namespace fulcrum
