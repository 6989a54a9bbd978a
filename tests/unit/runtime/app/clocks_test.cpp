#include "runtime/app/deadline_watch.h"
#include "runtime/app/felt_notes.h"
#include "runtime/app/stage_clock.h"
#include "runtime/app/tool_lacks.h"
#include "tests/unit/runtime/rig.h"

#include <chrono>
#include <cmath>
#include <string>
#include <thread>

using namespace fulcrum::runtime::test;

namespace {

PlanStage stage(const char* loop, const char* name) {
    return {loop, name, 1000.0, 0, "", 0};
}

Plan make_plan() {
    Plan plan;
    plan.stages = {stage("haptic", "read"),      stage("haptic", "estimate"),
                   stage("haptic", "passivity"), stage("haptic", "limits"),
                   stage("world", "falling"),    stage("world", "bucket"),
                   stage("lesson", "lua")};
    return plan;
}

const StageFigures* find(const Analysis& analysis, std::size_t index) {
    for (const StageFigures& figures : analysis.stages) {
        if (figures.stage == index) {
            return &figures;
        }
    }
    return nullptr;
}

constexpr double kDt_s = 0.001;
DeadlineWatch make_watch() {
    DeadlineWatch watch;
    watch.begin({kDt_s, 1.0 / 60.0, {0.005, 0.002}});
    return watch;
}

}  // namespace

TEST_CASE("stage clock: each call is counted for its own stage, what is not in the plan for none") {
    const Plan plan = make_plan();
    StageClock clock(plan);
    for (int i = 0; i < 5; ++i) {
        clock.begin();
        clock.passed(HapticStage::read);
        clock.passed(HapticStage::proxy);  // not in this plan
        clock.passed(HapticStage::estimate);
        clock.begin();
        clock.passed_effect("world", {.n_steps = 500, .n_unconverged = 3});
    }
    clock.begin();
    clock.passed_lesson();
    const Analysis analysis = clock.finish(1.5, 0.5);
    CHECK(analysis.simulated_s == 1.5);
    CHECK(analysis.wall_s == 0.5);
    REQUIRE(analysis.stages.size() == 4);
    CHECK(find(analysis, 0)->calls == 5);
    CHECK(find(analysis, 1)->calls == 5);
    CHECK(find(analysis, 4)->calls == 5);
    REQUIRE(find(analysis, 4)->errors.size() == 1);
    CHECK(find(analysis, 4)->errors[0].value == 3.0);
    CHECK(find(analysis, 5) == nullptr);
    CHECK(find(analysis, 6)->calls == 1);
}

TEST_CASE("stage clock: what could run beside the tool is the contact stage's, not the tool's") {
    Plan plan = make_plan();
    plan.stages.push_back(stage("haptic", "tool"));
    plan.stages.push_back({"contact", "finding", 2000.0, 0, "", 0});
    StageClock clock(plan);
    for (int i = 0; i < 4; ++i) {
        clock.begin();
        clock.begins_round();
        std::this_thread::sleep_for(std::chrono::milliseconds(3));
        clock.ended_round();
        clock.passed(HapticStage::tool);
    }
    const Analysis analysis = clock.finish(1.0, 1.0);
    const StageFigures* const tool = find(analysis, 7);
    const StageFigures* const contact = find(analysis, 8);
    REQUIRE(tool != nullptr);
    REQUIRE(contact != nullptr);
    CHECK(contact->calls == 4);
    CHECK(contact->median_us >= 2990.0);
    CHECK(tool->total_us < 0.5 * contact->total_us);
    // A thread would need so long, too: its answers would be as many steps old.
    REQUIRE(contact->errors.size() == 2);
    CHECK(contact->errors[0].value == Approx(1e6 / contact->p99_us));
    CHECK(contact->errors[1].value >= 4.0);
    // Without such a stage it is nobody's.
    const Plan without = make_plan();
    StageClock other(without);
    other.begin();
    other.begins_round();
    other.ended_round();
    CHECK(other.finish(1.0, 1.0).stages.empty());
}

