// scripts/lib/game.lua, run in a lesson as teachers use it.
#include "tests/unit/runtime/lua/lesson_player.h"

#include <catch2/catch.hpp>

#include <string>

namespace fulcrum::runtime {
namespace {

using test::lesson_text;
using test::LessonFolder;
using test::Player;

/// A lesson that plays `tell` as a game.
std::string game_text(const std::string& tell) {
    return R"(
local game = require "game"
local story = require "story"
L:question "q" { prompt = "?", answers = { "{thing}" }, right = function(a) return true end }
function L:start(world)
  world:body { name = "apple" }
  game.play(L, world, function(round)
)" + tell + "\n  end)\nend";
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
    CHECK(wait_for<FinishCommand>(player).stars == 3);
    player.step({KeyEvent{"space"}});
    CHECK(wait_for<FinishCommand>(player).stars == 3);
    CHECK(player.prints == "round\t1;round\t2;");
}

TEST_CASE("game: what it is given wrong is told at the lesson's line") {
    const auto sentence = [](const std::string& line) {
        Player player;
        player.start(game_text(line));
        for (int frame = 0; frame < 20 && player.error.empty(); ++frame) {
            player.step();
        }
        return player.error;
    };
    CHECK(sentence("game.point(0.5)") ==
          "lesson.lua:9: game.point takes a whole number of points, 1 or more; got 0.5.");
    CHECK(sentence("game.ask('q', 'Look!')") ==
          "lesson.lua:9: game.ask's options are a table, such as { hint = \"Look again.\" }; got "
          "the text \"Look!\".");
    CHECK(sentence("game.ask('q', { hnt = 'Look!' })") ==
          "lesson.lua:9: game.ask has no hnt; did you mean hint?");
    CHECK(sentence("game.ask('q', { again = 'Look!' })") ==
          "lesson.lua:9: game.ask's again is a function; got the text \"Look!\".");
    CHECK(sentence("game.points()") == "lesson.lua:9: game has no points; did you mean point?");
    CHECK(sentence("game.ask 'nothing'") == "lesson.lua:9: there is no question \"nothing\".");
}

TEST_CASE("game: points and questions belong inside a game") {
    const LessonFolder folder;
    const auto sentence = [&](const std::string& line) {
        auto process = folder.start(
            lesson_text("local game = require 'game'\nfunction L:start(world)\n" + line + "\nend"));
        return process ? std::string("started") : to_sentence(process.error());
    };
    CHECK(sentence("game.point()") ==
          "lesson.lua:4: game.point belongs inside game.play(L, world, function() … end).");
    CHECK(sentence("game.ask 'q'") ==
          "lesson.lua:4: game.ask belongs inside game.play(L, world, function() … end).");
    CHECK(sentence("game.play(function() end)") ==
          "lesson.lua:4: write game.play(L, world, function() … end).");
}

}  // namespace fulcrum::runtime
