#include "haptics/tool/implicit_penalty/implicit_penalty.h"

#include "haptics/math/rotation.h"
#include "tests/support/field_parts.h"
#include "tests/support/refused.h"
#include "tests/support/tool_scene.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace fulcrum;

namespace {

constexpr double kDt_s = 0.001;
const Vector3 kEdges_m(0.06, 0.03, 0.05);

// A block of 10 g on a coupling of 500 N/m over a table whose top is at y = 0: contacts of 5 kN/m.
ImplicitPenaltyPlan make_plan() {
    static const auto field = test::make_field(make_box({0.4, 0.1, 0.4}).value(), 128);
    static const auto shell = test::make_shell(make_box(kEdges_m).value(), 3000);
    ImplicitPenaltyPlan plan;
    plan.objects.push_back({field, shell});
    plan.settings.inertia = make_box_inertia(0.01, kEdges_m);
    plan.settings.coupling.shift.stiffness_N_per_m = 500.0;
    plan.settings.coupling.turn.stiffness_Nm_per_rad = 0.5;
    return plan;
}

const MovingFrame kTable{Pose::at({0.0, -0.05, 0.0}), {}};

ImplicitPenaltyTool make_tool(const ImplicitPenaltyPlan& plan, double y_m = 0.025) {
    auto tool = ImplicitPenaltyTool::build(plan).value();
    tool.place(Pose::at({0.0, y_m, 0.0}));
    return tool;
}

struct Course {
    double deepest_m = 0.0;  // of a cluster in the table itself
    double most_felt_N = 0.0;
    double most_jump_N = 0.0;  // from step to step, once pressed
    double farthest_m = 0.0;   // tool and hand
    ToolFelt last{};
    bool moved = true;
};

// Down on the table in a fifth of a second, a rest, and a second of sliding, turning and tilting.
MovingFrame find_hand(double now_s) {
    MovingFrame hand;
    hand.pose_W.position = {0.0, 0.025 - 0.018 * std::min(1.0, now_s / 0.2), 0.0};
    const double u = now_s - 0.4;
    if (u > 0.0) {
        hand.pose_W.position += Vector3(0.05 * std::sin(6.0 * u), 0.0, 0.03 * std::sin(9.0 * u));
        hand.pose_W.orientation = compute_exp(
            Vector3(0.3 * std::sin(5.0 * u), 0.5 * std::sin(3.0 * u), 0.3 * std::sin(7.0 * u)));
    }
    return hand;
}

Course press_and_slide(ImplicitPenaltyTool& tool, double duration_s) {
    Course course;
    Vector3 felt_N = Vector3::Zero();
    for (int i = 1; i * kDt_s < duration_s; ++i) {
        const double now_s = i * kDt_s;
        const MovingFrame hand = find_hand(now_s);
        course.last = tool.move(hand, {&kTable, 1}, now_s, kDt_s);
        course.moved = course.moved && course.last.moved;
        if (now_s > 0.3) {
            course.most_jump_N =
                std::max(course.most_jump_N, (course.last.felt_W.force - felt_N).norm());
        }
        felt_N = course.last.felt_W.force;
        course.most_felt_N = std::max(course.most_felt_N, felt_N.norm());
        course.farthest_m =
            std::max(course.farthest_m, (tool.centre_W() - hand.pose_W.position).norm());
        for (const PlaneContact& plane : tool.planes()) {
            course.deepest_m =
                std::max(course.deepest_m, compute_depth_m(plane, tool.state().pose_W) - 0.001);
        }
    }
    return course;
}

}  // namespace

