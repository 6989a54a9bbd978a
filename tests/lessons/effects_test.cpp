// Small lessons of one effect each: what is felt is what the law says.
#include "tests/lessons/program.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace fulcrum::test;

namespace {
constexpr const char* kTouch = FULCRUM_TEST_LESSONS "/touch";
constexpr const char* kTool = FULCRUM_TEST_LESSONS "/tool";
constexpr const char* kForces = FULCRUM_TEST_LESSONS "/forces";
}  // namespace

TEST_CASE("touch: a ball pressed from above pushes back along its normal, stiffness times depth") {
    const Sandbox sandbox;
    check_run(sandbox.run(std::string("run ") + kTouch + " --headless --hand " + kTouch +
                          "/press.lua --seconds 6 --record r.rec"),
              0, {"touched ball", "released ball"});
    const Record record = read_run(sandbox.path("r.rec"));
    // Held still at 3.5 s: the hand (300 N/m) and the ball (500 N/m) share 15 mm: F = 0.015 / (1/300 + 1/500).
    // The mesh is flat between its corners by at most 0.1 mm, worth 0.02 N here.
    const RecordSample& held = sample_at(record, 3.5);
    CHECK(held.applied_W.force.y() == Approx(0.015 / (1.0 / 300.0 + 1.0 / 500.0)).margin(0.03));
    CHECK(std::abs(held.applied_W.force.x()) < 0.1);
    // Free space before and after.
    CHECK(sample_at(record, 0.4).applied_W.force.norm() < 1e-9);
    CHECK(sample_at(record, 5.9).applied_W.force.norm() < 1e-9);
}

namespace {

// A ball that rings so, pressed from above; the rounds from the first in which it is felt.
std::vector<RecordSample> press_ringing_ball(const std::string& tap) {
    const Sandbox sandbox;
    sandbox.write(
        "tap/lesson.lua",
        "local L = lesson { id = \"tap\", title = \"A ball\", level = \"A1\", minutes = 1 }\n"
        "function L:start(world)\n"
        "  world:hand { centre = { 0, 0.5, 0 } }\n"
        "  local m = world:material { name = \"m\", stiffness = 500, damping = 2, tap = { " +
            tap +
            " } }\n"
            "  world:body { name = \"ball\", model = \"sphere\", radius = 0.1, solid = true, "
            "material = m, at = { 0, 0.3, 0 } }\n"
            "end\n"
            "return L\n");
    check_run(sandbox.run(std::string("run tap --headless --hand ") + kTouch +
                          "/press.lua --seconds 3 --record r.rec"),
              0);
    const Record record = read_run(sandbox.path("r.rec"));
    const auto touched = std::ranges::find_if(record.samples, [](const RecordSample& sample) {
        return sample.commanded_W.force.y() > 0.0;
    });
    return {touched, record.samples.end()};
}

}  // namespace

TEST_CASE("touch: each kind of tap, by its name, is felt as its law says") {
    const auto still = press_ringing_ball("kind = \"none\"");
    REQUIRE(still.size() > 100);
    const double speed_m_per_s = -still.front().twist_W.linear.y();
    REQUIRE(speed_m_per_s > 0.05);
    // Beside what the same ball is without a tap, so many rounds on.
    const auto added_N = [&](const std::vector<RecordSample>& rounds, std::size_t i) {
        return rounds[i].commanded_W.force.y() - still[i].commanded_W.force.y();
    };
    const auto pulse = press_ringing_ball("kind = \"fixed_pulse\", strength = 5, length = 0.02");
    for (const std::size_t round : {3U, 10U, 17U}) {
        CHECK(added_N(pulse, round) == Approx(5.0 * speed_m_per_s).epsilon(0.2));
    }
    CHECK(std::abs(added_N(pulse, 40)) < speed_m_per_s);
    // A period of 20 ms: up, and down, and weaker.
    for (const char* tap : {"frequency = 50, time = 0.02, strength = 10",
                            "kind = \"acceleration_matching\", frequency = 50, time = 0.02, "
                            "acceleration = 100"}) {
        CAPTURE(tap);
        const auto ringing = press_ringing_ball(tap);
        CHECK(added_N(ringing, 5) > speed_m_per_s);
        CHECK(added_N(ringing, 15) < -0.5 * speed_m_per_s);
        CHECK(std::abs(added_N(ringing, 80)) < 0.3 * added_N(ringing, 5));
    }
}

TEST_CASE("touch: explain shows the proxy with the line that asked for it, and no world") {
    const Sandbox sandbox;
    check_run(sandbox.run(std::string("explain ") + kTouch), {}, {"proxy", "lesson.lua:6"},
              {"forces: weight", "falling bodies"});
}

