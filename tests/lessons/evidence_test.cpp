// A record is evidence: repeated it gives every force again to the bit, and where it does not, it says where first and why.
#include "haptics/base/processor.h"
#include "haptics/device/replay/recorded_traits.h"
#include "tests/lessons/program.h"

#include <bit>
#include <nlohmann/json.hpp>

using namespace fulcrum::test;

namespace {

constexpr const char* kTool = FULCRUM_TEST_LESSONS "/tool";

void check_repeats(const Sandbox& sandbox, const std::string& lesson, const std::string& seconds,
                   const std::string& hand = {}) {
    INFO(lesson);
    const ProgramRun run = sandbox.run("run " + lesson + " --headless --seconds " + seconds +
                                       " --record a.rec " + hand);
    INFO(run.output);
    REQUIRE(run.exit_code == 0);
    const Record record = read_run(sandbox.path("a.rec"));
    CHECK(largest_force_N(record) > 0.1);
    check_run(sandbox.run("run " + lesson + " --headless --hand replay:a.rec"), 0,
              {"All forces are the record's, bit for bit, in " +
               std::to_string(record.samples.size()) + " rounds."});
}

// The first round of which the share of an effect is not the same, found without the program.
std::size_t first_other_share(const Record& a, const Record& b, std::size_t effect) {
    for (std::size_t i = 0; i < std::min(a.samples.size(), b.samples.size()); ++i) {
        if (a.shares_of(i)[effect].force != b.shares_of(i)[effect].force) {
            return i;
        }
    }
    return a.samples.size();
}

}  // namespace

TEST_CASE("evidence: weight, textures, kite, lever, blocks and maze with its keys repeat bitwise") {
    const Sandbox sandbox;
    check_repeats(sandbox, "gravity", "12");
    // Its header, and not a round.
    sandbox.write("cut.rec", bytes_of(sandbox.path("a.rec")).substr(0, 5000));
    check_run(sandbox.run("run gravity --headless --hand replay:cut.rec"), 1,
              {"the record holds no round of the hand: the record is cut off"});
    check_repeats(sandbox, "textures", "6");
    check_repeats(sandbox, "kite", "4");
    check_repeats(sandbox, "lever", "5");
    check_repeats(sandbox, "stacks", "8");
    check_repeats(sandbox, FULCRUM_EXAMPLES "/two-fingers", "8");
    const std::string two = FULCRUM_EXAMPLES "/two-fingers";
    const std::string other_reach =
        "--scale 1.2 --hand " + two + "/right.lua --hand " + two + "/left.lua --scale 1.5";
    check_repeats(sandbox, two, "8", other_reach);
    check_repeats(sandbox, "maze-park", "8", "--seed 7");
}

TEST_CASE("evidence: a tool with force and torque repeats to the bit") {
    const Sandbox sandbox;
    check_repeats(sandbox, kTool, "5", std::string("--hand ") + kTool + "/turn.lua");
    const Record record = read_run(sandbox.path("a.rec"));
    CHECK(record.header.effects == std::vector<std::string>{"tool", "tool damping", "brake"});
    CHECK(std::ranges::any_of(record.samples, [](const RecordSample& sample) {
        return sample.applied_W.torque.norm() > 0.01;
    }));
}

TEST_CASE("evidence: a run is repeated with the ladder of feedback it had, whoever repeats it") {
    const Sandbox sandbox;
    const auto ladder_of = [&](const std::string& arguments) {
        const std::string command =
            "run gravity --headless --seconds 2 --record b.rec " + arguments;
        CAPTURE(command);
        REQUIRE(sandbox.run(command).exit_code == 0);
        return std::string(
            find_fact(read_run(sandbox.path("b.rec")).header, "option.feedback").value_or("none"));
    };
    CHECK(ladder_of("") == "lesson");
    sandbox.write("say.txt", "the apple\n");
    const std::string mina = "--learner Mina --say say.txt";
    CHECK(ladder_of(mina + " --feedback rule,recast") == "rule,recast");
    CHECK(ladder_of(mina) == "rule,recast");  // kept
    REQUIRE(sandbox.run("run gravity --headless --seconds 2 --record a.rec " + mina).exit_code ==
            0);
    CHECK(ladder_of("--hand replay:a.rec") == "rule,recast");
    CHECK(ladder_of("--hand replay:a.rec --feedback prompt") == "prompt");
    // Neither does a learner's own come into a run that had the lesson's.
    REQUIRE(sandbox.run("run gravity --headless --seconds 2 --record a.rec").exit_code == 0);
    CHECK(ladder_of(mina + " --hand replay:a.rec") == "lesson");
}

