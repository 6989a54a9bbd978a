// What fulcrum check finds in a lesson whose parts are right one by one: its functions are called as a play would call them.
#include "tests/lessons/program.h"

using namespace fulcrum::test;

namespace {

// A lesson that asks two questions of an egg and a rock; `fields` belong to the second.
std::string lesson_with(const std::string& fields, const std::string& more = "") {
    return R"(local game = require "game"
local L = lesson { id = "x", title = "X" }
local before
L:question "first" {
  prompt = "Which one is heavier?", again = "Lift them again.",
  answers = { "the {thing} is <comparative:heavy>" }, right = function(a) return a.thing == "egg" end,
}
L:question "second" {
  prompt = "How does it feel?", again = "Feel it again.", )" +
           fields + R"(
}
function L:start(world)
  world:body { name = "egg", model = "sphere", solid = true, visible = true, material = "rubber" }
  world:body { name = "rock", model = "sphere", solid = true, visible = true, material = "rock", at = { 0.2, 0, 0 } }
  game.play(L, world, function()
    game.ask("first", { again = function(answer) )" +
           more + R"( end })
    before = 3
    game.ask "second"
  end)
end
)";
}

const std::string kGood =
    "answers = { \"it is <adjective:{feel}>\" }, lists = { feel = { \"hard\", \"soft\" } }, ";
const std::string kRight = "right = function(a) return a.feel == \"soft\" end";

ProgramRun check(const std::string& text) {
    const Sandbox sandbox;
    sandbox.write("x/lesson.lua", text + "return L\n");
    return sandbox.run("check x");
}

}  // namespace

TEST_CASE("check: a good lesson has nothing to tell") {
    const ProgramRun run = check(lesson_with(kGood + kRight));
    CHECK(run.output == "x: no mistakes found.\n");
    CHECK(run.exit_code == 0);
}

TEST_CASE("check: `right` of each question is tried with all it can be asked, when it is asked") {
    struct {
        std::string right, found;
    } const rows[] = {
        {"right = function(a) return a.feel == softt end",
         "lesson.lua:9: question \"second\", tried with \"It is hard.\": softt has no value"},
        {"right = function(a) if a.feel == \"soft\" then return before.x end end",
         "lesson.lua:9: question \"second\", tried with \"It is soft.\": attempt to index a number "
         "value"},
        {"right = function(a) while true do end end",
         "tried with \"It is hard.\": this ran for too long"},
        {"right = function(a) return a.fel == \"soft\" end", "did you mean answer.feel?"},
    };
    for (const auto& row : rows) {
        std::string text = lesson_with(kGood + row.right);
        const ProgramRun run = check(text);
        INFO(run.output);
        check_run(run, 1, {row.found});
        CHECK(run.output.find("lesson.lua:9: question \"second\", tried with \"It is") == 0);
    }
    // What is there by the time the question is asked is no mistake.
    CHECK(
        check(lesson_with(kGood +
                          "right = function(a) return before + 1 == 4 and a.feel == \"soft\" end"))
            .exit_code == 0);
}

TEST_CASE("check: a question to which nothing is right is told; one that never comes is tried") {
    const ProgramRun never =
        check(lesson_with(kGood + "right = function(a) return a.feel == \"sotf\" end"));
    INFO(never.output);
    check_run(never, 0,
              {"question \"second\": nothing that its sentences can mean is right, "
               "\"It is hard.\" neither"});
    CHECK(never.output.ends_with("x: it can be played, but see the sentence above.\n"));
    std::string unasked = lesson_with(kGood + "right = function(a) return a.feel == sfot end");
    unasked.replace(unasked.find("game.ask \"second\""), 17, "world:finish { stars = 3 } ");
    check_run(check(unasked), 0,
              {"question \"second\": nothing asks it",
               "question \"second\", tried with \"It is hard.\": sfot has no value",
               "the play did not come to it"});
}

TEST_CASE("check: a question whose own sentence is too long to be understood is told") {
    std::string words = "it is";
    for (int i = 1; i < 24; ++i) {
        words += " b" + std::to_string(i);
    }
    const std::string asked =
        lesson_with("answers = { \"" + words + "\" }, right = function(a) return true end");
    std::string unasked = asked;
    unasked.replace(unasked.find("game.ask \"second\""), 17, "world:finish { stars = 3 } ");
    for (const std::string& text : {asked, unasked}) {
        check_run(check(text), 0,
                  {"lesson.lua:8: question \"second\": nobody can answer this question"});
    }
}

