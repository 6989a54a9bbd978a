// Lessons made by chance from the binding table, each played by a process of its own, and judged by what the record of its run says, as
// `soak` judges what an arm is given. FULCRUM_PLAYED_LESSONS says how many.
#include "tests/lessons/program.h"
#include "tests/lessons/record_judge.h"
#include "tests/support/generated_lesson.h"

#include <cstdio>
#include <cstdlib>

using namespace fulcrum::test;

namespace {

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
    const bool felt = std::ranges::any_of(record.samples, is_felt, &RecordSample::applied_W);
    ++outcome.played;
    outcome.felt += felt ? 1 : 0;
    outcome.faded += felt && fails ? 1 : 0;
    std::filesystem::remove(sandbox.path(name + ".rec"));
}

}  // namespace

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
