// Lessons made by chance from the binding table, each played by a process of its own, and judged by what the record of its run says, as
// `soak` judges what an arm is given. FULCRUM_PLAYED_LESSONS says how many.
#include "haptics/device/replay/recorded_traits.h"
#include "haptics/link/felt_judge.h"
#include "haptics/link/spoiled_arm.h"
#include "tests/lessons/program.h"
#include "tests/support/generated_lesson.h"

#include <cstdio>
#include <cstdlib>

using namespace fulcrum::test;

namespace {

constexpr double kFelt_N = 0.05;
constexpr double kFelt_Nm = 0.005;
constexpr double kGone = 1.0e-9;
constexpr double kRound_s = 0.001;

double number_of(const Record& record, std::string_view name) {
    const auto found = find_fact(record.header, name);
    REQUIRE(found);
    return std::strtod(std::string(*found).c_str(), nullptr);
}

/// The limits that stand in the record: that its gate has the least of those of lesson, site and device is no lesson's to say.
FeltLimits limits_in(const Record& record) {
    SafetySettings gate;
    gate.max_force_N = number_of(record, "limit.plan N");
    gate.max_torque_Nm = number_of(record, "limit.plan Nm");
    gate.max_slew_N_per_s = number_of(record, "limit.slew N/s");
    gate.max_transient_N = number_of(record, "limit.transient N");
    gate.transient_Ns = number_of(record, "limit.transient N s");
    gate.transient_N2s = number_of(record, "limit.transient N2 s");
    return felt_limits(gate);
}

bool is_gone(const Wrench& wrench) {
    return wrench.force.norm() <= kGone && wrench.torque.norm() <= kGone;
}

bool is_felt(const RecordSample& sample) {
    return sample.applied_W.force.norm() > kFelt_N || sample.applied_W.torque.norm() > kFelt_Nm;
}

/// Empty where each round keeps all limits, no force is there before the gate opens, and one that must fade is gone in time.
std::string find_trouble(const Record& record) {
    const FeltLimits limits = limits_in(record);
    FeltJudge judge;
    const RecordSample* before = nullptr;
    double shut_s = 0.0;  // since when nothing may be felt but what fades
    for (const RecordSample& sample : record.samples) {
        const std::string at = " at " + std::to_string(sample.time_s) + " s";
        const double dt_s = before == nullptr ? kRound_s : sample.time_s - before->time_s;
        if (const FeltLimit broken =
                judge.judge(limits, {sample.commanded_W, sample.applied_W, sample.gate, dt_s});
            broken != FeltLimit::none) {
            return name_of(broken) + at;
        }
        const bool is_shut = sample.gate != GatePhase::rising && sample.gate != GatePhase::open;
        shut_s = is_shut ? shut_s : sample.time_s;
        if (sample.time_s - shut_s > SpoiledArm::kMostFade_s && !is_gone(sample.applied_W)) {
            return "a force that had to be gone" + at;
        }
        before = &sample;
    }
    const bool failed = std::ranges::any_of(record.events, [](const RecordEvent& event) {
        return event.kind == RecordEventKind::failed;
    });
    const bool is_left = failed && before != nullptr && !is_gone(before->applied_W);
    return is_left ? "a force is left after a lesson that failed" : "";
}

/// What has become of the lessons that were tried.
struct Outcome {
    int played = 0;
    int felt = 0;
    int faded = 0;    ///< of those that failed by themselves, with a force in the hand
    int refused = 0;  ///< by the plan, in a sentence with a line
};

bool is_refusal(const std::string& output) {
    return output.find("lesson.lua:") != std::string::npos &&
           output.find("malformed") == std::string::npos &&
           output.find("nonsense") == std::string::npos &&
           output.find("crashed") == std::string::npos;
}

void play(const Sandbox& sandbox, int seed, Outcome& outcome) {
    const std::string name = "g" + std::to_string(seed);
    const GeneratedLesson lesson = LessonWriter(Choices(static_cast<std::uint64_t>(seed))).write();
    sandbox.write(name + "/lesson.lua", lesson.text);
    sandbox.write(name + "/hand.lua", lesson.hand);
    sandbox.write(name + "/felt.png", bytes_of(FULCRUM_TEST_LESSONS "/felt/felt.png"));
    const ProgramRun run = sandbox.run("run " + name + " --headless --hand " + name +
                                       "/hand.lua --seconds 6 --record " + name + ".rec");
    INFO("seed " << seed << ": " << run.output);
    const bool fails = run.output.find("generated to fail") != std::string::npos;
    if (run.exit_code != 0 && !fails) {
        CHECK(is_refusal(run.output));
        ++outcome.refused;
        return;
    }
    const Record record = read_run(sandbox.path(name + ".rec"));
    CHECK(find_trouble(record).empty());
    const bool felt = std::ranges::any_of(record.samples, is_felt);
    ++outcome.played;
    outcome.felt += felt ? 1 : 0;
    outcome.faded += felt && fails ? 1 : 0;
    std::filesystem::remove(sandbox.path(name + ".rec"));
}

}  // namespace

