#include "haptics/geometry/shape.h"
#include "haptics/loop/haptic_loop.h"
#include "haptics/tool/tool_plan.h"
#include "runtime/app/knob_errors.h"
#include "runtime/app/repeated_faults.h"
#include "runtime/app/run_tape.h"
#include "runtime/app/taped_loops.h"
#include "runtime/scene/knobs.h"
#include "tests/support/scripted_device.h"
#include "tests/support/touchable.h"
#include "tests/unit/runtime/rig.h"

#include <cmath>

// What a knob leaves of error at the device, against what follows in closed form from the hand's way.
using namespace fulcrum::runtime::test;

namespace {

constexpr double kRate_Hz = 1000.0;
constexpr double kPeriod_s = 1.0 / kRate_Hz;
constexpr double kRest_s = 0.5;  // until the gate is open
constexpr double kSpeed_m_per_s = 0.04;

// One hand, and nothing that lends or brakes.
Plan make_plan() {
    Plan plan;
    plan.haptic.rate_hz = kRate_Hz;
    plan.haptic.expects_lesson = false;
    plan.haptic.safety.soft_start_s = 0.0;
    plan.haptic.passivity.on = false;
    plan.haptic.workspace.pose_WD.position = Vector3::Zero();
    for (std::size_t i = 0; i < kHapticStages; ++i) {
        plan.stages.push_back({"haptic", name_of(static_cast<HapticStage>(i)), kRate_Hz, 0, "", 0});
    }
    return plan;
}

// A run of a second of that plan: at rest where the way begins, and then along it. `answer` is what the lesson says at a place, every n rounds.
using Way = std::function<Vector3(double seconds)>;
using Answer = std::function<LinearisedWrench(const Vector3& place_W)>;
RunTape play(const Plan& plan, const Way& way, int every = 0, const Answer& answer = {}) {
    ScriptedDevice device;
    HapticChannels channels;
    HapticLoop loop(plan.haptic, device, channels);
    RunTape tape({device.traits()});
    for (int k = 0; k < 1000; ++k) {
        const double now_s = k / kRate_Hz;
        device.pose_D.position = way(std::max(now_s - kRest_s, 0.0));
        if (every > 0 && k % every == 0) {
            SessionOutput output;
            output.force.stamp_s = now_s;
            output.force.lesson_alive = true;
            output.force.linearised = answer(device.pose_D.position);
            output.force.linearised.stamp_s = now_s;
            tape.keep_frame(output);
            channels.command.publish(output.force);
        }
        loop.step(now_s);
        tape.keep_round({&loop});
    }
    return tape;
}

Vector3 go_along_x(double seconds) {
    return {kSpeed_m_per_s * seconds, 0.0, 0.0};
}

std::vector<KnobError> measure(const Plan& plan, const RunTape& tape) {
    return measure_knobs(tape, plan, {}, list_knobs({}, plan, tape.hands()));
}

const KnobError& find(const std::vector<KnobError>& errors, const std::string& what) {
    const auto found = std::ranges::find_if(
        errors, [&](const KnobError& error) { return error.what.starts_with(what); });
    REQUIRE(found != errors.end());
    return *found;
}

Plan make_spring(double stiffness_N_per_m) {
    Plan plan = make_plan();
    plan.haptic.fields.push_back(
        {.kind = FieldKind::spring, .stiffness_N_per_m = stiffness_N_per_m});
    return plan;
}

Knob make_knob(const std::function<void(Plan&)>& converge, KnobReach reach = KnobReach::hand) {
    Knob knob{.what = "a knob", .against = "another"};
    knob.reach = reach;
    knob.converge = converge;
    return knob;
}

}  // namespace

TEST_CASE("knobs: a spring that is held for a round is off by what it changes in that round") {
    constexpr double kStiffness_N_per_m = 50.0;
    const Plan plan = make_spring(kStiffness_N_per_m);
    const RunTape tape = play(plan, go_along_x);
    const KnobError error = find(measure(plan, tape), "rounds of 1000 Hz");
    CHECK(error.because.empty());
    CHECK(error.seconds == 1.0);
    // K v t for t = 0, 1/5 .. 4/5 of a round, in every round of the half second in which it goes.
    const double round_N = kStiffness_N_per_m * kSpeed_m_per_s * kPeriod_s;
    constexpr double kRounding = 1.0e-6;
    CHECK(error.force_N[2] == Approx(0.8 * round_N).epsilon(kRounding));
    constexpr double kOneRound = 2.0e-3;  // the first or the last counts or not
    CHECK(error.force_N[0] == Approx(round_N * std::sqrt(0.5 * 30.0 / 125.0)).epsilon(kOneRound));
    CHECK(error.force_N[1] == Approx(0.8 * round_N).epsilon(kRounding));
    CHECK_FALSE(error.turns);
}

