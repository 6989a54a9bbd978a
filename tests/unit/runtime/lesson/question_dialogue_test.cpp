#include "runtime/lesson/question_dialogue.h"

#include "tests/unit/runtime/lesson/question_states.h"
#include "tests/unit/runtime/rig.h"

#include <rapidcheck.h>

using namespace fulcrum::runtime::test;

TEST_CASE("question dialogue: whatever state another question interrupts, it can be answered") {
    for (int i = 0; i < static_cast<int>(fulcrum::dialogue::kCourseStates); ++i) {
        CAPTURE(i);
        QuestionDialogue dialogue = in_state(static_cast<State>(i));
        CHECK(dialogue.ask("lightest", 1.0).prompt == "Which one is the lightest?");
        (void)dialogue.judge("heaviest", true, 1.0);
        const QuestionTurn heard = dialogue.hear("the egg is the lightest", 1.0, 2.0);
        REQUIRE(heard.events.size() == 1);
        CHECK(std::get<JudgeEvent>(heard.events[0]).question == "lightest");
        const QuestionTurn judged = dialogue.judge("lightest", true, 2.5);
        REQUIRE(told(judged).size() == 1);
        CHECK(told(judged)[0].question == "lightest");
        CHECK(told(judged)[0].attempt == 1);
        CHECK(judged.answer->answer_s == Approx(1.5));
    }
}

TEST_CASE("question dialogue: words heard badly are asked for again and never told as wrong") {
    QuestionDialogue dialogue = in_state(State::asked);
    (void)dialogue.hear(kWrong, 0.1, 0.0);
    const QuestionTurn turn = dialogue.judge("heaviest", false, 0.0);
    CHECK(turn.events.empty());
    REQUIRE(turn.answer);
    CHECK(turn.answer->feedback.kind == fulcrum::dialogue::FeedbackKind::heard_badly);
    CHECK(dialogue.state() == State::asked);
}

TEST_CASE("question dialogue: a repeat heard badly is invited anew, and never kept as wrong") {
    const std::string said = GENERATE(kRight, kSlip, kNonsense);
    constexpr double kLater_s = 11.0;  // the invitation would soon have ended
    QuestionDialogue dialogue = in_state(State::invited);
    const auto hear_badly = [&](double time_s) {
        QuestionTurn turn = dialogue.hear(said, 0.1, time_s);
        return turn.answer ? turn : dialogue.judge("heaviest", said != kNonsense, time_s);
    };
    const QuestionTurn turn = hear_badly(kLater_s);
    REQUIRE(turn.answer);
    CHECK(turn.answer->feedback.kind == fulcrum::dialogue::FeedbackKind::heard_badly);
    CHECK(turn.answer->feedback.uptake == fulcrum::dialogue::Uptake::none);
    CHECK(told(turn).empty());
    CHECK(dialogue.state() == State::invited);
    CHECK(dialogue.asked_at_s() == kLater_s);
    CHECK(told(dialogue.step(2.0 * kLater_s)).empty());  // there is time to say it again
    SECTION("heard well then") {
        (void)dialogue.hear(kRight, 1.0, 2.0 * kLater_s);
        const QuestionTurn again = dialogue.judge("heaviest", true, 2.0 * kLater_s);
        REQUIRE(again.answer);
        CHECK(again.answer->feedback.uptake == fulcrum::dialogue::Uptake::repaired);
        REQUIRE(told(again).size() == 1);
        CHECK(told(again)[0].right);
    }
    SECTION("never heard well") {
        CHECK(told(hear_badly(2.0 * kLater_s)).empty());
        const std::vector<AnsweredEvent> answers = told(hear_badly(2.0 * kLater_s));
        REQUIRE(answers.size() == 1);
        CHECK(answers[0].right);  // as the answer was before it was to be said once more
    }
    SECTION("said no more") {
        CHECK(told(dialogue.step(kLater_s + kLongEnough_s)).size() == 1);
    }
    CHECK((dialogue.state() == State::done));
}

