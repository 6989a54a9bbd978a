#include "haptics/math/rotation.h"
#include "haptics/tool/step_limit.h"
#include "haptics/tool/step_time.h"
#include "haptics/tool/tool_motion.h"
#include "tests/support/tool_scene.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>

using namespace fulcrum;
using namespace fulcrum::test;

namespace {

constexpr double kDt_s = 0.001;
constexpr std::array<Integrator, 4> kExplicit{Integrator::explicit_euler,
                                              Integrator::semi_implicit_euler, Integrator::verlet,
                                              Integrator::runge_kutta_4};

struct Case {
    ToolPlan plan;
    Pointshell shell;
    [[nodiscard]] StepLimit limit() const { return {plan, shell}; }
};

Case make_case(ToolScene scene) {
    return {*make_tool_of(scene, {make_box({0.1, 0.04, 0.1}).value()}),
            make_surface_pointshell(scene.tool, scene.n_points).value()};
}

// One mode alone: a ball whose points push with next to nothing, on a spring and a damper of its own.
Case make_oscillator(Integrator integrator, double mass_kg, double damping_Ns_per_m,
                     double stiffness_N_per_m) {
    ToolScene scene = make_ball_tool(ToolMethod::field_sampling);
    scene.n_points = 100;
    scene.inertia = make_ball_inertia(mass_kg, 0.1);
    Case one = make_case(scene);
    VoxelToolSettings& settings = one.plan.settings;
    settings.critically_damped = false;
    settings.integrator.integrator = integrator;
    settings.coupling.shift.stiffness_N_per_m = stiffness_N_per_m;
    settings.coupling.shift.damping_Ns_per_m = damping_Ns_per_m;
    // Its turn has the same: k_r / I = k / m.
    const double lever_m2 = settings.inertia.moments_kg_m2.x() / mass_kg;
    settings.coupling.turn.stiffness_Nm_per_rad = stiffness_N_per_m * lever_m2;
    settings.coupling.turn.damping_Nms_per_rad.setConstant(damping_Ns_per_m * lever_m2);
    auto& object = std::get<std::vector<FieldSamplingPlan>>(one.plan.objects).front();
    object.settings.stiffness_N_per_m = 1.0e-9;
    return one;
}

bool holds(Integrator integrator, double mass_kg, double damping, double stiffness) {
    const Case one = make_oscillator(integrator, mass_kg, damping, stiffness);
    return one.limit().holds(one.plan.settings, kDt_s);
}

ToolScene make_scene(ToolMethod method, Integrator integrator) {
    ToolScene scene{.tool = make_box({0.04, 0.02, 0.04}).value(),
                    .inertia = make_box_inertia(0.02, {0.04, 0.02, 0.04}),
                    .method = method,
                    .voxel_m = 0.002,
                    .n_points = 200};
    scene.settings.coupling.turn.stiffness_Nm_per_rad = 0.5;
    scene.settings.integrator.integrator = integrator;
    return scene;
}

// Pressed 2 mm into the floor, flat; the least and the most that the hand feels when it has been still for half a second.
struct Felt {
    double least_N = HUGE_VAL;
    double most_N = -HUGE_VAL;
    [[nodiscard]] bool is_steady() const { return most_N - least_N < 0.05 && least_N > 0.5; }
};

Felt press(ToolPlan plan, double mass_kg) {
    plan.settings = make_heavier(plan.settings, mass_kg);
    const std::unique_ptr<ToolSolver> tool = make_tool(plan);
    const MovingFrame floor[] = {{}};
    tool->place(Pose::at({0.0, 0.04, 0.0}));
    Felt felt;
    for (int i = 1; i <= 2000; ++i) {
        const double y_m = std::max(0.028, 0.04 - 2.0e-5 * i);
        const ToolFelt now = tool->move({Pose::at({0.0, y_m, 0.0}), {}}, floor, i * kDt_s, kDt_s);
        if (i > 1500) {
            felt.least_N = std::min(felt.least_N, now.felt_W.force.y());
            felt.most_N = std::max(felt.most_N, now.felt_W.force.y());
        }
    }
    return felt;
}

constexpr double kRounding = 1.0e-12;

}  // namespace

