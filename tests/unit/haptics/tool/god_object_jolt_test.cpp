// No set of contacts that takes another's place is felt as a jolt.
#include "haptics/math/rotation.h"
#include "haptics/tool/god_object_tool.h"
#include "tests/support/god_scene.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace fulcrum {
namespace {

constexpr double kStiffness = 500.0;
constexpr double kFade_s = 0.03;
constexpr double kNothing_N = 1.0e-4;  // what ends a fade

TEST_CASE(
    "god-object jolts: whatever contacts come and go, the force of one handle changes by what "
    "fades in a step, and not by more") {
    const double mu = GENERATE(0.0, 0.5);
    const TriangleMesh cube = make_box(Vector3::Constant(0.04)).value();
    const TriangleMesh block = make_box({0.06, 0.05, 0.07}).value();
    GodObjectSettings settings =
        test::make_god_settings(make_box_inertia(0.05, Vector3::Constant(0.04)));
    settings.fade_s = kFade_s;
    settings.coupling.clamp_m = 1.0;
    GodObjectTool tool = GodObjectTool::build({{.object = GodSurface::create(block),
                                                .tool = GodSurface::create(cube),
                                                .friction = {mu, 0.8 * mu, 0.0}}},
                                              settings)
                             .value();
    const MovingFrame held{};
    Random random(3);
    Pose handle = Pose::at({0.0, 0.1, 0.0});
    tool.place(handle);
    Vector3 velocity = Vector3::Zero();
    Vector3 turning = Vector3::Zero();
    const double lost = 1.0 - std::exp(-test::kGodDt_s / kFade_s);
    double most_change_N = 0.0;  // of the contacts' own force
    double left_N = 0.0;         // felt when that begins to end
    int n_free = 0;              // steps without a push
    for (int i = 0; i < 16000; ++i) {
        velocity = 0.98 * velocity + 0.004 * random.in_cube() -
                   0.006 * (handle.position - Vector3(0.0, 0.068, 0.0));
        turning = 0.98 * turning + 0.1 * random.in_cube();
        handle.position += 0.02 * velocity;
        handle.orientation = compute_exp(0.002 * turning) * handle.orientation;
        handle.orientation.normalize();
        const Wrench before = tool.force(handle);
        const ToolFelt felt = tool.move({handle, {}}, {&held, 1}, 0.0, test::kGodDt_s);
        const Vector3 contacts = tool.touches()[0].wrench_W.force;
        const double change_N = (before.force - contacts).norm();
        most_change_N = std::max(most_change_N, change_N);
        CAPTURE(mu, i, before.force, contacts, felt.felt_W.force);
        // After 5 ms in the free it fades evenly, in 25 ms.
        n_free = contacts == Vector3::Zero() ? n_free + 1 : 0;
        left_N = n_free > 5 ? left_N : before.force.norm();
        const double most_N = std::max(lost * change_N, n_free > 5 ? left_N / 25.0 : 0.0);
        REQUIRE((felt.felt_W.force - before.force).norm() <=
                1.001 * most_N + kNothing_N + 1.0e-9 * kStiffness);
    }
    CHECK(most_change_N > 5.0);
}

}  // namespace
}  // namespace fulcrum
