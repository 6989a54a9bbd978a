// A lesson that fails fades its force first; commands and files that cannot be are one sentence. The mistakes of teachers stand in tables.
#include "tests/lessons/program.h"

using namespace fulcrum::test;

namespace {

const std::string kHead =
    "local L = lesson { id = \"x\", title = \"X\", level = \"A1\", minutes = 1 }\n";
// A spring, so that there is a force to fade; the hand is held 3 cm away from it.
const std::string kSpring =
    "function L:start(world)\n"
    "  world:spring { name = \"s\", at = { 0.03, 0.3, 0 }, stiffness = 60, damping = 1 }\n"
    "end\n";

}  // namespace

TEST_CASE("broken lessons: one that fails in the middle fades its force before the run ends") {
    const Sandbox sandbox;
    sandbox.write("hand.lua", "return function() return 0, 0.3, 0 end\n");
    sandbox.write("fails/lesson.lua",
                  kHead + kSpring +
                      "function L:update(world, dt)\n"
                      "  if world.time > 4 then error(\"the kite is gone\") end\n"
                      "end\nreturn L\n");
    check_run(sandbox.run("run fails --headless --hand hand.lua --record r.rec"), 1,
              {"lesson.lua:6: the kite is gone"});
    const Record record = read_run(sandbox.path("r.rec"));
    const RecordSample& before = sample_at(record, 3.9);
    CHECK(before.applied_W.force.norm() > 1.0);
    CHECK(record.samples.back().applied_W.force.norm() == 0.0);
    // It fades in the stated time, 0.1 s, without rising on the way.
    double last_N = before.applied_W.force.norm();
    for (const RecordSample& sample : record.samples) {
        if (sample.time_s > 4.05) {
            REQUIRE(sample.applied_W.force.norm() <= last_N + 1e-9);
            last_N = sample.applied_W.force.norm();
        }
    }
    CHECK(sample_at(record, 4.15).applied_W.force.norm() == 0.0);
}

TEST_CASE("broken input: a wrong command, hand, record, say file or database is one sentence") {
    const Sandbox sandbox;
    sandbox.write("garbage", std::string(1000, 'x'));
    const std::vector<std::pair<std::string, int>> cases{
        {"rnu gravity", 2},
        {"run gravty", 2},
        {"run gravity --headless --hand replay:garbage", 1},
        {"run gravity --headless --hand nowhere.lua", 1},
        {"run gravity --headless --hand replay:nowhere", 2},
        {"run gravity --headless --say nowhere.txt", 2},
        {"run gravity --headless --hand mouse", 2},
        {"report --db garbage", 2},
        {"report --db nowhere.db", 2},
    };
    for (const auto& [arguments, exit_code] : cases) {
        const ProgramRun run = sandbox.run(arguments);
        INFO(arguments << ": " << run.output);
        CHECK(run.exit_code == exit_code);
        CHECK(std::count(run.output.begin(), run.output.end(), '\n') == 1);
    }
}

TEST_CASE("broken input: with a damaged database the lesson is played, and the file stays") {
    const Sandbox sandbox;
    const std::string garbage(5000, 'x');
    sandbox.write("damaged.db", garbage);
    check_run(sandbox.run("run gravity --headless --seconds 5 --db damaged.db"), 4, {"damaged.db"});
    CHECK(bytes_of(sandbox.path("damaged.db")) == garbage);
}

TEST_CASE("check: a solid's open mesh is told in one sentence, a sound one is not spoken of") {
    const std::string triangle =
        bytes_of(FULCRUM_TEST_LESSONS "/../fuzz/corpus/gltf/data_uri.gltf");
    REQUIRE_FALSE(triangle.empty());
    const Sandbox sandbox;
    sandbox.write("meshes/paper.gltf", triangle);
    sandbox.write("meshes/lesson.lua",
                  kHead +
                      "function L:start(world)\n"
                      "  world:body { name = \"ball\", model = \"sphere\", solid = true }\n"
                      "  world:body { name = \"sheet\", model = \"paper\", solid = true }\n"
                      "  world:body { name = \"seen\", model = \"paper\", visible = true }\n"
                      "end\nreturn L\n");
    const ProgramRun run = sandbox.run("check meshes");
    INFO(run.output);
    CHECK(run.exit_code == 0);
    CHECK(run.output.find("lesson.lua:4: sheet: The mesh of 1 triangle, ") == 0);
    check_says(run.output, {"has 3 open edges"});
    check_lacks(run.output, {"ball", "seen"});
    CHECK(run.output.ends_with("\nx: it can be played, but see the sentence above.\n"));
}

TEST_CASE("program: a path that no file can have, and a full disk, each end in one sentence") {
    const Sandbox sandbox;
    for (const std::string& arguments :
         {"run gravity --headless --hand replay:" + std::string(300, 'a'),
          "run " + std::string(5000, 'b') + " --headless", std::string("list > /dev/full")}) {
        const ProgramRun run = sandbox.run(arguments);
        INFO(run.output);
        CHECK(run.exit_code == 2);
        CHECK(std::count(run.output.begin(), run.output.end(), '\n') <= 1);
    }
}

TEST_CASE("program: what the lesson's own test answers is nobody's progress") {
    const Sandbox sandbox;
    const ProgramRun run = sandbox.run("run gravity --headless --learner Mina");
    INFO(run.output);
    check_run(run, 0, {"not for Mina"});
    CHECK(sandbox.run("report").output.find("Mina") == std::string::npos);
    sandbox.write("empty.txt", "\n\n");
    CHECK(sandbox.run("run gravity --headless --say empty.txt").exit_code == 2);
}
