// No set of contacts that takes another's place is felt as a jolt; and of a tool that is free nothing is felt, with the settings that ship.
#include "haptics/loop/safety.h"
#include "haptics/math/rotation.h"
#include "haptics/tool/god_object_tool.h"
#include "tests/support/god_scene.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr double kStiffness = 500.0;
constexpr double kNothing_N = 1.0e-4;  // what ends a fade

constexpr double kNear_m = 16.0e-6;  // 16 gaps at rest
constexpr double kRounding_m = 1.0e-12;
constexpr double kHalf_m = 0.02;  // of the tool, a cube
constexpr int kBlended = 1200;    // steps in which any set of contacts is blended in

const Inertia kCube = make_box_inertia(0.05, Vector3::Constant(2.0 * kHalf_m));

test::GodScene make_scene(const Vector3& block_m,
                          const GodObjectSettings& settings = test::make_god_settings(kCube)) {
    return {test::make_cube(2.0 * kHalf_m), {make_box(block_m).value()}, settings};
}

double find_distance_m(const test::GodScene& scene) {
    return test::find_distance_m(scene.objects[0], scene.god.object_W(0), scene.tool,
                                 scene.god.pose_W());
}

TEST_CASE("god-object jolts: contacts that come and go change the force by a step's fade at most") {
    const double mu = GENERATE(0.0, 0.5);
    const TriangleMesh cube = test::make_cube(0.04);
    const TriangleMesh block = make_box({0.06, 0.05, 0.07}).value();
    GodObjectSettings settings =
        test::make_god_settings(make_box_inertia(0.05, Vector3::Constant(0.04)));
    const double fade_s = settings.fade_s;
    REQUIRE(fade_s > 0.0);
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
    const double lost = 1.0 - std::exp(-test::kGodDt_s / fade_s);
    double most_change_N = 0.0;  // of the contacts' own force
    double left_N = 0.0;         // felt when that begins to end
    int n_free = 0;              // steps without a push
    int n_dropped = 0;           // and with nothing near, as the force before was not yet gone
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
        const double apart_m = test::find_distance_m(block, {}, cube, tool.pose_W());
        if (apart_m > kNear_m + kRounding_m) {
            REQUIRE(felt.felt_W.force == Vector3::Zero());
            REQUIRE(felt.felt_W.torque == Vector3::Zero());
            n_dropped += before.force.norm() > 0.01 ? 1 : 0;
            n_free = 0;
            continue;
        }
        // After 5 ms without a push it fades evenly.
        n_free = contacts == Vector3::Zero() ? n_free + 1 : 0;
        left_N = n_free > 5 ? left_N : before.force.norm();
        const double most_N =
            std::max(lost * change_N, n_free > 5 ? left_N * test::kGodDt_s / fade_s : 0.0);
        REQUIRE((felt.felt_W.force - before.force).norm() <=
                1.001 * most_N + kNothing_N + 1.0e-9 * kStiffness);
    }
    CHECK(most_change_N > 5.0);
    CHECK(n_dropped > 3);
}

TEST_CASE("god-object in the free: nothing is felt in any step in which nothing is near") {
    test::GodScene scene = make_scene({0.06, 0.05, 0.07});
    Random random(21);
    Pose handle = Pose::at({0.0, 0.1, 0.0});
    scene.god.place(handle);
    Vector3 velocity = Vector3::Zero();
    int n_away = 0;
    int n_loaded = 0;
    double last_N = 0.0;
    for (int i = 0; i < 12000; ++i) {
        velocity = 0.98 * velocity + 0.004 * random.in_cube() -
                   0.006 * (handle.position - Vector3(0.0, 0.066, 0.0));
        handle.position += 0.03 * velocity;
        handle.orientation = compute_exp(0.006 * random.in_cube()) * handle.orientation;
        handle.orientation.normalize();
        // It swings, and is elsewhere for a while.
        const double thrown_m = i % 500 < 40 ? -0.03 : 0.0;
        scene.frames[0].pose_W = {Vector3(0.003 * std::sin(0.01 * i), thrown_m, 0.0),
                                  compute_exp(Vector3(0.0, 0.0, 0.05 * std::sin(0.007 * i)))};
        const ToolFelt felt = scene.step(handle);
        CAPTURE(i, felt.felt_W.force);
        REQUIRE(felt.moved);
        if (find_distance_m(scene) > kNear_m + kRounding_m) {
            ++n_away;
            n_loaded += last_N > 0.5 ? 1 : 0;
            REQUIRE(felt.felt_W.force == Vector3::Zero());
            REQUIRE(felt.felt_W.torque == Vector3::Zero());
            REQUIRE(scene.god.force(handle).force == Vector3::Zero());
        }
        last_N = felt.felt_W.force.norm();
    }
    CHECK(n_away > 1000);
    CHECK(n_loaded > 5);
}

