#include "haptics/point/proxy_frame.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace fulcrum {
namespace {

TEST_CASE("proxy frame: the proxy goes where the solid takes it") {
    ProxyFrame frame;
    frame.put_proxy({1.0, 0.0, 0.0});
    const Pose pose{{0.0, 2.0, 0.0}, Quaternion(AngleAxis(std::acos(0.0), Vector3::UnitZ()))};
    CHECK(frame.take_pose(pose));
    CHECK((frame.carried_proxy_W() - Vector3(0.0, 3.0, 0.0)).norm() <= 1.0e-15);
    frame.put_proxy({5.0, 5.0, 5.0});
    CHECK((frame.carried_proxy_W() - Vector3(5.0, 5.0, 5.0)).norm() <= 1.0e-14);
}

TEST_CASE("proxy frame: the same pose changes nothing, and one that is not finite is ignored") {
    ProxyFrame frame;
    CHECK_FALSE(frame.take_pose({}));
    Pose broken = Pose::at(Vector3(0.0, std::nan(""), 0.0));
    CHECK_FALSE(frame.take_pose(broken));
    broken = Pose::at(Vector3::Ones());
    broken.orientation.coeffs().setZero();
    CHECK_FALSE(frame.take_pose(broken));
    frame.put_proxy({1.0, 2.0, 3.0});
    CHECK(frame.carried_proxy_W() == Vector3(1.0, 2.0, 3.0));
    // A turn that is not of unit length is taken as the turn that it means.
    Pose long_turn;
    long_turn.orientation.coeffs() *= 3.0;
    CHECK(frame.take_pose(long_turn));
    CHECK(frame.carried_proxy_W() == Vector3(1.0, 2.0, 3.0));
}

}  // namespace
}  // namespace fulcrum
