// Answers that claim something else than that their words are right: the lesson is asked about each plain meaning, and is told one answer.
#include "runtime/lesson/question_dialogue.h"
#include "runtime/lesson/questions.h"
#include "tests/unit/runtime/lesson/session_fixture.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

/// The things that the lesson is asked about, in order.
std::vector<std::string> asked_of(const QuestionTurn& turn) {
    std::vector<std::string> things;
    for (const LessonEvent& event : turn.events) {
        if (const auto* judge = std::get_if<JudgeEvent>(&event)) {
            things.push_back(judge->slots.empty() ? "" : judge->slots.back().second);
        }
    }
    return things;
}

/// Says it where the apple is the heaviest; what came of it.
QuestionTurn say(QuestionDialogue& dialogue, const std::string& words) {
    const QuestionTurn heard = dialogue.hear(words, 1.0, 0.0);
    QuestionTurn last;
    for (const std::string& thing : asked_of(heard)) {
        CHECK_FALSE(last.answer);
        last = dialogue.judge("heaviest", thing == "apple", 0.0);
    }
    REQUIRE(last.answer);
    return last;
}

}  // namespace

TEST_CASE("question claims: no difference where nothing is right, and all is asked for it") {
    QuestionDialogue dialogue{compile_questions(two_questions()).value(), words()};
    (void)dialogue.ask("heaviest", 0.0);
    const QuestionTurn turn = say(dialogue, "they weigh the same");
    CHECK_FALSE(turn.answer->right);
    CHECK(turn.answer->mark.understood);
    REQUIRE(turn.events.size() == 1);
    const auto& answered = std::get<AnsweredEvent>(turn.events[0]);
    CHECK_FALSE(answered.right);
    REQUIRE(answered.slots.size() == 1);
    CHECK(answered.slots[0].second == "egg");  // a thing that is not right, as any wrong answer has
    CHECK(dialogue.state() == QuestionState::set_aside);
}

TEST_CASE("question claims: what is ruled out truly is told nobody, and the question goes on") {
    QuestionDialogue dialogue{compile_questions(two_questions()).value(), words()};
    (void)dialogue.ask("heaviest", 0.0);
    const QuestionTurn open = say(dialogue, "the egg is not the heaviest");
    CHECK(open.events.empty());
    CHECK_FALSE(open.answer->right);
    CHECK_FALSE(open.answer->mark.understood);
    CHECK(dialogue.listens());
    const QuestionTurn wrong = say(dialogue, "the apple is not the heaviest");
    CHECK_FALSE(wrong.answer->right);
    CHECK(wrong.answer->mark.understood);
    CHECK(wrong.events.size() == 1);
}
