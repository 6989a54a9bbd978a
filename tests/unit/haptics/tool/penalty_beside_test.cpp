// The implicit penalty's contact rounds beside its steps, by turns in one thread: as in line when they keep pace, and what is felt when they do not.
#include "tests/support/silent_contacts.h"
#include "tests/support/tool_scene.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
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
    test::check_silent_contacts(tool, tool.settings().age, hand_at, 0.4, [] {});
}

TEST_CASE(
    "penalty beside: a tool put elsewhere knows nothing of what it met before, with an answer "
    "under way") {
    for (const bool by_itself : {false, true}) {
        // Beside, or in rounds of its own that are told late.
        auto tool = ImplicitPenaltyTool::build(make_plan(!by_itself, 0.01)).value();
        const MovingFrame block;
        tool.place(hand_at(0.0));
        Vector3 pressed = Vector3::Zero();
        double t_s = 0.0;
        for (int i = 1; i <= 250; ++i) {
            t_s = i * kDt_s;
            pressed = tool.move({hand_at(t_s), {}}, {&block, 1}, t_s, kDt_s).felt_W.force;
            if (!by_itself) {
                (void)tool.beside()->run_once();
            }
        }
        REQUIRE(pressed.y() > 1.0);
        tool.place(Pose::at({0.0, 0.06, 0.0}));
        for (int i = 1; i <= 5; ++i) {
            const ToolFelt after =
                tool.move({Pose::at({0.0, 0.059, 0.0}), {}}, {&block, 1}, t_s + i * kDt_s, kDt_s);
            CHECK(after.moved);
            CHECK(after.felt_W.force == Vector3::Zero());
            CHECK(tool.planes().empty());
        }
    }
}

TEST_CASE("penalty: what a round is told is where all was when the step began") {
    auto tool = ImplicitPenaltyTool::build(make_plan(false)).value();
    MovingFrame block;
    block.velocity_W = {{0.0, 0.3, 0.0}, {0.0, 0.0, 0.2}};
    const Pose hand = Pose::at({0.0, 0.0402, 0.0});
    tool.place(hand);
    for (int i = 1; i <= 20; ++i) {
        const Pose tool_W = tool.state().pose_W;
        const Pose object_W = block.pose_W;
        block = move_evenly(block, kDt_s);
        REQUIRE(tool.move({hand, {}}, {&block, 1}, i * kDt_s, kDt_s).moved);
        REQUIRE(tool.model().n > 0);
        const Pose& X_OT = tool.model().contacts[0].X_OT;
        CHECK((X_OT.position - (object_W.inverse() * tool_W).position).norm() < 1.0e-12);
    }
}

TEST_CASE(
    "penalty: a step whose time is no number leaves the tool as it is, one that cannot be made "
    "leaves it at rest, and it goes on afterwards") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    auto tool = ImplicitPenaltyTool::build(make_plan(true)).value();
    auto calm = ImplicitPenaltyTool::build(make_plan(true)).value();
    const MovingFrame block;
    const auto step = [&](ImplicitPenaltyTool& one, int i) {
        const Wrench felt =
            one.move({hand_at(i * kDt_s), {}}, {&block, 1}, i * kDt_s, kDt_s).felt_W;
        (void)one.beside()->run_once();
        return felt;
    };
    tool.place(hand_at(0.0));
    calm.place(hand_at(0.0));
    for (int i = 1; i <= 300; ++i) {
        if (i % 50 == 0) {
            for (const double bad : {nan, -kDt_s, std::numeric_limits<double>::infinity()}) {
                const ToolFelt nothing =
                    tool.move({hand_at(i * kDt_s), {}}, {&block, 1}, i * kDt_s, bad);
                CHECK_FALSE(nothing.moved);
                CHECK(nothing.felt_W.force == Vector3::Zero());
            }
            CHECK_FALSE(tool.move({hand_at(i * kDt_s), {}}, {&block, 1}, nan, kDt_s).moved);
        }
        REQUIRE(same(step(tool, i), step(calm, i)));
    }
    // So far off that what pulls is no number.
    ImplicitPenaltyPlan unbounded = make_plan(true);
    unbounded.settings.coupling.clamp_m = unbounded.settings.coupling.clamp_rad = 0.0;
    auto thrown = ImplicitPenaltyTool::build(unbounded).value();
    thrown.place(hand_at(0.0));
    for (int i = 1; i <= 20; ++i) {
        REQUIRE(thrown.move({hand_at(i * kDt_s), {}}, {&block, 1}, i * kDt_s, kDt_s).moved);
    }
    REQUIRE(thrown.state().velocity_W.linear.norm() > 0.01);
    const Vector3 before = thrown.centre_W();
    CHECK_FALSE(thrown.move({Pose::at({0.0, 1.0e307, 0.0}), {}}, {&block, 1}, 0.021, kDt_s).moved);
    CHECK(thrown.centre_W() == before);
    CHECK(thrown.state().velocity_W.linear == Vector3::Zero());
    CHECK(thrown.state().velocity_W.angular == Vector3::Zero());
}
