#include "runtime/render/scene/arrow.h"

#include <catch2/catch.hpp>

#include <limits>

using namespace fulcrum;
using namespace fulcrum::runtime;

namespace {

Camera make_camera() {
    CameraDescription view;
    view.eye_W = {0, 0, 2};
    view.target_W = {0, 0, 0};
    return Camera(view, 640, 480, 0.5);
}

ViewTorque make_torque() {
    ViewTorque torque;
    torque.axis_W = {0.1, 0, 0};
    torque.force = {true, {0.5, 0, 0}, {0, -2, 0}, "2 N"};
    return torque;
}

}  // namespace

TEST_CASE("arrow: a lever arm reaches from the axis to where the force acts") {
    const auto arm = arm_for(make_torque(), make_camera());
    REQUIRE(arm);
    const Vector4f from = arm->world_from_model * Vector4f(0, 0, 0, 1);
    const Vector4f to = arm->world_from_model * Vector4f(0, 1, 0, 1);
    CHECK((from.head<3>() - Vector3f(0.1F, 0, 0)).norm() < 1e-5F);
    CHECK((to.head<3>() - Vector3f(0.5F, 0, 0)).norm() < 1e-5F);
}

TEST_CASE("arrow: a push on the axis itself has no arm, nor what is no number") {
    ViewTorque torque = make_torque();
    torque.axis_W = torque.force.at_W;
    CHECK_FALSE(arm_for(torque, make_camera()));
    torque.axis_W.x() = std::numeric_limits<double>::quiet_NaN();
    CHECK_FALSE(arm_for(torque, make_camera()));
}