TEST_CASE("knobs: a damper on an even way is off where the way begins, and nowhere else") {
    Plan plan = make_plan();
    plan.haptic.velocity_method = VelocityMethod::finite_difference;
    plan.haptic.fields.push_back({.kind = FieldKind::viscosity, .damping_Ns_per_m = 10.0});
    const KnobError error = find(measure(plan, play(plan, go_along_x)), "rounds of 1000 Hz");
    constexpr double kRounding = 1.0e-9;
    CHECK(error.force_N[1] < kRounding);
    CHECK(error.force_N[2] == Approx(10.0 * kSpeed_m_per_s));
}

TEST_CASE("knobs: what is converged already leaves nothing, to the bit, whatever is run again") {
    const Plan plan = make_spring(100.0);
    const RunTape tape = play(plan, go_along_x);
    const auto nothing = [](Plan&) {};
    for (const KnobReach reach : {KnobReach::hand, KnobReach::answers, KnobReach::all}) {
        const auto errors = measure_knobs(tape, plan, {}, {make_knob(nothing, reach)});
        REQUIRE(errors.size() == 1);
        CHECK(errors[0].because.empty());
        CHECK(errors[0].force_N == std::array<double, 3>{});
    }
    // And a spring that is not the same is off by as much as the hand is away.
    const auto softer =
        make_knob([](Plan& changed) { changed.haptic.fields.front().stiffness_N_per_m *= 0.5; });
    const double away_m = kSpeed_m_per_s * (0.5 - kPeriod_s);
    constexpr double kRounding = 1.0e-9;
    CHECK(measure_knobs(tape, plan, {}, {softer})[0].force_N[2] ==
          Approx(50.0 * away_m).epsilon(kRounding));
}

TEST_CASE(
    "knobs: a ball of facets is off by how far the facet lies below the ball, and how it leans") {
    constexpr double kRadius_m = 0.05;
    constexpr double kStiffness_N_per_m = 400.0;
    Plan plan = make_plan();
    const auto mesh = touchable(make_sphere(kRadius_m, 4));
    plan.haptic.coupling = {.stiffness_N_per_m = kStiffness_N_per_m, .damping_Ns_per_m = 0.0};
    plan.haptic.solids.push_back({.body = 0, .shape = mesh});
    const auto corners = mesh->places_B(0);
    const Vector3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
    const Vector3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
    const double facet_m = normal.dot(middle);
    // Down on the facet, a third of the way to a corner, by 4 mm.
    const Vector3 at = middle + (corners[0] - middle) / 3.0;
    const auto down = [&](double seconds) {
        return Vector3(at + std::max(0.002 - 0.02 * seconds, -0.004) * normal);
    };
    const RunTape tape = play(plan, down);
    const Vector3 hand = down(1.0);
    const Vector3 by_facet = kStiffness_N_per_m * (facet_m - normal.dot(hand)) * normal;
    const Vector3 by_ball = kStiffness_N_per_m * (kRadius_m - hand.norm()) * hand.normalized();
    const Vector3 sent = tape.round(999, 0).applied_W.force;
    constexpr double kRounding_N = 1.0e-6;
    CHECK((sent - by_facet).norm() < kRounding_N);
    const auto errors = measure_knobs(tape, plan, {}, {make_knob([](Plan& exact) {
                                          exact.haptic.solids.front().shape =
                                              SphereShape{kRadius_m};
                                      })});
    CHECK(errors[0].force_N[2] == Approx((by_facet - by_ball).norm()).epsilon(1.0e-4));
    // What facets are nobody knows finer is told, with why.
    const KnobError facets = find(measure(plan, tape), "facets of 1 body");
    CHECK_FALSE(facets.because.empty());
    CHECK(facets.force_N == std::array<double, 3>{});
}