TEST_CASE("stage clock: a stage that takes longer is said to take longer") {
    const Plan plan = make_plan();
    StageClock clock(plan);
    for (int i = 0; i < 3; ++i) {
        clock.begin();
        clock.passed(HapticStage::read);
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        clock.passed(HapticStage::estimate);
    }
    const Analysis analysis = clock.finish(1.0, 1.0);
    CHECK(find(analysis, 1)->median_us >= 1990.0);
    CHECK(find(analysis, 1)->total_us >= 3 * 1990.0);
    CHECK(find(analysis, 0)->median_us < find(analysis, 1)->median_us);
    CHECK(analysis.total_us() == Approx(find(analysis, 0)->total_us + find(analysis, 1)->total_us));
}

TEST_CASE("stage clock: a long run stays bounded, and every call counts") {
    const Plan plan = make_plan();
    StageClock clock(plan);
    clock.begin();
    const std::uint64_t n = 3 * StageClock::kMostCalls;
    for (std::uint64_t i = 0; i < n; ++i) {
        clock.passed(HapticStage::read);
    }
    const Analysis analysis = clock.finish(1.0, 1.0);
    CHECK(find(analysis, 0)->calls == n);
    CHECK(find(analysis, 0)->p99_us >= find(analysis, 0)->median_us);
}

TEST_CASE("stage clock: errors are what was compared, and stand with their stage") {
    const Plan plan = make_plan();
    StageClock clock(plan);
    clock.begin();
    clock.passed(HapticStage::estimate);
    clock.passed(HapticStage::passivity);
    clock.passed(HapticStage::limits);
    HapticState state;
    state.tool_twist_W.linear = {0.1, 0.0, 0.0};
    state.commanded_W.force = {0.0, 4.0, 0.0};
    state.applied_W.force = {0.0, 1.0, 0.0};
    state.force_energy = {-0.001, 0.002, 0.003};
    state.gate = GatePhase::open;
    clock.compare(state, Vector3(0.1, 0.003, 0.0));
    state.applied_W.force = {0.0, 0.0, 0.0};
    state.gate = GatePhase::waiting;
    clock.compare(state, Vector3(0.1, 0.001, 0.0));
    const Analysis analysis = clock.finish(1.0, 1.0);
    const auto& velocity = find(analysis, 1)->errors;
    REQUIRE(velocity.size() == 1);
    CHECK(velocity[0].value == Approx(1e3 * std::sqrt((9e-6 + 1e-6) / 2.0)));
    CHECK(velocity[0].unit == "mm/s");
    const auto& energy = find(analysis, 2)->errors;
    REQUIRE(energy.size() == 2);
    CHECK(energy[0].value == Approx(2.0));
    CHECK(energy[1].value == Approx(3.0));
    const auto& withheld = find(analysis, 3)->errors;
    REQUIRE(withheld.size() == 2);
    CHECK(withheld[0].value == Approx(std::sqrt((9.0 + 16.0) / 2.0)));
    CHECK(withheld[1].value == Approx(1.0 / plan.haptic.rate_hz));
    CHECK(withheld[1].against == "0.0 s in which a force was asked for");
}

