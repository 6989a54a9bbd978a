// The lesson on the lever, played to its end by its own simulated hand.
#include "tests/lessons/program.h"

using namespace fulcrum::test;

namespace {

// Scene indices, in the order of lesson.lua.
enum Body : int { support, lever };

}  // namespace

TEST_CASE("lever: each level is pressed and lifted, and what the hand feels stays in bounds") {
    const Sandbox sandbox;
    REQUIRE(sandbox.run("run lever --headless --record r.rec").exit_code == 0);
    const Record record = read_run(sandbox.path("r.rec"));
    const auto touches = std::ranges::count_if(record.events, [](const RecordEvent& event) {
        return event.kind == RecordEventKind::touched && event.body == lever;
    });
    CHECK(touches >= 5);
    // Near the support and against 20 newtons it presses as strongly as it may; 1000 newtons are lifted by one.
    CHECK(largest_force_N(record) > 4.5);
    double last_touch_s = 0.0;
    for (const RecordEvent& event : record.events) {
        last_touch_s = event.kind == RecordEventKind::touched ? event.time_s : last_touch_s;
    }
    double late_N = 0.0;
    for (const RecordSample& sample : record.samples) {
        if (sample.time_s > last_touch_s) {
            late_N = std::max(late_N, sample.applied_W.force.norm());
        }
    }
    CHECK(late_N > 0.9);
    CHECK(late_N < 3.5);
}

TEST_CASE("lever: the plan turns a body on a hinge; gravity and textures have no such stage") {
    const Sandbox sandbox;
    const std::string lever_plan = sandbox.run("explain lever").output;
    for (const char* words : {"a body turns on a hinge", "a cylinder meets bodies", "voxels of"}) {
        CHECK(lever_plan.find(words) != std::string::npos);
    }
    for (const char* lesson : {"gravity", "textures"}) {
        const std::string plan = sandbox.run(std::string("explain ") + lesson).output;
        CHECK(plan.find("What is not in this list is not built") != std::string::npos);
        for (const char* words : {"hinge", "meets bodies", "voxel"}) {
            CHECK(plan.find(words) == std::string::npos);
        }
    }
}
