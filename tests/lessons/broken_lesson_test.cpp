// Lessons that fail in every way a teacher can manage: the force fades first, then one sentence with file and line.
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

struct Case {
    const char* name;
    std::string text;
    int line;  // the sentence names it
};

}  // namespace

TEST_CASE("broken lessons: one sentence with file and line, exit code 1") {
    const std::vector<Case> cases{
        {"syntax", kHead + "function L:start(world\n  world:ground(0)\nend\nreturn L\n", 3},
        {"nil index", kHead + "function L:start(world)\n  local a = nothing.here\nend\nreturn L\n",
         3},
        {"out of range",
         kHead +
             "function L:start(world)\n  world:body { name = \"a\", mass = -3 }\nend\nreturn L\n",
         3},
        {"endless loop in start",
         kHead + "function L:start(world)\n  while true do end\nend\nreturn L\n", 3},
        {"endless loop in update",
         kHead + "function L:update(world, dt)\n  while true do end\nend\nreturn L\n", 3},
        {"memory",
         kHead + "function L:update(world, dt)\n  local t = {}\n  while true do t[#t+1] = "
                 "(\"x\"):rep(1000) .. #t end\nend\nreturn L\n",
         4},
        {"bad template",
         kHead + "L:question \"q\" { prompt = \"?\", answers = { \"[a\" }, right = function() "
                 "return true end }\nreturn L\n",
         2},
    };
    for (const Case& broken : cases) {
        const Sandbox sandbox;
        sandbox.write("broken/lesson.lua", broken.text);
        const ProgramRun run = sandbox.run("run broken --headless --seconds 5");
        INFO(broken.name << ": " << run.output);
        CHECK(run.exit_code == 1);
        CHECK(std::count(run.output.begin(), run.output.end(), '\n') == 1);
        check_says(run.output, {"lesson.lua:" + std::to_string(broken.line) + ":"});
    }
}

TEST_CASE("broken lessons: check finds models, sounds, expectations and hands that are not there") {
    struct Mistake {
        std::string text;
        std::string sentence;
    };
    const std::vector<Mistake> mistakes{
        {kHead + "function L:start(world)\n  world:body { name = \"a\", model = \"aple\" }\nend\n"
                 "return L\n",
         "lesson.lua:3: there is no model \"aple\" for a; did you mean \"apple\"? If not, put "
         "aple.glb "
         "beside the lesson.\n"},
        {kHead + "function L:start(world)\n  world:body { name = \"zebra\", visible = true }\nend\n"
                 "return L\n",
         "lesson.lua:3: there is no model \"zebra\" for zebra; put zebra.glb beside the lesson, or "
         "use sphere or box.\n"},
        {kHead + "function L:start(world)\n  world:body { name = \"zebra\", solid = true }\nend\n"
                 "return L\n",
         "lesson.lua:3: there is no model \"zebra\" for zebra; put zebra.glb beside the lesson, or "
         "use sphere or box.\n"},
        {kHead + "function L:start(world)\n  world:body { name = \"apple\", rigid = true, "
                 "simulated_model = \"buckte\" }\nend\nreturn L\n",
         "lesson.lua:3: there is no model \"buckte\" for apple; did you mean \"bucket\"? If not, "
         "put "
         "buckte.glb beside the lesson.\n"},
        {kHead + "function L:start(world)\n  world:bucket { model = \"buckte\" }\nend\nreturn L\n",
         "lesson.lua:3: there is no model \"buckte\" for the bucket; did you mean \"bucket\"? If "
         "not, put buckte.glb beside the lesson.\n"},
        {kHead + "function L:start(world)\n  world:body { name = \"box\", solid = true }\n"
                 "  world:hand { tool = { model = \"xylophone\" } }\nend\nreturn L\n",
         "lesson.lua:4: there is no model \"xylophone\" for the tool; put xylophone.glb beside the "
         "lesson, or use sphere or box.\n"},
        {kHead + "function L:key(name)\n  world:sound \"pup\"\nend\nreturn L\n",
         "lesson.lua:3: there is no sound \"pup\"; did you mean \"pop\"?\n"},
        {kHead + "L:test { expect = { stras = 3 } }\nreturn L\n",
         "lesson.lua:2: test.expect has no \"stras\"; did you mean \"stars\"?\n"},
        {kHead + "\nL:test { hand = \"sweep.lua\" }\nreturn L\n",
         "lesson.lua:3: there is no sweep.lua beside the lesson; write the simulated hand, or "
         "leave "
         "hand = … away.\n"},
    };
    for (const Mistake& mistake : mistakes) {
        const Sandbox sandbox;
        sandbox.write("broken/lesson.lua", mistake.text);
        const ProgramRun run = sandbox.run("check broken");
        CHECK(run.exit_code == 1);
        CHECK(run.output == mistake.sentence);
    }
}

