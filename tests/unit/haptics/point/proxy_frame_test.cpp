// What every solid of a proxy does with its poses: by itself, as a mesh, and as an obstacle.
#include "haptics/point/proxy_frame.h"

#include "haptics/collision/mesh_obstacle.h"
#include "haptics/geometry/shape.h"
#include "haptics/point/moving_obstacle.h"
#include "haptics/point/moving_solid.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/touchable.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace fulcrum {
namespace {

const Pose kPose{Vector3(3.0, -2.0, 1.0), Quaternion(AngleAxis(0.8, Vector3(0.6, 0.0, 0.8)))};

// Each kind at `kPose`, the proxy put at `p` in its frame.
template <class Law>
void for_each_frame(const Law& law) {
    const auto plate = touchable(make_plate(1.0, 1.0, 1));
    ProxyFrame bare;
    MovingSolid solid(only_solid(plate).front(), 2);
    MovingObstacle obstacle(std::make_unique<MeshObstacle>(plate, 0.1), 2, Pose{});
    law("bare", bare);
    law("solid", solid);
    law("obstacle", obstacle);
}

}  // namespace

TEST_CASE("proxy frame: the proxy goes where the solid takes it, and the same pose takes it not") {
    for_each_frame([](const char* name, auto& frame) {
        CAPTURE(name);
        CHECK_FALSE(frame.take_pose({}));
        frame.put_proxy({0.1, 0.2, 0.3});
        CHECK(frame.take_pose(kPose));
        CHECK((frame.carried_proxy_W() - kPose * Vector3(0.1, 0.2, 0.3)).norm() < 1e-15);
        CHECK_FALSE(frame.take_pose(kPose));
        frame.put_proxy({5.0, 5.0, 5.0});
        CHECK((frame.carried_proxy_W() - Vector3(5.0, 5.0, 5.0)).norm() <= 1.0e-14);
    });
}

TEST_CASE("proxy frame: a pose that is none is ignored, a turn not of unit length is that turn") {
    for_each_frame([](const char* name, auto& frame) {
        CAPTURE(name);
        CHECK(frame.take_pose(kPose));
        frame.put_proxy(kPose * Vector3(0.2, 0.35, 0.1));
        for (const double bad : {std::nan(""), kInfinity}) {
            Pose broken = kPose;
            broken.position.x() = bad;
            CHECK_FALSE(frame.take_pose(broken));
        }
        Pose flat = kPose;
        flat.orientation.coeffs().setZero();
        CHECK_FALSE(frame.take_pose(flat));
        for (const double length : {1e-3, 7.0, 1e6}) {
            Pose longer = kPose;
            longer.orientation.coeffs() *= length;
            CHECK(frame.take_pose(longer));
            CHECK((frame.carried_proxy_W() - kPose * Vector3(0.2, 0.35, 0.1)).norm() < 1e-14);
        }
    });
}

}  // namespace fulcrum
