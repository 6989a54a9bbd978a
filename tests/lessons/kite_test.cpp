// The lesson on the kite, played to its end by its own simulated hand; and kites of a teacher's own.
#include "tests/lessons/program.h"

using namespace fulcrum::test;

namespace {

// Plays a lesson that only flies a kite for some seconds and then says `told`.
ProgramRun fly(const Sandbox& sandbox, const std::string& start, const std::string& update) {
    sandbox.write("own/lesson.lua",
                  "local L = lesson { id = 'own', title = 'Own kite' }\nlocal kite, t = nil, 0\n"
                  "function L:start(world)\n" +
                      start + "\nend\nfunction L:update(world, dt)\n t = t + dt\n" + update +
                      "\nend\nreturn L\n");
    sandbox.write("own/hand.lua", "return function() return 0, 1.2, 0 end\n");
    return sandbox.run("run own --headless --seconds 25 --hand own/hand.lua");
}

}  // namespace

TEST_CASE("kite: the hand feels the line, and more of it in more wind") {
    const Sandbox sandbox;
    REQUIRE(sandbox.run("run kite --headless --record r.rec").exit_code == 0);
    const Record record = read_run(sandbox.path("r.rec"));
    CHECK(largest_force_N(record) > 1.5);
    CHECK(largest_force_N(record) <= 5.0);
}

TEST_CASE("kite: a hand that shakes, swings and lets line out all the time turns no answer") {
    const Sandbox sandbox;
    sandbox.write("say.txt",
                  "it needs a tail\n"
                  "the lift holds it up\n"
                  "I feel the tension\n"
                  "the lift is stronger than the drag\n"
                  "it pulls more\n"
                  "the lift was smaller than the weight\n");
    for (const char* hand :
         {"2 * math.sin(6.28 * t), 1.2, 0",
          "1.5 * math.sin(0.7 * t) + 0.3 * math.sin(25 * t), 1.2 + 0.5 * math.sin(2 * t), "
          "math.sin(t), 1"}) {
        sandbox.write("shake.lua",
                      std::string("return function(hand, t) return ") + hand + " end\n");
        check_run(sandbox.run("run kite --headless --say say.txt --hand shake.lua"), 0,
                  {"the lift was smaller than the weight (right)"}, {"(wrong)"});
    }
}

TEST_CASE("kite: only a lesson with a kite has its stages") {
    const Sandbox sandbox;
    const std::string plan = sandbox.run("explain kite").output;
    for (const char* words : {"forces: line", "the hand holds a kite's line", "a kite flies"}) {
        CHECK_THAT(plan, Catch::Contains(words));
    }
    for (const char* lesson : {"gravity", "textures", "lever", "solar-system"}) {
        const std::string other = sandbox.run(std::string("explain ") + lesson).output;
        CHECK(other.find("What is not in this list is not built") != std::string::npos);
        CHECK(other.find("kite") == std::string::npos);
    }
}

TEST_CASE("kite: a kite of a teacher's own flies, snaps, and comes down without wind") {
    const Sandbox sandbox;
    check_run(fly(sandbox, "kite = world:kite { shape = 'sled', knot = 0.72, line = 15 }",
                  "if t > 20 and t - dt <= 20 then print(kite.altitude > 8, kite.tension > 1, "
                  "kite.lift > kite.weight) end"),
              {}, {"true\ttrue\ttrue"});
    check_run(
        fly(sandbox, "world:wind { speed = 9 } kite = world:kite { strength = 2, line = 15 }",
            "if t > 20 and t - dt <= 20 then print(kite.snapped, kite.tension, kite.altitude < 3) "
            "end"),
        {}, {"true\t0.0\ttrue"});
    check_run(fly(sandbox, "world:wind { speed = 0 } kite = world:kite { line = 15 }",
                  "if t > 20 and t - dt <= 20 then print(kite.altitude < 1, kite.wind) end"),
              {}, {"true\t0.0"});
}

TEST_CASE(
    "kite: what a lesson is told of the pull at the hand is what is sent behind the last gate") {
    const Sandbox sandbox;
    sandbox.write("own/lesson.lua", R"(
local L = lesson { id = 'own', title = 'Own kite' }
local kite
function L:start(world) world:wind { speed = 6 } kite = world:kite { line = 15, felt = 0.5 } end
function L:update(world)
  if world.time > 10 then print(("told %.4f %.4f %.4f"):format(world.time, world:tool().force, kite.pull)) end
end
return L)");
    sandbox.write("own/hand.lua", "return function() return 0, 1.2, 0 end\n");
    const ProgramRun run =
        sandbox.run("run own --headless --seconds 12 --hand own/hand.lua --record r.rec");
    const Record record = read_run(sandbox.path("r.rec"));
    // A frame is told the newest round, at most one frame old.
    constexpr double kFrame_s = 1.0 / 60.0;
    std::istringstream lines(run.output);
    int n = 0;
    double time_s = 0.0;
    double told_N = 0.0;
    double line_N = 0.0;
    for (std::string line; std::getline(lines, line);) {
        if (std::sscanf(line.c_str(), "told %lf %lf %lf", &time_s, &told_N, &line_N) != 3) {
            continue;
        }
        double least_N = 1e9;
        double most_N = 0.0;
        for (const RecordSample& sample : record.samples) {
            if (std::abs(sample.time_s - time_s) <= kFrame_s) {
                const double sent_N = sample.applied_W.force.norm();
                least_N = std::min(least_N, sent_N);
                most_N = std::max(most_N, sent_N);
            }
        }
        INFO(line);
        CHECK(told_N >= least_N - 1e-3);
        CHECK(told_N <= most_N + 1e-3);
        CHECK(told_N < 0.75 * line_N);  // not the line's own
        ++n;
    }
    CHECK(n > 60);
}

TEST_CASE("kite: a mistake in a kite is told with file and line") {
    const Sandbox sandbox;
    const ProgramRun run = fly(sandbox, "kite = world:kite { bridle = 0.5 }", "");
    CHECK(run.exit_code != 0);
    CHECK_THAT(run.output, Catch::Contains("lesson.lua:4: a bridle of 0.5 m is too short"));
}
