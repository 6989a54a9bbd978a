// What a tool finds beside its steps, by turns in one thread: the god-object's motion, the implicit penalty's contact rounds. As in line when they keep
// pace, and what is felt when they come late or not at all.
#include "tests/support/bad_numbers.h"
#include "tests/support/god_scene.h"
#include "tests/support/silent_contacts.h"
#include "tests/support/tool_scene.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

using namespace fulcrum;

namespace {

constexpr double kDt_s = 0.001;
constexpr double kMost_N = 5.0;
constexpr double kTop_m = 0.02;     // of the block
constexpr double kRadius_m = 0.02;  // of the ball
const MovingFrame kBlock;

ToolPlan make_plan(ToolMethod method) {
    return *test::make_tool_of(test::make_ball_tool(method), {make_box({0.2, 0.04, 0.2}).value()});
}

GodObjectTool make_god(bool own_motion, double fade_s, double friction = 0.0) {
    const ToolPlan plan = make_plan(ToolMethod::god_object);
    auto plans = std::get<std::vector<GodObjectPlan>>(plan.objects);
    plans.front().friction = {.static_coefficient = friction, .dynamic_coefficient = friction};
    GodObjectSettings settings = make_god_object_settings(plan);
    settings.own_motion = own_motion;
    settings.fade_s = fade_s;
    return GodObjectTool::build(plans, settings).value();
}

ImplicitPenaltyPlan make_penalty_plan(bool beside, double round_s = 0.0) {
    ToolPlan plan = make_plan(ToolMethod::implicit_penalty);
    plan.beside = beside;
    plan.penalty->round_s = round_s;
    return make_implicit_penalty_plan(plan);
}

ImplicitPenaltyTool make_penalty(bool beside, double round_s = 0.0) {
    return ImplicitPenaltyTool::build(make_penalty_plan(beside, round_s)).value();
}

// Down on the block's top, along it, over its edge, and up.
Pose hand_at(double t_s) {
    const double down = std::min(1.0, t_s / 0.2) - std::clamp((t_s - 1.2) / 0.3, 0.0, 1.0);
    return Pose::at({0.12 * std::clamp((t_s - 0.3) / 0.9, 0.0, 1.0), 0.06 - 0.03 * down, 0.0});
}

template <class Tool>
ToolFelt step(Tool& tool, const Pose& hand_W, double t_s) {
    return tool.move({hand_W, {}}, {&kBlock, 1}, t_s, kDt_s);
}

bool same(const Wrench& a, const Wrench& b) {
    return a.force == b.force && a.torque == b.torque;
}

bool is_silent(const Wrench& felt) {
    return same(felt, Wrench{});
}

// One that found in line and one that finds beside, along hand_at; `look` steps the one in line and compares.
template <class Tool, class Look>
void keep_pace(Tool& in_line, Tool& beside, Look look) {
    CHECK(in_line.beside() == nullptr);
    REQUIRE(beside.beside() != nullptr);
    in_line.place(hand_at(0.0));
    beside.place(hand_at(0.0));
    CHECK(in_line.is_free({&kBlock, 1}) == beside.is_free({&kBlock, 1}));
    double most_N = 0.0;
    for (int i = 1; i <= 1500; ++i) {
        const ToolFelt felt = look(hand_at(i * kDt_s), i * kDt_s);
        REQUIRE(beside.contact_age().age_s() < 1.5 * kDt_s);
        REQUIRE_FALSE(beside.contact_age().is_late());
        CHECK(in_line.contact_age().age_s() == 0.0);
        // Found now, felt in the next step.
        CHECK(beside.beside()->run_once());
        most_N = std::max(most_N, felt.felt_W.force.norm());
    }
    CHECK(most_N > 3.0);
    // Nothing new, nothing done.
    CHECK_FALSE(beside.beside()->run_once());
}

struct Passage {
    double most_step_N = 0.0;  // where something holds the tool
    double lets_go_N = 0.0;    // where nothing is near any more
    double most_age_s = 0.0;
};

bool is_held(const GodObjectTool& tool) {
    return tool.last_step().contacts > 0;
}
bool is_held(const ImplicitPenaltyTool& /*tool*/) {
    return true;
}

// Along hand_at, what is beside done after every n-th step.
template <class Tool>
Passage pass(Tool tool, int every) {
    const TriangleMesh ball = make_sphere(kRadius_m, 12).value();
    const TriangleMesh box = make_box({0.2, 0.04, 0.2}).value();
    tool.place(hand_at(0.0));
    Passage found;
    double felt_N = 0.0;
    Wrench before;
    for (int i = 1; i <= 1500; ++i) {
        const ToolFelt felt = step(tool, hand_at(i * kDt_s), i * kDt_s);
        if (i % every == 0) {
            REQUIRE(tool.beside()->run_once());
        }
        REQUIRE(felt.moved);
        REQUIRE_FALSE(tool.contact_age().is_late());
        if constexpr (std::is_same_v<Tool, GodObjectTool>) {
            REQUIRE((i % 50 != 0 || !test::do_enter(box, kBlock.pose_W, ball, tool.pose_W())));
        }
        found.most_age_s = std::max(found.most_age_s, tool.contact_age().age_s());
        double& most_N = is_held(tool) ? found.most_step_N : found.lets_go_N;
        most_N = std::max(most_N, (felt.felt_W.force - before.force).norm());
        felt_N = std::max(felt_N, felt.felt_W.force.norm());
        before = felt.felt_W;
    }
    CHECK(is_silent(before));
    CHECK(felt_N > 3.0);
    CHECK(felt_N < 1.0001 * kMost_N);
    return found;
}

// Pressed on the block, with an answer under way, then put above it: nothing is felt of what it met before.
template <class Tool, class Look>
void put_elsewhere(Tool& tool, double from_s, Look look) {
    tool.place(hand_at(0.0));
    double pressed_N = 0.0;
    double t_s = from_s;
    for (int i = 1; i <= 250; ++i) {
        t_s = from_s + i * kDt_s;
        pressed_N = step(tool, hand_at(i * kDt_s), t_s).felt_W.force.y();
        if (tool.beside() != nullptr) {
            (void)tool.beside()->run_once();
        }
    }
    REQUIRE(pressed_N > 1.0);
    tool.place(Pose::at({0.0, 0.06, 0.0}));
    for (int i = 1; i <= 5; ++i) {
        const ToolFelt after = step(tool, Pose::at({0.0, 0.059, 0.0}), t_s + i * kDt_s);
        CHECK(after.moved);
        CHECK(after.felt_W.force == Vector3::Zero());
        look();
    }
}

}  // namespace

