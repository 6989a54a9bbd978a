// The gravity game, played to its end by its own simulated hand and pupil.
#include "tests/lessons/program.h"

using namespace fulcrum::test;

namespace {

// Scene indices, in the order of lesson.lua: three decorations, then the fruit.
enum Body : int { tree, hill, flower, watermelon, apple, banana, egg };

constexpr double kSettled_s =
    1.5;  // after a catch: onset 0.3 s, and the soft start of the first seconds is over
// Force-limited weights settle within the gate's own rounding; the arm's motion does not enter.
constexpr double kWeightTolerance_N = 0.01;

double felt_N(const Record& record, int body, double from_s = 0.0) {
    const double caught_s = time_of(record, RecordEventKind::caught, body, from_s);
    REQUIRE(caught_s > 0.0);
    return -sample_at(record, caught_s + kSettled_s).applied_W.force.y();
}

}  // namespace

TEST_CASE("gravity: the heaviest fruit uses its share of the limit: scaled, not clipped") {
    const Sandbox sandbox;
    REQUIRE(sandbox.run("run gravity --headless --record r.rec").exit_code == 0);
    const double largest_N = largest_force_N(read_run(sandbox.path("r.rec")));
    CHECK(largest_N == Approx(0.9 * 5.0).margin(kWeightTolerance_N));
}

TEST_CASE("gravity: at 10 N the apple weighs 6 N and the egg 3 N in the hand") {
    const Sandbox sandbox;
    REQUIRE(sandbox.run("run gravity --headless --force-limit 10 --record r.rec").exit_code == 0);
    const Record record = read_run(sandbox.path("r.rec"));
    const double later_s = time_of(record, RecordEventKind::caught, watermelon);
    CHECK(felt_N(record, apple, later_s) == Approx(6.0).margin(kWeightTolerance_N));
    CHECK(felt_N(record, egg, later_s) == Approx(3.0).margin(kWeightTolerance_N));
    CHECK(felt_N(record, watermelon) == Approx(8.829).margin(kWeightTolerance_N));
    CHECK(felt_N(record, banana, later_s - 10.0) == Approx(4.12).margin(kWeightTolerance_N));
}

TEST_CASE("gravity: a weight arrives softly, without a jolt") {
    const Sandbox sandbox;
    REQUIRE(sandbox.run("run gravity --headless --force-limit 10 --record r.rec").exit_code == 0);
    const Record record = read_run(sandbox.path("r.rec"));
    // Minimum jerk over 0.3 s: |dF/dt| <= 15/8 F/T and |d2F/dt2| <= 10/sqrt(3) F/T^2.
    const double weight_N = 8.829;
    const double onset_s = 0.3;
    const double steepest_N_per_s = 15.0 / 8.0 * weight_N / onset_s;
    const double sharpest_N_per_s2 = 10.0 / std::sqrt(3.0) * weight_N / (onset_s * onset_s);
    const double from_s = time_of(record, RecordEventKind::caught, watermelon);
    double before_N = 0.0;
    double rate_before = 0.0;
    int n = 0;
    for (const RecordSample& sample : record.samples) {
        if (sample.time_s < from_s || sample.time_s > from_s + 1.0) {
            continue;
        }
        const double force_N = -sample.applied_W.force.y();
        const double rate = n > 0 ? (force_N - before_N) * record.header.rate_Hz : 0.0;
        const double bend = n > 1 ? (rate - rate_before) * record.header.rate_Hz : 0.0;
        REQUIRE(std::abs(rate) <= 1.02 * steepest_N_per_s);
        REQUIRE(std::abs(bend) <= 1.05 * sharpest_N_per_s2);
        before_N = force_N;
        rate_before = rate;
        ++n;
    }
    CHECK(n > 900);
    CHECK(before_N == Approx(weight_N).margin(kWeightTolerance_N));
}

