// A god-object's motion beside its force, by turns in one thread: the force of the last set of contacts, new ones blended in, and what is felt of sets that
// come late or not at all.
#include "tests/support/god_scene.h"
#include "tests/support/silent_contacts.h"
#include "tests/support/tool_scene.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace fulcrum;

namespace {

constexpr double kDt_s = 0.001;
constexpr double kMost_N = 5.0;
constexpr double kTop_m = 0.02;     // of the block
constexpr double kRadius_m = 0.02;  // of the ball

GodObjectTool make_tool(bool own_motion, double fade_s, double friction = 0.0) {
    ToolPlan plan = *test::make_tool_of(test::make_ball_tool(ToolMethod::god_object),
                                        {make_box({0.2, 0.04, 0.2}).value()});
    auto plans = std::get<std::vector<GodObjectPlan>>(plan.objects);
    plans.front().friction = {.static_coefficient = friction, .dynamic_coefficient = friction};
    GodObjectSettings settings = make_god_object_settings(plan);
    settings.own_motion = own_motion;
    settings.fade_s = fade_s;
    return GodObjectTool::build(plans, settings).value();
}

// Down on the block's top, along it, over its edge, and up.
Pose hand_at(double t_s) {
    const double down = std::min(1.0, t_s / 0.2) - std::clamp((t_s - 1.2) / 0.3, 0.0, 1.0);
    return Pose::at({0.12 * std::clamp((t_s - 0.3) / 0.9, 0.0, 1.0), 0.06 - 0.03 * down, 0.0});
}

struct Passage {
    double most_N = 0.0;
    double most_step_N = 0.0;  // where something holds the tool
    double lets_go_N = 0.0;    // where nothing is near any more
    double most_age_s = 0.0;
};

// Along hand_at, the motion's round after every n-th step.
Passage pass(double fade_s, int every) {
    auto tool = make_tool(false, fade_s);
    const MovingFrame block;
    const TriangleMesh ball = make_sphere(kRadius_m, 12).value();
    const TriangleMesh box = make_box({0.2, 0.04, 0.2}).value();
    tool.place(hand_at(0.0));
    Passage found;
    Wrench before;
    for (int i = 1; i <= 1500; ++i) {
        const ToolFelt felt = tool.move({hand_at(i * kDt_s), {}}, {&block, 1}, i * kDt_s, kDt_s);
        if (i % every == 0) {
            REQUIRE(tool.beside()->run_once());
        }
        REQUIRE(felt.moved);
        REQUIRE_FALSE(tool.contact_age().is_late());
        if (i % 50 == 0) {
            REQUIRE_FALSE(test::do_enter(box, block.pose_W, ball, tool.pose_W()));
        }
        found.most_age_s = std::max(found.most_age_s, tool.contact_age().age_s());
        double& most_N = tool.last_step().contacts > 0 ? found.most_step_N : found.lets_go_N;
        most_N = std::max(most_N, (felt.felt_W.force - before.force).norm());
        found.most_N = std::max(found.most_N, felt.felt_W.force.norm());
        before = felt.felt_W;
    }
    CHECK(before.force == Vector3::Zero());
    CHECK(before.torque == Vector3::Zero());
    CHECK(found.most_N > 3.0);
    CHECK(found.most_N < 1.0001 * kMost_N);
    return found;
}

}  // namespace

TEST_CASE(
    "god beside: a step feels the last set of contacts by where the handle is now, as a tool in "
    "line says between its steps, and its motion is that tool's to the bit") {
    constexpr double kSolved_N = 1.0e-7;  // asked once more, the solver begins elsewhere
    for (const double friction : {0.0, 0.4}) {
        auto in_line = make_tool(true, 0.0, friction);
        auto beside = make_tool(false, 0.0, friction);
        CHECK(in_line.beside() == nullptr);
        REQUIRE(beside.beside() != nullptr);
        const MovingFrame block;
        in_line.place(hand_at(0.0));
        beside.place(hand_at(0.0));
        CHECK(in_line.is_free({&block, 1}) == beside.is_free({&block, 1}));
        double most_N = 0.0;
        for (int i = 1; i <= 1500; ++i) {
            const Pose hand = hand_at(i * kDt_s);
            const Wrench expected = in_line.force(hand);
            const ToolFelt felt = beside.move({hand, {}}, {&block, 1}, i * kDt_s, kDt_s);
            REQUIRE((felt.felt_W.force - expected.force).norm() < kSolved_N);
            REQUIRE((felt.felt_W.torque - expected.torque).norm() < kSolved_N);
            REQUIRE(beside.pose_W().position == in_line.pose_W().position);
            REQUIRE(beside.pose_W().orientation.coeffs() == in_line.pose_W().orientation.coeffs());
            REQUIRE(beside.contact_age().age_s() < 1.5 * kDt_s);
            // Found now, felt in the next step.
            CHECK(beside.beside()->run_once());
            REQUIRE(in_line.move({hand, {}}, {&block, 1}, i * kDt_s, kDt_s).moved);
            CHECK(in_line.contact_age().age_s() == 0.0);
            most_N = std::max(most_N, felt.felt_W.force.norm());
        }
        CHECK(most_N > 3.0);
        // Nothing new, nothing done.
        CHECK_FALSE(beside.beside()->run_once());
    }
}