TEST_CASE("god beside: a step feels the last set of contacts, and moves as a tool in line does") {
    constexpr double kSolved_N = 1.0e-7;   // each solver begins where its own last answer was
    constexpr double kSolved_m = 1.0e-10;  // a ten-thousandth of the gap at which it rests
    for (const double friction : {0.0, 0.4}) {
        auto in_line = make_god(true, 0.0, friction);
        auto beside = make_god(false, 0.0, friction);
        keep_pace(in_line, beside, [&](const Pose& hand, double t_s) {
            const Wrench expected = in_line.force(hand);
            const ToolFelt felt = step(beside, hand, t_s);
            REQUIRE((felt.felt_W.force - expected.force).norm() < kSolved_N);
            REQUIRE((felt.felt_W.torque - expected.torque).norm() < kSolved_N);
            REQUIRE((beside.pose_W().position - in_line.pose_W().position).norm() < kSolved_m);
            REQUIRE(beside.pose_W().orientation.angularDistance(in_line.pose_W().orientation) <
                    kSolved_m / kRadius_m);
            REQUIRE(step(in_line, hand, t_s).moved);
            return felt;
        });
    }
}

TEST_CASE("penalty beside: rounds that keep pace give the forces of rounds in line, to the bit") {
    auto in_line = make_penalty(false, kDt_s);
    auto beside = make_penalty(true);
    keep_pace(in_line, beside, [&](const Pose& hand, double t_s) {
        const ToolFelt a = step(in_line, hand, t_s);
        const ToolFelt b = step(beside, hand, t_s);
        REQUIRE(same(a.felt_W, b.felt_W));
        REQUIRE(same(a.spring_W, b.spring_W));
        REQUIRE(in_line.state().pose_W.position == beside.state().pose_W.position);
        return a;
    });
}

