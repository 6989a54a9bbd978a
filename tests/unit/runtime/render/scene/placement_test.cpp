#include "runtime/render/scene/placement.h"

#include "runtime/render/scene/arrow.h"
#include "runtime/render/scene/light.h"
#include "tests/unit/runtime/rig.h"

#include <numbers>

using namespace fulcrum::runtime::test;

namespace {

const double kNan = std::numeric_limits<double>::quiet_NaN();

Vector3f moved(const Placement& placement, const Vector3f& point) {
    return (placement.world_from_model * (Vector4f() << point, 1.0F).finished()).head<3>();
}

const Camera kCamera(CameraDescription{}, 1280, 720);

double length_m(const Arrow& arrow) {
    return (arrow.tip_W - arrow.tail_W).norm();
}

ViewForce force(const Vector3& newtons) {
    return {true, Vector3(0.1, 0.2, 0.3), newtons, "f"};
}

}  // namespace

TEST_CASE("placement: scales in the model, then turns, then moves") {
    Pose pose;
    pose.position = Vector3(1.0, 2.0, 3.0);
    pose.orientation = Quaternion(AngleAxis(0.5 * std::numbers::pi, Vector3::UnitZ()));
    const auto placement = place(pose, Vector3(2.0, 1.0, 1.0));
    REQUIRE(placement);
    CHECK(moved(*placement, {1, 0, 0}).isApprox(Vector3f(1, 4, 3), 1e-6F));
    CHECK(moved(*placement, {0, 1, 0}).isApprox(Vector3f(0, 2, 3), 1e-6F));
    // Normals stay at right angles to the surface: on a plane x + y = const stretched along x.
    const Vector3f along = moved(*placement, {1, -1, 0}) - moved(*placement, Vector3f::Zero());
    const Vector3f normal = placement->normal_from_model * Vector3f(1, 1, 0);
    CHECK(along.dot(normal) == Approx(0.0F).margin(1e-6));
    CHECK_FALSE(placement->mirrored);
    CHECK(place(pose, Vector3(-1.0, 1.0, 1.0))->mirrored);
}

TEST_CASE("placement: numbers that cannot be drawn are refused") {
    Pose lost;
    lost.position.x() = kNan;
    CHECK_FALSE(place(lost, Vector3::Ones()));
    Pose far;
    far.position.y() = 1e9;
    CHECK_FALSE(place(far, Vector3::Ones()));
    Pose unturned;
    unturned.orientation.coeffs().setZero();
    CHECK_FALSE(place(unturned, Vector3::Ones()));
    unturned.orientation.coeffs().setConstant(1e200);
    CHECK_FALSE(place(unturned, Vector3::Ones()));
    CHECK_FALSE(place(Pose{}, Vector3(1.0, 0.0, 1.0)));
    CHECK_FALSE(place(Pose{}, Vector3(1.0, kNan, 1.0)));
    CHECK_FALSE(place(Pose{}, Vector3(1.0, 1e30, 1.0)));
}

TEST_CASE("placement: a quaternion that is not quite of unit length still only turns") {
    Pose pose;
    pose.orientation.coeffs() *= 1.7;
    const auto placement = place(pose, Vector3::Ones());
    REQUIRE(placement);
    CHECK(placement->world_from_model.isApprox(Matrix4f::Identity(), 1e-6F));
}

TEST_CASE("placement: bounds of a box") {
    Pose pose;
    pose.position = Vector3(0.0, 1.0, 0.0);
    const Bounds bounds =
        bounds_of(*place(pose, Vector3(1.0, 0.5, 1.0)), {-0.1F, -0.2F, -0.3F}, {0.1F, 0.2F, 0.3F});
    CHECK(bounds.centre_W.isApprox(Vector3(0.0, 1.0, 0.0), 1e-6));
    CHECK(bounds.lowest_m == Approx(0.9));
    CHECK(bounds.half_width_m == Approx(0.3));
    CHECK(bounds.radius_m == Approx(0.3));
    CHECK(bounds.enclosing_radius_m == Approx(std::sqrt(0.01 + 0.01 + 0.09)));
}

TEST_CASE("arrow: twice the newtons is twice the length, from the same tail, along the force") {
    const auto two = arrow_for(force(Vector3(0.0, -2.0, 0.0)), kCamera);
    const auto four = arrow_for(force(Vector3(0.0, -4.0, 0.0)), kCamera);
    REQUIRE(two);
    REQUIRE(four);
    CHECK(two->tail_W.isApprox(Vector3(0.1, 0.2, 0.3)));
    CHECK(length_m(*two) == Approx(kLengthPerNewton * 2.0 * kCamera.distance_m()));
    CHECK(length_m(*four) == Approx(2.0 * length_m(*two)));
    CHECK((two->tip_W - two->tail_W).normalized().isApprox(-Vector3::UnitY()));
    // The drawn tip is where it is said to be.
    CHECK(moved(two->head, {0, 1, 0}).cast<double>().isApprox(two->tip_W, 1e-5));
    CHECK(moved(two->shaft, {0, 0, 0}).cast<double>().isApprox(two->tail_W, 1e-5));
}