TEST_CASE(
    "step time: looks are sixths at most, shared among what is near, and never more than is left") {
    StepTime time(120.0, BudgetClock::counted);
    time.begin();
    CHECK(time.find_look_us(1) == 20.0);
    CHECK(time.find_look_us(4) == 5.0);
    time.count(0, 110.0);
    CHECK(time.find_look_us(1) == Approx(10.0));
    time.count(0, 50.0);
    CHECK(time.left_us() == 0.0);
    CHECK(time.find_look_us(1) == 0.0);
    // The next step has all of it; one look alone likewise.
    time.begin(1);
    CHECK(time.left_us() == 120.0);
    CHECK(time.find_look_us(1) == 120.0);
}

TEST_CASE("step time: there is time while two looks as dear as the dearest are left") {
    StepTime time(100.0, BudgetClock::counted);
    time.begin();
    CHECK(time.has_time());
    const auto look = [&](double cost_us) {
        time.begin_look();
        time.count(32, cost_us);
        time.end_look();
    };
    look(30.0);
    CHECK(time.has_time());
    look(10.0);
    CHECK(time.has_time());  // 60 are left
    look(1.0);
    CHECK_FALSE(time.has_time());
    CHECK(time.has_time_for(1.0));
    look(30.0);
    CHECK_FALSE(time.has_time_for(1.0));
    CHECK(time.n_looks() == 4);
    CHECK(time.n_points() == 4 * 32);
    time.begin();
    CHECK(time.has_time());
    CHECK(time.n_looks() == 0);
    CHECK(time.n_points() == 0);
}

TEST_CASE("step time: without a budget there is always time, on the machine's clock it passes") {
    StepTime endless;
    endless.begin();
    endless.begin_look();
    endless.count(7, 1.0e9);
    endless.end_look();
    CHECK_FALSE(endless.has_end());
    CHECK(endless.has_time());
    CHECK(std::isinf(endless.left_us()));
    CHECK(endless.n_points() == 7);
    StepTime time(1.0);
    time.begin();
    time.begin_look();
    const double began_s = monotonic_now_s();
    while (monotonic_now_s() - began_s < 2.0e-6) {
    }
    time.end_look();
    CHECK(time.elapsed_us() >= 2.0);
    CHECK(time.left_us() == 0.0);
    CHECK_FALSE(time.has_time());
}

TEST_CASE("step limit: of a single mode it is the closed form of each integrator") {
    // h^2 k/m = w and 2 h b/m = 2 c, with m = 1 kg: k = 1e6 w, b = 1e3 c.
    const auto mode = [](Integrator integrator, double w, double c) {
        return holds(integrator, 1.0, 1.0e3 * c, 1.0e6 * w);
    };
    for (const double c : {0.01, 0.3, 0.8}) {
        CHECK(mode(Integrator::explicit_euler, 0.99 * c, c));
        CHECK_FALSE(mode(Integrator::explicit_euler, 1.01 * c, c));
        CHECK(mode(Integrator::semi_implicit_euler, 0.99 * (4.0 - 2.0 * c), c));
        CHECK_FALSE(mode(Integrator::semi_implicit_euler, 1.01 * (4.0 - 2.0 * c), c));
    }
    CHECK(mode(Integrator::verlet, 3.96, 1.0e-9));
    CHECK_FALSE(mode(Integrator::verlet, 4.04, 1.0e-9));
    CHECK(mode(Integrator::runge_kutta_4, 7.99, 1.0e-9));
    CHECK_FALSE(mode(Integrator::runge_kutta_4, 8.01, 1.0e-9));
    CHECK(mode(Integrator::runge_kutta_4, 1.0e-9, 2.785));
    CHECK_FALSE(mode(Integrator::runge_kutta_4, 1.0e-9, 2.786));
}