TEST_CASE("tools beside: a hundred sets a second shake nothing, and new contacts blend in") {
    const Passage sudden = pass(make_god(false, 0.0), 10);
    const Passage blended = pass(make_god(false, 0.05), 10);
    CAPTURE(sudden.most_step_N, blended.most_step_N, blended.lets_go_N);
    CHECK(blended.most_age_s < 0.0115);
    // The hand is 2.6 mm deep when it is told of the block: at 500 N/m a step of the force, were it felt at once. Blended in a fiftieth of what is to
    // come in each millisecond, besides the hand's own way.
    CHECK(sudden.most_step_N > 1.0);
    const double facets_N = 0.15 * kMost_N;  // from facet to facet of the ball: felt at once
    CHECK(blended.most_step_N < 0.11 + facets_N);
    const Passage in_pace = pass(make_god(false, 0.05), 1);
    CHECK(in_pace.most_step_N < 0.11 + facets_N);
    // Off the block it is felt no longer, to the bit; that is the safety gate's to stretch.
    CHECK(blended.lets_go_N < 0.8);
    CHECK(in_pace.lets_go_N < 0.11);
    const Passage found = pass(make_penalty(true), 10);
    CHECK(found.most_age_s < 0.0115);
    // As far as one plane may rise in a step (contact_planes.h).
    const ContactPlanesSettings planes = make_penalty_plan(true).settings.contacts;
    CHECK(found.most_step_N < planes.stiffness_N_per_m * planes.rise_m_per_s * kDt_s);
}

TEST_CASE(
    "tool beside: found late it is held for 0.1 s, gone 0.1 s later, and comes back as evenly") {
    auto god = make_god(false, 0.05);
    test::check_silent_contacts(
        god, {}, hand_at, 0.6, [&] { REQUIRE(god.force(hand_at(0.25)).force == Vector3::Zero()); });
    auto penalty = make_penalty(true);
    test::check_silent_contacts(penalty, penalty.settings().age, hand_at, 0.4, [] {});
}

TEST_CASE("tool beside: put elsewhere it knows nothing of what it met before") {
    auto god = make_god(false, 0.05);
    put_elsewhere(god, 0.3, [&] {
        CHECK(god.pose_W().position.y() == 0.06);  // no set has been found since
        CHECK(god.last_step().contacts == 0);
        CHECK(god.force(Pose::at({0.0, 0.03, 0.0})).force == Vector3::Zero());
    });
    // Beside, or in rounds of its own that are told late.
    for (const bool beside : {true, false}) {
        auto penalty = make_penalty(beside, 0.01);
        put_elsewhere(penalty, 0.0, [&] { CHECK(penalty.planes().empty()); });
    }
}

TEST_CASE(
    "god beside: between two sets the handle is felt in time: deeper by K, off without a pull") {
    auto tool = make_god(false, 0.05);
    tool.place(hand_at(0.0));
    double t_s = 0.0;
    const auto felt_at = [&](double height_m, bool finds) {
        t_s += kDt_s;
        const ToolFelt felt = step(tool, Pose::at({0.0, height_m, 0.0}), t_s);
        if (finds) {
            (void)tool.beside()->run_once();
        }
        return felt.felt_W.force;
    };
    const double touching_m = kTop_m + kRadius_m;
    for (int i = 0; i < 600; ++i) {
        (void)felt_at(touching_m + 0.02 - 0.022 * std::min(1.0, i / 200.0), true);
    }
    const double resting_N = felt_at(touching_m - 0.002, true).y();
    const double deeper_N = felt_at(touching_m - 0.003, false).y();
    const double stiffness = make_god_object_settings(make_plan(ToolMethod::god_object))
                                 .coupling.shift.stiffness_N_per_m;
    CHECK(deeper_N - resting_N == Approx(0.001 * stiffness).epsilon(1e-3));
    // Lifted by what the set says is a wall: it never pulls.
    double least_N = 1.0;
    for (int i = 0; i < 20; ++i) {
        least_N = std::min(least_N, felt_at(touching_m + 0.001 * i, false).y());
    }
    CHECK(least_N >= 0.0);
    CHECK(felt_at(touching_m + 0.02, false).y() < 1.0e-3 * resting_N);
}

