// Pupils who never find the answer, or are never understood: they are helped, and nobody is left without it.
#include "tests/lessons/program.h"

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
    check_run(play("gravity", times(4, "the egg is heavier") + times(4, "the egg is the heaviest") +
                                  times(4, "the egg is the heaviest") +
                                  times(4, "the apple is the lightest")),
              0,
              {"shows    The apple is heavier.", "shows    The apple is the heaviest.",
               "shows    The watermelon is the heaviest.", "shows    The egg is the lightest."});
    check_run(play("lever", times(4, "near") + times(4, "to my hand") + times(4, "1000 newtons")),
              0,
              {"shows    It is easier far from the support", "shows    It must go to the Earth",
               "shows    You need 1 newton"});
}

TEST_CASE("answers: textures tell what is right, read off the materials") {
    check_run(play("textures", times(4, "metal is soft") + "wood is hard\nrock is hard\n" +
                                   times(4, "it is wood") + "metal\n" +
                                   times(4, "it is made of rock") + "wood\nrock\n"),
              0,
              {"shows    Metal is hard and smooth.", "shows    It is rock.",
               "shows    The spaceship is made of metal."});
}

TEST_CASE("answers: nonsense gets hints of words, never of dots or of leftovers") {
    check_run(play("solar-system",
                   times(3, "bla") + times(4, "nine") + "one\n" + times(4, "three") +
                       times(3, "bla") + "How many moons Saturn has?\n" + times(3, "bla") +
                       times(4, "near the pole") + times(3, "bla") + times(4, "the Earth")),
              0,
              {"Please say it like this: There are … planets.", "shows    There are eight planets.",
               "shows    Mars has two moons.", "For example: How many moons does Mercury have?",
               "Good question! We say: *How many moons does Saturn have*?",
               "Please say it like this: It turns more at …", "You can say: the side or the pole.",
               "shows    It turns more at the side", "Please say it like this: … is harder.",
               "You can say: the Earth or Jupiter.", "shows    Jupiter is harder to turn"},
              {"like this: …\n", "or have"});
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
    check_run(sandbox.run("test two"), 1, {told + ".\n"});
    check_run(sandbox.run("run two --headless"), 1,
              {told + ", or give --say a file with one answer a line."});
}

TEST_CASE("answers: a failed test names what was marked wrong, and what nobody knows fails it") {
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
    check_run(
        tested(
            "L:test { say = { 'it is an apple', 'hm', 'it is an egg' }, expect = { stars = 3 } }"),
        1,
        {"lesson.lua:11: the answer \"it is an apple\" was marked wrong.",
         "lesson.lua:11: the answer \"hm\" was not understood."},
        {"\"it is an egg\""});
    check_run(tested("L:test { say = { '?what colour is the sea', '?what colour is the sky', 'it "
                     "is an egg' }, "
                     "expect = { finished = true } }"),
              1,
              {"lesson.lua:11: the test asks \"what colour is the sea\", and the lesson "
               "knows nothing that this asks for"},
              {"colour is the sky\", and"});
    CHECK(tested("L:test { say = { 'it is an apple', '?what colour is the sky', 'it is an egg' }, "
                 "expect = { finished = true } }")
              .exit_code == 0);
}
