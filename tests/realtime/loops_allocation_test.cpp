#include "haptics/device/arm/simulated_wam.h"
#include "haptics/device/simulated/simulated_hand.h"
#include "haptics/flight/kite_loop.h"
#include "haptics/geometry/height_field.h"
#include "haptics/geometry/shape.h"
#include "haptics/loop/haptic_loop.h"
#include "haptics/math/rotation.h"
#include "haptics/point/god_object.h"
#include "haptics/point/make_proxy.h"
#include "tests/realtime/allocation_trap.h"
#include "tests/support/distance_bodies.h"
#include "tests/support/hands_in_world.h"
#include "tests/support/tool_scene.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <thread>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

using namespace fulcrum;
using fulcrum::test::BoxScene;
using fulcrum::test::HandsInWorld;

namespace {

constexpr double kDt_s = 0.001;

// A body of each kind that the cursor can touch, some 0.1 m in size.
std::vector<SolidShape> make_shapes(bool with_function) {
    std::vector<SolidShape> shapes{
        touchable(make_bumpy_sphere(0.1, 20, 0.003, 20.0)),
        SphereShape{0.1},
        BoxShape{{0.1, 0.08, 0.09}},
        CapsuleShape{0.05, 0.05},
        CylinderShape{0.08, 0.07},
        make_hull_shape({{-0.1, 0, 0}, {0.1, 0, 0}, {0, 0, 0.1}, {0, 0, -0.1}, {0, 0.1, 0}})
            .value(),
        make_height_field_shape({.width_m = 0.2,
                                 .depth_m = 0.2,
                                 .n_x = 9,
                                 .n_z = 9,
                                 .heights_m = std::vector<double>(81, 0.08)})
            .value()};
    if (with_function) {
        shapes.emplace_back(DistanceShape{std::make_shared<BallFunction>(0.1)});
    }
    return shapes;
}

// Steps a hand about two bodies of one shape that move, one from each side; counts what it allocates, and the touches.
std::uint64_t count_in_proxy(const ProxySettings& settings, const SolidShape& shape,
                             int& n_touching, int& n_between) {
    SolidPlan solid{.shape = shape, .friction = {0.4, 0.3, 0.5}};
    const auto proxy = make_proxy(settings, {solid, solid}, {{.stiffness_N_per_m = 500.0}, 0.001});
    proxy->reset({0.0, 0.3, 0.0});
    std::array<Pose, 2> poses;
    return count_allocations([&] {
        for (int k = 0; k < 2000; ++k) {
            const Quaternion turn(AngleAxis(0.001 * k, Vector3(0.6, 0.0, 0.8)));
            poses[0] = {Vector3(-0.09, 0.01 * std::sin(0.01 * k), 0.0), turn};
            poses[1] = {Vector3(0.09, 0.0, 0.01 * std::sin(0.007 * k)), Quaternion::Identity()};
            const Vector3 hand(0.12 * std::sin(0.011 * k), 0.14 + 0.16 * std::cos(0.005 * k),
                               0.05 * std::sin(0.017 * k));
            (void)proxy->turn(Quaternion(AngleAxis(0.02 * k, Vector3(0.0, 0.6, 0.8))));
            const ProxyContact& contact = proxy->step(hand, poses);
            n_touching += contact.n_constraints > 0 ? 1 : 0;
            n_between += contact.n_constraints > 1 ? 1 : 0;
        }
    });
}

BoxScene make_busy_scene(int n_threads) {
    BoxScene scene;
    scene.grip_buttons = 1U;
    scene.n_threads = n_threads;
    for (int i = 0; i < 6; ++i) {
        scene.boxes.push_back({.at_W = {0.1 * (i % 3 + 1), 0.03 + 0.061 * (i / 3), 0.0}});
    }
    return scene;
}

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

// No read and no write of the simulated WAM allocates: held, thrown about, let go, refused and late.

TEST_CASE("no allocation: five thousand reads and writes of the simulated WAM") {
    LatestValue<HandTarget> target;
    SimulatedWamSettings settings;
    settings.delay_s = 0.003;
    const auto wam = SimulatedWam::create(settings, target);
    REQUIRE(wam);
    double farthest_m = 0.0;
    const auto play = [&] {
        DeviceReading reading;
        for (int k = 0; k < 5000; ++k) {
            HandTarget wanted;
            wanted.pose_D.position =
                Vector3(0.3 * std::sin(0.01 * k), 0.2 * std::cos(0.007 * k), 0.0);
            wanted.velocity_D.x() = k % 500 == 0 ? std::numeric_limits<double>::quiet_NaN() : 0.0;
            target.publish(wanted);
            if (k % 1000 == 0) {
                (*wam)->take_hold(k % 2000 == 0 ? HandGrip{} : kNoGrip);
            }
            const double now_s = k % 700 == 0 ? 0.0 : 0.001 * k;
            (void)(*wam)->read(now_s, reading);
            const double force_N =
                k % 300 == 0 ? std::numeric_limits<double>::infinity() : 40.0 * std::sin(0.1 * k);
            (void)(*wam)->write(now_s, {Vector3(0.0, force_N, 0.0), Vector3::Zero()});
            farthest_m = std::max(farthest_m, reading.pose_D.position.norm());
        }
        (*wam)->reset();
    };
    CHECK(count_allocations(play) == 0);
    CHECK(farthest_m > 0.1);
}

// No round of a kite's loop allocates, nor of what the hand feels of its line: in gusts, snapped, and on the ground.

TEST_CASE("no allocation: two thousand rounds of a kite, launched, let out, snapped and fallen") {
    KiteFlightSettings settings;
    settings.wind.gustiness = 1.0;
    settings.line.strength_N = 4.0;
    const auto channels = std::make_unique<KiteChannels>();
    KiteLoop loop(settings, 500.0, *channels);
    LineFeel feel(LineFeelSettings{});
    double most_N = 0.0;
    const auto fly = [&] {
        KiteOrders orders;
        for (int i = 0; i < 2000; ++i) {
            const Vector3 hand_W(0.1 * std::sin(0.02 * i), 1.0, 0.0);
            orders.line_m = 20.0 + 0.001 * i;
            orders.wind_m_per_s = 0.005 * i;
            orders.n_launches = i > 1500 ? 1U : 0U;
            channels->orders.publish(orders);
            channels->hand_W.publish(hand_W);
            loop.step(0.002 * i);
            (void)channels->line.take();
            const Wrench felt =
                feel.step(channels->line.value(), Pose::at(hand_W), 0.002 * i, 0.002);
            most_N = std::max(most_N, felt.force.norm());
        }
        loop.silence(4.0);
    };
    CHECK(count_allocations(fly) == 0);
    CHECK(most_N > 0.1);
}

// No step of any proxy allocates: every cursor, turned, on every kind of body, two of them, moving.

TEST_CASE("no allocation: point, ball and convex cursors, with friction, on bodies of every kind") {
    const HullShape hull =
        make_hull_shape({{-0.02, 0, 0}, {0.02, 0, 0}, {0, 0, 0.02}, {0, -0.03, 0}, {0, 0.01, 0}})
            .value();
    const std::vector<CursorShape> cursors{
        std::monostate{},         SphereShape{0.01},         BoxShape{{0.01, 0.02, 0.015}},
        CapsuleShape{0.01, 0.02}, CylinderShape{0.01, 0.02}, hull};
    for (const CursorShape& cursor : cursors) {
        int n_between = 0;
        for (const SolidShape& shape : make_shapes(cursor.index() <= 1)) {
            INFO("cursor " << cursor.index() << ", body " << shape.index());
            int n_touching = 0;
            const ProxySettings settings{.kind = ProxyKind::friction_cone, .cursor = cursor};
            CHECK(count_in_proxy(settings, shape, n_touching, n_between) == 0);
            CHECK(n_touching > 100);
        }
        CHECK(n_between > 20);
    }
    for (const SegmentStructureKind structure :
         {SegmentStructureKind::h_collide, SegmentStructureKind::brute_force}) {
        int n_touching = 0;
        int n_between = 0;
        CHECK(count_in_proxy({.structure = structure}, make_shapes(false).front(), n_touching,
                             n_between) == 0);
        CHECK(n_touching > 100);
    }
}

TEST_CASE("no allocation: god object in free space, sliding, in corners, on moving bodies") {
    const auto mesh = touchable(make_bumpy_sphere(1.0, 40, 0.03, 20.0));
    const auto box = touchable(make_box(Vector3::Ones()));
    GodObject proxy({SolidPlan{.body = 0, .shape = mesh, .initial_pose_W = {}},
                     SolidPlan{.body = 1, .shape = box, .initial_pose_W = {}}});
    Random random(15);
    std::array<Pose, 2> poses;
    proxy.reset({0.0, 2.0, 0.0});
    int n_touching = 0;
    CHECK(count_allocations([&] {
              for (int i = 0; i < 20000; ++i) {
                  const Vector3 hand =
                      Vector3(0.0, 2.0 * std::cos(0.003 * i), 0.0) + 0.02 * random.vector();
                  poses[0] = {0.01 * random.vector(), random.turn(0.01) * poses[0].orientation};
                  poses[1] = {Vector3(1.1, 0.2 * std::sin(0.01 * i), 0.0),
                              random.turn(0.01) * poses[1].orientation};
                  n_touching += proxy.step(hand, poses).solid != kNoBody ? 1 : 0;
              }
          }) == 0);
    CHECK(n_touching > 1000);
    CHECK(n_touching < 20000);
}

// No round of a world of rigid bodies allocates, on one thread or more, nor of the hands that push and grip in it; and both sides run at
// once on threads of their own.

TEST_CASE("no allocation: rounds of rigid bodies that are pushed, gripped, hidden and dropped") {
    for (const int n_threads : {1, 3}) {
        HandsInWorld hands(make_busy_scene(n_threads), {{-0.06, 0.03, 0.0}, {0.3, 0.14, 0.0}});
        double most_N = 0.0;
        const auto play = [&] {
            for (int i = 0; i < 2000; ++i) {
                hands.aim(0, {-0.06 + 1.0e-4 * i, 0.03, 0.0});
                hands.aim(1, {0.3, 0.14 - 0.03 * std::sin(0.004 * i), 0.0},
                          i / 500 % 2 == 1 ? 1U : 0U);
                if (i % 300 == 0) {
                    (void)hands.lesson.commands.push(
                        {i % 600 == 0 ? WorldCommand::Kind::drop : WorldCommand::Kind::hide,
                         5,
                         {0.2, 0.5, 0.0}});
                }
                hands.step();
                most_N = std::max(most_N, hands.state(1).applied_W.force.norm());
            }
        };
        CHECK(count_allocations(play) == 0);
        CHECK(most_N > 0.5);
        CHECK(hands.world().report().n_islands > 1);
    }
}

TEST_CASE("live: haptic loop and world of rigid bodies on threads of their own") {
    const BoxScene scene = make_busy_scene(2);
    RigidChannels rigid;
    HapticChannels channels;
    channels.rigid = &rigid;
    WorldChannels lesson;
    LatestValue<HandTarget> target;
    SimulatedArm arm({.start_D = {-0.06, 0.03, 0.0}}, target);
    target.publish({Pose::at({0.05, 0.03, 0.0}), Vector3::Zero(), 0U});
    HapticLoop loop(scene.make_hand(), arm, channels);
    RigidChannels* const hands[] = {&rigid};
    const auto world = std::move(RigidLoop::create(scene.make_world(), &lesson, hands)).value();
    std::atomic<int> n_world{0};
    std::atomic<bool> ends{false};
    std::thread beside([&] {
        while (!ends.load()) {
            world->step(1.0e-3 * n_world.fetch_add(1));
        }
    });
    for (int i = 0; i < 1500; ++i) {
        loop.step(1.0e-3 * i);
        // Neither runs away from the other's time for good.
        while (n_world.load() < i) {
            std::this_thread::yield();
        }
    }
    ends.store(true);
    beside.join();
    lesson.snapshot.take();
    CHECK(lesson.snapshot.value().bodies[0].pose_W.position.allFinite());
    CHECK(loop.state().applied_W.force.allFinite());
}

// No step of a loop with a tool in six degrees of freedom allocates: touching, turning a body on a hinge, let go by a fault.

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