TEST_CASE("god beside: in the free nothing is felt, to the bit, however late the sets are") {
    auto tool = make_god(false, 0.05);
    tool.place(Pose::at({0.0, 0.06, 0.0}));
    for (int i = 1; i <= 300; ++i) {
        const double t_s = i * kDt_s;
        const Pose hand = Pose::at({0.1 * std::sin(9.0 * t_s), 0.07, 0.05 * std::cos(7.0 * t_s)});
        REQUIRE(is_silent(step(tool, hand, t_s).felt_W));
        if (i % 37 == 0) {
            (void)tool.beside()->run_once();
        }
    }
}

TEST_CASE("god beside: a tool that was placed inside something stands still, and says so") {
    auto tool = make_god(false, 0.05);
    const Pose across = Pose::at({0.0, kTop_m, 0.0});
    tool.place(across);
    CHECK_FALSE(tool.is_free({&kBlock, 1}));
    CHECK(step(tool, across, kDt_s).moved);
    (void)tool.beside()->run_once();
    const ToolFelt told = step(tool, across, 2.0 * kDt_s);
    CHECK_FALSE(told.moved);
    CHECK(told.felt_W.force == Vector3::Zero());
}

TEST_CASE("god beside: who measures is told of each round of a tool in line, and of none beside") {
    struct Counter final : RoundListener {
        void begins_round() noexcept override { ++n_begun; }
        void ended_round() noexcept override { n_ended += n_ended + 1 == n_begun ? 1 : 0; }
        int n_begun = 0;
        int n_ended = 0;
    };
    for (const bool own_motion : {true, false}) {
        auto tool = make_god(own_motion, 0.05);
        Counter counter;
        tool.listen_to_rounds(&counter);
        tool.place(hand_at(0.0));
        for (int i = 1; i <= 20; ++i) {
            REQUIRE(step(tool, hand_at(i * kDt_s), i * kDt_s).moved);
        }
        CHECK(counter.n_begun == (own_motion ? 20 : 0));
        CHECK(counter.n_ended == counter.n_begun);
    }
}

TEST_CASE("penalty: what a round is told is where all was when the step began") {
    auto tool = make_penalty(false);
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

TEST_CASE("penalty: a step of no time leaves the tool as it is, one that cannot be made at rest") {
    auto tool = make_penalty(true);
    auto calm = make_penalty(true);
    const auto go_on = [&](ImplicitPenaltyTool& one, int i) {
        const Wrench felt = step(one, hand_at(i * kDt_s), i * kDt_s).felt_W;
        (void)one.beside()->run_once();
        return felt;
    };
    tool.place(hand_at(0.0));
    calm.place(hand_at(0.0));
    for (int i = 1; i <= 300; ++i) {
        if (i % 50 == 0) {
            for (const double bad : {kNan, -kDt_s, kInfinity}) {
                const ToolFelt nothing =
                    tool.move({hand_at(i * kDt_s), {}}, {&kBlock, 1}, i * kDt_s, bad);
                CHECK_FALSE(nothing.moved);
                CHECK(nothing.felt_W.force == Vector3::Zero());
            }
            CHECK_FALSE(tool.move({hand_at(i * kDt_s), {}}, {&kBlock, 1}, kNan, kDt_s).moved);
        }
        REQUIRE(same(go_on(tool, i), go_on(calm, i)));
    }
    // So far off that what pulls is no number.
    ImplicitPenaltyPlan unbounded = make_penalty_plan(true);
    unbounded.settings.coupling.clamp_m = unbounded.settings.coupling.clamp_rad = 0.0;
    auto thrown = ImplicitPenaltyTool::build(unbounded).value();
    thrown.place(hand_at(0.0));
    for (int i = 1; i <= 20; ++i) {
        REQUIRE(step(thrown, hand_at(i * kDt_s), i * kDt_s).moved);
    }
    REQUIRE(thrown.state().velocity_W.linear.norm() > 0.01);
    const Vector3 before = thrown.centre_W();
    CHECK_FALSE(thrown.move({Pose::at({0.0, 1.0e307, 0.0}), {}}, {&kBlock, 1}, 0.021, kDt_s).moved);
    CHECK(thrown.centre_W() == before);
    CHECK(thrown.state().velocity_W.linear == Vector3::Zero());
    CHECK(thrown.state().velocity_W.angular == Vector3::Zero());
}
