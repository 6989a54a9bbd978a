#include "haptics/geometry/shape.h"
#include "haptics/point/god_object.h"
#include "tests/support/bumpy_ball.h"
#include "tests/support/nearest_point.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <random>

using namespace fulcrum;

namespace {

constexpr double kDepth = 0.02;  // of the radius: how deep the hand presses
constexpr double kNearest =
    2.0e-5;  // the claim: the proxy's distance from the nearest point, in radii

// Is there a free direction in which the proxy would come nearer to the hand? Then something holds it that is not there.
bool is_snagged(const CollisionMesh& mesh, const Vector3& proxy, const Vector3& hand,
                std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    const Vector3 pull = (hand - proxy).normalized();
    for (int i = 0; i < 100; ++i) {
        const Vector3 way = Vector3(normal(random), normal(random), normal(random)).normalized();
        if (way.dot(pull) > 0.05 && !find_nearest_hit(mesh, proxy, proxy + 1e-6 * way).found()) {
            return true;
        }
    }
    return false;
}

// Presses and wanders; stops now and then, where nothing may hold the proxy that is not there.
template <class Radius>
void check_no_snag(const CollisionMesh& mesh, double depth, int n_steps, Radius&& radius) {
    GodObject proxy({SolidPlan{.body = 0,
                               .shape = std::shared_ptr<const CollisionMesh>(&mesh, [](auto*) {}),
                               .initial_pose_W = {}}});
    Wanderer wanderer(7);
    std::mt19937_64 random(8);
    const Vector3 start = wanderer.next();
    const double start_side = depth > 0.0 ? 1.0 : -1.0;
    proxy.reset(start * (radius(start) + 0.3 * start_side));
    int n_snagged = 0;
    int n_far = 0;
    for (int i = 0; i < n_steps; ++i) {
        const Vector3& u = wanderer.next();
        const Vector3 hand = u * (radius(u) - depth);
        proxy.step(hand, {});
        n_far += (proxy.contact().position_W - hand).norm() > 3.0 * std::abs(depth) ? 1 : 0;
        if (i % 50 == 49) {
            for (int still = 0; still < 3; ++still) {
                proxy.step(hand, {});
            }
            REQUIRE(proxy.contact().solid == 0);
            n_snagged += is_snagged(mesh, proxy.contact().position_W, hand, random) ? 1 : 0;
        }
    }
    CHECK(n_snagged == 0);
    CHECK(n_far == 0);
}

// A star-shaped body: a point is outside when nothing lies between it and far away, straight from the centre.
bool is_outside(const CollisionMesh& mesh, const Vector3& p_B) {
    return p_B.norm() > 0.5 && !find_nearest_hit(mesh, p_B, 5.0 * p_B).found();
}

}  // namespace

// Hard cases for the god-object: fine, shallow, noisy, thin and cracked meshes, fast hands, tumbling bodies, soups.

TEST_CASE(
    "god object: pressed 2 % deep at 4 radii a second it is at the nearest point, on 1 k and 100 k "
    "triangles") {
    for (const int frequency : {7, 71}) {
        const auto mesh = touchable(make_sphere(1.0, frequency));
        // From inside, edges are concave and the nearest point is one; from outside each face holds the proxy until its
        // foot leaves the face, so that only the distance must agree, to depth (1 - cos of the angle between faces).
        const double between_faces = 1.3 / frequency;
        for (const double side : {-1.0, 1.0}) {
            const double most_excess =
                side < 0.0 ? kNearest
                           : std::max(kNearest, kDepth * (1.0 - std::cos(between_faces)));
            GodObject proxy({SolidPlan{.body = 0, .shape = mesh, .initial_pose_W = {}}});
            Wanderer wanderer(3);
            proxy.reset(wanderer.next() * (1.0 + 0.3 * side));
            for (int i = 0; i < 3000; ++i) {
                const Vector3 hand = wanderer.next() * (1.0 - kDepth * side);
                const ProxyContact& contact = proxy.step(hand, {});
                if (i % 61 != 60) {
                    continue;
                }
                const Vector3 nearest = find_nearest_on_mesh(*mesh, hand);
                const double excess = (contact.position_W - hand).norm() - (nearest - hand).norm();
                REQUIRE(excess <= most_excess);
                REQUIRE(excess >= -1e-12);
                if (side < 0.0) {
                    REQUIRE((contact.position_W - nearest).norm() <= kNearest);
                }
            }
        }
    }
}

