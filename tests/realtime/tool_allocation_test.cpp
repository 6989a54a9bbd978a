// No step of a loop with a tool in six degrees of freedom allocates: touching, turning a body on a hinge, let go by a fault.
#include "haptics/device/simulated/simulated_hand.h"
#include "haptics/loop/haptic_loop.h"
#include "haptics/math/rotation.h"
#include "tests/realtime/allocation_trap.h"
#include "tests/support/tool_scene.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <memory>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

namespace fulcrum {
namespace {

constexpr double kDt_s = 0.001;

void put_surfaces(HapticPlan& plan, const std::vector<TriangleMesh>& meshes) {
    ToolPlan tool = *plan.tool;
    std::size_t i = 0;
    for (GodObjectPlan& object : std::get<std::vector<GodObjectPlan>>(tool.objects)) {
        object.friction = {0.6, 0.4, 0.0};
        object.object_shading = GodShading::create(meshes[i++], {.on = true}).value();
        object.texture = std::make_shared<const Texture>(
            TextureSettings{.source = NoiseTexture{0.001, 0.004, 3}});
    }
    plan.tool = std::make_shared<const ToolPlan>(std::move(tool));
}

HapticPlan make_plan(const VoxelToolSettings& settings, ToolMethod method, bool has_surfaces,
                     ContactFinding contact) {
    HapticPlan plan;
    plan.safety.soft_start_s = 0.0;
    plan.expects_lesson = false;
    plan.solids.push_back({.body = 1,
                           .shape = BoxShape{Vector3(0.1, 0.02, 0.1)},
                           .initial_pose_W = Pose::at(Vector3(0, -0.02, 0))});
    plan.solids.push_back({.body = 2,
                           .shape = BoxShape{Vector3(0.02, 0.1, 0.1)},
                           .initial_pose_W = Pose::at(Vector3(0.12, 0.05, 0))});
    AxlePlan axle;
    axle.axle.inertia_kg_m2 = 0.01;
    axle.reach_m = 0.15;
    plan.axles.push_back(axle);
    test::ToolScene scene = test::make_ball_tool(method);
    scene.settings = settings;
    scene.contact = contact;
    const std::vector<TriangleMesh> meshes{make_box({0.2, 0.04, 0.2}).value(),
                                           make_box({0.04, 0.2, 0.2}).value()};
    plan.tool = test::make_tool_of(scene, meshes);
    if (has_surfaces) {
        put_surfaces(plan, meshes);
    }
    return plan;
}

}  // namespace

TEST_CASE(
    "no allocation: five thousand rounds with a tool, massive and massless, faults included") {
    VoxelToolSettings massless;
    massless.mass = ToolMass::massless;
    VoxelToolSettings explicit_steps;
    explicit_steps.integrator.integrator = Integrator::runge_kutta_4;
    VoxelToolSettings hurried;
    hurried.budget_us = 100.0;
    const auto levels = ContactFinding::levels;
    const auto fields = ContactFinding::fields;
    const std::tuple<VoxelToolSettings, ToolMethod, bool, ContactFinding> tools[] = {
        {{}, ToolMethod::field_sampling, false, fields},
        {{}, ToolMethod::voxel_sampling, false, fields},
        {{}, ToolMethod::god_object, false, fields},
        {{}, ToolMethod::god_object, true, fields},
        {massless, ToolMethod::field_sampling, false, fields},
        {massless, ToolMethod::voxel_sampling, false, fields},
        {explicit_steps, ToolMethod::voxel_sampling, false, fields},
        {{}, ToolMethod::implicit_penalty, false, fields},
        {{}, ToolMethod::implicit_penalty, false, levels},
        {hurried, ToolMethod::implicit_penalty, false, levels}};
    for (const auto& [settings, method, has_surfaces, contact] : tools) {
        auto channels = std::make_unique<HapticChannels>();
        auto axles = std::make_unique<AxleChannels>();
        channels->axles = axles.get();
        LatestValue<HandTarget> target;
        SimulatedHand hand(SimulatedHandSettings{}, target);
        HapticLoop loop(make_plan(settings, method, has_surfaces, contact), hand, *channels);
        bool touched = false;
        bool let_go = false;
        const std::uint64_t n = count_allocations([&] {
            for (int k = 1; k <= 5000; ++k) {
                HandTarget wanted;
                wanted.pose_D = {
                    Vector3(0.09 * std::sin(0.002 * k), 0.03 + 0.05 * std::cos(0.004 * k), 0.0),
                    compute_exp(Vector3(0.0, 0.0, 0.3 * std::sin(0.003 * k)))};
                target.publish(wanted);
                if (k == 3000) {
                    channels->emergency_stop.press();
                    channels->emergency_stop.release();
                }
                if (k == 3500) {
                    channels->rearm.store(true);
                }
                loop.step(k * kDt_s);
                touched = touched || loop.state().commanded_W.force.norm() > 0.1;
                let_go = let_go || any(loop.state().faults);
            }
            loop.silence(5.0);
        });
        CHECK(n == 0);
        CHECK(touched);
        CHECK(let_go);
    }
}

}  // namespace fulcrum