TEST_CASE("step limit: a step of a tool in free air grows as the limit says") {
    // A tool on its coupling alone, off its handle by a nanometre and a nanoradian, for 40 steps on both sides of the limit.
    for (const Integrator integrator : kExplicit) {
        ToolScene scene = make_ball_tool(ToolMethod::field_sampling);
        scene.settings.grip_T = {0.0, 0.03, 0.01};
        scene.settings.integrator.integrator = integrator;
        scene.settings.coupling.turn.stiffness_Nm_per_rad = 0.5;
        scene.n_points = 100;
        Case one = make_case(scene);
        std::get<std::vector<FieldSamplingPlan>>(one.plan.objects)[0].settings.stiffness_N_per_m =
            1.0e-9;
        const StepLimit limit = one.limit();
        const auto least_kg =
            limit.find_least_mass_kg(make_heavier(one.plan.settings, 1.0e-5), kDt_s, 1.0);
        REQUIRE(least_kg);
        for (const double ratio : {0.9, 1.1}) {
            const VoxelToolSettings settings = make_heavier(one.plan.settings, ratio * *least_kg);
            one.plan.settings = settings;
            const std::unique_ptr<ToolSolver> tool = make_tool(one.plan);
            const MovingFrame far[] = {{Pose::at({0.0, -3.0, 0.0}), {}}};
            tool->place(
                {Vector3(1.0e-9, 2.0e-9, 0.0), compute_exp(Vector3(1.0e-9, 2.0e-9, 3.0e-9))});
            double early_m = 0.0;
            double late_m = 0.0;
            for (int i = 1; i <= 400; ++i) {
                (void)tool->move({}, far, i * kDt_s, kDt_s);
                const double off_m = tool->grip_W().position.norm();
                early_m = i <= 200 ? std::max(early_m, off_m) : early_m;
                late_m = i > 200 ? std::max(late_m, off_m) : late_m;
            }
            CAPTURE(to_string(integrator), ratio, early_m, late_m);
            CHECK((late_m > early_m) == (ratio < 1.0));
        }
    }
}

TEST_CASE("step limit: just inside it a tool pressed flat is felt, far outside it shakes") {
    for (const ToolMethod method : {ToolMethod::field_sampling, ToolMethod::voxel_sampling}) {
        for (const Integrator integrator : kExplicit) {
            const Case one = make_case(make_scene(method, integrator));
            const auto least_kg = one.limit().find_least_mass_kg(one.plan.settings, kDt_s, 100.0);
            CAPTURE(to_string(integrator), static_cast<int>(method), least_kg.value_or(-1.0));
            if (integrator == Integrator::explicit_euler) {
                // It gains in each mode what only the coupling's damper takes.
                CHECK(least_kg.value_or(100.0) > 1.0);
                continue;
            }
            REQUIRE(least_kg);
            CHECK(*least_kg > 0.02);
            CHECK_FALSE(
                one.limit().holds(make_heavier(one.plan.settings, 0.98 * *least_kg), kDt_s));
            CHECK(press(one.plan, *least_kg).is_steady());
            CHECK_FALSE(press(one.plan, 0.1 * *least_kg).is_steady());
        }
    }
}

TEST_CASE("step limit: backward Euler and a tool without mass have none") {
    Case one = make_case(make_scene(ToolMethod::field_sampling, Integrator::backward_euler));
    CHECK(one.limit().compute_growth(one.plan.settings, kDt_s) == 0.0);
    one.plan.settings.integrator.integrator = Integrator::explicit_euler;
    CHECK(one.limit().compute_growth(one.plan.settings, kDt_s) > 1.0);
    one.plan.settings.mass = ToolMass::massless;
    CHECK(one.limit().holds(one.plan.settings, kDt_s));
    CHECK(*one.limit().find_least_mass_kg(one.plan.settings, kDt_s, 1.0) ==
          one.plan.settings.inertia.mass_kg);
}

