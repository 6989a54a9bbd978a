#include "haptics/geometry/shape.h"
#include "haptics/loop/safety.h"
#include "haptics/math/rotation.h"
#include "haptics/tool/god_object/god_object_tool.h"
#include "tests/support/god_scene.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

using namespace fulcrum;

namespace {

constexpr double kDt_s = 0.001;
constexpr double kHalfBlock_m = 0.01;
constexpr double kStiffness = 500.0;
const MovingFrame kFloor{Pose::at({0.0, -0.05, 0.0}), {}};  // its top is y = 0

// A block on grooves along z; so heavy to turn that it stays as it is held.
GodObjectTool make_block_on_grooves(bool own_motion) {
    GodObjectPlan plan{.object = GodSurface::create(make_box({0.6, 0.1, 0.6}).value()),
                       .tool = GodSurface::create(test::make_cube(2.0 * kHalfBlock_m))};
    plan.texture = std::make_shared<const Texture>(
        TextureSettings{SineTexture{0.0043, 0.0}, TextureLaw::lateral, 2.0e-4, 1.0});
    GodObjectSettings settings = test::make_sudden_settings(test::make_still_inertia());
    settings.own_motion = own_motion;
    return GodObjectTool::build({plan}, settings).value();
}

// Pressed `depth_m` deep, so far along.
Pose hand_at(double x_m, double depth_m) {
    return Pose::at({x_m, kHalfBlock_m - depth_m, 0.02});
}

// Down from above, and left to come to rest.
ToolFelt press(GodObjectTool& tool, double x_m, double depth_m, double& t_s) {
    tool.place(hand_at(x_m, -0.002));
    ToolFelt felt;
    for (int i = 0; i < 80; ++i) {
        t_s += kDt_s;
        felt = tool.move({hand_at(x_m, depth_m), {}}, {&kFloor, 1}, t_s, kDt_s);
        if (BesideTask* const beside = tool.beside(); beside != nullptr) {
            (void)beside->run_once();
        }
    }
    return felt;
}

constexpr double kNothing_N = 1.0e-4;  // what ends a fade

constexpr double kNear_m = 16.0e-6;  // 16 gaps at rest
constexpr double kRounding_m = 1.0e-12;
constexpr int kEndsSteps = 10;    // in which a force ends that nothing is near
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

}  // namespace

// What hand and objects feel between two sets of contacts, and of sets that come late: with a relief, and in its fade.

TEST_CASE("god object felt: between steps the relief weakens with the push, and never grows") {
    GodObjectTool tool = make_block_on_grooves(true);
    double t_s = 0.0;
    const ToolFelt felt = press(tool, 0.011, 0.002, t_s);
    const double relief_N = felt.texture_W.force.x();
    REQUIRE(std::abs(relief_N) > 0.01);
    const auto felt_at = [&](double depth_m) { return tool.force(hand_at(0.011, depth_m)).force; };
    CHECK(felt_at(0.002).x() == Approx(relief_N).epsilon(1.0e-6));
    CHECK(felt_at(0.001).x() == Approx(0.5 * relief_N).epsilon(1.0e-2));
    CHECK(felt_at(0.004).x() == Approx(relief_N).epsilon(1.0e-6));
    CHECK(felt_at(0.004).y() == Approx(2.0 * kStiffness * 0.002).epsilon(1.0e-2));
    CHECK(felt_at(-0.001).isZero(0.0));
}

TEST_CASE("god object felt: beside its motion it feels grooves as a tool in line a step before") {
    GodObjectTool in_line = make_block_on_grooves(true);
    GodObjectTool beside = make_block_on_grooves(false);
    double t_s = 0.0;
    (void)press(in_line, 0.0, 0.002, t_s);
    t_s = 0.0;
    (void)press(beside, 0.0, 0.002, t_s);
    Vector3 before = Vector3::Zero();
    double most_N = 0.0;
    for (int i = 0; i < 400; ++i) {
        t_s += kDt_s;
        // Fast enough that the relief is evened over a step's way.
        const Pose hand = hand_at(0.0004 * std::min(i, 300), 0.002);
        const ToolFelt late = beside.move({hand, {}}, {&kFloor, 1}, t_s, kDt_s);
        REQUIRE(beside.beside()->run_once());
        CAPTURE(i);
        if (i > 20) {
            REQUIRE((late.texture_W.force - before).norm() < 1.0e-4);
        }
        before = in_line.move({hand, {}}, {&kFloor, 1}, t_s, kDt_s).texture_W.force;
        most_N = std::max(most_N, before.norm());
    }
    CHECK(most_N > 0.02);
    // At rest there nothing is evened over the way that it came.
    GodObjectTool pressed = make_block_on_grooves(true);
    CHECK((press(pressed, 0.0004 * 300, 0.002, t_s).texture_W.force - before).norm() <
          1.0e-3 * most_N);
}

TEST_CASE("god object felt: what is late is felt as weakly between two steps as in them") {
    GodObjectTool tool = make_block_on_grooves(false);
    double t_s = 0.0;
    (void)press(tool, 0.011, 0.002, t_s);
    const Pose hand = hand_at(0.011, 0.002);
    int n_faded = 0;
    for (int i = 0; i < 250; ++i) {
        t_s += kDt_s;
        const ToolFelt felt = tool.move({hand, {}}, {&kFloor, 1}, t_s, kDt_s);
        CAPTURE(i);
        REQUIRE((tool.force(hand).force - felt.felt_W.force).norm() < 1.0e-9);
        REQUIRE((tool.force(hand).torque - felt.felt_W.torque).norm() < 1.0e-9);
        n_faded += felt.felt_W.force.y() < 0.9 && felt.felt_W.force.y() > 0.1 ? 1 : 0;
    }
    CHECK(n_faded > 50);
    CHECK(tool.force(hand).force == Vector3::Zero());
}