TEST_CASE("question dialogue: in any order an open question hears, and is over at most once") {
    const bool holds = rc::check([] {
        QuestionDialogue dialogue = make_dialogue();
        const std::vector<std::string> ids{"heaviest", "lightest"};
        std::map<std::string, int> asked;
        std::map<std::string, int> over;
        double time_s = 0.0;
        const auto count = [&](const QuestionTurn& turn) {
            for (const AnsweredEvent& answered : told(turn)) {
                over[answered.question] += answered.over ? 1 : 0;
                RC_ASSERT(over[answered.question] <= asked[answered.question]);
            }
        };
        const int n_steps = *rc::gen::inRange(1, 60);
        for (int i = 0; i < n_steps; ++i) {
            time_s += *rc::gen::element(0.0, 1.0 / 60.0, 5.0, 13.0);
            const std::string id = *rc::gen::elementOf(ids);
            switch (*rc::gen::inRange(0, 6)) {
                case 0:
                    ++asked[id];
                    count(dialogue.ask(id, time_s));
                    RC_ASSERT(dialogue.state() == State::asked);
                    break;
                case 1:
                    count(dialogue.judge(id, *rc::gen::arbitrary<bool>(), time_s));
                    break;
                case 2:
                    count(dialogue.step(time_s));
                    break;
                case 3:
                    dialogue.end_exchange();
                    RC_ASSERT(dialogue.is_open() == dialogue.listens());
                    break;
                case 4:
                    if (*rc::gen::inRange(0, 4) == 0) {
                        dialogue.close();
                        RC_ASSERT(dialogue.state() == State::idle);
                    }
                    break;
                default:
                    count(dialogue.hear(*rc::gen::element<std::string>(
                                            kRight, kSlip, kWrong, kNonsense,
                                            "the egg is the lightest", "the egg is the most light"),
                                        1.0, time_s));
            }
        }
        // After any history the question that is open can be answered, and time ends an invitation.
        dialogue.end_exchange();
        if (dialogue.state() == State::asked) {
            bool judged = false;
            for (const char* said : {kRight, "the egg is the lightest"}) {
                judged |= dialogue.state() == State::heard ||
                          !dialogue.hear(said, 1.0, time_s).events.empty();
            }
            RC_ASSERT(judged);
        } else if (dialogue.state() == State::invited) {
            const QuestionTurn turn = dialogue.step(time_s + kLongEnough_s);
            RC_ASSERT(told(turn).size() == 1U);
            RC_ASSERT(told(turn)[0].right);
            RC_ASSERT(dialogue.state() == State::done);
        }
    });
    CHECK(holds);
}

TEST_CASE("question dialogue: where asking is the answer, what is asked elsewhere is a right one") {
    LessonDescription lesson = two_things();
    lesson.questions[0].answers = {"how heavy is the {thing}"};
    QuestionDialogue dialogue(compile_questions(lesson).value(), words());
    fulcrum::dialogue::Mark asked;
    asked.understood = true;
    asked.said = asked.corrected = "Who are you?";
    CHECK_FALSE(dialogue.wants_question());
    CHECK_FALSE(dialogue.take_question(asked, 0.0).answer);
    (void)dialogue.ask("heaviest", 0.0);
    CHECK(dialogue.wants_question());
    const QuestionTurn turn = dialogue.take_question(asked, 1.0);
    REQUIRE(turn.answer);
    CHECK(turn.answer->right);
    CHECK(dialogue.state() == State::done);
    REQUIRE(turn.events.size() == 1);
    CHECK(std::get<AnsweredEvent>(turn.events[0]).over);
    // Others are not answered so.
    QuestionDialogue other = make_dialogue();
    (void)other.ask("heaviest", 0.0);
    CHECK_FALSE(other.wants_question());
}

TEST_CASE("question dialogue: words that fit no answer are checked where a lesson wants it") {
    QuestionDialogue dialogue = make_dialogue();
    (void)dialogue.ask("heaviest", 0.0);
    CHECK(dialogue.hear("it have a ring", 1.0, 0.0).answer->feedback.free_errors.empty());
    dialogue.set_form_check([](std::string_view text) {
        fulcrum::dialogue::CheckedText checked;
        checked.corrected = checked.marked = std::string(text);
        checked.errors.resize(1);
        return checked;
    });
    const QuestionTurn turn = dialogue.hear("it have a ring", 1.0, 0.0);
    REQUIRE(turn.answer);
    CHECK(turn.answer->feedback.free_errors.size() == 1);
    CHECK_FALSE(turn.answer->mark.understood);
    CHECK(dialogue.state() == State::asked);
}
