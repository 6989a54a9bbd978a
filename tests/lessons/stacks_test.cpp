// The lesson of blocks, played to its end by its own simulated hand.
#include "tests/lessons/program.h"

using namespace fulcrum::test;

namespace {

// Scene indices, in the order of lesson.lua.
enum Block : int { wood, rock, metal };

}  // namespace

TEST_CASE("stacks: both blocks are gripped, and the hand carries what they weigh") {
    const Sandbox sandbox;
    REQUIRE(sandbox.run("run stacks --headless --record r.rec").exit_code == 0);
    const Record record = read_run(sandbox.path("r.rec"));
    for (const int block : {wood, metal}) {
        CHECK(std::ranges::any_of(record.events, [&](const RecordEvent& event) {
            return event.kind == RecordEventKind::touched && event.body == block;
        }));
    }
    // The metal block weighs 3.4 N, and pulls the hand down.
    const auto pulls = std::ranges::count_if(record.samples, [](const RecordSample& sample) {
        return std::abs(sample.applied_W.force.y() + 0.35 * 9.81) < 0.05;
    });
    CHECK(pulls > 500);
    CHECK(largest_force_N(record) < 5.0);
}

TEST_CASE("stacks: the plan has a world of rigid bodies; gravity and the lever have none") {
    const Sandbox sandbox;
    const std::string blocks = sandbox.run("explain stacks").output;
    for (const char* words : {"rigid bodies", "pushing", "lesson.lua:"}) {
        CHECK(blocks.find(words) != std::string::npos);
    }
    for (const char* lesson : {"gravity", "lever"}) {
        const std::string plan = sandbox.run(std::string("explain ") + lesson).output;
        CHECK(plan.find("rigid") == std::string::npos);
        CHECK(plan.find("pushing") == std::string::npos);
    }
}

TEST_CASE("stacks: with no hand the tower is missed, and the lesson waits for the first lift") {
    const Sandbox sandbox;
    sandbox.write("hand.lua", "return function() return 0, 0.34, 0 end");
    check_run(sandbox.run("run stacks --headless --seconds 20 --hand hand.lua"), 0, {"score 0"});
}