TEST_CASE("arrow: small forces have none, large ones stay in the picture") {
    CHECK_FALSE(arrow_for(force(Vector3::Zero()), kCamera));
    CHECK_FALSE(arrow_for(force(Vector3(0.0, 0.01, 0.0)), kCamera));
    CHECK_FALSE(arrow_for(force(Vector3(0.0, kNan, 0.0)), kCamera));
    ViewForce unseen = force(Vector3(0.0, 1.0, 0.0));
    unseen.visible = false;
    CHECK_FALSE(arrow_for(unseen, kCamera));
    const auto huge = arrow_for(force(Vector3(1e200, 1e200, 0.0)), kCamera);
    REQUIRE(huge);
    CHECK(length_m(*huge) <= kLongestArrow * kCamera.distance_m() + 1e-9);
    const auto upwards = arrow_for(force(Vector3(0.0, 3.0, 0.0)), kCamera);
    REQUIRE(upwards);
    CHECK(upwards->tip_W.y() > upwards->tail_W.y());
}

TEST_CASE("light: what stands on the floor before the camera is inside its map") {
    const Light light = light_for(kCamera, 0.0, 1024);
    for (const auto& [x, y, z] :
         {std::array{0.0F, 0.0F, 0.0F}, {0.8F, 0.0F, 0.8F}, {-0.5F, 1.2F, 0.3F}}) {
        const Vector3f place = (light.shadow_from_world * Vector4f(x, y, z, 1.0F)).head<3>();
        for (int axis = 0; axis < 3; ++axis) {
            CHECK(place[axis] > 0.0F);
            CHECK(place[axis] < 1.0F);
        }
    }
    // Higher is nearer to the lamp.
    const auto depth = [&](float y) {
        return (light.shadow_from_world * Vector4f(0.0F, y, 0.0F, 1.0F)).z();
    };
    CHECK(depth(0.5F) < depth(0.0F));
    CHECK(light_for(kCamera, kNan, 1024).clip_from_world.allFinite());
}

TEST_CASE("arrow: forces that are compared are drawn to one scale") {
    std::vector<ViewTorque> torques(2);
    for (ViewTorque& torque : torques) {
        torque.force.visible = true;
    }
    torques[0].force.force_W = Vector3(0, -2, 0);
    torques[1].force.force_W = Vector3(0, -4, 0);
    CHECK(common_scale(torques) == 1.0);
    torques[0].force.force_W = Vector3(0, -10, 0);
    torques[1].force.force_W = Vector3(0, -20, 0);
    const double scale = common_scale(torques);
    const auto long_m = [&](const ViewTorque& torque) {
        const auto arrow = arrow_for(torque.force, kCamera, {.scale = scale});
        REQUIRE(arrow);
        return length_m(*arrow);
    };
    CHECK(long_m(torques[1]) == Approx(kLongestArrow * kCamera.distance_m()));
    CHECK(long_m(torques[1]) == Approx(2.0 * long_m(torques[0])));
    torques[1].force.force_W.x() = std::numeric_limits<double>::quiet_NaN();
    CHECK(common_scale(torques) == Approx(kLongestForce_N / 10.0));
    torques[1].force.look = ForceLook::load;
    torques[1].force.force_W = Vector3(0, -1, 0);
    CHECK(arrow_for(torques[1].force, kCamera)->look == ForceLook::load);
}

TEST_CASE("arrow: forces on one thing are slim, as long as may be, and keep their proportions") {
    const double most_m = kLongestArrow * kCamera.distance_m();
    std::vector<ViewForce> forces{force({0.0, 4.0, 0.0}), force({1.0, 0.0, 0.0}),
                                  force({0.0, -0.3, 0.0})};
    const auto draw = [&](const ViewForce& one) {
        return *arrow_for(one, kCamera, style_of_balance(forces));
    };
    CHECK(length_m(draw(forces[0])) == Approx(most_m));
    CHECK(length_m(draw(forces[1])) == Approx(most_m / 4.0));
    // The weight of a kite is shorter than the head of an arrow alone.
    CHECK(length_m(draw(forces[2])) < length_m(draw(forces[1])));
    CHECK(draw(forces[0]).radius_m < 0.6 * arrow_for(forces[0], kCamera)->radius_m);
    // Weak ones are not blown up without end, strong ones shrink, and what cannot be drawn counts for nothing.
    forces[0].force_W.y() = 0.5;
    CHECK(style_of_balance(forces).scale == kMostStretch);
    forces[0].force_W.y() = 12.0;
    CHECK(length_m(draw(forces[0])) == Approx(most_m));
    forces[1].force_W.x() = kNan;
    forces[2].visible = false;
    CHECK(style_of_balance(forces).scale == Approx(kLongestForce_N / 12.0));
    CHECK(std::isfinite(style_of_balance({}).scale));
}
