#include "haptics/collision/mesh_obstacle.h"
#include "haptics/geometry/shape.h"
#include "haptics/point/moving_obstacle.h"
#include "haptics/point/moving_solid.h"
#include "tests/support/touchable.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <random>

using namespace fulcrum;

namespace {

constexpr double kRadius_m = 0.1;
const Pose kPose{Vector3(3.0, -2.0, 1.0), Quaternion(AngleAxis(0.8, Vector3(0.6, 0.0, 0.8)))};

MovingObstacle make_plate_at(const Pose& pose_W) {
    return {std::make_unique<MeshObstacle>(touchable(make_plate(1.0, 1.0, 1)), kRadius_m), 2,
            pose_W};
}

MovingSolid make_solid(const Expected<TriangleMesh>& mesh, const Pose& pose_W) {
    REQUIRE(mesh);
    return MovingSolid(
        {.body = 5, .shape = *CollisionMesh::create(*mesh), .initial_pose_W = pose_W}, 2);
}

}  // namespace

TEST_CASE("moving obstacle: planes and ways are those of the turned and moved solid") {
    MovingObstacle plate = make_plate_at(kPose);
    plate.put_proxy(kPose * Vector3(-0.3, -0.35, 0.1));
    const ObstaclePlane plane = plate.find_plane(0);
    CHECK(plane.solid == 2);
    CHECK((plane.normal_W - kPose.orientation * Vector3(0.0, -1.0, 0.0)).norm() < 1e-15);
    CHECK(plane.gap_m == Approx(0.25).epsilon(1e-14));
    CHECK(plane.clearance_m > 1e-11);
    CHECK(plane.clearance_m < 1e-9);
    plate = make_plate_at(Pose{});
    plate.put_proxy(Vector3(0.1, 0.2, 0.1));
    CHECK_FALSE(plate.cast(Vector3(0.1, 0.11, 0.1), 0.1, {}).found());
    CHECK(plate.cast(Vector3(0.1, 0.0, 0.1), 0.1, {}).t == Approx(0.5));
    // The plate comes up by 0.2 m past a hand that stays.
    CHECK(plate.take_pose(Pose::at(Vector3(0.0, 0.2, 0.0))));
    CHECK(plate.cast(Vector3(0.1, 0.2, 0.1), 0.1, {}).t == Approx(0.5));
    CHECK((plate.carried_proxy_W() - Vector3(0.1, 0.4, 0.1)).norm() < 1e-15);
    CHECK(plate.find_deepest() == -1);
    plate.put_proxy(Vector3(0.1, 0.25, 0.1));
    CHECK(plate.find_deepest() >= 0);
}

TEST_CASE("moving obstacle: it is near when the ball can come to touch it") {
    const MovingObstacle plate = make_plate_at(Pose::at(Vector3(5.0, 0.0, 0.0)));
    const double corner_m = std::sqrt(0.5) + kRadius_m;
    CHECK(plate.is_near(Vector3(5.0 + corner_m + 0.2, 0.0, 0.0), 0.21));
    CHECK_FALSE(plate.is_near(Vector3(5.0 + corner_m + 0.2, 0.0, 0.0), 0.19));
}

TEST_CASE("moving solid: a plane is that of the turned and moved triangle, on the side asked for") {
    const MovingSolid plate = make_solid(make_plate(1.0, 1.0, 1), kPose);
    for (const int side : {1, -1}) {
        const TouchedPlane plane = plate.find_plane(0, side);
        CHECK(plane.solid == 2);
        CHECK((plane.normal_W - kPose.orientation * Vector3(0.0, side, 0.0)).norm() < 1e-15);
        CHECK(plane.height_m(kPose * Vector3(0.3, 0.25 * side, -0.1)) ==
              Approx(0.25).epsilon(1e-14));
        CHECK(plane.clearance_m > 1e-11);
        CHECK(plane.clearance_m < 1e-9);
    }
}

