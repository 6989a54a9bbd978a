#include "haptics/loop/workspace.h"

#include "haptics/math/rotation.h"

#include <catch2/catch.hpp>

using namespace fulcrum;

namespace {

constexpr double kRounding = 1e-12;

Workspace make_workspace() {
    return {{Vector3(1.0, 2.0, 3.0), compute_exp(Vector3(0.0, 1.5707963267948966, 0.0))}, 4.0};
}

}  // namespace

TEST_CASE("workspace: p_W = p + R (scale p_D), a quarter turn about y") {
    const Pose pose_W =
        compute_world_pose(make_workspace(), {Vector3(0.1, 0.2, 0.3), Quaternion::Identity()});
    CHECK((pose_W.position - Vector3(1.0 + 1.2, 2.0 + 0.8, 3.0 - 0.4)).norm() < kRounding);
    CHECK((pose_W.orientation * Vector3::UnitZ() - Vector3::UnitX()).norm() < kRounding);
}

TEST_CASE("workspace: there and back again") {
    const Pose pose_D{Vector3(0.1, -0.2, 0.05), compute_exp(Vector3(0.3, -0.2, 0.9))};
    const Pose back =
        compute_device_pose(make_workspace(), compute_world_pose(make_workspace(), pose_D));
    CHECK((back.position - pose_D.position).norm() < kRounding);
    CHECK((back.orientation.coeffs() - pose_D.orientation.coeffs()).norm() < kRounding);
}

TEST_CASE("workspace: forces are turned and not scaled") {
    const Wrench wrench_D =
        compute_device_wrench(make_workspace(), {Vector3(1.0, 0.0, 0.0), Vector3(0.0, 2.0, 0.0)});
    CHECK((wrench_D.force - Vector3(0.0, 0.0, 1.0)).norm() < kRounding);
    CHECK((wrench_D.torque - Vector3(0.0, 2.0, 0.0)).norm() < kRounding);
    const Wrench back_W = compute_world_wrench(make_workspace(), wrench_D);
    CHECK((back_W.force - Vector3(1.0, 0.0, 0.0)).norm() < kRounding);
    // A quarter turn about y takes (x, y, z) to (z, y, -x): back by R^T it is (-z, y, x).
    const Wrench oblique_W{Vector3(4.0, 5.0, 6.0), Vector3(1.0, 2.0, 3.0)};
    const Wrench oblique_D = compute_device_wrench(make_workspace(), oblique_W);
    CHECK((oblique_D.force - Vector3(-6.0, 5.0, 4.0)).norm() < kRounding);
    CHECK((oblique_D.torque - Vector3(-3.0, 2.0, 1.0)).norm() < kRounding);
    const Wrench again_W = compute_world_wrench(make_workspace(), oblique_D);
    CHECK((again_W.force - oblique_W.force).norm() < kRounding);
    CHECK((again_W.torque - oblique_W.torque).norm() < kRounding);
}