TEST_CASE("check: help that says what is right is told, help that leaves a choice is not") {
    const std::string lists = "lists = { feel = { \"hard\", \"rough\" } }, ";
    check_run(check(lesson_with("answers = { \"it is soft\", \"it is {feel}\" }, " + lists +
                                "right = function(a) return a.feel == nil end")),
              0,
              {"lesson.lua:8: question \"second\": who asks for help is told what is "
               "right, \"It is soft.\"; let the first of `answers` have a list"});
    // The same sentence where it is wrong, and two sentences of which each names its own word.
    for (const char* fields : {"right = function(a) return a.feel == \"hard\" end",
                               "right = function(a) return a.one ~= nil end"}) {
        const bool apart = std::string(fields).find("one") != std::string::npos;
        check_run(
            check(lesson_with(
                (apart
                     ? "answers = { \"it is {one} outside\", \"it is {feel}\" }, lists = { one = { "
                       "\"soft\" }, feel = { \"hard\", \"rough\" } }, "
                     : "answers = { \"it is soft\", \"it is {feel}\" }, " + lists) +
                fields)),
            {}, {}, {"who asks for help"});
    }
}

TEST_CASE("check: what comes after a wrong answer, of a key and of a touch is called as well") {
    struct {
        std::string text, found;
    } const rows[] = {
        {lesson_with(kGood + kRight, "answer.thing.x.y = 1"),
         "attempt to index a nil value (field 'x')"},
        {lesson_with(kGood + kRight) +
             "function L:key(name) if name == \"up\" then print(name + 1) end end\n",
         "when the key \"up\" is pressed: attempt to add"},
        {lesson_with(kGood + kRight) + "function L:touched(body) print(body.nam) end\n",
         "when \"egg\" is touched: body has no \"nam\"; did you mean \"name\"?"},
        {lesson_with(kGood + kRight) + "function L:answered(answer) print(answer.atempt) end\n",
         "did you mean answer.attempt?"},
    };
    for (const auto& row : rows) {
        const ProgramRun run = check(row.text);
        INFO(run.output);
        check_run(run, 1, {row.found});
        CHECK(run.output.find("lesson.lua:") == 0);
    }
}

TEST_CASE("check: what a learner may ask is named where its function fails") {
    check_run(check(lesson_with(kGood + kRight) +
                    "L:knows \"home\" { asked = { \"where does the {animal} live\" }, "
                    "lists = { animal = { \"fish\", \"bird\" } },\n"
                    "  answer = function(asked) return \"In the \" .. ({ fish = "
                    "\"sea\" })[asked.animal] end }\n"),
              1,
              {"what the lesson knows as \"home\", asked \"Where does the bird live?\": attempt "
               "to concatenate a nil value",
               "the table has nothing under the name that is looked for"});
}

TEST_CASE("check: sentences that the program would say back are looked over as a learner's") {
    const auto told = [](const std::string& answers, const std::string& found) {
        check_run(check(lesson_with("answers = { " + answers +
                                    " }, lists = { feel = { \"hard\", \"soft\" } }, " + kRight)),
                  0, {found});
    };
    told("\"it feel <adjective:{feel}>\"",
         "answer 1: \"It feel hard.\" is no good English; better is \"It feels hard.\"");
    told("\"it is is <adjective:{feel}>\"", "\"It is is hard.\" has \"is\" twice");
    told("\"it is <adjective:{feel}>\", \"it is more <comparative:{feel}>\"",
         "answer 2: \"It is more harder.\"");
    told("\"the rock is <superlative:{feel}>\"", "better is \"The rock is the hardest.\"");
}

