// The maze park, played to its end by its own simulated hand, by the arrow keys and by a hand that leads.
#include "tests/lessons/program.h"

using namespace fulcrum::test;

namespace {

std::vector<std::string> lines_with(const std::string& text, const std::string& words) {
    std::vector<std::string> found;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.find(words) != std::string::npos) {
            found.push_back(line.substr(line.find(words)));
        }
    }
    return found;
}

std::string play(const Sandbox& sandbox, const std::string& arguments) {
    const ProgramRun run = sandbox.run("run maze-park --headless " + arguments);
    INFO(run.output);
    check_run(run, 0, {"finished after"});
    return run.output;
}

}  // namespace

TEST_CASE("maze park: each of six dead ends has a question of its own; the end tells how it went") {
    const Sandbox sandbox;
    const std::string told = play(sandbox, "");
    CHECK(lines_with(told, "A dead end!").size() == 6);
    const auto asked = lines_with(told, "asks  ");
    CHECK(std::set<std::string>(asked.begin(), asked.end()).size() == 6);
    CHECK(lines_with(told, "The gate is open").size() == 1);
    REQUIRE(lines_with(told, "You know: ").size() == 1);
    REQUIRE(lines_with(told, "Well said: ").size() == 1);
    CHECK(lines_with(told, "You know: ").front().find(" of ") != std::string::npos);
    // Three lines of the picture, so that nothing is cut.
    CHECK(lines_with(told, "You know: ").front().size() < 150);
    CHECK(lines_with(told, "Well said: ").front().size() < 150);
}

TEST_CASE("maze park: another seed has another way and other questions") {
    const Sandbox sandbox;
    const auto asked = [&](const std::string& seed) {
        return lines_with(play(sandbox, "--seed " + seed), "asks  ");
    };
    CHECK(asked("11") != asked("12"));
    CHECK(asked("11") == asked("11"));
}

TEST_CASE("maze park: nobody stays blocked, however often the learner errs") {
    const Sandbox sandbox;
    for (const char* errors : {"0", "0.5", "0.9"}) {
        for (const char* seed : {"1", "2", "3"}) {
            const ProgramRun run = sandbox.run(std::string("test maze-park --by arm --errors ") +
                                               errors + " --seed " + seed);
            INFO(errors << ' ' << seed << ": " << run.output);
            CHECK(run.exit_code == 0);
        }
    }
}

TEST_CASE("maze park: who never finds the words is held, helped, and let go on") {
    const Sandbox sandbox;
    std::string nothing;
    for (int i = 0; i < 100; ++i) {
        nothing += "blah blah\n";
    }
    sandbox.write("say.txt", nothing);
    const std::string told = play(sandbox, "--say say.txt");
    CHECK(lines_with(told, "You may go on.").size() == 6);
    CHECK(told.find("0 of 3 stars") == std::string::npos);
}

TEST_CASE("maze park: the way is free after as many wrong answers as the lesson says") {
    const std::string folder = FULCRUM_TEST_LESSONS "/../../scenarios/maze-park/";
    for (const int tries : {1, 3}) {
        const Sandbox sandbox;
        std::string lesson = bytes_of(folder + "lesson.lua");
        for (const auto& [from, to] :
             {std::pair("tries = 4", "tries = " + std::to_string(tries)),
              std::pair("learner = { wrong = 0.2, form = 0.3, unclear = 0.1 }",
                        std::string("learner = { wrong = 1 }"))}) {
            const std::size_t at = lesson.find(from);
            REQUIRE(at != std::string::npos);
            lesson.replace(at, std::string_view(from).size(), to);
        }
        sandbox.write("maze/lesson.lua", lesson);
        sandbox.write("maze/gardener.lua", bytes_of(folder + "gardener.lua"));
        const ProgramRun run = sandbox.run("run maze --headless");
        INFO(run.output);
        CHECK(run.exit_code == 0);
        CHECK(lines_with(run.output, "(wrong").size() == static_cast<std::size_t>(6 * tries));
        CHECK(lines_with(run.output, "You may go on.").size() == 6);
    }
}

TEST_CASE("maze park: while a question is open no key walks on") {
    const Sandbox sandbox;
    // Nobody answers: the walker stays in the first dead end, whatever is pressed.
    sandbox.write("hand.lua",
                  "local motion = require 'motion'\n"
                  "local turns = { 'right', 'down', 'left', 'up' }\n"
                  "return motion.play(function(world)\n"
                  "  local walker, held = world:find 'walker', nil\n"
                  "  for i = 1, 400 do\n"
                  "    motion.key(turns[math.random(4)])\n"
                  "    motion.wait(0.25)\n"
                  "    print(('walker %.2f %.2f'):format(walker.x, walker.z))\n"
                  "  end\nend)\n");
    sandbox.write("say.txt", "\n# nothing\nblah\n");
    const ProgramRun run =
        sandbox.run("run maze-park --headless --seconds 100 --hand hand.lua --say say.txt");
    INFO(run.output);
    const std::size_t asked = run.output.find("asks  ");
    REQUIRE(asked != std::string::npos);
    const auto places = lines_with(run.output.substr(asked), "walker ");
    REQUIRE(places.size() > 20);
    CHECK(std::set<std::string>(places.begin(), places.end()).size() == 1);
}

TEST_CASE("maze park: a hand that leads feels the hedges and is held in a dead end") {
    const Sandbox sandbox;
    REQUIRE(sandbox.run("run maze-park --headless --record r.rec").exit_code == 0);
    const Record record = read_run(sandbox.path("r.rec"));
    CHECK(largest_force_N(record) > 0.5);
    CHECK(largest_force_N(record) <= 5.0 + 1e-9);
}

TEST_CASE("maze park: what was wrong in another lesson is asked, nothing of one never played") {
    const Sandbox sandbox;
    sandbox.write("say.txt",
                  "it is easier near the support\nit is easier near the support\n"
                  "it is easier near the support\nit is easier near the support\n");
    (void)sandbox.run("run lever --headless --learner Mina --db p.db --say say.txt --seconds 60");
    const std::string told = play(sandbox, "--learner Mina --db p.db --errors 0 --seed 5");
    const auto asked = lines_with(told, "asks  ");
    REQUIRE(asked.size() == 6);
    for (const std::string& question : asked) {
        INFO(question);
        CHECK(std::ranges::any_of(
            std::vector<std::string>{"lever", "force", "door", "support", "seesaw", "Archimedes",
                                     "newtons", "Give me a place"},
            [&](const std::string& word) { return question.find(word) != std::string::npos; }));
    }
    // The program keeps what is answered here like any other lesson's answers.
    const std::string report = sandbox.run("report --learner Mina --db p.db").output;
    CHECK(report.find("maze-park") != std::string::npos);
    CHECK(report.find("lever_") != std::string::npos);
}