TEST_CASE("knobs: an answer of a lesson is off by how its force bends, and by the blend") {
    // F = c x^2 across the way, told every 20 ms with its slope.
    constexpr double kBend_N_per_m2 = 4000.0;
    constexpr int kEvery = 20;
    Plan plan = make_plan();
    plan.haptic.lesson_force = true;
    plan.haptic.lesson_rate_hz = kRate_Hz / kEvery;
    const auto answer = [&](const Vector3& place_W) {
        LinearisedWrench told;
        told.at_position_W = place_W;
        told.force_W.y() = kBend_N_per_m2 * place_W.x() * place_W.x();
        told.stiffness_N_per_m(1, 0) = 2.0 * kBend_N_per_m2 * place_W.x();
        return told;
    };
    const RunTape tape = play(plan, go_along_x, kEvery, answer);
    const KnobError error = find(measure(plan, tape), "answers of 50 Hz");
    CHECK(error.because.empty());
    // At a share a of the time between answers: c (v T)^2 (a^2 + 1 - a), at most where an answer comes.
    const double most_N = kBend_N_per_m2 * std::pow(kSpeed_m_per_s * kEvery * kPeriod_s, 2);
    constexpr double kLate = 1.0e-2;  // of the reference, which answers each round: (1 / kEvery)^2
    CHECK(error.force_N[2] == Approx(most_N).epsilon(kLate));
    double squares = 0.0;
    for (int i = 0; i < kEvery; ++i) {
        const double a = static_cast<double>(i) / kEvery;
        squares += std::pow(most_N * (a * a + 1.0 - a), 2);
    }
    constexpr double kBeginning = 0.05;  // the first answers after the rest are nearer
    CHECK(error.force_N[0] == Approx(std::sqrt(0.5 * squares / kEvery)).epsilon(kBeginning));
}

TEST_CASE("knobs: between two answers lies what a force that is quadratic in the place has there") {
    const Vector3 from(0.01, 0.02, -0.01);
    const Vector3 to(0.03, -0.01, 0.02);
    const auto answer = [](const Vector3& x) {
        LinearisedWrench told;
        told.at_position_W = x;
        told.force_W = {x.x() * x.y(), x.z() * x.z(), x.squaredNorm()};
        told.stiffness_N_per_m << x.y(), x.x(), 0.0, 0.0, 0.0, 2.0 * x.z(), 2.0 * x.x(),
            2.0 * x.y(), 2.0 * x.z();
        told.torque_W = -2.0 * told.force_W;
        told.torque_stiffness_Nm_per_m = -2.0 * told.stiffness_N_per_m;
        return told;
    };
    for (const double share : {0.0, 0.25, 0.7, 1.0}) {
        const Vector3 at = from + share * (to - from);
        const LinearisedWrench mixed = blend_answers(answer(from), answer(to), share, 2.0);
        CHECK(mixed.stamp_s == 2.0);
        const Wrench got = compute_linearised_wrench(mixed, at, Vector3::Zero());
        constexpr double kRounding = 1.0e-15;
        CHECK((got.force - answer(at).force_W).norm() < kRounding);
        CHECK((got.torque - answer(at).torque_W).norm() < kRounding);
    }
}

TEST_CASE("knobs: the same tape gives the same bits, and another plan than the run's gives none") {
    const Plan plan = make_spring(80.0);
    const RunTape tape = play(plan, [](double seconds) {
        return Vector3(0.02 * std::sin(9.0 * seconds), 0.01 * seconds, 0.0);
    });
    const auto first = measure(plan, tape);
    const auto second = measure(plan, tape);
    REQUIRE(first.size() == second.size());
    REQUIRE(first.size() == 3);  // rounds, velocity, brake
    for (std::size_t i = 0; i < first.size(); ++i) {
        CHECK(first[i].what == second[i].what);
        CHECK(first[i].force_N == second[i].force_N);
        CHECK(first[i].torque_Nm == second[i].torque_Nm);
    }
    const auto other = measure(make_spring(81.0), tape);
    for (const KnobError& error : other) {
        CHECK(error.because.starts_with("the run could not be repeated: "));
        CHECK(error.force_N == std::array<double, 3>{});
    }
}

TEST_CASE("knobs: a run that was stopped, lifted and failed is repeated with all of it") {
    Plan plan = make_spring(80.0);
    plan.haptic.safety.rest_s = 0.2;
    ScriptedDevice device;
    HapticChannels channels;
    HapticLoop loop(plan.haptic, device, channels);
    RunTape tape({device.traits()});
    bool was_felt = false;
    constexpr int kLifted =
        626;  // the spring is nearly slack then: what comes a round late is felt
    for (int k = 0; k < 2000; ++k) {
        device.pose_D.position.x() = 0.01 * std::sin(0.01 * k);
        device.gives_pose = k < 1800 || k > 1810;
        if (k == 400) {
            channels.emergency_stop.tap();
        }
        if (k == kLifted) {
            channels.rearm = true;
        }
        channels.lesson_failed = k > 1500 && k < 1600;
        loop.step(k / kRate_Hz);
        tape.keep_round({&loop});
        was_felt = was_felt || (k > 1000 && loop.state().applied_W.force.norm() > 0.1);
    }
    CHECK(was_felt);
    CHECK(find(measure(plan, tape), "the brake").because.empty());
    // A reading that is no new one says what it said: the device's fault is the round's.
    CHECK(any(tape.round(1805, 0).faults & Fault::device_read));
}