TEST_CASE("moving solid: a sweep runs from the place in the solid to the target in it now") {
    MovingSolid plate = make_solid(make_plate(1.0, 1.0, 1), Pose{});
    plate.put_proxy(Vector3(0.1, 0.2, 0.3));
    CHECK_FALSE(plate.sweep(Vector3(0.1, 0.1, 0.3)).found());
    // The plate rises past the proxy: the same target now lies below it.
    plate.take_pose({Vector3(0.0, 0.5, 0.0), Quaternion::Identity()});
    const SegmentHit hit = plate.sweep(Vector3(0.1, 0.1, 0.3));
    CHECK(hit.found());
    CHECK(hit.side == 1);
    CHECK(hit.t == Approx(0.2 / 0.6).epsilon(1e-14));
}

TEST_CASE("moving solid: what is remembered around the proxy answers as the tree does") {
    MovingSolid ball = make_solid(make_bumpy_sphere(1.0, 20, 0.05, 9.0), kPose);
    std::mt19937_64 random(19);
    std::normal_distribution<double> normal;
    const auto vector = [&]() -> Vector3 {
        return {normal(random), normal(random), normal(random)};
    };
    int n_hits = 0;
    for (int place = 0; place < 200; ++place) {
        Vector3 at = 1.02 * vector().normalized();
        for (int step = 0; step < 50; ++step) {
            at += 0.003 * vector();
            ball.put_proxy(kPose * at);
            const Vector3 to = kPose * (at + (step % 3 == 0 ? 0.5 : 0.02) * vector());
            const SegmentHit near = ball.sweep_nearby(to, 0.01);
            const SegmentHit all = ball.sweep(to);
            REQUIRE(near.triangle == all.triangle);
            REQUIRE(near.t == all.t);
            n_hits += all.found() ? 1 : 0;
        }
    }
    CHECK(n_hits > 1000);
}

TEST_CASE("moving solid: one that looks ahead answers as the tree does and seldom has to search") {
    const auto slide = [](bool looks_ahead) {
        MovingSolid ball = make_solid(make_bumpy_sphere(1.0, 70, 0.03, 20.0), kPose);
        for (int step = 0; step < 2000; ++step) {
            const double turn = 0.004 * step;
            const Vector3 at = 1.035 * Vector3(std::cos(turn), std::sin(turn), 0.1).normalized();
            ball.put_proxy(kPose * at);
            const Vector3 to = kPose * (0.99 * at);
            const SegmentHit near = ball.sweep_nearby(to, 0.004);
            const SegmentHit all = ball.sweep(to);
            REQUIRE(near.triangle == all.triangle);
            REQUIRE(near.t == all.t);
            if (looks_ahead) {
                ball.look_ahead(0.004);
            }
        }
        return ball.n_searches();
    };
    const std::uint64_t n_without = slide(false);
    CHECK(n_without > 100);
    CHECK(slide(true) * 5 < n_without);
}