TEST_CASE(
    "implicit penalty: at rest the hand feels what the contacts push, spring against spring") {
    auto tool = make_tool(make_plan());
    Course course = press_and_slide(tool, 0.4);
    // The hand stays for another fifth of a second.
    const MovingFrame hand = find_hand(0.4);
    for (int i = 400; i <= 600; ++i) {
        course.last = tool.move(hand, {&kTable, 1}, i * kDt_s, kDt_s);
    }
    const double y_m = tool.centre_W().y();
    // The coupling's shift from grip to hand, and every contact k times its depth in the layer.
    CHECK(course.last.felt_W.force.y() == Approx(500.0 * (y_m - 0.007)).epsilon(1e-6));
    CHECK(std::hypot(course.last.felt_W.force.x(), course.last.felt_W.force.z()) < 1.0e-3);
    double pushed_N = 0.0;
    for (const PlaneContact& plane : tool.planes()) {
        pushed_N +=
            plane.stiffness_N_per_m * std::max(compute_depth_m(plane, tool.state().pose_W), 0.0);
    }
    CHECK(pushed_N == Approx(course.last.felt_W.force.y()).epsilon(1e-4));
    CHECK(tool.touches()[0].wrench_W.force.y() == Approx(pushed_N).epsilon(1e-4));
    CHECK(tool.touches()[0].touches);
    CHECK(tool.state().velocity_W.linear.norm() < 1.0e-6);
    // Its underside lies in the layer, above the table.
    CHECK(y_m - 0.015 > 0.0);
    CHECK(y_m - 0.015 < 0.001);
}

TEST_CASE("implicit penalty: stable at 5 kN/m, 10 g, 100 looks a second; without a model not") {
    for (const PenaltyModel model : {PenaltyModel::planes, PenaltyModel::linearised}) {
        for (const double round_s : {0.0, 0.002, 0.005, 0.01}) {
            ImplicitPenaltyPlan plan = make_plan();
            plan.settings.contacts.model = model;
            plan.settings.round_s = round_s;
            auto tool = make_tool(plan);
            const Course course = press_and_slide(tool, 1.5);
            CAPTURE(static_cast<int>(model), round_s);
            CHECK(course.moved);
            CHECK(course.most_felt_N < 6.0);
            CHECK(course.most_jump_N < 0.6);
            CHECK(course.farthest_m < 0.012);
            CHECK(course.deepest_m < 0.001);
        }
    }
    for (const double round_s : {0.002, 0.01}) {
        ImplicitPenaltyPlan plan = make_plan();
        plan.settings.contacts.model = PenaltyModel::held;
        plan.settings.round_s = round_s;
        auto tool = make_tool(plan);
        const Course course = press_and_slide(tool, 1.5);
        CHECK(course.most_felt_N > 50.0);
        CHECK(course.most_jump_N > 20.0);
    }
}

TEST_CASE(
    "implicit penalty: what the contact thread leaves undone for a fifth of a second breaks "
    "nothing") {
    ImplicitPenaltyPlan plan = make_plan();
    plan.settings.own_rounds = false;
    auto tool = make_tool(plan);
    double most_jump_N = 0.0;
    double most_N = 0.0;
    Vector3 last_N = Vector3::Zero();
    for (int i = 1; i < 1500; ++i) {
        const double now_s = i * kDt_s;
        // Rounds at 500 Hz, but for a stall from 0.6 to 0.8 s.
        if (i % 2 == 0 && (now_s < 0.6 || now_s > 0.8)) {
            tool.contact_loop().step(now_s);
        }
        const ToolFelt felt = tool.move(find_hand(now_s), {&kTable, 1}, now_s, kDt_s);
        CHECK(felt.moved);
        if (now_s > 0.3) {
            most_jump_N = std::max(most_jump_N, (felt.felt_W.force - last_N).norm());
        }
        last_N = felt.felt_W.force;
        most_N = std::max(most_N, last_N.norm());
    }
    CHECK(most_N < 8.0);
    CHECK(most_jump_N < 0.5);
}

TEST_CASE(
    "implicit penalty: a hand that saturates the coupling feels no more, and presses no deeper") {
    ImplicitPenaltyPlan plan = make_plan();
    plan.settings.coupling.shift.linear_range_m = 0.004;
    plan.settings.coupling.shift.saturation_range_m = 0.008;
    plan.settings.coupling.shift.saturation_force_N = 3.0;
    auto tool = make_tool(plan);
    std::vector<double> depths_m;
    for (const double down_m : {0.01, 0.02, 0.04, 0.08}) {
        ToolFelt felt;
        for (int i = 1; i <= 500; ++i) {
            felt = tool.move({Pose::at({0.0, 0.015 - down_m, 0.0}), {}}, {&kTable, 1},
                             static_cast<double>(i) * kDt_s, kDt_s);
        }
        CHECK(felt.felt_W.force.norm() == Approx(3.0).epsilon(1e-6));
        depths_m.push_back(tool.centre_W().y());
    }
    CHECK(*std::ranges::max_element(depths_m) - *std::ranges::min_element(depths_m) < 1.0e-6);
}