TEST_CASE("lessons: a record with a force too strong, too sudden or left over is found out") {
    Record kept;
    kept.header.facts = {{"limit.plan N", "5"},           {"limit.plan Nm", "0.3"},
                         {"limit.slew N/s", "500"},       {"limit.transient N", "4"},
                         {"limit.transient N s", "0.02"}, {"limit.transient N2 s", "0.06"}};
    for (int i = 0; i < 400; ++i) {
        RecordSample sample;
        sample.time_s = 0.001 * i;
        sample.gate = GatePhase::open;
        const double share = std::min(0.1 * i, 1.0);
        sample.applied_W = {Vector3(share, 0.0, 0.0), Vector3(0.1 * share, 0.0, 0.0)};
        sample.commanded_W = sample.applied_W;
        kept.samples.push_back(sample);
    }
    const Wrench usual = kept.samples.back().applied_W;
    const auto with = [&](const Wrench& wrench) {
        Record record = kept;
        record.samples[200].applied_W = wrench;
        return find_trouble(record);
    };
    CHECK(with(usual).empty());
    CHECK(with({Vector3(5.1, 0, 0), usual.torque}).starts_with("a force above its limit"));
    CHECK(with({Vector3(-3.1, 0, 0), usual.torque}).starts_with("a force that swung too far"));
    CHECK(with({usual.force, Vector3(0.4, 0, 0)}).starts_with("a torque above its limit"));
    CHECK(with({usual.force, Vector3(0.2, 0, 0)}).starts_with("a torque that changed too fast"));
    // More than was asked for, for good; to both sides of it; and suddenly while the gate opens.
    Record pushed = kept;
    Record shaken = kept;
    Record sudden = kept;
    for (std::size_t i = 200; i < kept.samples.size(); ++i) {
        pushed.samples[i].applied_W.force.x() += 0.6;
        shaken.samples[i].applied_W.force.x() += i % 2 == 0 ? 2.0 : -2.0;
        sudden.samples[i].applied_W.force.x() += 0.6;
        sudden.samples[i].gate = GatePhase::rising;
    }
    CHECK(find_trouble(pushed).starts_with("a blow of too much impulse at 0.2"));
    CHECK(find_trouble(shaken).starts_with("a force that swung too much for too long at 0.2"));
    CHECK(find_trouble(sudden) == "a force that changed too fast at 0.200000 s");
    for (const GatePhase shut : {GatePhase::waiting, GatePhase::fading, GatePhase::stopped}) {
        Record record = kept;
        for (RecordSample& sample : record.samples) {
            sample.gate = sample.time_s > 0.1 ? shut : sample.gate;
        }
        CHECK(find_trouble(record).starts_with("a force that had to be gone at 0.2"));
    }
    Record failed = kept;
    failed.events.push_back({0.3, RecordEventKind::failed, kNoBody, ""});
    CHECK(find_trouble(failed) == "a force is left after a lesson that failed");
}

TEST_CASE("lessons: generated ones end as they should, nine of ten with a force") {
    const char* said = std::getenv("FULCRUM_PLAYED_LESSONS");
    const int n_lessons = said == nullptr ? 60 : std::atoi(said);
    const Sandbox sandbox;
    Outcome outcome;
    for (int seed = 1; seed <= n_lessons; ++seed) {
        play(sandbox, seed, outcome);
    }
    std::printf(
        "%d lessons: %d played, %d of them with a force (%.0f %%), which faded in %d that failed; "
        "%d refused in a sentence\n",
        n_lessons, outcome.played, outcome.felt, 100.0 * outcome.felt / std::max(outcome.played, 1),
        outcome.faded, outcome.refused);
    CHECK(3 * outcome.played >= 2 * n_lessons);
    CHECK(10 * outcome.felt >= 9 * outcome.played);
    CHECK(outcome.faded > 0);
}
