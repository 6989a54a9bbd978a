#include "runtime/render/camera.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

using namespace fulcrum;
using namespace fulcrum::runtime;

namespace {

constexpr double kRoundTrip = 1e-9;  // a few roundings of numbers around 1000
const double kNan = std::numeric_limits<double>::quiet_NaN();

CameraDescription straight_ahead() {
    CameraDescription camera;
    camera.eye_W = Vector3(0.0, 0.0, 2.0);
    camera.target_W = Vector3::Zero();
    camera.vertical_angle_deg = 90.0;
    return camera;
}

}  // namespace

TEST_CASE("camera: projects in closed form") {
    const Camera camera(straight_ahead(), 1600, 900);
    const auto target = camera.project(Vector3::Zero());
    REQUIRE(target);
    CHECK(target->position_px.x() == Approx(800.0));
    CHECK(target->position_px.y() == Approx(kTargetHeight * 900.0));
    CHECK(target->depth_m == Approx(2.0));
    // At 90 degrees and 2 m half the height is 2 m; +X is right, +Y is up.
    const auto aside = camera.project(Vector3(1.0, 0.5, 0.0));
    REQUIRE(aside);
    CHECK(aside->position_px.x() == Approx(800.0 + 225.0));
    CHECK(aside->position_px.y() == Approx(kTargetHeight * 900.0 - 112.5));
}

TEST_CASE("camera: unproject undoes project, for any camera and point") {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> metres(-3.0, 3.0);
    std::uniform_real_distribution<double> degrees(10.0, 100.0);
    int seen_points = 0;
    for (int i = 0; i < 2000; ++i) {
        CameraDescription description;
        description.eye_W = Vector3(metres(random), metres(random), metres(random));
        description.target_W = Vector3(metres(random), metres(random), metres(random));
        description.vertical_angle_deg = degrees(random);
        const Camera camera(description, 1280, 720);
        const Vector3 point(metres(random), metres(random), metres(random));
        const auto seen = camera.project(point);
        if (!seen) {
            continue;
        }
        ++seen_points;
        CHECK((camera.unproject(*seen) - point).norm() < kRoundTrip);
        const Ray ray = camera.ray(seen->position_px);
        CHECK(ray.direction_W.norm() == Approx(1.0));
        CHECK((point - ray.origin_W).cross(ray.direction_W).norm() < 1e-8);
    }
    CHECK(seen_points > 500);
}

TEST_CASE("camera: the matrix for OpenGL agrees with project") {
    CameraDescription description;
    description.eye_W = Vector3(0.4, 0.9, 1.3);
    description.target_W = Vector3(-0.1, 0.3, 0.1);
    const Camera camera(description, 1280, 720);
    for (const Vector3& point : {Vector3(0.2, 0.1, -0.4), Vector3(-0.5, 0.8, 0.3)}) {
        const auto seen = camera.project(point);
        REQUIRE(seen);
        const Vector4f world(static_cast<float>(point.x()), static_cast<float>(point.y()),
                             static_cast<float>(point.z()), 1.0F);
        const Vector4f clip = camera.clip_from_world() * world;
        const double x_px = 0.5 * (1.0 + static_cast<double>(clip.x() / clip.w())) * 1280.0;
        const double y_px = 0.5 * (1.0 - static_cast<double>(clip.y() / clip.w())) * 720.0;
        CHECK(x_px == Approx(seen->position_px.x()).margin(1e-2));
        CHECK(y_px == Approx(seen->position_px.y()).margin(1e-2));
        CHECK(std::abs(clip.z()) <= clip.w());
        CHECK(clip.w() == Approx(static_cast<float>(seen->depth_m)));
    }
}

TEST_CASE("camera: what lies behind the eye or is not finite is not seen") {
    const Camera camera(straight_ahead(), 800, 600);
    CHECK_FALSE(camera.project(Vector3(0.0, 0.0, 2.5)));
    CHECK_FALSE(camera.project(Vector3(0.0, 0.0, 2.0)));
    CHECK_FALSE(camera.project(Vector3(kNan, 0.0, 0.0)));
    CHECK_FALSE(camera.project(Vector3(0.0, std::numeric_limits<double>::infinity(), 0.0)));
}