TEST_CASE("moving solid: a step looks into six nodes ahead and no more") {
    constexpr int kNodesAStep = 6;
    const auto mesh = make_bumpy_sphere(1.0, 70, 0.03, 20.0);
    const auto collision = CollisionMesh::create(mesh.value());
    REQUIRE(collision);
    const Vector3 along = Vector3::UnitZ();
    const Vector3 from(1.035, 0.0, 0.0);
    int n_tried = 0;
    for (const double reach_m : {0.0165, 0.02, 0.025}) {
        // What comes next lies six reaches on, two reaches around: so many nodes are looked into.
        const Vector3 next = from + 6.0 * reach_m * along;
        const Vector3 margin = Vector3::Constant(2.0 * reach_m);
        NearbyTriangles whole;
        whole.begin_ahead(**collision, {next - margin, next + margin});
        int n_nodes = 1;
        while (whole.go_on_ahead(**collision, 1) == Collecting::goes_on) {
            ++n_nodes;
        }
        REQUIRE(whole.covers_ahead(next));
        const int n_steps = (n_nodes + kNodesAStep - 1) / kNodesAStep;
        REQUIRE(n_steps >= 2);
        const auto has_to_search_after = [&](int steps) {
            MovingSolid ball = make_solid(mesh, Pose{});
            ball.put_proxy(from);
            ball.look_ahead(reach_m);
            (void)ball.sweep_nearby(from - 0.1 * reach_m * Vector3::UnitX(), reach_m);
            ball.put_proxy(from + 1.5 * reach_m * along);
            for (int step = 0; step < steps; ++step) {
                ball.look_ahead(reach_m);
            }
            ball.put_proxy(next);
            const auto before = ball.n_searches();
            (void)ball.sweep_nearby(next - 0.1 * reach_m * Vector3::UnitX(), reach_m);
            return ball.n_searches() > before;
        };
        CHECK(has_to_search_after(n_steps - 1));
        CHECK_FALSE(has_to_search_after(n_steps));
        ++n_tried;
    }
    CHECK(n_tried == 3);
}

TEST_CASE("moving solid: over a triangle means that the foot lies within its edges") {
    MovingSolid plate = make_solid(make_plate(1.0, 1.0, 1), kPose);
    for (const double height : {-0.3, 1e-9, 2.0}) {
        const auto over = [&](double x, double z) {
            plate.put_proxy(kPose * Vector3(x, height, z));
            return std::pair(plate.is_over(0), plate.is_over(1));
        };
        // The square's two halves part along a diagonal: a place is over one of them, or, beside the square, over none.
        CHECK(over(0.3, -0.1) != over(-0.1, 0.3));
        CHECK(over(0.3, -0.1).first != over(0.3, -0.1).second);
        CHECK(over(0.6, 0.1) == std::pair(false, false));
        CHECK(over(-0.2, -0.51) == std::pair(false, false));
    }
}

TEST_CASE("moving solid: near is all that a ball can reach; a turn of any length is that turn") {
    const MovingSolid ball = make_solid(make_sphere(0.5, 4), kPose);
    const Vector3 away = Vector3(1.0, 2.0, -1.0).normalized();
    CHECK(ball.is_near(kPose.position + 2.0 * away, 1.5));
    CHECK_FALSE(ball.is_near(kPose.position + 2.0 * away, 1.49));
    for (const double length : {1e-3, 0.999, 2.0, 1e6}) {
        Pose scaled = kPose;
        scaled.orientation.coeffs() *= length;
        const MovingSolid plate = make_solid(make_plate(1.0, 1.0, 1), scaled);
        CHECK((plate.find_plane(0, 1).normal_W - kPose.orientation * Vector3::UnitY()).norm() <
              1e-14);
    }
}

TEST_CASE(
    "moving solid: far out the clearance stays above rounding; a foot on the edge is beside") {
    for (const double scale : {1e-6, 1e-3, 1.0}) {
        const Pose far_away = Pose::at(Vector3(700.0, -1000.0, 300.0));
        const TouchedPlane plane =
            make_solid(make_plate(scale, scale, 1), far_away).find_plane(0, 1);
        const double rounding_m = std::numeric_limits<double>::epsilon() * 1000.0;
        CHECK(plane.clearance_m > 64.0 * rounding_m);
        CHECK(plane.clearance_m < 256.0 * rounding_m + 1e-10 * scale);
    }
    MovingSolid plate = make_solid(make_plate(1.0, 1.0, 1), Pose{});
    const auto over_any = [&](double x) {
        plate.put_proxy(Vector3(x, 0.3, 0.1));
        return plate.is_over(0) || plate.is_over(1);
    };
    CHECK(over_any(0.5 - 1e-12));
    CHECK_FALSE(over_any(0.5 - 2e-14));
    CHECK_FALSE(over_any(0.5));
}
