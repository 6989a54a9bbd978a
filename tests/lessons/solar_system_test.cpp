// The lesson on planets, played to its end by its own simulated hand and pupil.
#include "tests/lessons/program.h"

using namespace fulcrum::test;

namespace {

// Scene indices, in the order of lesson.lua: the Sun, then of each planet its way, the far one and the near one.
enum Body : int { earth = 9, jupiter = 15 };

}  // namespace

TEST_CASE("solar-system: the hand turns the Earth at its side, near its pole, and then Jupiter") {
    const Sandbox sandbox;
    REQUIRE(sandbox.run("run solar-system --headless --record r.rec").exit_code == 0);
    const Record record = read_run(sandbox.path("r.rec"));
    const double first_s = time_of(record, RecordEventKind::touched, earth);
    const double last_s = time_of(record, RecordEventKind::touched, jupiter);
    REQUIRE(first_s > 0.0);
    REQUIRE(last_s > first_s);
    // It drags the surface sideways: friction, not only a push.
    double sideways_N = 0.0;
    for (const RecordSample& sample : record.samples) {
        if (sample.time_s > first_s && sample.time_s < last_s) {
            sideways_N = std::max(sideways_N, std::abs(sample.commanded_W.force.x()));
        }
    }
    CHECK(sideways_N > 0.3);
}

TEST_CASE("solar-system: the same day shows the same sky") {
    const Sandbox sandbox;
    const std::string run = "run solar-system --headless --seconds 5 --screenshot ";
    REQUIRE(sandbox.run(run + "a.png").exit_code == 0);
    REQUIRE(sandbox.run(run + "b.png").exit_code == 0);
    CHECK(bytes_of(sandbox.path("a.png")) == bytes_of(sandbox.path("b.png")));
}