TEST_CASE("stage clock: of a tool it tells what was looked at, was off and took too long") {
    Plan plan = make_plan();
    plan.haptic.rate_hz = 1000.0;
    plan.stages.push_back(stage("haptic", "tool"));
    StageClock clock(plan);
    for (int i = 0; i < 4; ++i) {
        clock.begin();
        std::this_thread::sleep_for(std::chrono::microseconds(i == 0 ? 2000 : 0));
        clock.passed(HapticStage::tool);
        HapticState state;
        state.tool = {.n_looks = 3 + i,
                      .n_points = 9000 - 1000 * i,
                      .error_N = 0.0,
                      .most_error_N = 0.02 * i,
                      .n_inexact = 2,
                      .n_lacking = {static_cast<std::uint64_t>(i), 0, 0, 7}};
        clock.compare(state, std::nullopt);
    }
    const Analysis analysis = clock.finish(1.0, 1.0);
    const StageFigures* const tool = find(analysis, plan.stages.size() - 1);
    REQUIRE(tool != nullptr);
    CHECK(tool->calls == 4);
    REQUIRE(tool->errors.size() == 6);
    CHECK(tool->errors[0].what == "left out by the budget at most");
    CHECK(tool->errors[0].value == Approx(0.06));
    CHECK(tool->errors[0].unit == "N");
    // Steps that were not settled, and those that ended before their tolerance; of the others there was none.
    CHECK(tool->errors[1].what == std::string("steps that ") + kToolLackWords[0]);
    CHECK(tool->errors[1].value == 3.0);
    CHECK(tool->errors[2].what == std::string("steps that ") + kToolLackWords[3]);
    CHECK(tool->errors[2].value == 7.0);
    CHECK(tool->errors[3].value == Approx(9.0));
    CHECK(tool->errors[4].value == 6.0);
    CHECK(tool->errors[5].value >= 25.0);
    CHECK(tool->errors[5].against == "500 us");
}

TEST_CASE("stage clock: it knows whether the hand moved at all") {
    const Plan plan = make_plan();
    StageClock clock(plan);
    HapticState state;
    state.tool_pose_W.position = {0.1, 0.2, 0.3};
    clock.compare(state, std::nullopt);
    clock.compare(state, std::nullopt);
    CHECK_FALSE(clock.hand_moved());
    state.tool_pose_W.position.x() += 1e-6;
    clock.compare(state, std::nullopt);
    state.tool_pose_W.position.x() -= 1e-6;
    clock.compare(state, std::nullopt);
    CHECK(clock.hand_moved());
}

TEST_CASE("stage clock: a hand whose speed nobody knows has no error of velocity") {
    const Plan plan = make_plan();
    StageClock clock(plan);
    clock.begin();
    clock.passed(HapticStage::estimate);
    clock.compare(HapticState{}, std::nullopt);
    CHECK(find(clock.finish(1.0, 1.0), 1)->errors.empty());
}

TEST_CASE("deadlines: what comes in its time is met, and counted") {
    DeadlineWatch watch = make_watch();
    long frame = 0;
    for (int tick = 0; tick < 10000; ++tick) {
        const double now_s = kDt_s * tick;
        if (now_s * 60.0 >= static_cast<double>(frame) - 1e-9) {
            watch.passed_frame(now_s, now_s);
            ++frame;
        }
        watch.hands_stepped(now_s, 0.0, {}, now_s);
        if (tick % 5 == 0) {
            watch.passed_effect(0, now_s, now_s);
        }
    }
    CHECK(watch.n_broken() == 0);
    CHECK(watch.broken() == Deadline::none);
    CHECK(watch.n_met(Deadline::hands) == 9999);
    CHECK(watch.n_met(Deadline::effect) >= 1990);
    CHECK(watch.n_met(Deadline::frame) >= 590);
    CHECK(watch.n_met(Deadline::command) == 8500);
}

TEST_CASE("deadlines: a round that is left out is told, a clock that jumped is not") {
    DeadlineWatch watch = make_watch();
    watch.hands_stepped(1.000, 0.0, {}, 0.0);
    watch.hands_stepped(1.001, 0.0, {}, 0.0);
    watch.hands_stepped(1.502, 0.5, {}, 0.0);
    CHECK(watch.n_broken() == 0);
    watch.hands_stepped(1.504, 0.0, {}, 0.0);
    CHECK(watch.n_broken() == 1);
    CHECK(watch.broken() == Deadline::hands);
    CHECK(watch.broken_at_s() == 1.504);
}

