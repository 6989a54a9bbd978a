// One scene, each way to keep a tool outside things, by changing one word: the lever, and a planet that has handles.
#include "tests/lessons/program.h"

using namespace fulcrum::test;
namespace fs = std::filesystem;

namespace {

constexpr double kLimit_N = 5.0 + 1.0e-9;

// The lesson once more, with one word of it another one.
void copy_lesson(const fs::path& from, const fs::path& to, const std::string& word,
                 const std::string& other) {
    fs::copy(from, to, fs::copy_options::recursive);
    std::string lesson = bytes_of(to / "lesson.lua");
    const std::size_t at = lesson.find(word);
    REQUIRE(at != std::string::npos);
    lesson.replace(at, word.size(), other);
    std::ofstream(to / "lesson.lua") << lesson;
}

}  // namespace

TEST_CASE("tool methods: the lever and the planets are played to their ends by each of them") {
    // The last finds contact by levels.
    const std::string words = GENERATE("field_sampling", "voxel_sampling", "implicit_penalty",
                                       "god_object", "implicit_penalty\", contact = \"levels");
    const std::string method = words.substr(0, words.find('"'));
    const bool by_levels = method != words;
    const Sandbox sandbox;
    copy_lesson(std::string(FULCRUM_SCENARIOS) + "/lever", sandbox.path("lever"), "tool = { shape",
                "tool = { method = \"" + words + "\", shape");
    copy_lesson(
        std::string(FULCRUM_EXAMPLES) + "/planet-handles", sandbox.path("planets"),
        "local method, contact = \"field_sampling\", nil",
        "local method, contact = \"" + method + "\", " + (by_levels ? "\"levels\"" : "nil"));
    for (const char* lesson : {"lever", "planets"}) {
        const ProgramRun run =
            sandbox.run("run ./" + std::string(lesson) + " --headless --record r.rec");
        INFO(words << ", " << lesson << ": " << run.output);
        check_run(run, 0, {"3 of 3 stars"});
        const Record record = read_run(sandbox.path("r.rec"));
        CHECK(largest_force_N(record) > 0.5);
        CHECK(largest_force_N(record) <= kLimit_N);
        const ProgramRun told = sandbox.run("explain ./" + std::string(lesson));
        CHECK(told.output.find(method) != std::string::npos);
        CHECK((told.output.find("contact by levels") != std::string::npos) == by_levels);
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

TEST_CASE("tool methods: a banana in a bowl, by levels and by fields, and from the cache") {
    const Sandbox sandbox;
    copy_lesson(std::string(FULCRUM_EXAMPLES) + "/fruit-bowl", sandbox.path("fields"),
                "local contact = \"levels\"", "local contact = \"fields\"");
    fs::copy(std::string(FULCRUM_EXAMPLES) + "/fruit-bowl", sandbox.path("levels"));
    // The same forces, whether levels are made or read.
    std::vector<Record> records;
    for (const char* shapes : {"made now", "from the cache"}) {
        if (!records.empty()) {
            const ProgramRun told = sandbox.run("explain ./levels");
            CAPTURE(told.output);
            const std::size_t pieces = told.output.find(" pieces, ");
            REQUIRE(pieces != std::string::npos);
            CHECK(told.output.find(shapes, pieces) < told.output.find("N/m", pieces));
        }
        check_run(sandbox.run("run ./levels --headless --record r.rec"), 0);
        records.push_back(read_run(sandbox.path("r.rec")));
    }
    CHECK(largest_force_N(records[0]) > 1.0);
    CHECK(largest_force_N(records[0]) <= kLimit_N);
    REQUIRE(records[0].samples.size() == records[1].samples.size());
    for (std::size_t i = 0; i < records[0].samples.size(); ++i) {
        REQUIRE(records[0].samples[i].applied_W.force == records[1].samples[i].applied_W.force);
    }
    for (const char* lesson : {"levels", "fields"}) {
        const ProgramRun run = sandbox.run("test ./" + std::string(lesson));
        INFO(lesson << ": " << run.output);
        CHECK(run.exit_code == 0);
        for (const char* by : {"arm", "mouse", "keyboard"}) {
            CHECK(run.output.find(std::string("passed by ") + by) != std::string::npos);
        }
    }
}

TEST_CASE("tool methods: a god_object's hand feels the texture of a lesson's material") {
    const Sandbox sandbox;
    sandbox.write("rough/lesson.lua", R"lua(
local L = lesson { title = "Rough", id = "rough", minutes = 5 }
function L:start(world)
  world:body { name = "table", model = "box", size = { 0.4, 0.04, 0.4 }, solid = true, visible = true,
               at = { 0, 0.2, 0 }, material = "sandpaper", rounded = true }
  world:hand { centre = { 0, 0.3, 0 },
               tool = { method = "god_object", shape = "capsule", rounded = true } }
end
return L
)lua");
    sandbox.write("rough/stroker.lua", R"lua(
local motion = require "motion"
return motion.play(function()
  motion.start_at { -0.06, 0.35, 0 }
  motion.wait(1)
  motion.move_to({ -0.06, 0.26, 0 }, 1)
  motion.move_to({ 0.06, 0.26, 0 }, 2)
  motion.move_to({ 0.06, 0.35, 0 }, 0.5)
end)
)lua");
    check_run(
        sandbox.run("run ./rough --headless --seconds 5 --hand rough/stroker.lua --record r.rec"),
        0);
    const Record record = read_run(sandbox.path("r.rec"));
    const auto slot = std::ranges::find(record.header.effects, "texture");
    REQUIRE(slot != record.header.effects.end());
    const auto k = static_cast<std::size_t>(slot - record.header.effects.begin());
    double most_N = 0.0;
    for (std::size_t i = 0; i < record.samples.size(); ++i) {
        most_N = std::max(most_N, record.shares_of(i)[k].force.norm());
    }
    CHECK(most_N > 0.05);
    CHECK(record.shares_of(record.samples.size() - 1)[k].force.isZero(0.0));
    CHECK(largest_force_N(record) <= kLimit_N);
}