TEST_CASE("god object: nothing snags on bumps, nearly flat meshes, noise, slivers or a ring") {
    for (const int frequency : {7, 22, 71, 150}) {
        const auto mesh = touchable(make_bumpy_sphere(1.0, frequency, kBumpHeight, kBumps));
        // The coarsest does not resolve the bumps, so its facets reach further from the true surface.
        if (frequency > 7) {
            check_no_snag(*mesh, kDepth, 20000, bumpy_radius);
            check_no_snag(*mesh, -kDepth, 20000, bumpy_radius);
        } else {
            check_no_snag(*mesh, 3.0 * kDepth, 20000, bumpy_radius);
            check_no_snag(*mesh, -3.0 * kDepth, 20000, bumpy_radius);
        }
    }
    // Angles between neighbours down to some 1e-5 and 1e-8 of a radian.
    for (const double height : {1e-4, 1e-7}) {
        const auto mesh = touchable(make_bumpy_sphere(1.0, 71, height, 60.0));
        check_no_snag(*mesh, -kDepth, 10000, [](const Vector3&) { return 1.0; });
        check_no_snag(*mesh, kDepth, 10000, [](const Vector3&) { return 1.0; });
    }
    auto noisy = make_sphere(1.0, 50);
    std::vector<Vector3> vertices = noisy->vertices_B();
    std::mt19937_64 random(9);
    std::normal_distribution<double> normal;
    for (Vector3& vertex : vertices) {
        vertex *= 1.0 + 0.002 * normal(random);
    }
    const auto sphere = [](const Vector3&) { return 1.0; };
    check_no_snag(*touchable(TriangleMesh::build(vertices, noisy->triangles())), kDepth, 20000,
                  sphere);
    check_no_snag(*touchable(TriangleMesh::build(vertices, noisy->triangles())), -kDepth, 20000,
                  sphere);
    check_no_snag(*touchable(make_globe(1.0, 2000, 12)), 3.0 * kDepth, 20000, sphere);
    check_no_snag(*touchable(make_globe(1.0, 2000, 12)), -3.0 * kDepth, 20000, sphere);
    check_no_snag(*touchable(make_globe(1.0, 8, 2000)), -8.0 * kDepth, 20000, sphere);
}

TEST_CASE("god object: a mesh turned inside out feels the same, to the bit") {
    const auto mesh = make_bumpy_sphere(1.0, 30, kBumpHeight, kBumps);
    GodObject front({SolidPlan{.body = 0, .shape = touchable(mesh), .initial_pose_W = {}}});
    GodObject back(
        {SolidPlan{.body = 0, .shape = touchable(make_inverted(*mesh)), .initial_pose_W = {}}});
    Wanderer wanderer(5);
    front.reset(1.3 * wanderer.next());
    back.reset(front.contact().position_W);
    for (int i = 0; i < 20000; ++i) {
        const Vector3& u = wanderer.next();
        const Vector3 hand = u * (bumpy_radius(u) - kDepth);
        REQUIRE((front.step(hand, {}).position_W - back.step(hand, {}).position_W).norm() <= 1e-9);
    }
}

TEST_CASE("god object: cracks that the weld closes leak nowhere, not along them either") {
    // Each triangle has corners of its own, moved apart by up to 1e-4 of the radius.
    const auto whole = make_bumpy_sphere(1.0, 12, kBumpHeight, 5.0);
    std::vector<Vector3> vertices;
    std::vector<TriangleCorners> triangles;
    std::mt19937_64 random(10);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (const TriangleCorners& t : whole->triangles()) {
        const auto first = static_cast<std::int32_t>(vertices.size());
        for (const std::int32_t corner : t) {
            vertices.emplace_back(whole->vertices_B()[static_cast<std::size_t>(corner)] +
                                  2.5e-5 * Vector3(unit(random), unit(random), unit(random)));
        }
        triangles.push_back({first, first + 1, first + 2});
    }
    const auto mesh = touchable(TriangleMesh::build(vertices, triangles, {.weld_relative = 1e-4}));
    for (unsigned seed = 0; seed < 50; ++seed) {
        GodObject proxy({SolidPlan{.body = 0, .shape = mesh, .initial_pose_W = {}}});
        Wanderer wanderer(100 + seed);
        proxy.reset(1.5 * wanderer.next());
        for (int i = 0; i < 1000; ++i) {
            const ProxyContact& contact = proxy.step(wanderer.next() * (0.95 - kDepth), {});
            REQUIRE_FALSE(
                find_nearest_hit(*mesh, contact.position_W, 3.0 * contact.position_W).found());
        }
    }
}

// The god-object under fast hands, tumbling bodies and meshes that are no surface.

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