TEST_CASE("tool: a stick lies flat on a table with force, and turned there with torque") {
    const Sandbox sandbox;
    const ProgramRun run = sandbox.run(std::string("run ") + kTool + " --headless --hand " + kTool +
                                       "/turn.lua --seconds 7 --record r.rec");
    INFO(run.output);
    check_run(run, 0, {"touched table"});
    const Record record = read_run(sandbox.path("r.rec"));
    CHECK(sample_at(record, 0.4).applied_W.force.norm() < 1e-9);
    // Flat at 3.8 s: hand (300 N/m) and coupling (500 N/m) share the 10 mm that the stick's half width is too high by, and the
    // springs of its points, 5 N for the tool's clamp, give way by little.
    const RecordSample& flat = sample_at(record, 3.8);
    const double force_N = 0.01 / (1.0 / 300.0 + 1.0 / 500.0);
    CHECK(flat.applied_W.force.y() == Approx(force_N).epsilon(0.1));
    CHECK(flat.applied_W.force.y() < force_N);
    CHECK(flat.applied_W.torque.norm() < 1e-3);
    // Turned by 6 degrees, hand (3 Nm/rad) and coupling (0.5 Nm/rad) share the angle, for the stick still lies flat.
    const RecordSample& turned = sample_at(record, 6.5);
    const double torque_Nm = 6.0 * M_PI / 180.0 / (1.0 / 3.0 + 1.0 / 0.5);
    CHECK(turned.applied_W.torque.z() == Approx(torque_Nm).epsilon(0.05));
    CHECK(turned.applied_W.torque.z() < torque_Nm);
    CHECK(run.output.find("turned 8") != std::string::npos);
}

TEST_CASE("forces: a force the lesson computes is felt as its law says, between its answers too") {
    const Sandbox sandbox;
    check_run(sandbox.run(std::string("run ") + kForces + " --headless --hand " + kForces +
                          "/away.lua --seconds 6 --record r.rec"),
              0);
    const Record record = read_run(sandbox.path("r.rec"));
    // At rest: the hand's spring (300 N/m) against the lesson's (50 N/m) over 4 cm.
    const RecordSample& held = sample_at(record, 5.5);
    CHECK(held.applied_W.force.x() == Approx(-0.04 / (1.0 / 300.0 + 1.0 / 50.0)).margin(0.01));
    // The torque of the law arrives at the device, and turns the hand's 3 Nm/rad.
    const double torque_Nm = 2.0 * held.pose_D.position.x();
    CHECK(torque_Nm > 0.05);
    CHECK(held.applied_W.torque.y() == Approx(torque_Nm).margin(1e-3));
    CHECK(AngleAxis(held.pose_D.orientation).angle() == Approx(torque_Nm / 3.0).margin(1e-3));
    // While moving the linearisation keeps the 1 kHz force on the law, though Lua runs at 60 Hz.
    for (const RecordSample& sample : record.samples) {
        if (sample.time_s > 3.0) {
            const double law_N = -50.0 * sample.pose_D.position.x();
            REQUIRE(std::abs(sample.commanded_W.force.x() - law_N -
                             -1.0 * sample.twist_W.linear.x()) < 0.02);
            REQUIRE(std::abs(sample.commanded_W.torque.y() - 2.0 * sample.pose_D.position.x()) <
                    1e-3);
        }
    }
}

namespace {

// The lesson of this id that a page shows.
std::string lesson_shown(const std::string& page, const std::string& id) {
    const std::string text = bytes_of(FULCRUM_TEST_LESSONS "/../../" + page);
    const std::string kBegin = "```lua\n";
    const std::size_t at = text.find("lesson { id = \"" + id + "\"");
    REQUIRE(at != std::string::npos);
    const std::size_t begin = text.rfind(kBegin, at);
    REQUIRE(begin != std::string::npos);
    return text.substr(begin + kBegin.size(), text.find("```", at) - begin - kBegin.size());
}

}  // namespace

TEST_CASE("lessons: those that README and docs/teach.md begin with run as they stand there") {
    for (const char* page : {"README.md", "docs/teach.md"}) {
        INFO(page);
        const Sandbox sandbox;
        sandbox.write("stone/lesson.lua", lesson_shown(page, "stone"));
        check_run(sandbox.run("check stone"), 0);
        check_run(sandbox.run("run stone --headless"), 0, {"stone: finished"});
    }
    const std::string shown = lesson_shown("README.md", "stone");
    CHECK(std::count(shown.begin(), shown.end(), '\n') == 10);
}

TEST_CASE("lessons: the one with a question in docs/teach.md has no mistakes and passes its test") {
    const Sandbox sandbox;
    sandbox.write("heavier/lesson.lua", lesson_shown("docs/teach.md", "heavier"));
    const ProgramRun check = sandbox.run("check heavier");
    INFO(check.output);
    CHECK(check.output == "heavier: no mistakes found.\n");
    check_run(sandbox.run("test heavier"), 0);
}

TEST_CASE("explain --analyze: each haptic stage of the plan is called in each round, no other") {
    const Sandbox sandbox;
    const ProgramRun run =
        sandbox.run(std::string("explain ") + kTouch + " --analyze --headless --seconds 4 --hand " +
                    kTouch + "/press.lua");
    INFO(run.output);
    REQUIRE(run.exit_code == 0);
    const auto costs = run.output.substr(run.output.find("Played 4.0 s"));
    for (const char* stage : {"take inputs", "read", "estimate", "proxy", "forces: coupling",
                              "passivity", "limits", "write", "publish"}) {
        const std::size_t line = costs.find(std::string("haptic   ") + stage);
        INFO(stage);
        REQUIRE(line != std::string::npos);
        CHECK(costs.find(" 4000 ", line) < costs.find('\n', line));
    }
    CHECK(costs.find("forces: weight") == std::string::npos);
    CHECK(costs.find("world ") == std::string::npos);
    CHECK(costs.find("velocity, rms") != std::string::npos);
    // The lesson prints; that would be in the way of the figures.
    CHECK(run.output.find("touched ball") == std::string::npos);
}