TEST_CASE(
    "god beside: a hundred sets a second shake nothing, nothing enters, and new contacts blend "
    "in") {
    const Passage sudden = pass(0.0, 10);
    const Passage blended = pass(0.05, 10);
    CAPTURE(sudden.most_step_N, blended.most_step_N, blended.lets_go_N);
    CHECK(blended.most_age_s < 0.0115);
    // The hand is 2.6 mm deep when it is told of the block: at 500 N/m a step of the force, were it felt at once. Blended in a fiftieth of what is to
    // come in each millisecond, besides the hand's own way.
    CHECK(sudden.most_step_N > 1.0);
    CHECK(blended.most_step_N < 0.11);
    const Passage in_pace = pass(0.05, 1);
    CHECK(in_pace.most_step_N < 0.11);
    // Off the block it is felt no longer, to the bit; that is the safety gate's to stretch.
    CHECK(blended.lets_go_N < 0.8);
    CHECK(in_pace.lets_go_N < 0.11);
}

TEST_CASE(
    "god beside: when the sets end the force is held for 0.1 s and gone 0.1 s later, evenly; when "
    "they begin again it comes back as evenly") {
    auto tool = make_tool(false, 0.05);
    test::check_silent_contacts(tool, {}, hand_at, 0.6, [&] {
        REQUIRE(tool.force(hand_at(0.25)).force == Vector3::Zero());
    });
}

TEST_CASE(
    "god beside: a handle that moves on between two sets is felt in time: deeper by K, off without "
    "a pull") {
    auto tool = make_tool(false, 0.05);
    const MovingFrame block;
    tool.place(hand_at(0.0));
    double t_s = 0.0;
    const auto step = [&](double height_m, bool finds) {
        t_s += kDt_s;
        const ToolFelt felt =
            tool.move({Pose::at({0.0, height_m, 0.0}), {}}, {&block, 1}, t_s, kDt_s);
        if (finds) {
            (void)tool.beside()->run_once();
        }
        return felt.felt_W.force;
    };
    const double touching_m = kTop_m + kRadius_m;
    for (int i = 0; i < 600; ++i) {
        (void)step(touching_m + 0.02 - 0.022 * std::min(1.0, i / 200.0), true);
    }
    const double resting_N = step(touching_m - 0.002, true).y();
    const double deeper_N = step(touching_m - 0.003, false).y();
    const double stiffness =
        make_god_object_settings(*test::make_tool_of(test::make_ball_tool(ToolMethod::god_object),
                                                     {make_box({0.2, 0.04, 0.2}).value()}))
            .coupling.shift.stiffness_N_per_m;
    CHECK(deeper_N - resting_N == Approx(0.001 * stiffness).epsilon(1e-3));
    // Lifted by what the set says is a wall: it never pulls.
    double least_N = 1.0;
    for (int i = 0; i < 20; ++i) {
        least_N = std::min(least_N, step(touching_m + 0.001 * i, false).y());
    }
    CHECK(least_N >= 0.0);
    CHECK(step(touching_m + 0.02, false).y() < 1.0e-3 * resting_N);
}

TEST_CASE(
    "god beside: in the free nothing is felt, to the bit, however late the sets are; a tool put "
    "elsewhere knows nothing of what it met before") {
    auto tool = make_tool(false, 0.05);
    const MovingFrame block;
    tool.place(Pose::at({0.0, 0.06, 0.0}));
    for (int i = 1; i <= 300; ++i) {
        const double t_s = i * kDt_s;
        const Pose hand = Pose::at({0.1 * std::sin(9.0 * t_s), 0.07, 0.05 * std::cos(7.0 * t_s)});
        const ToolFelt felt = tool.move({hand, {}}, {&block, 1}, t_s, kDt_s);
        REQUIRE(felt.felt_W.force == Vector3::Zero());
        REQUIRE(felt.felt_W.torque == Vector3::Zero());
        if (i % 37 == 0) {
            (void)tool.beside()->run_once();
        }
    }
    // Pressed on the block, with an answer under way, then put above it.
    tool.place(hand_at(0.0));
    Vector3 pressed = Vector3::Zero();
    for (int i = 1; i <= 250; ++i) {
        pressed =
            tool.move({hand_at(i * kDt_s), {}}, {&block, 1}, 0.3 + i * kDt_s, kDt_s).felt_W.force;
        (void)tool.beside()->run_once();
    }
    REQUIRE(pressed.y() > 1.0);
    tool.place(Pose::at({0.0, 0.06, 0.0}));
    const ToolFelt after = tool.move({Pose::at({0.0, 0.059, 0.0}), {}}, {&block, 1}, 0.551, kDt_s);
    CHECK(after.moved);
    CHECK(after.felt_W.force == Vector3::Zero());
    CHECK(tool.pose_W().position.y() == 0.06);
    CHECK(tool.last_step().contacts == 0);
    CHECK(tool.force(Pose::at({0.0, 0.03, 0.0})).force == Vector3::Zero());
}

TEST_CASE("god beside: a tool that was placed inside something stands still, and says so") {
    auto tool = make_tool(false, 0.05);
    const MovingFrame block;
    const Pose across = Pose::at({0.0, kTop_m, 0.0});
    tool.place(across);
    CHECK_FALSE(tool.is_free({&block, 1}));
    CHECK(tool.move({across, {}}, {&block, 1}, kDt_s, kDt_s).moved);
    (void)tool.beside()->run_once();
    const ToolFelt told = tool.move({across, {}}, {&block, 1}, 2.0 * kDt_s, kDt_s);
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
    const MovingFrame block;
    for (const bool own_motion : {true, false}) {
        auto tool = make_tool(own_motion, 0.05);
        Counter counter;
        tool.listen_to_rounds(&counter);
        tool.place(hand_at(0.0));
        for (int i = 1; i <= 20; ++i) {
            REQUIRE(tool.move({hand_at(i * kDt_s), {}}, {&block, 1}, i * kDt_s, kDt_s).moved);
        }
        CHECK(counter.n_begun == (own_motion ? 20 : 0));
        CHECK(counter.n_ended == counter.n_begun);
    }
}