TEST_CASE("check: what is shown, hinted, solved, said of things and answered is looked over") {
    std::string lesson =
        lesson_with(kGood + kRight, "world:caption(\"The \" .. \"egg are here.\") story.wait(1)");
    const auto put = [&](const std::string& before, const std::string& text) {
        const std::size_t at = lesson.find(before);
        REQUIRE(at != std::string::npos);
        lesson.insert(at + before.size(), text);
    };
    put("local game = require \"game\"", " local story = require \"story\"");
    put("material = \"rubber\"", ", about = \"It are an egg.\"");
    put("game.ask \"second\"",
        "\n    if world.time < 0 then world:caption \"It have a shell.\" end\n"
        "    game.ask(\"second\", { hint = \"An rock is hard.\", solution = function() return \"It "
        "feel soft.\" end })");
    check_run(
        check(lesson + "L:knows \"sky\" { asked = { \"what colour is the sky\" },\n"
                       "answer = function() return \"It are blue.\" end }\n"),
        0,
        {"lesson.lua:12: \"It are an egg.\" is no good English; better is \"It is an egg.\".",
         "lesson.lua:15: \"The egg are here.\" is no good English; better is \"The egg is "
         "here.\".",
         "lesson.lua:18: \"It have a shell.\" is no good English; better is \"It has a shell.\".",
         "lesson.lua:19: \"An rock is hard.\" is no good English; better is \"A rock is hard.\".",
         "lesson.lua:19: \"It feel soft.\" is no good English; better is \"It feels soft.\".",
         "lesson.lua:23: what the lesson knows as \"sky\": \"It are blue.\" is no good English; "
         "better is \"It is blue.\"."});
}

TEST_CASE("check: what keeps a lesson from being tested is said once, not for each player") {
    for (const std::string& end :
         {std::string("return L\n"), std::string("return 3\n"), std::string("retrun L\n")}) {
        const Sandbox sandbox;
        sandbox.write("x/lesson.lua", lesson_with(kGood + kRight) + end);
        const ProgramRun run = sandbox.run("test x");
        INFO(run.output);
        CHECK(run.exit_code == 1);
        CHECK(std::count(run.output.begin(), run.output.end(), '\n') == 1);
    }
}

TEST_CASE("check: a file that is no UTF-8 text is one sentence") {
    const std::string text = lesson_with(kGood + kRight) + "return L\n";
    std::string wide = "\xFF\xFE";
    std::string big_endian;
    for (const char letter : text) {
        wide += {letter, '\0'};
        big_endian += {'\0', letter};
    }
    struct {
        std::string bytes, found;
    } const rows[] = {{wide, "lesson.lua: this is saved as UTF-16, not as UTF-8; save it again"},
                      {big_endian, "this is saved as UTF-16"},
                      {"{\\rtf1\\ansi " + text, "this is a document of a word processor"},
                      {"PK\x03\x04 and so on", "this is a document of a word processor"}};
    for (const auto& row : rows) {
        const Sandbox sandbox;
        sandbox.write("x/lesson.lua", row.bytes);
        const ProgramRun run = sandbox.run("check x");
        INFO(run.output);
        CHECK(run.exit_code != 0);
        CHECK(run.output.find(row.found) != std::string::npos);
        CHECK(std::count(run.output.begin(), run.output.end(), '\n') == 1);
    }
}

TEST_CASE("check: what was found is told again until something changes, or it is asked for anew") {
    const Sandbox sandbox;
    const std::string note = "lesson.lua:8: question \"second\": ";
    const std::string text =
        lesson_with(kGood + "right = function(a) return a.feel == \"sotf\" end") + "return L\n";
    sandbox.write("x/lesson.lua", text);
    const ProgramRun first = sandbox.run("check x");
    check_run(first, 0, {note}, {"nothing has changed"});
    const auto is_told_again = [&](const ProgramRun& run) {
        return run.exit_code == 0 &&
               run.output.starts_with(first.output + "This was found on 20") &&
               run.output.ends_with(
                   ", and nothing has changed since; to look anew, add --again.\n");
    };
    const ProgramRun second = sandbox.run("check x");
    INFO(second.output);
    CHECK(is_told_again(second));
    CHECK(sandbox.run("check x --again").output == first.output);
    // Ended in the middle it keeps nothing, and what is kept stays.
    const ProgramRun ended = sandbox.run("check x --again", "timeout -s INT 0.2");
    check_run(ended, {}, {}, {"another scene"});
    CHECK(is_told_again(sandbox.run("check x")));
    CHECK(sandbox.run("check x --force-limit 2").output == first.output);
    sandbox.write("x/lesson.lua", "-- mended\n" + text);
    check_run(sandbox.run("check x"), 0, {"lesson.lua:9: question"}, {"nothing has changed"});
    // What fails is looked at each time, and leaves nothing behind.
    sandbox.write("x/lesson.lua", text + "x = ");
    for (int i = 0; i < 2; ++i) {
        check_run(sandbox.run("check x"), 1, {"lesson.lua:"}, {"nothing has changed"});
    }
    sandbox.write("x/lesson.lua", "-- mended\n" + text);
    check_run(sandbox.run("check x"), 0, {"nothing has changed"});
}