TEST_CASE("broken lessons: check plays the first seconds, so that a slip in a story is found") {
    const std::string story = kHead +
                              "local story = require \"story\"\nfunction L:start(world)\n"
                              "  story(L, function()\n    story.wait(3)\n    ";
    const std::string end = "\n  end)\nend\nreturn L\n";
    const struct {
        const char *line, *sentence;
    } rows[] = {
        {"world:capton \"Hello\"",
         "lesson.lua:6: world has no \"capton\"; did you mean \"caption\"?\n"},
        {"world:ask \"where\"", "lesson.lua:6: there is no question \"where\".\n"},
        {"world:caption \"Hello\"", "x: no mistakes found.\n"},
    };
    for (const auto& row : rows) {
        const Sandbox sandbox;
        sandbox.write("told/lesson.lua", story + row.line + end);
        const ProgramRun run = sandbox.run("check told");
        CHECK(run.output == row.sentence);
        CHECK(run.exit_code == (run.output.starts_with("x:") ? 0 : 1));
    }
}

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

TEST_CASE("lessons: a test without a hand is played without one") {
    const Sandbox sandbox;
    sandbox.write("idle/lesson.lua", kHead +
                                         "function L:start(world) world:finish { stars = 1 } end\n"
                                         "L:test { expect = { finished = true } }\nreturn L\n");
    for (const char* command : {"check idle", "explain idle", "test idle", "run idle --headless"}) {
        const ProgramRun run = sandbox.run(command);
        INFO(command << ": " << run.output);
        CHECK(run.exit_code == 0);
    }
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

TEST_CASE("lessons: one that never ends is ended, and says how long it went on") {
    const Sandbox sandbox;
    sandbox.write("endless/lesson.lua", kHead +
                                            "function L:update() end\n"
                                            "L:test { expect = { finished = true } }\nreturn L\n");
    for (const char* command : {"test endless", "run endless --headless"}) {
        const ProgramRun run = sandbox.run(command);
        INFO(command << ": " << run.output);
        check_run(run, 1, {"had not finished after 3 minutes of play"});
    }
    // Told when to stop, it has done what was asked.
    CHECK(sandbox.run("run endless --headless --seconds 200").exit_code == 0);
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

TEST_CASE("broken lessons: one that declares too much, a learner who errs too often, are told") {
    const auto refused = [](const std::string& body, const std::string& words) {
        const Sandbox sandbox;
        sandbox.write("broken/lesson.lua", kHead + body + "\nreturn L\n");
        const ProgramRun run = sandbox.run("check broken");
        INFO(run.output);
        CHECK(run.exit_code == 1);
        CHECK(std::count(run.output.begin(), run.output.end(), '\n') == 1);
        check_says(run.output, {"lesson.lua", words});
    };
    refused(
        "for i = 1, 20 do\n  local answers = {}\n  for j = 1, 60 do answers[j] = (\"big "
        "\"):rep(200) .. "
        "j end\n  L:question(\"q\" .. i) { prompt = \"?\", answers = answers, right = print }\nend",
        "kB of text in all, and 512 kB are the most; take some out, or make two lessons of it");
    refused(
        "L:test { learner = { wrong = 0.5, form = 0.5, unclear = 0.2 } }",
        "test.learner errs in 1.2 of its answers, wrong, form and unclear together; 1 is all of "
        "them");
    const Sandbox sandbox;
    sandbox.write(
        "fine/lesson.lua",
        kHead + "L:test { learner = { wrong = 0.7, form = 0.2, unclear = 0.1 } }\nreturn L\n");
    CHECK(sandbox.run("check fine").exit_code == 0);
}