TEST_CASE("explain: what belongs to a play is refused without one; a hand that rests is told of") {
    const Sandbox sandbox;
    check_run(sandbox.run(std::string("explain ") + kTouch + " --seconds 3"), 2, {"add --analyze"});
    check_run(sandbox.run(std::string("explain ") + kTouch + " --analyze --headless --seconds 1"),
              0, {"The hand stayed where it was"});
    const ProgramRun full = sandbox.run(std::string("explain ") + kTouch + " --json > /dev/full");
    CHECK(full.exit_code == 2);
}

TEST_CASE("explain --json: one object, with the figures when it was played") {
    const Sandbox sandbox;
    const ProgramRun run =
        sandbox.run(std::string("explain ") + kForces +
                    " --analyze --json --headless --seconds 1 --hand " + kForces + "/away.lua");
    INFO(run.output);
    REQUIRE(run.exit_code == 0);
    CHECK(run.output.front() == '{');
    check_says(run.output, {"\"stage\": \"forces: lesson\"", "\"calls\": 1000",
                            "\"what\": \"answers of 60 Hz\""});
}

namespace {

/// What explain says that a stage of a lesson of these bodies takes, bytes.
long memory_of(const Sandbox& sandbox, const std::string& stage, const std::string& bodies) {
    sandbox.write("solids/lesson.lua",
                  "local L = lesson { id = \"solids\", title = \"T\", level = \"A1\" }\n"
                  "local function thing(world, name, model)\n"
                  "  world:body { name = name, model = model, solid = true,\n"
                  "               material = \"sandpaper\", at = { 0, 0.2, 0 } }\n"
                  "end\n"
                  "function L:start(world)\n" +
                      bodies + "\nend\nreturn L\n");
    const ProgramRun run = sandbox.run("explain solids --json");
    INFO(run.output);
    REQUIRE(run.exit_code == 0);
    const std::size_t at = run.output.find("\"stage\": \"" + stage + '"');
    REQUIRE(at != std::string::npos);
    const std::string field = "\"memory_bytes\": ";
    return std::stol(run.output.substr(run.output.find(field, at) + field.size()));
}

}  // namespace

TEST_CASE("solids: bodies of one model share its mesh, and those of one material its relief") {
    const Sandbox sandbox;
    const char* one = "thing(world, \"a\", \"apple\")";
    const char* same =
        "thing(world, \"a\", \"apple\") thing(world, \"b\", \"apple\") thing(world, \"c\", "
        "\"apple\")";
    const char* other = "thing(world, \"a\", \"apple\") thing(world, \"b\", \"egg\")";
    const long mesh = memory_of(sandbox, "proxy", one);
    CHECK(memory_of(sandbox, "proxy", same) == mesh);
    CHECK(2 * memory_of(sandbox, "proxy", other) > 3 * mesh);
    const auto relief = static_cast<double>(memory_of(sandbox, "forces: texture", one));
    CHECK(static_cast<double>(memory_of(sandbox, "forces: texture", same)) < 1.2 * relief);
}

TEST_CASE("tool: a flat face pressed on a box is felt alike by either method, with many points") {
    const Sandbox sandbox;
    sandbox.write("press.lua",
                  "local motion = require 'motion'\n"
                  "return motion.play(function()\n"
                  "  motion.start_at { 0.01, 0.45, 0.01 }\n"
                  "  motion.move_to({ 0.01, 0.34, 0.01 }, 0.8)\n"
                  "end)\n");
    for (const char* how : {"", "method = 'voxel_sampling'", "points = 50000"}) {
        sandbox.write("lesson.lua",
                      std::string("local L = lesson { id = 'face', title = 'A face' }\n"
                                  "function L:start(world)\n"
                                  "  world:body { name = 'floor', model = 'box', radius = 0.05, "
                                  "at = { 0, 0.25, 0 }, solid = true }\n"
                                  "  world:hand { tool = { shape = 'cylinder', ") +
                          how + " } }\nend\nreturn L\n");
        const ProgramRun run =
            sandbox.run("run " + sandbox.path("lesson.lua") + " --headless --hand " +
                        sandbox.path("press.lua") + " --seconds 2 --record r.rec");
        INFO(how << "\n" << run.output);
        REQUIRE(run.exit_code == 0);
        // Hand (300 N/m) and coupling (500 N/m) share 10 mm, or with voxels up to a layer of 0.6 mm more.
        const double force_N = sample_at(read_run(sandbox.path("r.rec")), 1.9).applied_W.force.y();
        CHECK(force_N > 1.8);
        CHECK(force_N < 10.6e-3 / (1.0 / 300.0 + 1.0 / 500.0));
    }
}
