// What starts with a lesson: beside what every lesson has, the stages that it asks for and no other, whatever else the library knows.
#include "tests/lessons/program.h"

using namespace fulcrum::test;

namespace {

using Stages = std::set<std::string>;

const Stages kEvery{"take inputs", "read", "estimate", "passivity", "limits", "write",
                    "publish",     "lua",  "dialogue", "scene",     "mixer",  "free English"};
// What is touched with a fingertip.
const Stages kTouch{"proxy", "forces: coupling", "forces: texture", "touch"};

const std::map<std::string, Stages> kAsked{
    {"gravity", {"forces: weight", "falling bodies", "bucket"}},
    {"textures", {"forces: weight", "falling bodies", "forces: transient", "forces: spring"}},
    {"solar-system", {"forces: weight", "falling bodies", "turning"}},
    {"lever", {"forces: weight", "falling bodies", "turning", "tool"}},
    {"kite", {"forces: weight", "falling bodies", "forces: line", "flight"}},
    {"stacks", {"rigid bodies", "pushing", "forces: transient"}},
    {"maze-park", {"forces: weight", "falling bodies", "forces: transient", "forces: spring"}},
};
const Stages kTouched{"textures", "solar-system", "stacks", "maze-park"};

Stages find_stages(const std::string& json) {
    const std::string key = "\"stage\": \"";
    Stages stages;
    for (auto at = json.find(key); at != std::string::npos; at = json.find(key, at + 1)) {
        const auto begin = at + key.size();
        stages.insert(json.substr(begin, json.find('"', begin) - begin));
    }
    return stages;
}

std::string list(const Stages& stages) {
    std::string text;
    for (const std::string& stage : stages) {
        text += stage + "; ";
    }
    return text;
}

}  // namespace

TEST_CASE("stages: each lesson starts what it asks for and nothing else") {
    const Sandbox sandbox;
    for (const auto& [lesson, asked] : kAsked) {
        Stages expected = kEvery;
        expected.insert(asked.begin(), asked.end());
        if (kTouched.contains(lesson)) {
            expected.insert(kTouch.begin(), kTouch.end());
        }
        const ProgramRun run = sandbox.run("explain " + lesson + " --json");
        REQUIRE(run.exit_code == 0);
        INFO(lesson);
        CHECK(list(find_stages(run.output)) == list(expected));
    }
}

TEST_CASE("stages: what costs time when it is played is what was said before") {
    const Sandbox sandbox;
    for (const char* lesson : {"gravity", "lever", "kite"}) {
        const ProgramRun told = sandbox.run(std::string("explain ") + lesson + " --json");
        const ProgramRun played =
            sandbox.run(std::string("explain ") + lesson + " --analyze --json --seconds 2");
        INFO(lesson << played.output);
        REQUIRE(played.exit_code == 0);
        CHECK(list(find_stages(told.output)) == list(find_stages(played.output)));
    }
}

TEST_CASE(
    "stages: each knob of each lesson says what it leaves at the device, or why nobody knows") {
    const std::map<std::string, Stages> knobs{
        {"gravity", {"rounds of", "velocity by", "the brake", "steps of"}},
        {"kite", {"rounds of", "velocity by", "the brake", "segments of the line", "steps of"}},
        {"lever", {"rounds of", "velocity by", "the brake", "points of the tool", "iterations of"}},
        {"maze-park", {"rounds of", "velocity by", "the brake", "rounds of the friction cone"}},
        {"solar-system", {"rounds of", "velocity by", "the brake", "the relief's law"}},
        {"stacks", {"rounds of", "velocity by", "the brake", "steps of", "solver within"}},
        {"textures", {"rounds of", "velocity by", "the brake", "points of a relief", "facets of"}}};
    const Sandbox sandbox;
    const auto find_rows = [&](const std::string& lesson) {
        const ProgramRun run =
            sandbox.run("explain " + lesson + " --analyze --headless --seconds 3");
        INFO(lesson << run.output);
        REQUIRE(run.exit_code == 0);
        const std::size_t table = run.output.find("What each knob leaves at the device");
        REQUIRE(table != std::string::npos);
        return run.output.substr(table);
    };
    REQUIRE(knobs.size() == kAsked.size());
    for (const auto& [lesson, expected] : knobs) {
        const std::string rows = find_rows(lesson);
        INFO(rows);
        for (const std::string& knob : expected) {
            const std::size_t row = rows.find(" " + knob);
            INFO(knob);
            REQUIRE(row != std::string::npos);
            const std::string text = rows.substr(row, rows.find('\n', row) - row);
            CHECK((text.find(" N; ") != std::string::npos) !=
                  (text.find("no reference: ") != std::string::npos));
        }
        CHECK(rows.find("could not be repeated") == std::string::npos);
        CHECK(rows == find_rows(lesson));
    }
}