TEST_CASE("evidence: a record says what the run was made with, and what happened in it") {
    const Sandbox sandbox;
    REQUIRE(
        sandbox.run("run gravity --headless --seconds 12 --seed 3 --force-limit 4 --record a.rec")
            .exit_code == 0);
    const Record record = read_run(sandbox.path("a.rec"));
    const auto fact = [&](const char* name) {
        return std::string(find_fact(record.header, name).value_or("nothing"));
    };
    CHECK(fact("program.version") == "0.1.0");
    CHECK(fact("program.build").size() >= 32);
    CHECK(fact("program.kernels") == name_kernels());
    CHECK(fact("lesson.lesson.lua").size() == 64);
    CHECK(fact("lesson.lib/story.lua").size() == 64);
    CHECK(fact("asset.models/apple.glb").size() == 64);
    CHECK(fact("option.seed") == "3");
    CHECK(fact("option.clock") == "virtual");
    CHECK(fact("device.name") == "simulated hand");
    CHECK(fact("limit.site N") == "4");
    CHECK(fact("workspace.scale") == "2");
    CHECK(fact("plan.weight of apple N") != "nothing");
    CHECK(record.header.max_force_N == 4.0);
    CHECK(record.header.effects == std::vector<std::string>{"weight", "brake"});
    REQUIRE(record.header.bodies.size() > 2);
    const auto has_event = [&](RecordEventKind kind, const std::string& text) {
        return std::ranges::any_of(record.events, [&](const RecordEvent& event) {
            return event.kind == kind && event.text.find(text) != std::string::npos;
        });
    };
    CHECK(has_event(RecordEventKind::gate, "rising"));
    CHECK(has_event(RecordEventKind::gate, "open"));
    CHECK(has_event(RecordEventKind::dropped, ""));
    CHECK(has_event(RecordEventKind::said, "shows"));
    CHECK(has_event(RecordEventKind::answered, ""));
    // What is carried goes with the hand.
    CHECK(std::ranges::any_of(
        record.bodies, [](const RecordBody& body) { return body.state.where == BodyWhere::held; }));
    // Together the shares are what was commanded.
    for (std::size_t i = 0; i < record.samples.size(); i += 97) {
        const Vector3 sum_W = record.shares_of(i)[0].force + record.shares_of(i)[1].force;
        REQUIRE((sum_W - record.samples[i].commanded_W.force).norm() < 1e-12);
    }
}

TEST_CASE("evidence: another mass is told at the round and the effect where it is felt first") {
    const Sandbox sandbox;
    std::filesystem::copy(FULCRUM_SCENARIOS "/gravity", sandbox.path("mine"),
                          std::filesystem::copy_options::recursive);
    REQUIRE(sandbox.run("run mine --headless --seconds 8 --record a.rec").exit_code == 0);
    std::string text = bytes_of(sandbox.path("mine/lesson.lua"));
    const std::string mass = "mass = 0.2039";
    REQUIRE(text.find(mass) != std::string::npos);
    text.replace(text.find(mass), mass.size(), "mass = 0.2040");
    sandbox.write("mine/lesson.lua", text);
    const ProgramRun run = sandbox.run("run mine --headless --hand replay:a.rec --record b.rec");
    INFO(run.output);
    CHECK(run.exit_code == 3);
    const Record a = read_run(sandbox.path("a.rec"));
    const Record b = read_run(sandbox.path("b.rec"));
    const std::size_t first = first_other_share(a, b, 0);
    REQUIRE(first < a.samples.size());
    check_says(run.output, {"(round " + std::to_string(a.samples[first].tick) +
                                ") the share of weight is the first thing that differs",
                            "Likely why: the lesson's files have changed (lesson.lua)."});
}