TEST_CASE("deadlines: a world or a frame is late only while nobody keeps it back") {
    for (const bool is_frame : {false, true}) {
        DeadlineWatch watch = make_watch();
        const auto passed = [&](double now_s, double quiet_s) {
            is_frame ? watch.passed_frame(now_s, quiet_s) : watch.passed_effect(0, now_s, quiet_s);
        };
        passed(1.0, 1.0);
        passed(1.1, 0.0);  // kept back
        passed(1.2, 0.004);
        CHECK(watch.n_broken() == 0);
        passed(1.3, 0.1);
        CHECK(watch.n_broken() == 1);
        CHECK(watch.broken() == (is_frame ? Deadline::frame : Deadline::effect));
    }
}

TEST_CASE("deadlines: each effect has a period of its own") {
    DeadlineWatch watch = make_watch();
    watch.passed_effect(0, 1.0, 1.0);
    watch.passed_effect(1, 1.0, 1.0);
    watch.passed_effect(0, 1.004, 1.0);
    CHECK(watch.n_broken() == 0);
    watch.passed_effect(1, 1.004, 1.0);
    CHECK(watch.n_broken() == 1);
}

TEST_CASE("deadlines: who is told to be late with nothing broken is late") {
    for (const Fault fault : {Fault::device_read, Fault::device_stale, Fault::command_stale,
                              Fault::device_write, Fault::record_full}) {
        DeadlineWatch watch = make_watch();
        HapticState state;
        state.faults = fault | Fault::hand_too_fast;
        watch.hands_stepped(1.0, 0.0, state, 0.5 * DeadlineWatch::kSettle_s);
        CHECK(watch.n_broken() == 0);
        watch.hands_stepped(1.001, 0.0, state, DeadlineWatch::kSettle_s);
        CHECK(watch.n_broken() == 1);
        CHECK(watch.broken() == Deadline::command);
    }
    // What a hand or a person does breaks none.
    DeadlineWatch watch = make_watch();
    HapticState state;
    state.faults = Fault::hand_too_fast | Fault::emergency_stop | Fault::too_much_energy;
    watch.hands_stepped(1.0, 0.0, state, 5.0);
    CHECK(watch.n_broken() == 0);
}

TEST_CASE("felt notes: a hand that felt nothing, or little of what was asked for, is told why") {
    struct {
        FeltTime time;
        const char* told;  // empty: nothing
    } const rows[] = {
        {{.asked_s = 0.9, .waiting_s = 0.9}, ""},
        {{.asked_s = 10.0, .felt_s = 10.0}, ""},
        {{.asked_s = 10.0, .felt_s = 5.0, .waiting_s = 2.0, .taken_s = 3.0}, ""},
        {{.asked_s = 7.5, .waiting_s = 7.5},
         "x: the hand was asked to feel a force for 7.5 s and felt none: one that is there from "
         "the "
         "start waits until the hand has rested for half a second; let the hand rest, or let the "
         "force begin at nothing."},
        {{.asked_s = 10.0, .felt_s = 4.0, .waiting_s = 1.0, .taken_s = 5.0},
         "x: the hand was asked to feel a force for 10.0 s, and for 6.0 s of them it was kept "
         "back: "
         "a fault or a stop had taken it away; see what was told of that, and if the hand was too "
         "fast let it move more slowly."},
        {{.asked_s = 3.0},
         "x: the hand was asked to feel a force for 3.0 s and felt none: its device gives none of "
         "the kind that was asked for; ask for a force as well as a torque."},
    };
    for (const auto& row : rows) {
        const FeltTime hands[] = {{}, row.time};
        const auto alone = notes_of_felt({&row.time, 1}, "x");
        REQUIRE(alone.size() == (*row.told == '\0' ? 0 : 1));
        const auto both = notes_of_felt(hands, "x");
        REQUIRE(both.size() == alone.size());
        if (!alone.empty()) {
            CHECK(to_sentence(alone[0]) == row.told);
            CHECK(both[0].message.starts_with("the second hand was asked"));
        }
        CHECK(was_felt(hands) == (row.time.felt_s > 0.0));
    }
}