TEST_CASE("knobs: a device that counts steps has no converged velocity, and that is said") {
    const Plan plan = make_spring(80.0);
    DeviceTraits traits;
    traits.position_resolution_m = 5.0e-5;
    for (const Knob& knob : list_knobs({}, plan, {traits})) {
        CHECK(knob.because.empty() == !knob.what.starts_with("velocity"));
        CHECK(knob.against.empty() == !knob.because.empty());
    }
}

TEST_CASE("knobs: of a tool those of its method are turned, in a plan of its own") {
    const auto cube = GodSurface::create(make_box({0.04, 0.04, 0.04}).value());
    ToolPlan god{.objects = std::vector<GodObjectPlan>{{cube, cube}}};
    ToolPlan penalty{.objects = std::vector<FieldSamplingPlan>{}};
    penalty.penalty.emplace();
    ToolPlan levels{.objects = std::vector<LevelContactsPlan>(1)};
    std::get<std::vector<LevelContactsPlan>>(levels.objects).front().settings.tolerance_m = 0.002;
    levels.penalty.emplace();
    const ToolPlan massive{.objects = std::vector<FieldSamplingPlan>{}};
    ToolPlan massless{.objects = std::vector<VoxelSamplingPlan>{}};
    massless.settings.mass = ToolMass::massless;
    LessonDescription lesson;
    lesson.hand.tool.emplace();
    const auto turn = [&](const ToolPlan& tool, const std::string& what) {
        Plan plan = make_plan();
        plan.haptic.tool = std::make_shared<const ToolPlan>(tool);
        const auto knobs = list_knobs(lesson, plan, {DeviceTraits{}});
        const auto found = std::ranges::find_if(
            knobs, [&](const Knob& knob) { return knob.what.starts_with(what); });
        REQUIRE(found != knobs.end());
        CHECK(plan.stages[found->stage].name == "tool");
        if (found->change) {
            LessonDescription changed = lesson;
            found->change(changed);
            CHECK(changed.hand.tool->points == 8000);
        } else if (found->converge) {
            const auto before = plan.haptic.tool;
            found->converge(plan);
            CHECK(plan.haptic.tool != before);
        } else {
            CHECK_FALSE(found->because.empty());
        }
        return *plan.haptic.tool;
    };
    const GodObjectSettings exact = make_god_object_settings(turn(god, "rounds a step: 100"));
    CHECK(exact.most_rounds == 1000);
    CHECK(exact.gap_m == make_god_object_settings(god).gap_m);
    CHECK(make_god_object_settings(turn(god, "gap of 0.001 mm")).gap_m == 1.0e-7);
    CHECK(turn(penalty, "clusters of contact: 10").penalty->clusters.most == kMostClusters);
    const ToolPlan fine = turn(levels, "contact levels within 2 mm");
    CHECK(std::get<std::vector<LevelContactsPlan>>(fine.objects).front().settings.tolerance_m ==
          0.0);
    CHECK(turn(massive, "iterations of Newton: 12").settings.integrator.newton_iterations == 100);
    CHECK(turn(massless, "iterations at rest: 4").settings.static_iterations == 100);
    (void)turn(massive, "points of the tool: 2000");
    (void)turn(massive, "voxels of what it meets");
    (void)turn(massless, "voxels, and the points in their rows");
}

TEST_CASE("knobs: a tape is no longer than what it keeps") {
    const Plan plan = make_plan();
    ScriptedDevice device;
    HapticChannels channels;
    const HapticLoop loop(plan.haptic, device, channels);
    RunTape tape({device.traits()});
    for (std::size_t k = 0; k < kMostTapedRounds + 5; ++k) {
        tape.keep_round({&loop});
    }
    tape.keep_frame({});
    CHECK(tape.n_rounds() == kMostTapedRounds);
    CHECK(tape.frames().empty());
}
