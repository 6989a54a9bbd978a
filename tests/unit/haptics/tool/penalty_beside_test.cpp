// The implicit penalty's contact rounds beside its steps, by turns in one thread: as in line when they keep pace, and what is felt when they do not.
#include "tests/support/tool_scene.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

using namespace fulcrum;

namespace {

constexpr double kDt_s = 0.001;
constexpr double kMost_N = 5.0;

ImplicitPenaltyPlan make_plan(bool beside, double round_s = 0.0) {
    ToolPlan plan = *test::make_tool_of(test::make_ball_tool(ToolMethod::implicit_penalty),
                                        {make_box({0.2, 0.04, 0.2}).value()});
    plan.beside = beside;
    plan.penalty->round_s = round_s;
    return make_implicit_penalty_plan(plan);
}

// Down on the block's top, at height 0.02, and along it over its edge, and up.
Pose hand_at(double t_s) {
    const double down = std::min(1.0, t_s / 0.2) - std::clamp((t_s - 1.2) / 0.3, 0.0, 1.0);
    return Pose::at({0.12 * std::clamp((t_s - 0.3) / 0.9, 0.0, 1.0), 0.06 - 0.03 * down, 0.0});
}

bool same(const Wrench& a, const Wrench& b) {
    return a.force == b.force && a.torque == b.torque;
}

}  // namespace

TEST_CASE(
    "penalty beside: rounds that keep pace with the steps give the forces of rounds in line, to "
    "the bit") {
    auto in_line = ImplicitPenaltyTool::build(make_plan(false, kDt_s)).value();
    auto beside = ImplicitPenaltyTool::build(make_plan(true)).value();
    CHECK(in_line.beside() == nullptr);
    REQUIRE(beside.beside() != nullptr);
    const MovingFrame block;
    in_line.place(hand_at(0.0));
    beside.place(hand_at(0.0));
    CHECK(in_line.is_free({&block, 1}) == beside.is_free({&block, 1}));
    double most_N = 0.0;
    for (int i = 1; i <= 1500; ++i) {
        const MovingFrame hand{hand_at(i * kDt_s), {}};
        const ToolFelt a = in_line.move(hand, {&block, 1}, i * kDt_s, kDt_s);
        const ToolFelt b = beside.move(hand, {&block, 1}, i * kDt_s, kDt_s);
        CHECK(beside.beside()->run_once());
        REQUIRE(same(a.felt_W, b.felt_W));
        REQUIRE(same(a.spring_W, b.spring_W));
        REQUIRE(in_line.state().pose_W.position == beside.state().pose_W.position);
        REQUIRE(beside.contact_age().age_s() < 1.5 * kDt_s);
        REQUIRE_FALSE(beside.contact_age().is_late());
        CHECK(in_line.contact_age().age_s() == 0.0);
        most_N = std::max(most_N, a.felt_W.force.norm());
    }
    CHECK(most_N > 3.0);
    // Nothing new, nothing done.
    CHECK_FALSE(beside.beside()->run_once());
}

TEST_CASE("penalty beside: a hundred rounds a second shake nothing, and no round is too late") {
    auto tool = ImplicitPenaltyTool::build(make_plan(true)).value();
    const MovingFrame block;
    tool.place(hand_at(0.0));
    Wrench before;
    double most_N = 0.0;
    double most_step_N = 0.0;
    for (int i = 1; i <= 1500; ++i) {
        const ToolFelt felt = tool.move({hand_at(i * kDt_s), {}}, {&block, 1}, i * kDt_s, kDt_s);
        if (i % 10 == 0) {
            (void)tool.beside()->run_once();
        }
        REQUIRE_FALSE(tool.contact_age().is_late());
        REQUIRE(tool.contact_age().age_s() < 0.0115);
        most_step_N = std::max(most_step_N, (felt.felt_W.force - before.force).norm());
        most_N = std::max(most_N, felt.felt_W.force.norm());
        before = felt.felt_W;
    }
    CHECK(before.force == Vector3::Zero());
    CHECK(most_N > 3.0);
    CHECK(most_N < 1.0001 * kMost_N);
    // As far as one plane may rise in a step (contact_planes.h).
    const ContactPlanesSettings& planes = tool.settings().contacts;
    CHECK(most_step_N < planes.stiffness_N_per_m * planes.rise_m_per_s * kDt_s);
}

TEST_CASE(
    "penalty beside: when the rounds end the force is held for 0.1 s and gone 0.1 s later, evenly; "
    "when they begin "
    "again it comes back as evenly") {
    auto tool = ImplicitPenaltyTool::build(make_plan(true)).value();
    const ContactAgeSettings age = tool.settings().age;
    const MovingFrame block;
    tool.place(hand_at(0.0));
    Wrench before;
    double held_N = 0.0;
    for (int i = 1; i <= 1000; ++i) {
        const double t_s = i * kDt_s;
        // Pressed at rest; silent from 0.4 s to 0.7 s.
        const ToolFelt felt =
            tool.move({hand_at(std::min(t_s, 0.25)), {}}, {&block, 1}, t_s, kDt_s);
        if (t_s <= 0.4 || t_s > 0.7) {
            (void)tool.beside()->run_once();
        }
        held_N = i == 400 ? felt.felt_W.force.norm() : held_N;
        const double silent_s = t_s - 0.4;
        if (t_s > 0.4 && silent_s < age.hold_s - 0.001) {
            REQUIRE(felt.felt_W.force.norm() == Approx(held_N).epsilon(1e-3));
            REQUIRE_FALSE(tool.contact_age().is_lost());
        }
        if (t_s < 0.7 && silent_s > age.hold_s + age.fade_s + 0.002) {
            REQUIRE(felt.felt_W.force == Vector3::Zero());
            REQUIRE(felt.spring_W.force == Vector3::Zero());
            REQUIRE(felt.spring_energy_J == 0.0);
            REQUIRE(tool.contact_age().is_lost());
            REQUIRE(tool.contact_age().is_late());
        }
        if (t_s > 0.401) {
            REQUIRE((felt.felt_W.force - before.force).norm() < 1.1 * held_N * kDt_s / age.fade_s);
        }
        before = felt.felt_W;
    }
    CHECK(held_N > 3.0);
    CHECK(before.force.norm() == Approx(held_N).epsilon(1e-3));
}