TEST_CASE(
    "god object felt: stopped over grooves it feels them once the way it came is evened out") {
    const auto texture = std::make_shared<const Texture>(
        TextureSettings{SineTexture{0.0043, 0.0}, TextureLaw::lateral, 2.0e-4, 1.0});
    GodTexture felt(texture, {.stiffness_N_per_m = kStiffness, .reach_m = 0.02, .fade_s = 0.03});
    constexpr double kForce_N = 1.0;
    // Where the grooves are steepest.
    constexpr double kEnd_m = 4 * 0.0043;
    constexpr double kStep_m = 0.002;
    const auto feel = [&](double from_m, double to_m) {
        felt.begin(Pose::at({from_m, 0.0, 0.0}), Pose::at({to_m, 0.0, 0.0}), kForce_N);
        felt.add({to_m, 0.0, 0.0}, Vector3::UnitY(), kForce_N);
        return felt.finish(kDt_s).force.x();
    };
    double fast_N = 0.0;
    for (int i = 40; i > 0; --i) {
        fast_N = feel(kEnd_m - kStep_m * i, kEnd_m - kStep_m * (i - 1));
    }
    double stopped_N = 0.0;
    for (int i = 0; i < 12; ++i) {
        stopped_N = feel(kEnd_m, kEnd_m);
    }
    const double steepest_N = kForce_N * std::abs(texture->relief({kEnd_m, 0.0}).slope_u);
    CAPTURE(fast_N, stopped_N, steepest_N);
    CHECK(std::abs(fast_N) < 0.2 * steepest_N);
    CHECK(std::abs(stopped_N) > 0.9 * steepest_N);
}

// No set of contacts that takes another's place is felt as a jolt; and of a tool that is free nothing is felt, with the settings that ship.

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
    int n_away = 0;              // and with nothing near
    int n_dropped = 0;           // of these, as the force before was not yet gone
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
            // Evenly, to nothing.
            const int n_left = kEndsSteps - n_away++;
            const double ends = n_left > 1 ? 1.0 / n_left : 1.0;
            REQUIRE(felt.felt_W.force.norm() <= (1.001 - ends) * before.force.norm() + kNothing_N);
            REQUIRE((n_left > 1 || felt.felt_W.force == Vector3::Zero()));
            REQUIRE((n_left > 1 || felt.felt_W.torque == Vector3::Zero()));
            n_dropped += before.force.norm() > 0.01 ? 1 : 0;
            n_free = 0;
            continue;
        }
        n_away = 0;
        // After 5 ms without a push it fades evenly.
        n_free = contacts == Vector3::Zero() ? n_free + 1 : 0;
        left_N = n_free > 5 ? left_N : before.force.norm();
        // At once no more than 0.4 of what the contacts before held, which is what these hold to a tenth.
        const double most_N =
            std::max(lost * change_N, n_free > 5 ? left_N * test::kGodDt_s / fade_s : 0.0) +
            0.45 * contacts.norm();
        REQUIRE((felt.felt_W.force - before.force).norm() <=
                1.001 * most_N + kNothing_N + 1.0e-9 * kStiffness);
    }
    CHECK(most_change_N > 1.0);
    CHECK(n_dropped > 3);
}

TEST_CASE("god-object in the free: nothing is felt 10 ms after something was near") {
    test::GodScene scene = make_scene({0.06, 0.05, 0.07});
    Random random(21);
    Pose handle = Pose::at({0.0, 0.1, 0.0});
    scene.god.place(handle);
    Vector3 velocity = Vector3::Zero();
    int n_away = 0;
    int n_loaded = 0;
    int n_in_a_row = 0;
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
            REQUIRE(felt.felt_W.force.norm() <= last_N);
            const bool is_over = ++n_in_a_row >= kEndsSteps;
            REQUIRE((!is_over || felt.felt_W.force == Vector3::Zero()));
            REQUIRE((!is_over || felt.felt_W.torque == Vector3::Zero()));
            REQUIRE((!is_over || scene.god.force(handle).force == Vector3::Zero()));
        } else {
            n_in_a_row = 0;
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

TEST_CASE("god-object in the free: off an edge it ends within 10 ms, behind the gate too") {
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
        CHECK((passed.force - sent_N).norm() <= slew_N + safety.max_transient_N);
        if (find_distance_m(scene) > kNear_m + kRounding_m) {
            n_free = x > 0.0 ? n_free + 1 : 0;
            CHECK((n_free < kEndsSteps || felt.felt_W.force == Vector3::Zero()));
            CHECK((n_free < kEndsSteps || felt.felt_W.torque == Vector3::Zero()));
            CHECK((n_free < kEndsSteps + safety.max_force_N / slew_N ||
                   passed.force == Vector3::Zero()));
        }
        asked_N = felt.felt_W.force;
        sent_N = passed.force;
    }
    CHECK(most_drop_N > 0.1);
    CHECK(most_drop_N < 0.1 * kStiffness * 0.009);
    CHECK(n_free > 100);
}
