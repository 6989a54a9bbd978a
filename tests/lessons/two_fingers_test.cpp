// The example of two fingers, through the program: with two, with one, and with more than it can use.
#include "tests/lessons/program.h"

using namespace fulcrum::test;

namespace {

const std::string kLesson = FULCRUM_EXAMPLES "/two-fingers";

bool says(const ProgramRun& run, const std::string& words) {
    return run.output.find(words) != std::string::npos;
}

}  // namespace

TEST_CASE("two fingers: they lift, turn and stack a box, by arms, mouse and keys; one hand grips") {
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
    check_run(run, 0, {"Turn it in the air", "3 of 3 stars"});
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

TEST_CASE("two fingers: whoever has one is told so, and nothing of the other is built") {
    const Sandbox sandbox;
    const std::string one = " --hand " + kLesson + "/right.lua";
    const ProgramRun run = sandbox.run("run " + kLesson + " --headless" + one);
    INFO(run.output);
    check_run(run, 0, {"hold the button", "3 of 3 stars"}, {"Turn it"});
    CHECK(says(sandbox.run("explain " + kLesson), "hand 2   pushing"));
    check_run(sandbox.run("explain " + kLesson + " --analyze --seconds 3" + one), 0, {"pushing"},
              {"hand 2"});
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

TEST_CASE("two fingers: a device of no use to a lesson is left alone, one it needs is asked for") {
    const Sandbox sandbox;
    sandbox.write("still.lua", "return function() return 0, 0.3, 0 end\n");
    check_run(sandbox.run("run gravity --headless --seconds 1 --hand still.lua --hand " + kLesson +
                          "/left.lua"),
              0, {"This lesson uses one hand: ", "left.lua is left alone, without force."});
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