TEST_CASE("gravity: a wrong meaning is weighed again, a wrong form recast, the teacher told") {
    const Sandbox sandbox;
    sandbox.write("say.txt",
                  "the egg is heavier than the apple\n"  // wrong meaning: weighed again
                  "an apple is heavier than an egg\n"    // right
                  "apple is most heavy\n"                // right meaning, wrong form
                  "bla bla\n"                            // not understood
                  "watermelon is the heaviest\n"         // right, article missing
                  "an egg is the lightest\n");
    const ProgramRun run =
        sandbox.run("run gravity --headless --say say.txt --learner Mina --record r.rec");
    INFO(run.output);
    REQUIRE(run.exit_code == 0);

    // Weighed again: after the wrong answer the egg's and then the apple's weight are felt without any catch.
    const Record record = read_run(sandbox.path("r.rec"));
    const double answered_s = time_of(record, RecordEventKind::answered, kNoBody);
    const double again_s = time_of(record, RecordEventKind::answered, kNoBody, answered_s + 0.1);
    CHECK(time_of(record, RecordEventKind::caught, banana) > again_s);
    double egg_N = 0.0;
    double apple_N = 0.0;
    for (const RecordSample& sample : record.samples) {
        if (sample.time_s > answered_s && sample.time_s < again_s) {
            const double force_N = -sample.applied_W.force.y();
            egg_N = std::abs(force_N - 1.53) < 0.02 ? force_N : egg_N;
            apple_N = std::abs(force_N - 3.06) < 0.02 ? force_N : apple_N;
        }
    }
    CHECK(egg_N > 1.5);
    CHECK(apple_N > 3.0);

    const ProgramRun report = sandbox.run("report --learner Mina");
    INFO(report.output);
    check_run(report, 0, {"Mina", "\"most heavy\" for \"heaviest\"", "left out \"the\""});
    const ProgramRun csv = sandbox.run("report --format csv");
    CHECK(csv.output.find("Mina,") != std::string::npos);
}

TEST_CASE("gravity: a hand never under the fruit catches nothing, and the run ends as told") {
    const Sandbox sandbox;
    sandbox.write("still.lua", "return function(hand, t, world) return 0.9, 0.3, 0 end\n");
    check_run(sandbox.run("run gravity --headless --hand still.lua --seconds 20 --record r.rec"),
              0);
    const Record record = read_run(sandbox.path("r.rec"));
    CHECK(time_of(record, RecordEventKind::landed, apple) > 0.0);
    for (const RecordSample& sample : record.samples) {
        REQUIRE(sample.applied_W.force.norm() == 0.0);
    }
}

TEST_CASE("gravity: a recorded hand plays the same game again") {
    const Sandbox sandbox;
    REQUIRE(sandbox.run("run gravity --headless --seconds 20 --record a.rec").exit_code == 0);
    check_run(sandbox.run("run gravity --headless --seconds 20 --hand replay:a.rec --record b.rec"),
              0);
    const Record first = read_run(sandbox.path("a.rec"));
    const Record again = read_run(sandbox.path("b.rec"));
    REQUIRE(first.samples.size() == again.samples.size());
    for (std::size_t i = 0; i < first.samples.size(); ++i) {
        REQUIRE(first.samples[i].applied_W.force == again.samples[i].applied_W.force);
    }
}

TEST_CASE("gravity: explain lists what runs and nothing else") {
    const Sandbox sandbox;
    const ProgramRun run = sandbox.run("explain gravity --mute");
    INFO(run.output);
    check_run(run, 0, {"forces: weight", "lesson.lua:"});
    // Every planned stage of the haptic loop was built: only what was built has a size.
    std::istringstream rows(run.output);
    int haptic_rows = 0;
    for (std::string row; std::getline(rows, row);) {
        if (row.rfind("haptic ", 0) == 0) {
            ++haptic_rows;
            CHECK(row.find(" -  ") == std::string::npos);
        }
    }
    CHECK(haptic_rows == 8);
    check_lacks(run.output, {"proxy", "sound", "recogniser", "forces: lesson", "record"});
}
