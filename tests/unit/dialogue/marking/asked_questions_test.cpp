#include "dialogue/english/antonyms.h"
#include "dialogue/marking/feedback_ladder.h"
#include "dialogue/marking/grammar_point.h"
#include "dialogue/marking/question.h"
#include "dialogue/marking/question_review.h"
#include "tests/support/english_words.h"
#include "tests/unit/dialogue/questions.h"
#include "tests/unit/dialogue/rig.h"

#include <rapidcheck.h>

using namespace fulcrum::dialogue;

namespace {

Opposites opposites() {
    const auto antonyms = std::make_shared<Expected<Antonyms>>(Antonyms::open());
    REQUIRE(*antonyms);
    return [antonyms](std::string_view word) { return (*antonyms)->of(word); };
}

}  // namespace

TEST_CASE("question: compiles, and keeps what its author wrote") {
    const Question question =
        compiled({"q", "What is it?", {"it is big", "it is small"}, {}, {}, {}, "Feel it again."});
    CHECK(question.templates->answers == 2);
    CHECK(question.id == "q");
    CHECK(question.prompt == "What is it?");
    CHECK(question.again == "Feel it again.");
}

TEST_CASE("question: errors name the question, the answer and the column") {
    const auto no_list = compile_question({"q", "What?", {"it is big", "the {thing} is big"}});
    REQUIRE_FALSE(no_list);
    CHECK(no_list.error().message ==
          "question \"q\", answer 2: there is no list \"thing\"; the lists are: none");
    CHECK(no_list.error().column == 5);
    CHECK_FALSE(compile_question({"", "What?", {"it"}}));
    CHECK_FALSE(compile_question({"q", "", {"it"}}));
    CHECK_FALSE(compile_question({"q", "What?", {}}));
}

TEST_CASE("question review: opposites that the author means to be alike are not told") {
    const Question question = compiled({"q", "?", {"the {thing} (pushes|pulls) it up"}, fruit()});
    CHECK(review_question(question, opposites()).size() == 1);
    CHECK(review_question(question, opposites(), {"The egg pushes it up.", "The egg pulls it up."})
              .empty());
    CHECK(review_question(question, opposites(), {"The egg pushing it", "the egg pullses it"})
              .size() == 1);
}

TEST_CASE("question review: what is said back, of each answer") {
    const auto all = said_back(
        compiled({"q", "Which one?", {"the {thing} is big", "it is the {thing} [here]"}, fruit()}));
    CHECK(std::ranges::any_of(all, [](const SaidBack& one) {
        return one.answer == 0 && one.sentence == "The egg is big.";
    }));
    CHECK(std::ranges::any_of(all, [](const SaidBack& one) {
        return one.answer == 1 && one.sentence == "It is the egg.";
    }));
}

TEST_CASE("question review: words that cannot be heard, each once") {
    const auto words = unheard_words(heaviest(), [](std::string_view word) {
        return word != "watermelon" && word != "heaviest";
    });
    CHECK(words == std::vector<std::string>{"watermelon", "heaviest"});
    CHECK(unheard_words(heaviest(), [](std::string_view) { return true; }).empty());
}

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

TEST_CASE("grammar point: every one has a name of its own, and the catalogue a text") {
    const Catalogue words = english_words();
    std::set<std::string_view> ids;
    for (std::size_t i = 0; i < kGrammarPointIds.size(); ++i) {
        const std::string_view id = grammar_point_id(static_cast<GrammarPoint>(i));
        CHECK(ids.insert(id).second);
        CHECK(words.has("point." + std::string(id)));
    }
    for (int code = 1; code < kErrorCodes; ++code) {
        FormError error;
        error.code = static_cast<ErrorCode>(code);
        CHECK(ids.count(grammar_point_id(grammar_point(error))) == 1);
    }
}
