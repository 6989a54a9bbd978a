#include "dialogue/marking/feedback_ladder.h"

#include <catch2/catch.hpp>

#include <rapidcheck.h>

using namespace fulcrum::dialogue;

TEST_CASE("feedback ladder: names are read in order, and each step has one") {
    const auto ladder = read_ladder({"rule", "recast", "replay", "prompt", "prompt"});
    REQUIRE(ladder);
    CHECK(*ladder == FeedbackLadder{FeedbackStep::rule, FeedbackStep::recast, FeedbackStep::replay,
                                    FeedbackStep::prompt, FeedbackStep::prompt});
    for (const FeedbackStep step : *ladder) {
        CHECK(read_ladder({std::string(name_of(step))}) == FeedbackLadder{step});
    }
}

TEST_CASE("feedback ladder: nonsense is one sentence that says what there is") {
    const auto refused = [](const std::vector<std::string>& names) {
        const auto ladder = read_ladder(names);
        REQUIRE_FALSE(ladder);
        return ladder.error().message;
    };
    CHECK(refused({}) ==
          "a ladder of feedback has a step at least; steps are recast, prompt, rule and replay");
    CHECK(refused({"recast", "recats"}) ==
          "there is no step of feedback \"recats\"; did you mean \"recast\"?");
    CHECK(refused({"Rules"}) == "there is no step of feedback \"Rules\"; did you mean \"rule\"?");
    CHECK(refused({"shout"}) ==
          "there is no step of feedback \"shout\"; steps are recast, prompt, rule and replay");
    CHECK(refused(std::vector<std::string>(kLongestLadder + 1, "rule")) ==
          "a ladder of feedback has at most 8 steps; got 9");
    CHECK(read_ladder(std::vector<std::string>(kLongestLadder, "rule")));
    CHECK_FALSE(read_ladder({""}));
}

TEST_CASE("feedback ladder: a text of steps is read and written") {
    for (const char* text : {"recast", "recast,prompt,rule", "rule,rule,replay"}) {
        const auto ladder = read_ladder_text(text);
        REQUIRE(ladder);
        CHECK(ladder_text(*ladder) == text);
    }
    for (const char* text : {"", ",", "recast,", "recast, rule", "rule;recast"}) {
        INFO(text);
        CHECK_FALSE(read_ladder_text(text));
    }
    CHECK(ladder_text({}).empty());
}

TEST_CASE("feedback ladder: each sighting has a step, and the last one stays") {
    CHECK(step_at({}, 1) == FeedbackStep::recast);
    CHECK(step_at({}, 2) == FeedbackStep::prompt);
    CHECK(step_at({}, 99) == FeedbackStep::rule);
    CHECK(step_at({FeedbackStep::rule}, 0) == FeedbackStep::rule);
    CHECK(step_at({FeedbackStep::rule, FeedbackStep::recast}, -7) == FeedbackStep::rule);
    CHECK(rc::check("within the ladder its own, behind its end the last", [] {
        const auto steps =
            *rc::gen::nonEmpty(rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 4)));
        FeedbackLadder ladder;
        for (const int step : steps) {
            ladder.push_back(static_cast<FeedbackStep>(step));
        }
        const int sighting = *rc::gen::inRange(1, 20);
        const std::size_t at = static_cast<std::size_t>(sighting - 1);
        RC_ASSERT(step_at(ladder, sighting) == (at < ladder.size() ? ladder[at] : ladder.back()));
    }));
}