TEST_CASE("step limit: more points, a shorter way to turn and a longer step come nearer to it") {
    const auto growth = [](auto change, double dt_s = kDt_s) {
        ToolScene scene = make_scene(ToolMethod::field_sampling, Integrator::semi_implicit_euler);
        change(scene);
        const Case one = make_case(scene);
        return one.limit().compute_growth(one.plan.settings, dt_s);
    };
    const double as_it_is = growth([](ToolScene&) {});
    CHECK(as_it_is > 1.0);
    CHECK(growth([](ToolScene& scene) { scene.n_points = 2000; }) > 2.0 * as_it_is);
    CHECK(growth([](ToolScene& scene) { scene.inertia.moments_kg_m2 *= 0.1; }) > 2.0 * as_it_is);
    CHECK(growth([](ToolScene&) {}, 0.25 * kDt_s) < 0.5 * as_it_is);
}

TEST_CASE("tool motion: the way is the object's, and as long as its fastest point's at most") {
    // Both go together on a carousel: no way at all.
    MovingFrame object{{{0.3, -0.1, 0.2}, compute_exp({0.2, 1.0, -0.4})},
                       {{0.5, 0.1, 0.0}, {0.0, 3.0, 1.0}}};
    const Pose tool_O{{0.04, 0.02, -0.01}, compute_exp({0.1, 0.0, 0.3})};
    const Pose object_before = move_evenly(object, -kDt_s).pose_W;
    const ToolMotion together{object_before * tool_O, object_before, object};
    CHECK(find_way(together, object.pose_W * tool_O, 0.1).longest_m < kRounding);
    // Shifted by 5 mm and turned by 0.2 in the object's eyes: a point at 0.1 m goes 25 mm at most.
    const Pose moved_O{tool_O.position + Vector3(0.0, 0.003, 0.004),
                       compute_exp({0.0, 0.2, 0.0}) * tool_O.orientation};
    const ToolWay way = find_way(together, object.pose_W * moved_O, 0.1);
    CHECK(way.longest_m == Approx(0.025).epsilon(1.0e-9));
    CHECK((way.to_OT.position - moved_O.position).norm() < kRounding);
}

TEST_CASE(
    "tool motion: put back to none of the way the tool goes with the object, to all of it as it "
    "went") {
    const MovingFrame object{{{0.3, -0.1, 0.2}, compute_exp({0.2, 1.0, -0.4})},
                             {{0.5, 0.1, 0.0}, {0.0, 3.0, 1.0}}};
    const Pose before_O{{0.04, 0.02, -0.01}, compute_exp({0.1, 0.0, 0.3})};
    const Pose object_before = move_evenly(object, -kDt_s).pose_W;
    const ToolMotion motion{object_before * before_O, object_before, object};
    RigidState end;
    end.pose_W = object.pose_W * Pose{{0.05, 0.01, -0.01}, compute_exp({0.1, 0.2, 0.3})};
    end.velocity_W = {{1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}};
    const ToolWay way = find_way(motion, end.pose_W, 0.1);
    RigidState all = end;
    put_back(motion, way, 1.0, 1.0, all);
    CHECK((all.pose_W.position - end.pose_W.position).norm() < kRounding);
    CHECK((all.velocity_W.linear - end.velocity_W.linear).norm() < kRounding);
    CHECK((all.velocity_W.angular - end.velocity_W.angular).norm() < kRounding);
    RigidState none = end;
    put_back(motion, way, 0.0, 0.0, none);
    const Pose there = object.pose_W * before_O;
    CHECK((none.pose_W.position - there.position).norm() < kRounding);
    CHECK((none.velocity_W.linear - compute_velocity_at(object, there.position)).norm() <
          kRounding);
    CHECK((none.velocity_W.angular - object.velocity_W.angular).norm() < kRounding);
}
