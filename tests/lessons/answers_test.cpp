// Pupils who never find the answer, or are never understood: they are helped, and nobody is left without it.
#include "tests/lessons/program.h"

#include <catch2/catch.hpp>

#include <string>

using namespace fulcrum;
using namespace fulcrum::test;

namespace {

ProgramRun play(const std::string& lesson, const std::string& answers) {
    const Sandbox sandbox;
    sandbox.write("say.txt", answers);
    return sandbox.run("run " + lesson + " --headless --say say.txt");
}

std::string times(int n, const std::string& line) {
    std::string lines;
    for (int i = 0; i < n; ++i) {
        lines += line + '\n';
    }
    return lines;
}

}  // namespace

TEST_CASE("answers: after the last wrong try every lesson tells what is right") {
    const ProgramRun gravity = play(
        "gravity", times(4, "the egg is heavier") + times(4, "the egg is the heaviest") +
                       times(4, "the egg is the heaviest") + times(4, "the apple is the lightest"));
    INFO(gravity.output);
    CHECK(gravity.exit_code == 0);
    for (const char* told :
         {"shows    The apple is heavier.", "shows    The apple is the heaviest.",
          "shows    The watermelon is the heaviest.", "shows    The egg is the lightest."}) {
        CHECK_THAT(gravity.output, Catch::Contains(told));
    }
    const ProgramRun lever =
        play("lever", times(4, "near") + times(4, "to my hand") + times(4, "1000 newtons"));
    INFO(lever.output);
    CHECK(lever.exit_code == 0);
    for (const char* told : {"shows    It is easier far from the support",
                             "shows    It must go to the Earth", "shows    You need 1 newton"}) {
        CHECK_THAT(lever.output, Catch::Contains(told));
    }
}

TEST_CASE("answers: textures tell what is right, read off the materials") {
    const ProgramRun run =
        play("textures", times(4, "metal is soft") + "wood is hard\nrock is hard\n" +
                             times(4, "it is wood") + "metal\n" + times(4, "it is made of rock") +
                             "wood\nrock\n");
    INFO(run.output);
    CHECK(run.exit_code == 0);
    for (const char* told : {"shows    Metal is hard and smooth.", "shows    It is rock.",
                             "shows    The spaceship is made of metal."}) {
        CHECK_THAT(run.output, Catch::Contains(told));
    }
}

TEST_CASE("answers: nonsense gets hints of words, never of dots or of leftovers") {
    const ProgramRun run = play(
        "solar-system", times(3, "bla") + times(4, "nine") + "one\n" + times(4, "three") +
                            times(3, "bla") + "How many moons Saturn has?\n" + times(3, "bla") +
                            times(4, "near the pole") + times(3, "bla") + times(4, "the Earth"));
    INFO(run.output);
    CHECK(run.exit_code == 0);
    for (const char* told :
         {"Please say it like this: There are … planets.", "shows    There are eight planets.",
          "shows    Mars has two moons.", "For example: How many moons does Mercury have?",
          "Good question! We say: *How many moons does Saturn have*?",
          "Please say it like this: It turns more at …", "You can say: the side or the pole.",
          "shows    It turns more at the side", "Please say it like this: … is harder.",
          "You can say: the Earth or Jupiter.", "shows    Jupiter is harder to turn"}) {
        CHECK_THAT(run.output, Catch::Contains(told));
    }
    CHECK(run.output.find("like this: …\n") == std::string::npos);
    CHECK(run.output.find("or have") == std::string::npos);
}

TEST_CASE("answers: a test whose say is too short says so, and where, not to give --say") {
    const Sandbox sandbox;
    sandbox.write(
        "two/lesson.lua",
        "local L = lesson { id = \"two\", title = \"Two\", minutes = 1 }\n"
        "L:question \"q\" { prompt = \"?\", answers = { \"yes\" }, right = function() return "
        "true end }\n"
        "local w function L:start(world) w = world w:ask \"q\" end\n"
        "function L:answered() w:ask \"q\" end\n"
        "L:test { say = { \"yes\" }, expect = { finished = true } }\nreturn L\n");
    const std::string told =
        "lesson.lua:5: the lesson asked, and say of L:test has no answer left (1 in all); add "
        "answers to it";
    const ProgramRun test = sandbox.run("test two");
    INFO(test.output);
    CHECK(test.exit_code == 1);
    CHECK_THAT(test.output, Catch::Contains(told + ".\n"));
    const ProgramRun run = sandbox.run("run two --headless");
    INFO(run.output);
    CHECK(run.exit_code == 1);
    CHECK_THAT(run.output,
               Catch::Contains(told + ", or give --say a file with one answer a line."));
}

TEST_CASE(
    "answers: a test that fails names the answers that were marked wrong, and what nobody knows "
    "fails it") {
    const auto tested = [](const std::string& test) {
        const Sandbox sandbox;
        sandbox.write("x/lesson.lua", R"(local game = require "game"
local L = lesson { id = "x", title = "X" }
L:knows "sky" { asked = { "what colour is the sky" }, answer = function() return "It is blue." end }
L:question "egg" {
  prompt = "What is it?", again = "Look.", answers = { "it is <article> {food}" }, lists = { food = { "egg", "apple" } },
  right = function(a) return a.food == "egg" end,
}
function L:start(world)
  game.play(L, world, function() game.ask "egg" end)
end
)" + test + "\nreturn L\n");
        return sandbox.run("test x --by arm");
    };
    const ProgramRun wrong = tested(
        "L:test { say = { 'it is an apple', 'hm', 'it is an egg' }, expect = { stars = 3 } }");
    INFO(wrong.output);
    CHECK(wrong.exit_code == 1);
    CHECK(wrong.output.find("lesson.lua:11: the answer \"it is an apple\" was marked wrong.") !=
          std::string::npos);
    CHECK(wrong.output.find("lesson.lua:11: the answer \"hm\" was not understood.") !=
          std::string::npos);
    CHECK(wrong.output.find("\"it is an egg\"") == std::string::npos);
    const ProgramRun asks = tested(
        "L:test { say = { '?what colour is the sea', '?what colour is the sky', 'it is an egg' }, "
        "expect = { finished = true } }");
    INFO(asks.output);
    CHECK(asks.exit_code == 1);
    CHECK(
        asks.output.find("lesson.lua:11: the test asks \"what colour is the sea\", and the lesson "
                         "knows nothing that this asks for") != std::string::npos);
    CHECK(asks.output.find("colour is the sky\", and") == std::string::npos);
    CHECK(tested("L:test { say = { 'it is an apple', '?what colour is the sky', 'it is an egg' }, "
                 "expect = { finished = true } }")
              .exit_code == 0);
}
