// The example of two fingers, through the program: with two, with one, and with more than it can use.
#include "tests/lessons/program.h"

#include <catch2/catch.hpp>

#include <string>

using namespace fulcrum;
using namespace fulcrum::test;

namespace {

const std::string kLesson = FULCRUM_EXAMPLES "/two-fingers";

bool says(const ProgramRun& run, const std::string& words) {
    return run.output.find(words) != std::string::npos;
}

}  // namespace

TEST_CASE(
    "two fingers: they lift, turn and stack a box, by arms and by mouse and keys; one hand grips "
    "it") {
    const Sandbox sandbox;
    const ProgramRun run = sandbox.run("test " + kLesson);
    INFO(run.output);
    CHECK(run.exit_code == 0);
    for (const char* by : {"arm", "mouse", "keyboard"}) {
        CHECK(says(run, std::string("passed by ") + by));
    }
}

TEST_CASE("two fingers: each is held within its limits, and the same run gives the same bytes") {
    const Sandbox sandbox;
    const ProgramRun run = sandbox.run("run " + kLesson + " --headless --record a.rec");
    INFO(run.output);
    REQUIRE(run.exit_code == 0);
    CHECK(says(run, "Turn it in the air"));
    CHECK(says(run, "3 of 3 stars"));
    REQUIRE(sandbox.run("run " + kLesson + " --headless --record b.rec").exit_code == 0);
    CHECK(bytes_of(sandbox.path("a.rec")) == bytes_of(sandbox.path("b.rec")));
    const Record record = read_run(sandbox.path("a.rec"));
    CHECK(largest_force_N(record) > 1.0);
    CHECK(largest_force_N(record) <= 5.0 + 1e-9);
    const auto second = find_hand(record, 1);
    REQUIRE(second);
    CHECK(second->samples.size() == record.samples.size());
    CHECK(largest_force_N(*second) > 1.0);
    CHECK(largest_force_N(*second) <= 5.0 + 1e-9);
}

TEST_CASE(
    "two fingers: whoever has one is told so by the lesson, and nothing of the other is built") {
    const Sandbox sandbox;
    const std::string one = " --hand " + kLesson + "/right.lua";
    const ProgramRun run = sandbox.run("run " + kLesson + " --headless" + one);
    INFO(run.output);
    CHECK(run.exit_code == 0);
    CHECK(says(run, "hold the button"));
    CHECK_FALSE(says(run, "Turn it"));
    CHECK(says(run, "3 of 3 stars"));
    CHECK(says(sandbox.run("explain " + kLesson), "hand 2   pushing"));
    const ProgramRun plan = sandbox.run("explain " + kLesson + " --analyze --seconds 3" + one);
    CHECK(plan.exit_code == 0);
    CHECK(says(plan, "pushing"));
    CHECK_FALSE(says(plan, "hand 2"));
}

TEST_CASE("two fingers: what each loop costs is told") {
    const Sandbox sandbox;
    const ProgramRun plan = sandbox.run("explain " + kLesson + " --analyze --seconds 8");
    INFO(plan.output);
    CHECK(plan.exit_code == 0);
    const std::size_t costs = plan.output.find("us");
    REQUIRE(costs != std::string::npos);
    CHECK(plan.output.find("hand 2", plan.output.find("What is not in this list")) !=
          std::string::npos);
}

TEST_CASE(
    "two fingers: a device that a lesson cannot use is left alone, one that it needs is asked "
    "for") {
    const Sandbox sandbox;
    sandbox.write("still.lua", "return function() return 0, 0.3, 0 end\n");
    const ProgramRun gravity = sandbox.run(
        "run gravity --headless --seconds 1 --hand still.lua --hand " + kLesson + "/left.lua");
    INFO(gravity.output);
    CHECK(gravity.exit_code == 0);
    CHECK(says(gravity, "This lesson uses one hand: "));
    CHECK(says(gravity, "left.lua is left alone, without force."));
    sandbox.write("both/lesson.lua",
                  "local L = lesson { id = 'both', title = 'Both', hands = 2 }\n"
                  "function L:start(world)\n"
                  "  world:hand {}\n"
                  "  world:hand { needed = true }\n"
                  "end\n"
                  "return L\n");
    const ProgramRun one = sandbox.run("run both --headless --seconds 1 --hand still.lua");
    CHECK(one.exit_code != 0);
    CHECK(says(one, "lesson.lua:4: this lesson needs two hands at once, and one is there"));
    CHECK(sandbox.run("run both --headless --seconds 1 --hand still.lua --hand still.lua")
              .exit_code == 0);
    CHECK(sandbox.run("check both").exit_code == 0);
}
