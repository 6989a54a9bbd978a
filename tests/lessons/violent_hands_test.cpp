// The last gate under attack: every lesson played by hands that throw, shake, jump and press, each record judged by
// the limits of force, slew, torque and fade. FULCRUM_VIOLENT_HANDS says how many hands.
#include "tests/lessons/program.h"
#include "tests/lessons/record_judge.h"
#include "tests/support/violent_hand.h"

#include <cstdio>

using namespace fulcrum::test;
namespace fs = std::filesystem;

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

namespace {

struct Played {
    int runs = 0;
    int felt = 0;     ///< with a force in the hand
    int guarded = 0;  ///< in which the guard of the hand's speed or energy took it away
};

void play(const Sandbox& sandbox, const std::string& lesson, const std::string& hand,
          Played& played) {
    sandbox.write("violent.lua", hand);
    const ProgramRun run = sandbox.run(
        "run " + lesson + " --headless --hand violent.lua --seconds 120 --record a.rec");
    INFO(lesson << ": " << run.output);
    REQUIRE(run.exit_code == 0);
    const Record record = read_run(sandbox.path("a.rec"));
    CHECK(find_trouble(record) == "");
    ++played.runs;
    const bool felt = std::ranges::any_of(record.samples, is_felt, &RecordSample::applied_W);
    played.felt += felt ? 1 : 0;
    if (!felt) {
        std::printf("%s: no force was felt\n", lesson.c_str());
    }
    played.guarded += std::ranges::any_of(record.samples,
                                          [](const RecordSample& sample) {
                                              return any(sample.faults & (Fault::hand_too_fast |
                                                                          Fault::too_much_energy));
                                          })
                          ? 1
                          : 0;
}

std::string hand_of(const fs::path& folder) {
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string text = entry.path().extension() == ".lua" ? bytes_of(entry.path()) : "";
        if (text.find("return motion.play") != std::string::npos) {
            return text;
        }
    }
    return {};
}

}  // namespace

TEST_CASE("violent hands: no lesson gives them more than its limits, and nearly all feel a force") {
    const char* said = std::getenv("FULCRUM_VIOLENT_HANDS");
    const int n_hands = said == nullptr ? 1 : std::atoi(said);
    const Sandbox sandbox;
    Played played;
    for (const auto& entry : fs::directory_iterator(FULCRUM_SCENARIOS)) {
        if (!entry.is_directory()) {
            continue;
        }
        const std::string own = hand_of(entry.path());
        REQUIRE(!own.empty());
        for (int seed = 1; seed <= n_hands; ++seed) {
            play(sandbox, entry.path().filename().string(),
                 make_violent(own, static_cast<std::uint64_t>(seed)), played);
        }
    }
    std::printf("%d runs of violent hands: %d with a force, %d in which a guard took it away\n",
                played.runs, played.felt, played.guarded);
    CHECK(20 * played.felt >= 19 * played.runs);
    CHECK(played.guarded > 0);
}
