#include "haptics/point/moving_obstacle.h"

#include "haptics/collision/mesh_obstacle.h"
#include "haptics/geometry/shape.h"
#include "tests/support/touchable.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace fulcrum {
namespace {

constexpr double kRadius_m = 0.1;
const Pose kPose{Vector3(3.0, -2.0, 1.0), Quaternion(AngleAxis(0.8, Vector3(0.6, 0.0, 0.8)))};

MovingObstacle make_plate_at(const Pose& pose_W) {
    return {std::make_unique<MeshObstacle>(touchable(make_plate(1.0, 1.0, 1)), kRadius_m), 2,
            pose_W};
}

TEST_CASE("moving obstacle: a plane is that of the turned and moved feature") {
    MovingObstacle plate = make_plate_at(kPose);
    plate.put_proxy(kPose * Vector3(-0.3, -0.35, 0.1));
    const ObstaclePlane plane = plate.find_plane(0);
    CHECK(plane.solid == 2);
    CHECK((plane.normal_W - kPose.orientation * Vector3(0.0, -1.0, 0.0)).norm() < 1e-15);
    CHECK(plane.gap_m == Approx(0.25).epsilon(1e-14));
    CHECK(plane.clearance_m > 1e-11);
    CHECK(plane.clearance_m < 1e-9);
}

TEST_CASE("moving obstacle: a way is that in the solid's frame, whichever of the two moved") {
    MovingObstacle plate = make_plate_at(Pose{});
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

}  // namespace
}  // namespace fulcrum