TEST_CASE("evidence: another seed, another limit and another lesson are told for what they are") {
    const Sandbox sandbox;
    REQUIRE(sandbox.run("run maze-park --headless --seconds 6 --record a.rec").exit_code == 0);
    check_run(sandbox.run("run maze-park --headless --seed 9 --hand replay:a.rec"), 3,
              {"options differ (seed is 9 and was 1)"});
    REQUIRE(sandbox.run("run gravity --headless --seconds 8 --record b.rec").exit_code == 0);
    check_run(sandbox.run("run gravity --headless --force-limit 2 --hand replay:b.rec"), 3,
              {"limits differ (site N is 2 and was 5"});
    check_run(sandbox.run("run gravity --headless --seconds 1 --hand replay:a.rec"), 0,
              {"of the lesson \"maze-park\", so its forces are not compared"});
}

TEST_CASE("evidence: explain --force --json of a record of two hands is one document") {
    const Sandbox sandbox;
    const std::string play = "run " FULCRUM_EXAMPLES "/two-fingers --headless --seconds 4";
    REQUIRE(sandbox.run(play + " --record two.rec").exit_code == 0);
    const ProgramRun told = sandbox.run("explain --force 3 two.rec --json");
    INFO(told.output);
    CHECK(told.exit_code == 0);
    const auto json = nlohmann::json::parse(told.output, nullptr, false);
    REQUIRE_FALSE(json.is_discarded());
    CHECK(json["lesson"] == "two-fingers");
    REQUIRE(json["hands"].size() == 2);
    const Record record = read_run(sandbox.path("two.rec"));
    const auto second = find_hand(record, 1);
    REQUIRE(second);
    CHECK(json["hands"][0]["felt"]["force_N"][1].get<double>() ==
          sample_at(record, 3.0).applied_W.force.y());
    CHECK(json["hands"][1]["felt"]["force_N"][1].get<double>() ==
          sample_at(*second, 3.0).applied_W.force.y());
}

TEST_CASE("evidence: explain --force accounts for a force, export writes it to the bit") {
    const Sandbox sandbox;
    REQUIRE(sandbox.run("run gravity --headless --seconds 12 --record a.rec").exit_code == 0);
    const Record record = read_run(sandbox.path("a.rec"));
    // The most that was felt is a weight.
    const auto strongest = std::ranges::max_element(
        record.samples, {}, [](const auto& sample) { return sample.applied_W.force.norm(); });
    check_run(
        sandbox.run("explain --force " + std::to_string(strongest->time_s + 0.0001) + " a.rec"), 0,
        {"(round " + std::to_string(strongest->tick) + ")", "N down", "weight"});
    const auto json =
        nlohmann::json::parse(sandbox.run("explain a.rec --force 3 --json").output, nullptr, false);
    REQUIRE_FALSE(json.is_discarded());
    REQUIRE(json["hands"].size() == 1);
    CHECK(json["hands"][0].contains("taken_by_gate"));
    const ProgramRun late = sandbox.run("explain --force 99 a.rec");
    CHECK(late.exit_code == 2);
    CHECK(late.output.find("a.rec: the record has no round at 99 s; give --force a time from 0 to "
                           "11.999.") == 0);
    CHECK(sandbox.run("explain --force 1").exit_code == 2);
    CHECK(sandbox.run("explain --force 1 --analyze a.rec").exit_code == 2);
    CHECK(sandbox.run("explain --force 1 nowhere.rec").exit_code == 2);

    check_run(sandbox.run("export a.rec"), 0);
    const std::string rows = bytes_of(sandbox.path("a.csv"));
    CHECK(static_cast<std::size_t>(std::ranges::count(rows, '\n')) == record.samples.size() + 1);
    CHECK(bytes_of(sandbox.path("a.facts.csv")).find("option.seed,1") != std::string::npos);
    CHECK(bytes_of(sandbox.path("a.events.csv")).find(",gate,,rising") != std::string::npos);
    CHECK(bytes_of(sandbox.path("a.bodies.csv")).find(",held,") != std::string::npos);
    sandbox.write("bad.rec", "no record");
    const ProgramRun bad = sandbox.run("export bad.rec");
    CHECK(bad.exit_code == 2);
    CHECK(bad.output.find("bad.rec: this is no Fulcrum record") == 0);
    CHECK_FALSE(std::filesystem::exists(sandbox.path("bad.csv")));
    CHECK(sandbox.run("export a.rec --out a.rec").exit_code == 2);
    CHECK(sandbox.run("export a.rec --out /no/such/folder/x.csv").exit_code == 2);
    CHECK(sandbox.run("export").exit_code == 2);
    CHECK(read_run(sandbox.path("a.rec")).samples.size() == record.samples.size());
}