TEST_CASE("camera: bad descriptions give a camera that works") {
    CameraDescription nonsense;
    nonsense.eye_W = Vector3(kNan, 0.0, 0.0);
    nonsense.vertical_angle_deg = kNan;
    const CameraDescription standard;
    const Camera repaired(nonsense, 640, 480);
    CHECK(repaired.eye_W() == standard.eye_W);
    CHECK(repaired.project(standard.target_W));

    CameraDescription on_target;
    on_target.eye_W = on_target.target_W;
    CHECK(Camera(on_target, 640, 480).forward_W().isApprox(-Vector3::UnitZ()));

    CameraDescription down;
    down.eye_W = Vector3(0.0, 5.0, 0.0);
    down.target_W = Vector3::Zero();
    const Camera from_above(down, 640, 480);
    CHECK(from_above.up_W().isApprox(-Vector3::UnitZ(), 1e-6));
    CHECK(from_above.clip_from_world().allFinite());

    CHECK(Camera(standard, 0, -5).clip_from_world().allFinite());
    CameraDescription wide;
    wide.vertical_angle_deg = 500.0;
    CHECK(Camera(wide, 640, 480).clip_from_world().allFinite());
}

TEST_CASE("camera: a narrow picture shows as much from left to right as one of 4:3") {
    const CameraDescription description;
    const Camera usual(description, 800, 600);
    const Camera narrow(description, 400, 800);
    const Vector3 edge = usual.unproject({{0.0, 0.5 * 600.0}, usual.distance_m()});
    const auto seen = narrow.project(edge);
    REQUIRE(seen);
    CHECK(seen->position_px.x() == Approx(0.0).margin(1e-6));
}

TEST_CASE("camera: the pointer lies on the upright plane through the target, and where it points") {
    const CameraDescription description;
    const Camera camera(description, 1280, 720);
    for (const double wheel_m : {0.0, 0.2, -0.15}) {
        const Vector2 pointer(300.0, 500.0);
        const auto place = pointer_on_plane(camera, pointer, wheel_m);
        REQUIRE(place);
        // The eye looks along -Z, so the plane is z = target's z - wheel.
        CHECK(place->z() == Approx(description.target_W.z() - wheel_m).margin(1e-9));
        const auto back = camera.project(*place);
        REQUIRE(back);
        CHECK((back->position_px - pointer).norm() < 1e-6);
    }
    const auto target = pointer_on_plane(camera, {640.0, kTargetHeight * 720.0}, 0.0);
    REQUIRE(target);
    CHECK((*target - description.target_W).norm() < 1e-9);
}

TEST_CASE("camera: the pointer's plane has the normal along which its wheel moves it") {
    CameraDescription aside;
    aside.eye_W = Vector3(1.0, 0.9, 1.5);
    for (const double height_m : {0.9, 8.0}) {
        aside.eye_W.y() = height_m;
        const Camera camera(aside, 1280, 720);
        const Vector3 normal = pointer_plane_normal(camera);
        CHECK(normal.norm() == Approx(1.0));
        CHECK(normal.dot(camera.forward_W()) > 0.0);
        if (height_m < 2.0) {
            CHECK(normal.y() == 0.0);
        }
        const auto place = pointer_on_plane(camera, {500.0, 320.0}, 0.1);
        REQUIRE(place);
        CHECK(normal.dot(*place - camera.target_W()) == Approx(0.1));
    }
}

TEST_CASE("camera: from steeply above, the pointer moves across the view") {
    CameraDescription down;
    down.eye_W = Vector3(0.0, 2.0, 0.1);
    down.target_W = Vector3(0.0, 0.0, 0.0);
    const Camera camera(down, 1280, 720);
    const auto place = pointer_on_plane(camera, {900.0, 200.0}, 0.0);
    REQUIRE(place);
    CHECK(camera.forward_W().dot(*place - down.target_W) == Approx(0.0).margin(1e-9));
}

TEST_CASE("camera: a pointer without a place has none") {
    const Camera camera(CameraDescription{}, 1280, 720);
    CHECK_FALSE(pointer_on_plane(camera, {kNan, 0.0}, 0.0));
    // The plane pulled behind the eye is not in front of any ray.
    CHECK_FALSE(pointer_on_plane(camera, {640.0, 300.0}, -100.0));
}
