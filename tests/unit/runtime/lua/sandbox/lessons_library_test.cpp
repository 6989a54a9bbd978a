#include "tests/unit/runtime/lua/lesson_player.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

/// What the lines print in the first frame of a lesson that recalls `past`.
std::string printed(const std::string& lines, const std::vector<PastAnswers>& past = {},
                    std::uint64_t seed = 1) {
    const LessonFolder folder;
    folder.write(
        "lesson.lua",
        lesson_text("local bank = require 'bank'\nbank.declare(L)\nfunction L:start(world) "
                    "world:recall() end\nlocal done\nfunction L:update(world)\nif done then return "
                    "end\ndone = true\n" +
                    lines + "\nend"));
    LessonProcessOptions options = LessonFolder::options();
    options.seed = seed;
    auto process = LessonProcess::start(folder.files(), options);
    if (!process) {
        return to_sentence(process.error());
    }
    LessonFrame frame = frame_for((*process)->description(), 0.0);
    ReadyEvent ready;
    ready.past = past;
    frame.events = {ready};
    const auto reply = (*process)->exchange(frame);
    if (!reply) {
        return to_sentence(reply.error());
    }
    std::string prints;
    for (const LessonCommand& command : reply->commands) {
        if (const auto* print = std::get_if<PrintCommand>(&command)) {
            prints += print->text + ';';
        }
    }
    return prints;
}

const std::string kChosen =
    "for _, q in ipairs(bank.choose(world, 6)) do print(q.lesson .. '/' .. q.id) end";

std::set<std::string> chosen(const std::vector<PastAnswers>& past, std::uint64_t seed) {
    std::istringstream text(printed(kChosen, past, seed));
    std::set<std::string> names;
    for (std::string name; std::getline(text, name, ';');) {
        names.insert(name);
    }
    return names;
}

// Three questions are asked, and answered as `answers` says; what is told at the end.
std::string told_after(const std::vector<AnsweredEvent>& answers) {
    Player player;
    player.start(R"(
local bank, game = require "bank", require "game"
bank.declare(L)
local questions = {}
for _, q in ipairs(bank.all()) do questions[q.point] = questions[q.point] or q end
function L:start(world)
  game.play(L, world, function()
    for _, point in ipairs { "article", "comparison", "comparison" } do bank.ask(questions[point]) end
    print(select(2, bank.summary()))
  end)
end)");
    std::size_t next = 0;
    for (int frame = 0; frame < 400 && player.prints.empty(); ++frame) {
        std::vector<LessonEvent> events;
        for (const LessonCommand& command : player.last.commands) {
            if (const auto* ask = std::get_if<AskCommand>(&command)) {
                AnsweredEvent event = answers.at(next++);
                event.question = ask->question;
                events.emplace_back(std::move(event));
            }
        }
        player.step(std::move(events));
        REQUIRE(player.error == "");
    }
    return player.prints;
}

AnsweredEvent answered(bool right, bool form_right, bool form_known) {
    AnsweredEvent event{"", "words", {}, true, right, form_right, true, 1};
    event.form_known = form_known;
    return event;
}

/// What the lesson asked for of kind `Command`, in the last frame or in one to come.
template <class Command>
Command wait_for(Player& player) {
    for (int frame = 0; frame < 100; ++frame) {
        for (const LessonCommand& command : player.last.commands) {
            if (const auto* found = std::get_if<Command>(&command)) {
                return *found;
            }
        }
        player.step();
        REQUIRE(player.error == "");
    }
    FAIL("the lesson never asked for it");
    return {};
}

void answer(Player& player, bool right, int attempt, bool over, bool turned_round = false) {
    (void)wait_for<AskCommand>(player);
    AnsweredEvent event{"q", "an apple", {{"thing", "apple"}}, true, right, true, over, attempt};
    event.turned_round = turned_round;
    player.step({event});
    REQUIRE(player.error == "");
}

/// The stars of a game of one point and one question, after so many wrong answers.
int stars_after(int wrong, bool left = false) {
    Player player;
    player.start(game_text("game.point() game.ask 'q'"));
    for (int i = 1; i <= wrong; ++i) {
        answer(player, false, i, left && i == wrong);
    }
    if (!left) {
        answer(player, true, wrong + 1, true);
    }
    return wait_for<FinishCommand>(player).stars;
}

}  // namespace

TEST_CASE("bank: over sixty questions, of every lesson, each complete, with a name of its own") {
    const LessonFolder folder;
    auto process = folder.start(lesson_text("require('bank').declare(L)"));
    INFO((process ? "" : to_sentence(process.error())));
    REQUIRE(process);
    const auto& questions = (*process)->description().questions;
    CHECK(questions.size() >= 60);
    std::set<std::string> prompts;
    std::set<std::string> lessons;
    for (const QuestionDescription& question : questions) {
        INFO(question.id);
        CHECK(prompts.insert(question.prompt).second);
        lessons.insert(question.id.substr(0, question.id.find('_')));
        CHECK_FALSE(question.again.empty());
        CHECK_FALSE(question.examples.right.empty());
        CHECK_FALSE(question.examples.wrong.empty());
        CHECK_FALSE(question.examples.form.empty());
    }
    CHECK(lessons ==
          std::set<std::string>{"gravity", "kite", "lever", "solar", "stacks", "textures"});
    CHECK(printed("for _, q in ipairs(bank.all()) do assert(#q.like > 0 and q.point and q.idea and "
                  "q.hint and "
                  "q.solution, q.id) end print 'all'") == "all;");
}