TEST_CASE(
    "implicit penalty: near something the mass comes and goes bit by bit, in the free not at all") {
    ImplicitPenaltyPlan plan = make_plan();
    plan.settings.clusters.within_m = 4.0e-3;
    auto tool = make_tool(plan, 0.03);
    // 20 m/s^2 where it turns, 3.7 mm over the table: 0.2 N by 10 g.
    constexpr double kRate_per_s = 60.0;
    constexpr double kSwing_m = 20.0 / (kRate_per_s * kRate_per_s);
    Vector3 before_N = Vector3::Zero();
    double most_N = 0.0;
    double most_step_N = 0.0;
    int n_silent = 0;
    for (int i = 1; i <= 1000; ++i) {
        const double t_s = i * kDt_s;
        const double phase = kRate_per_s * t_s;
        const MovingFrame hand{
            Pose::at({0.0, 0.0187 + kSwing_m * (1.0 + std::cos(phase)), 0.0}),
            {{0.0, -kSwing_m * kRate_per_s * std::sin(phase), 0.0}, Vector3::Zero()}};
        const ToolFelt felt = tool.move(hand, {&kTable, 1}, t_s, kDt_s);
        REQUIRE_FALSE(tool.touches()[0].touches);
        // Clusters fade for a while, and then the mass.
        if (std::cos(phase) > 0.5) {
            CAPTURE(i, phase);
            REQUIRE(felt.felt_W.force == Vector3::Zero());
            REQUIRE(felt.felt_W.torque == Vector3::Zero());
            REQUIRE(felt.spring_energy_J == 0.0);
            ++n_silent;
        }
        most_N = std::max(most_N, felt.felt_W.force.norm());
        most_step_N = std::max(most_step_N, (felt.felt_W.force - before_N).norm());
        before_N = felt.felt_W.force;
    }
    CHECK(n_silent > 300);
    CHECK(most_N > 0.15);
    CHECK(most_step_N < 0.06);
}

TEST_CASE("implicit penalty: in free space nothing is felt, or, if asked for, the tool's mass") {
    auto silent = make_tool(make_plan(), 0.3);
    ImplicitPenaltyPlan plan = make_plan();
    plan.settings.silent_in_free_space = false;
    auto heavy = make_tool(plan, 0.3);
    // Ten metres a second square, from rest.
    ToolFelt felt;
    for (int i = 1; i <= 300; ++i) {
        const double t_s = i * kDt_s;
        const MovingFrame hand{Pose::at({5.0 * t_s * t_s, 0.3, 0.0}),
                               {{10.0 * t_s, 0.0, 0.0}, Vector3::Zero()}};
        const ToolFelt nothing = silent.move(hand, {&kTable, 1}, t_s, kDt_s);
        CHECK(nothing.felt_W.force == Vector3::Zero());
        CHECK(nothing.felt_W.torque == Vector3::Zero());
        felt = heavy.move(hand, {&kTable, 1}, t_s, kDt_s);
    }
    CHECK(felt.felt_W.force.x() == Approx(-0.01 * 10.0).epsilon(1e-3));
    CHECK(felt.felt_W.force.tail<2>().norm() < 1.0e-9);
}

TEST_CASE("implicit penalty: one linear solve a step leads where all of Newton's do") {
    // As shipped, and as exactly as it goes.
    ImplicitPenaltyPlan plan = make_plan();
    auto once = make_tool(plan);
    plan.settings.newton_iterations = 24;
    auto exact = make_tool(plan);
    for (int i = 1; i < 1400; ++i) {
        const double now_s = i * kDt_s;
        const ToolFelt a = once.move(find_hand(now_s), {&kTable, 1}, now_s, kDt_s);
        const ToolFelt b = exact.move(find_hand(now_s), {&kTable, 1}, now_s, kDt_s);
        REQUIRE(a.effort.n_looks == 1);
        if (now_s > 0.3) {
            REQUIRE((a.felt_W.force - b.felt_W.force).norm() < 0.25);
        }
    }
    CHECK((once.centre_W() - exact.centre_W()).norm() < 1.0e-4);
}

