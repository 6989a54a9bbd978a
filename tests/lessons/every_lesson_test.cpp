// What holds for every lesson that comes with the program.
#include "tests/lessons/program.h"

using namespace fulcrum::test;
namespace fs = std::filesystem;

namespace {

constexpr double kLimit_N = 5.0;  // of a site that says nothing else
constexpr double kRounding_N = 1e-9;

std::vector<std::string> lessons() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(FULCRUM_SCENARIOS)) {
        if (fs::exists(entry.path() / "lesson.lua")) {
            names.push_back(entry.path().filename().string());
        }
    }
    std::ranges::sort(names);
    REQUIRE(names.size() >= 2);
    return names;
}

void check_ends(const std::string& by) {
    for (const std::string& lesson : lessons()) {
        if (by == "idle" && lesson == "science-room") {
            continue;  // a room ends where somebody enters a lesson
        }
        const Sandbox sandbox;
        const ProgramRun run = sandbox.run("test " + lesson + " --by " + by);
        INFO(lesson << ": " << run.output);
        CHECK(run.exit_code == 0);
        CHECK(run.output.find(lesson + ": passed by " + by) != std::string::npos);
    }
}

}  // namespace

TEST_CASE("every lesson: its own test passes by arm, by mouse and by keyboard") {
    for (const std::string& lesson : lessons()) {
        const Sandbox sandbox;
        const ProgramRun run = sandbox.run("test " + lesson);
        INFO(lesson << ": " << run.output);
        CHECK(run.exit_code == 0);
        for (const char* by : {"arm", "mouse", "keyboard"}) {
            CHECK(run.output.find(lesson + ": passed by " + by) != std::string::npos);
        }
    }
}

TEST_CASE("every lesson: nobody stays blocked who errs in half of the answers, or in nearly all") {
    for (const std::string& lesson : lessons()) {
        const Sandbox sandbox;
        for (const char* errors : {"0.5", "0.9"}) {
            const ProgramRun run = sandbox.run("test " + lesson + " --errors " + errors);
            INFO(lesson << ", " << errors << ": " << run.output);
            CHECK(run.exit_code == 0);
        }
    }
}

TEST_CASE("every lesson: a finger on a screen comes to its end") {
    check_ends("touch");
}

TEST_CASE("every lesson: a clumsy hand comes to its end, whatever it answers") {
    check_ends("clumsy");
}

TEST_CASE("every lesson: so does who moves nothing") {
    check_ends("idle");
}

TEST_CASE("every lesson: who plays at a desk gives the same bytes twice, and feels no force") {
    const Sandbox sandbox;
    for (const char* by : {"mouse", "keyboard"}) {
        CAPTURE(by);
        const std::string play =
            std::string("run gravity --headless --errors 0.3 --by ") + by + " --record ";
        const ProgramRun run = sandbox.run(play + "a.rec");
        INFO(run.output);
        REQUIRE(run.exit_code == 0);
        REQUIRE(sandbox.run(play + "b.rec").exit_code == 0);
        CHECK(bytes_of(sandbox.path("a.rec")) == bytes_of(sandbox.path("b.rec")));
    }
    check_run(sandbox.run("run gravity --headless --hand replay:a.rec --by mouse"), 2,
              {"--by says how a simulated hand plays"});
}

TEST_CASE("every lesson: the same input twice gives the same bytes, and nothing passes the limit") {
    for (const std::string& lesson : lessons()) {
        CAPTURE(lesson);
        const Sandbox sandbox;
        REQUIRE(sandbox.run("run " + lesson + " --headless --record a.rec").exit_code == 0);
        REQUIRE(sandbox.run("run " + lesson + " --headless --record b.rec").exit_code == 0);
        const std::string bytes = bytes_of(sandbox.path("a.rec"));
        CHECK(bytes.size() > 100'000);
        CHECK(bytes == bytes_of(sandbox.path("b.rec")));
        const Record record = read_run(sandbox.path("a.rec"));
        CHECK(record.samples.size() > 10'000);
        CHECK(largest_force_N(record) <= kLimit_N + kRounding_N);
        CHECK(largest_force_N(record) > 0.5);
    }
}