TEST_CASE("bank: only lessons that were played are asked about, and all where none was") {
    std::set<std::string> lessons;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const auto names = chosen({{"lever", "near_far", 2, 1, 0, 3.0, {}}}, seed);
        REQUIRE(names.size() == 6);
        for (const std::string& name : names) {
            CHECK(name.starts_with("lever/"));
        }
        for (const std::string& name : chosen({}, seed)) {
            lessons.insert(name.substr(0, name.find('/')));
        }
    }
    CHECK(lessons.size() >= 5);
}

// 1 - p is 0 for what was right a moment ago many times, 1 for what was never met.
TEST_CASE("bank: what was got wrong or has not been heard for long comes first") {
    const auto times_asked = [](const PastAnswers& last) {
        int n = 0;
        for (std::uint64_t seed = 1; seed <= 40; ++seed) {
            n += static_cast<int>(chosen({{"lever", "near_far", 1, 1, 0, 1.0, {}}, last}, seed)
                                      .count("lever/lever_torque"));
        }
        return n;
    };
    const int known = times_asked({"maze-park", "lever_torque", 6, 6, 0, 0.1, {}});
    const int forgotten = times_asked({"maze-park", "lever_torque", 6, 6, 0, 400.0, {}});
    const int wrong = times_asked({"maze-park", "lever_torque", 3, 0, 3, 0.1, {}});
    CHECK(known < 10);
    CHECK(forgotten > known + 5);
    CHECK(wrong > known + 5);
}

TEST_CASE("bank: well said is only what was heard with its form") {
    const auto told = [](const AnsweredEvent& one, const AnsweredEvent& two,
                         const AnsweredEvent& three) {
        return told_after({one, two, three});
    };
    const AnsweredEvent good = answered(true, true, true);
    const AnsweredEvent slip = answered(true, false, true);
    const AnsweredEvent unheard = answered(true, false, false);
    CHECK(told(good, slip, good) == "Well said: articles 1 of 1, comparing 1 of 2.;");
    CHECK(told(answered(false, true, true), slip, slip) ==
          "Well said: articles 0 of 1, comparing 0 of 2.;");
    CHECK(told(unheard, slip, unheard) == "Well said: comparing 0 of 1.;");
    CHECK(told(unheard, unheard, unheard) == "Your grammar was not marked this time.;");
}

TEST_CASE("bank: the same seed asks the same, another something else") {
    CHECK(chosen({}, 3) == chosen({}, 3));
    CHECK(chosen({}, 3) != chosen({}, 4));
}

TEST_CASE("bank: what cannot be is one sentence at the lesson's line") {
    CHECK(printed("bank.choose(world, 1000)").find("takes a number of questions from 1 to") !=
          std::string::npos);
    CHECK(printed("bank.ask(5)").find("takes a question that bank.choose gave; got 5") !=
          std::string::npos);
    CHECK(printed("bank.chose(world, 1)").find("choose") != std::string::npos);
}

TEST_CASE("game: stars follow from the points that could be had, one less for each wrong try") {
    CHECK(stars_after(0) == 3);        // 4 of 4
    CHECK(stars_after(1) == 2);        // 3 of 4, three quarters
    CHECK(stars_after(2) == 1);        // 2 of 4
    CHECK(stars_after(9) == 1);        // never less than a point
    CHECK(stars_after(3, true) == 1);  // left: none
}

TEST_CASE("game: a point that was missed counts among those that could be had") {
    Player player;
    player.start(game_text("game.point() game.miss()"));
    CHECK(wait_for<FinishCommand>(player).stars == 1);
    Player better;
    better.start(game_text("game.point(3) game.miss()"));
    CHECK(wait_for<FinishCommand>(better).stars == 2);
}

TEST_CASE("game: after a wrong answer comes the hint, then the hand feels again, then it asks") {
    Player player;
    player.start(game_text(R"(
    local last = game.ask("q", { hint = "Look!", again = function(a) print("again", a.attempt) end })
    print("left", last.right))"));
    answer(player, false, 1, false);
    CHECK(wait_for<CaptionCommand>(player).text == "Look!");
    CHECK(player.prints.empty());  // the hint is read first
    (void)wait_for<AskCommand>(player);
    CHECK(player.prints == "again\t1;");
    answer(player, false, 2, false, true);  // turned round: only to be said
    answer(player, true, 3, true);
    CHECK(wait_for<CaptionCommand>(player).text == "");
    CHECK(player.prints == "again\t1;left\ttrue;");
}

TEST_CASE("game: when the last try was wrong too, the right answer is told") {
    Player player;
    player.start(game_text(R"(
    game.ask("q", { solution = "It is an apple." })
    game.ask("q", { solution = function() return "It is " .. 1 + 1 .. "." end }))"));
    answer(player, false, 4, true);
    CHECK(wait_for<CaptionCommand>(player).text == "It is an apple.");
    answer(player, false, 4, true);
    CHECK(wait_for<CaptionCommand>(player).text == "It is 2.");
    Player right;
    right.start(game_text("game.ask('q', { solution = 'It is an apple.' })"));
    answer(right, true, 1, true);
    CHECK(wait_for<CaptionCommand>(right).text == "");
}

TEST_CASE("game: the space bar plays again, with no points") {
    Player player;
    player.start(game_text("print('round', round) game.point(round)"));
    CHECK(wait_for<CaptionCommand>(player).text == "Points: 1 of 1.");
    player.step({KeyEvent{"space"}});
    CHECK(wait_for<FinishCommand>(player).stars == 3);
    CHECK(player.prints == "round\t1;round\t2;");
}