TEST_CASE(
    "implicit penalty: one solve a step takes no contact to and fro, and more do not either") {
    // Two grams without dampers, pressed with the coupling's clamp on contacts of 11 kN/m: linearised where the speed leads, one
    // solve opens and closes them for ever, and the force shakes by 1.7 N.
    const auto find_ripple_N = [](int newton_iterations) {
        const Vector3 size(0.04, 0.02, 0.04);
        test::ToolScene scene = test::make_ball_tool(ToolMethod::implicit_penalty);
        scene.tool = make_box(size).value();
        scene.inertia = make_box_inertia(0.002, size);
        scene.voxel_m = 0.002;
        scene.n_points = 3000;
        scene.settings.coupling.turn.stiffness_Nm_per_rad = 0.2;
        const ToolPlan made = *test::make_tool_of(scene, {make_box({0.2, 0.04, 0.2}).value()});
        ImplicitPenaltyPlan plan = make_implicit_penalty_plan(made);
        plan.settings.contacts.damping_Ns_per_m = 0.0;
        plan.settings.contacts.stiffness_N_per_m = 11'200.0;
        plan.settings.contacts.within_m = 0.9e-3;
        plan.settings.newton_iterations = newton_iterations;
        auto tool = ImplicitPenaltyTool::build(plan).value();
        tool.place(Pose::at({0.0, 0.06, 0.0}));
        const MovingFrame block;
        double least_N = 1.0e9;
        double most_N = 0.0;
        for (int i = 1; i <= 2000; ++i) {
            const double y_m = 0.06 - 0.05 * std::min(1.0, i / 1000.0);
            const ToolFelt felt = tool.move({Pose::at({0.0, y_m, 0.0}), {}}, {&block, 1},
                                            static_cast<double>(i) * kDt_s, kDt_s);
            if (i > 1600) {
                least_N = std::min(least_N, felt.felt_W.force.norm());
                most_N = std::max(most_N, felt.felt_W.force.norm());
            }
        }
        return most_N - least_N;
    };
    for (const int newton_iterations : {1, 4}) {
        CHECK(find_ripple_N(newton_iterations) < 1.0e-3);
    }
}

TEST_CASE(
    "implicit penalty: a table that rises carries the tool, and gives the hand no more than its "
    "spring") {
    auto tool = make_tool(make_plan());
    press_and_slide(tool, 0.4);
    MovingFrame table = kTable;
    table.velocity_W.linear.y() = 0.1;
    const Pose hand = find_hand(0.4).pose_W;
    for (int i = 1; i <= 50; ++i) {
        const double now_s = 0.4 + i * kDt_s;
        table.pose_W.position.y() += 0.1 * kDt_s;
        const ToolFelt felt = tool.move({hand, {}}, {&table, 1}, now_s, kDt_s);
        CHECK(felt.moved);
        CHECK(tool.centre_W().y() - 0.015 > table.pose_W.position.y() + 0.05 - 0.0005);
    }
    CHECK(tool.centre_W().y() > 0.02);
}

TEST_CASE("implicit penalty: whether it is free is told") {
    auto tool = make_tool(make_plan());
    CHECK(tool.is_free({&kTable, 1}));
    tool.place(Pose::at({0.0, 0.0154, 0.0}));
    CHECK_FALSE(tool.is_free({&kTable, 1}));
    CHECK_FALSE(tool.is_free({}));
    CHECK(tool.memory_bytes() > 100'000);
}

TEST_CASE("implicit penalty: what cannot be built is refused with a sentence") {
    const auto takes = [](const ImplicitPenaltyPlan& plan) {
        const auto tool = ImplicitPenaltyTool::build(plan);
        CHECK((tool || !tool.error().message.empty()));
        return tool.has_value();
    };
    check_refused(
        make_plan(), takes,
        {[](auto& p) { p.objects.clear(); }, [](auto& p) { p.objects.front().field = nullptr; },
         [](auto& p) { p.settings.inertia.mass_kg = 0.0; },
         [](auto& p) { p.settings.coupling.shift.stiffness_N_per_m = -1.0; },
         [](auto& p) { p.settings.contacts.within_m = 0.05; },
         [](auto& p) { p.settings.clusters.most = 100; },
         [](auto& p) { p.settings.newton_iterations = 0; },
         [](auto& p) { p.settings.round_s = 1.0e-5; },
         [](auto& p) { p.settings.handle_turn.coeffs() *= 2.0; },
         [](auto& p) { p.settings.grip_T.x() = std::nan(""); }});
}