TEST_CASE("god-object in the free: lifted, the force goes to zero without a step") {
    test::GodScene scene = make_scene({0.2, 0.1, 0.2});
    const double rest_m = 0.05 + kHalf_m + 1.0e-6;
    constexpr double kLift_m = 2.0e-5;  // a step
    constexpr double kDepth_m = 0.003;
    scene.god.place(Pose::at({0.0, rest_m + 0.001, 0.0}));
    const Pose pressed{Vector3(0.0, rest_m - kDepth_m, 0.0), compute_exp(Vector3(0.01, 0.2, 0.0))};
    for (int i = 0; i < kBlended; ++i) {
        (void)scene.step(pressed);
    }
    Vector3 last_N = scene.god.force(pressed).force;
    CHECK(last_N.y() == Approx(kStiffness * kDepth_m).epsilon(1.0e-6));
    Vector3 last_Nm = scene.god.force(pressed).torque;
    const double turn_stiffness = kStiffness * kCube.moments_kg_m2.x() / kCube.mass_kg;
    for (int i = 1; i <= 200; ++i) {
        const ToolFelt felt =
            scene.step({pressed.position + Vector3(0.0, kLift_m * i, 0.0), pressed.orientation});
        CAPTURE(i, felt.felt_W.force, last_N);
        CHECK((felt.felt_W.force - last_N).norm() < 1.01 * kStiffness * kLift_m);
        // As it comes off by one edge after the other it turns, a step of the tool at most by what its half of the lift is along its edge.
        CHECK((felt.felt_W.torque - last_Nm).norm() < turn_stiffness * 0.01);
        last_N = felt.felt_W.force;
        last_Nm = felt.felt_W.torque;
        if (kLift_m * i > kDepth_m + 3.0e-4) {
            CHECK(felt.felt_W.force.norm() <= 1.0e-9);
            CHECK(felt.felt_W.torque.norm() <= 1.0e-9);
        }
    }
}

TEST_CASE("god-object in the free: off an edge it is felt no longer, and the gate slews down") {
    test::GodScene scene = make_scene({0.1, 0.04, 0.1});
    const SafetySettings safety;
    SafetyGate gate(safety);
    const double on_m = 0.02 + kHalf_m;
    scene.god.place(Pose::at({0.0, on_m + 0.02, 0.0}));
    // Long enough above it for the gate to be open.
    for (int i = 0; i < 3000; ++i) {
        const ToolFelt felt = scene.step(Pose::at({0.0, on_m + 0.02, 0.0}));
        (void)gate.pass(felt.felt_W, Fault::none, test::kGodDt_s);
    }
    REQUIRE(gate.phase() == GatePhase::open);
    const double slew_N = safety.max_slew_N_per_s * test::kGodDt_s;
    double most_drop_N = 0.0;  // asked for
    int n_free = 0;
    Vector3 asked_N = Vector3::Zero();
    Vector3 sent_N = Vector3::Zero();
    for (int i = 0; i < 1400; ++i) {
        const double down_m = 0.029 * std::min(1.0, i / 300.0);
        const double x = i < 400 ? 0.0 : 0.0002 * (i - 400);
        const ToolFelt felt = scene.step(Pose::at({x, on_m + 0.02 - down_m, 0.0}));
        const Wrench passed = gate.pass(felt.felt_W, Fault::none, test::kGodDt_s);
        CAPTURE(i, felt.felt_W.force, passed.force);
        most_drop_N = std::max(most_drop_N, (felt.felt_W.force - asked_N).norm());
        CHECK((passed.force - sent_N).norm() <= slew_N * (1.0 + 1.0e-9));
        if (find_distance_m(scene) > kNear_m + kRounding_m) {
            CHECK(felt.felt_W.force == Vector3::Zero());
            CHECK(felt.felt_W.torque == Vector3::Zero());
            n_free = x > 0.0 ? n_free + 1 : 0;
            CHECK((n_free < safety.max_force_N / slew_N || passed.force == Vector3::Zero()));
        }
        asked_N = felt.felt_W.force;
        sent_N = passed.force;
    }
    CHECK(most_drop_N > 4.0 * slew_N);
    CHECK(n_free > 100);
}

}  // namespace
}  // namespace fulcrum
