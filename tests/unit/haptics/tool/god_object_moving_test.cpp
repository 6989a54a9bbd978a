// A god-object's tool among several objects and objects that move. Cases that are known to be hard: tests/stability/cases/god_tool.cpp.
#include "haptics/math/rotation.h"
#include "tests/support/god_scene.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace fulcrum {
namespace {

using test::kGodDt_s;

constexpr double kGap_m = 1.0e-6;
constexpr double kStiffness = 500.0;
constexpr double kHalf_m = 0.02;

using Scene = test::GodScene;
const GodObjectSettings kSettings =
    test::make_sudden_settings(make_box_inertia(0.05, Vector3::Constant(2.0 * kHalf_m)));

TEST_CASE("god-object tool: an object pushes a standing tool ahead, and the hand feels how far") {
    Scene scene(test::make_cube(2.0 * kHalf_m), {make_box({0.1, 0.1, 0.1}).value()}, kSettings);
    const Pose handle = Pose::at({0.0, 0.05 + kHalf_m + 0.001, 0.0});
    scene.god.place(handle);
    for (int i = 0; i < 200; ++i) {
        const double up_m = 0.01 * (1.0 - std::cos(0.02 * i));
        scene.frames[0].pose_W = Pose::at({0.003 * std::sin(0.1 * i), up_m, 0.0});
        const ToolFelt felt = scene.step(handle);
        const double pushed_m = std::max(up_m + kGap_m - 0.001, 0.0);
        CAPTURE(i, scene.god.last_step().rounds);
        REQUIRE_FALSE(scene.god.last_step().wedged);
        REQUIRE_FALSE(scene.is_inside());
        CHECK((felt.felt_W.force - Vector3(0.0, kStiffness * pushed_m, 0.0)).norm() < 1.0e-6);
    }
}

TEST_CASE("god-object tool: objects that turn and fly about by chance never get into it") {
    Scene scene(
        test::make_cube(2.0 * kHalf_m),
        {make_box({0.05, 0.02, 0.08}).value(), make_bumpy_sphere(0.03, 3, 0.2, 90.0).value()},
        kSettings);
    Random random(11);
    Pose handle{};
    scene.frames[0].pose_W = Pose::at({0.0, -0.09, 0.0});
    scene.frames[1].pose_W = Pose::at({0.0, 0.1, 0.0});
    scene.god.place(handle);
    int n_touching = 0;
    int n_wedged = 0;
    for (int i = 0; i < 1500; ++i) {
        for (std::size_t k = 0; k < 2; ++k) {
            Pose& pose = scene.frames[k].pose_W;
            // They circle round it, and lean on it.
            const Vector3 to = handle.position - pose.position;
            pose.position += 0.002 * random.in_cube() + (to.norm() > 0.06 ? 0.02 : -0.02) * to;
            pose.orientation =
                (compute_exp(0.05 * random.in_cube() + Vector3(0.01, 0.0, 0.02)) * pose.orientation)
                    .normalized();
        }
        handle.orientation =
            (compute_exp(0.03 * random.in_cube()) * handle.orientation).normalized();
        const ToolFelt felt = scene.step(handle);
        REQUIRE(felt.moved);
        n_touching += scene.god.touches()[0].touches || scene.god.touches()[1].touches ? 1 : 0;
        n_wedged += scene.god.last_step().wedged ? 1 : 0;
        CAPTURE(i, scene.god.last_step().rounds, scene.god.last_step().contacts);
        REQUIRE_FALSE(scene.is_inside());
    }
    CHECK(n_touching > 300);
    CHECK(n_wedged < n_touching / 2);
    // Drawn away, both are where they are said to be.
    for (int i = 0; i < 100; ++i) {
        scene.frames[0].pose_W.position.y() -= 0.001;
        scene.frames[1].pose_W.position.y() += 0.001;
        (void)scene.step(handle);
        REQUIRE_FALSE(scene.is_inside());
    }
    CHECK_FALSE(scene.god.last_step().wedged);
}

TEST_CASE("god-object tool: two objects that close upon it wedge it; opened they are where told") {
    const TriangleMesh jaw = make_box({0.1, 0.1, 0.1}).value();
    Scene scene(test::make_cube(2.0 * kHalf_m), {jaw, jaw}, kSettings);
    const double apart_m = kHalf_m + 0.05;
    bool was_wedged = false;
    scene.frames[0].pose_W = Pose::at({-apart_m - 0.002, 0.0, 0.0});
    scene.frames[1].pose_W = Pose::at({apart_m + 0.002, 0.0, 0.0});
    scene.god.place(Pose{});
    for (int i = 0; i < 200; ++i) {
        const double side_m = apart_m + 0.002 * std::cos(0.0315 * i);
        scene.frames[0].pose_W.position.x() = -side_m;
        scene.frames[1].pose_W.position.x() = side_m;
        (void)scene.step(Pose{});
        const bool wedged = scene.god.last_step().wedged;
        was_wedged = was_wedged || wedged;
        CAPTURE(i, side_m - apart_m);
        REQUIRE_FALSE(scene.is_inside());
        CHECK(wedged == (side_m < apart_m + 0.6 * kGap_m));
    }
    CHECK(was_wedged);
    CHECK_FALSE(scene.god.last_step().wedged);
    CHECK(scene.god.object_W(0).position == scene.frames[0].pose_W.position);
}

}  // namespace
}  // namespace fulcrum
