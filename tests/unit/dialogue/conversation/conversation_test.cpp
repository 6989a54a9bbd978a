#include "dialogue/conversation/conversation.h"

#include "dialogue/conversation/help.h"
#include "tests/support/english_words.h"
#include "tests/unit/dialogue/questions.h"
#include "tests/unit/dialogue/rig.h"
#include "tests/unit/dialogue/talk.h"

#include <rapidcheck.h>

using namespace fulcrum::dialogue;

namespace {

const Catalogue& words() {
    static const Catalogue catalogue = english_words();
    return catalogue;
}

/// Asks once and answers once.
Said answer(Talk& talk, const Question& question, std::string_view said, bool right = true) {
    talk.ask(question);
    return talk.respond(talk.hear(said), right);
}

}  // namespace

TEST_CASE("conversation: asks in lines") {
    Talk talk(words());
    const Question question =
        compiled({"q", "You felt four things. Which one is the heaviest?", {"it"}, {}});
    CHECK(talk.ask(question) ==
          std::vector<std::string>{"You felt four things.", "Which one is the heaviest?"});
    CHECK(talk.ask(question, 2, 5)[0] == "Question 2 of 5.");
    CHECK(talk.ask_again().size() == 2);
    CHECK(sentences_of("It weighs 3.5 N. Yes!") ==
          std::vector<std::string>{"It weighs 3.5 N.", "Yes!"});
    CHECK(sentences_of("one\ntwo\n\n").size() == 2);
    CHECK(sentences_of("").empty());
}

TEST_CASE("conversation: after a wrong meaning a question says what comes next, and only it") {
    Talk talk(words());
    const Question thicker = compiled({"thicker",
                                       "Which one is thicker, the air or the honey?",
                                       {"the {thing} is <comparative:thick>"},
                                       {{"thing", {"air", "honey"}}}});
    CHECK(answer(talk, thicker, "the air is thicker", false).text == "Not yet. Try again.");
    Question weighed = heavier();
    weighed.again = "Let's weigh both again.";
    const Said feedback = answer(talk, weighed, "an egg is heavier", false);
    CHECK(feedback.text == "Not yet. Let's weigh both again.");
    CHECK(feedback.keys == std::vector<std::string>{"feedback.wrong_meaning.again"});
}

TEST_CASE(
    "conversation: a number off the list is a wrong answer, not one that was not understood") {
    Talk talk(words());
    const Said other = answer(talk, moons(), "Mars has fifteen moons", true);
    CHECK(other.kind == FeedbackKind::wrong_meaning);
    CHECK(other.text == "It is not fifteen. Try again.");
    CHECK(other.ask_again);
    Question counted = moons();
    counted.again = "Let's count again.";
    CHECK(answer(talk, counted, "Mars has 15 moons", false).text ==
          "It is not 15. Let's count again.");
    // Such answers count among the tries.
    for (int i = 0; i < 2; ++i) {
        talk.ask_again();
        CHECK(talk.respond(talk.hear("Mars has fifteen moons"), false).ask_again);
    }
    talk.ask_again();
    CHECK(talk.respond(talk.hear("Mars has fifteen moons"), false).kind == FeedbackKind::moved_on);
}

TEST_CASE("conversation: out of turn nothing happens") {
    Talk talk(words());
    const Mark mark = talk.hear("watermelon");
    CHECK_FALSE(mark.understood);
    CHECK(talk.respond(mark, true).text.empty());
    CHECK(talk.state() == CourseState::idle);
    talk.ask(heaviest());
    CHECK(talk.respond(mark, true).text.empty());
    CHECK(talk.state() == CourseState::asked);
}

TEST_CASE("conversation: any answers in any order keep it going and deterministic") {
    const std::vector<std::string> said = {
        "watermelon", "watermelon is most heavy", "a watermelon is the heaviest", "what",
        "",           "a apple is heaviest",      "watermelons is the heaviest"};
    CHECK(rc::check([&](const std::vector<unsigned>& choices) {
        Talk first(words());
        Talk second(words());
        const Question question = heaviest();
        for (const unsigned choice : choices) {
            std::string texts[2];
            for (Talk* talk : {&first, &second}) {
                if (talk->state() == CourseState::replaying) {
                    talk->ask_again();
                } else if (!listens(talk->state())) {
                    talk->ask(question);
                }
                const Mark mark = talk->hear(said[choice % said.size()]);
                const Said feedback = talk->respond(mark, choice % 3 != 0);
                RC_ASSERT(!feedback.text.empty());
                RC_ASSERT(feedback.text.find('[') == std::string::npos);
                RC_ASSERT(feedback.ask_again == (talk->state() == CourseState::asked ||
                                                 talk->state() == CourseState::replaying));
                texts[talk == &first ? 0 : 1] = feedback.text;
            }
            RC_ASSERT(texts[0] == texts[1]);
        }
    }));
}

TEST_CASE("conversation: the ladder can be set, and a question has its own") {
    ConversationSettings settings;
    settings.ladder = {FeedbackStep::prompt, FeedbackStep::rule};
    Talk talk(words(), settings);
    CHECK(answer(talk, heaviest(), "watermelon is heaviest").kind == FeedbackKind::prompt);
    const Said rule = answer(talk, heaviest(), "watermelon is heaviest");
    CHECK(rule.kind == FeedbackKind::rule);
    CHECK_THAT(rule.text, Catch::Contains("There is only one, so we say the: *the heaviest*."));
    // Who stands on the last step stays there.
    CHECK(answer(talk, heaviest(), "watermelon is heaviest").kind == FeedbackKind::rule);
    Question patient = heaviest();
    patient.ladder = {FeedbackStep::recast};
    for (int i = 0; i < 5; ++i) {
        CHECK(answer(talk, patient, "watermelon is heaviest").kind == FeedbackKind::recast);
    }
    // Sightings are counted over all questions, whatever their ladders.
    CHECK(answer(talk, heaviest(), "watermelon is heaviest").kind == FeedbackKind::rule);
    settings.ladder.clear();
    Talk usual(words(), settings);
    for (const FeedbackKind kind :
         {FeedbackKind::recast, FeedbackKind::prompt, FeedbackKind::rule, FeedbackKind::rule}) {
        CHECK(answer(usual, heaviest(), "watermelon is heaviest").kind == kind);
    }
}

TEST_CASE("rules: every error that any template labels has a rule among the needed keys") {
    std::set<std::string> needed;
    for (const CatalogueNeed& need : conversation_needs()) {
        CHECK(needed.insert(std::string(need.key)).second);
    }
    for (int code = 1; code < kErrorCodes; ++code) {
        for (const Role role : {Role::word, Role::determiner, Role::noun, Role::adjective,
                                Role::verb, Role::preposition}) {
            FormError error;
            error.code = static_cast<ErrorCode>(code);
            error.role = role;
            error.base = "heavy";
            error.degree = Degree::superlative;
            INFO(error.errant());
            CHECK(needed.count(rule_key(error)) == 1);
        }
    }
}
