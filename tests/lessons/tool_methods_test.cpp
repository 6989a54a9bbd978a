// One scene, each way to keep a tool outside things, by changing one word: the lever, and a planet that has handles.
#include "tests/lessons/program.h"

#include <catch2/catch.hpp>

#include <fstream>
#include <sstream>
#include <string>

using namespace fulcrum;
using namespace fulcrum::test;
namespace fs = std::filesystem;

namespace {

constexpr double kLimit_N = 5.0 + 1.0e-9;

// The lesson once more, with one word of it another one.
void copy_lesson(const fs::path& from, const fs::path& to, const std::string& word,
                 const std::string& other) {
    fs::copy(from, to, fs::copy_options::recursive);
    std::ifstream file(to / "lesson.lua");
    std::stringstream text;
    text << file.rdbuf();
    file.close();
    std::string lesson = text.str();
    const std::size_t at = lesson.find(word);
    REQUIRE(at != std::string::npos);
    lesson.replace(at, word.size(), other);
    std::ofstream(to / "lesson.lua") << lesson;
}

}  // namespace

TEST_CASE("tool methods: the lever and the planets are played to their ends by each of them") {
    const std::string method =
        GENERATE("field_sampling", "voxel_sampling", "implicit_penalty", "god_object");
    const Sandbox sandbox;
    copy_lesson(std::string(FULCRUM_SCENARIOS) + "/lever", sandbox.path("lever"), "tool = { shape",
                "tool = { method = \"" + method + "\", shape");
    copy_lesson(std::string(FULCRUM_EXAMPLES) + "/planet-handles", sandbox.path("planets"),
                "local method = \"field_sampling\"", "local method = \"" + method + "\"");
    for (const char* lesson : {"lever", "planets"}) {
        const ProgramRun run =
            sandbox.run("run ./" + std::string(lesson) + " --headless --record r.rec");
        INFO(method << ", " << lesson << ": " << run.output);
        CHECK(run.exit_code == 0);
        CHECK(run.output.find("3 of 3 stars") != std::string::npos);
        const Record record = read_run(sandbox.path("r.rec"));
        CHECK(largest_force_N(record) > 0.5);
        CHECK(largest_force_N(record) <= kLimit_N);
        const ProgramRun told = sandbox.run("explain ./" + std::string(lesson));
        CHECK(told.output.find(method) != std::string::npos);
    }
}

TEST_CASE("tool methods: the planets by their handles, by arm, by mouse and by keyboard") {
    const Sandbox sandbox;
    const ProgramRun run = sandbox.run("test " FULCRUM_EXAMPLES "/planet-handles");
    INFO(run.output);
    CHECK(run.exit_code == 0);
    for (const char* by : {"arm", "mouse", "keyboard"}) {
        CHECK(run.output.find(std::string("passed by ") + by) != std::string::npos);
    }
}
