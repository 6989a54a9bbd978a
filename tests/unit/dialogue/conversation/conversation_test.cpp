#include "dialogue/conversation/conversation.h"

#include "dialogue/conversation/help.h"
#include "tests/unit/dialogue/questions.h"
#include "tests/unit/dialogue/rig.h"
#include "tests/unit/dialogue/words.h"

#include <rapidcheck.h>

using namespace fulcrum::dialogue;

namespace {

const Catalogue& words() {
    static const Catalogue catalogue = english_words();
    return catalogue;
}

/// Asks once and answers once.
Feedback answer(Conversation& talk, const Question& question, std::string_view said,
                bool right = true) {
    talk.ask(question);
    return talk.respond(talk.hear(said), right);
}

}  // namespace

TEST_CASE("conversation: asks in lines") {
    Conversation talk(words());
    const Question question =
        compiled({"q", "You felt four things. Which one is the heaviest?", {"it"}, {}});
    CHECK(talk.ask(question) ==
          std::vector<std::string>{"You felt four things.", "Which one is the heaviest?"});
    CHECK(talk.ask(question, 2, 5)[0] == "Question 2 of 5.");
    CHECK(talk.prompt_again().size() == 2);
    CHECK(sentences_of("It weighs 3.5 N. Yes!") ==
          std::vector<std::string>{"It weighs 3.5 N.", "Yes!"});
    CHECK(sentences_of("one\ntwo\n\n").size() == 2);
    CHECK(sentences_of("").empty());
}

TEST_CASE("conversation: praise goes round in turn, not by chance") {
    Conversation talk(words());
    std::vector<std::string> heard;
    for (int i = 0; i < 5; ++i) {
        const Feedback feedback = answer(talk, heaviest(), "a watermelon is the heaviest");
        CHECK(feedback.kind == FeedbackKind::praise);
        heard.push_back(feedback.text);
    }
    CHECK(heard[0] != heard[1]);
    CHECK(heard[4] == heard[0]);
    CHECK(answer(talk, heaviest(), "the watermelon").text == "Yes! A watermelon is the heaviest.");
}

TEST_CASE("conversation: what is said after a prompt is taken up and never holds back") {
    Conversation talk(words());
    const auto invite = [&] {
        (void)answer(talk, heaviest(), "a watermelon is the most heavy");
        while (answer(talk, heaviest(), "a watermelon is the most heavy").kind !=
               FeedbackKind::prompt) {
        }
        REQUIRE(talk.state() == Conversation::State::invited);
    };
    ConversationSettings settings;
    settings.ladder = {FeedbackStep::recast, FeedbackStep::prompt};
    talk = Conversation(words(), settings);
    invite();
    Feedback feedback = talk.respond(talk.hear("A watermelon is the heaviest"), true);
    CHECK(feedback.kind == FeedbackKind::praise);
    CHECK(feedback.uptake == Uptake::repaired);
    CHECK(feedback.attempt == 2);
    CHECK(talk.state() == Conversation::State::done);
    for (const char* said : {"a watermelon is the most heavy", "what?", "the watermelon"}) {
        invite();
        feedback = talk.respond(talk.hear(said), true);
        CHECK(feedback.kind == FeedbackKind::recast);
        CHECK(feedback.text == "Yes. A watermelon is *the heaviest*.");
        CHECK(feedback.uptake == Uptake::not_repaired);
        CHECK_FALSE(feedback.ask_again);
        CHECK(talk.state() == Conversation::State::done);
    }
}

TEST_CASE("conversation: after a wrong meaning a question says what comes next, and only it") {
    Conversation talk(words());
    const Question thicker = compiled({"thicker",
                                       "Which one is thicker, the air or the honey?",
                                       {"the {thing} is <comparative:thick>"},
                                       {{"thing", {"air", "honey"}}}});
    CHECK(answer(talk, thicker, "the air is thicker", false).text == "Not yet. Try again.");
    Question weighed = heavier();
    weighed.again = "Let's weigh both again.";
    const Feedback feedback = answer(talk, weighed, "an egg is heavier", false);
    CHECK(feedback.text == "Not yet. Let's weigh both again.");
    CHECK(feedback.keys == std::vector<std::string>{"feedback.wrong_meaning.again"});
}

TEST_CASE("conversation: the opposite of what is asked is named, called neither right nor wrong") {
    ConversationSettings settings;
    settings.unheard_tries = 3;
    Conversation talk(words(), settings);
    talk.ask(heavier());
    for (int i = 0; i < 2; ++i) {
        const Feedback feedback = talk.respond(talk.hear("the egg is lighter"), false);
        CHECK(feedback.kind == FeedbackKind::not_understood);
        CHECK(feedback.text == "You told me what is lighter. And what is *heavier*?");
        CHECK(feedback.ask_again);
        CHECK_FALSE(feedback.replay);
    }
    CHECK(talk.respond(talk.hear("the egg is lighter"), false).kind == FeedbackKind::moved_on);
}

TEST_CASE(
    "conversation: a number off the list is a wrong answer, not one that was not understood") {
    Conversation talk(words());
    const Feedback other = answer(talk, moons(), "Mars has fifteen moons", true);
    CHECK(other.kind == FeedbackKind::wrong_meaning);
    CHECK(other.text == "It is not fifteen. Try again.");
    CHECK(other.ask_again);
    Question counted = moons();
    counted.again = "Let's count again.";
    CHECK(answer(talk, counted, "Mars has 15 moons", false).text ==
          "It is not 15. Let's count again.");
    // Such answers count among the tries.
    for (int i = 0; i < 2; ++i) {
        CHECK(talk.respond(talk.hear("Mars has fifteen moons"), false).ask_again);
    }
    CHECK(talk.respond(talk.hear("Mars has fifteen moons"), false).kind == FeedbackKind::moved_on);
}

TEST_CASE("conversation: nobody stays at one question for ever") {
    ConversationSettings settings;
    settings.tries = 3;
    settings.unheard_tries = 4;
    Conversation talk(words(), settings);
    talk.ask(heaviest());
    CHECK(talk.respond(talk.hear("egg"), false).ask_again);
    CHECK(talk.respond(talk.hear("apple"), false).ask_again);
    const Feedback last = talk.respond(talk.hear("banana"), false);
    CHECK(last.kind == FeedbackKind::moved_on);
    CHECK(last.text == "Good try! Let's go on.");  // no promise: nothing comes back to it
    CHECK_FALSE(last.ask_again);
    CHECK(last.attempt == 3);
    CHECK(talk.state() == Conversation::State::done);

    talk.ask(heaviest());
    CHECK(talk.respond(talk.hear("hm?"), true).text ==
          "I did not understand. Please say it again.");
    CHECK(talk.respond(talk.hear("hm?"), true).text ==
          "Please say it like this: … is the heaviest.");
    CHECK(talk.respond(talk.hear("hm?"), true).text ==
          "You can say: a watermelon, an apple, a banana or an egg.");
    CHECK(talk.respond(talk.hear("hm?"), true).kind == FeedbackKind::moved_on);
}

TEST_CASE("conversation: what is heard badly is never called wrong") {
    Conversation talk(words());
    talk.ask(heaviest());
    const Feedback feedback = talk.respond(talk.hear("an egg is the heaviest", 0.2), false);
    CHECK(feedback.kind == FeedbackKind::heard_badly);
    CHECK(feedback.ask_again);
    const Feedback praise = talk.respond(talk.hear("a watermelon is the heaviest", 0.5), true);
    CHECK(praise.kind == FeedbackKind::praise);
    CHECK(praise.attempt == 1);  // what was heard badly is none
}

TEST_CASE("conversation: out of turn nothing happens") {
    Conversation talk(words());
    const Mark mark = talk.hear("watermelon");
    CHECK_FALSE(mark.understood);
    CHECK(talk.respond(mark, true).text.empty());
    CHECK(talk.state() == Conversation::State::idle);
    talk.ask(heaviest());
    CHECK(talk.respond(mark, true).text.empty());
    CHECK(talk.state() == Conversation::State::asked);
}

TEST_CASE("conversation: any answers in any order keep it going and deterministic") {
    const std::vector<std::string> said = {
        "watermelon", "watermelon is most heavy", "a watermelon is the heaviest", "what",
        "",           "a apple is heaviest",      "watermelons is the heaviest"};
    CHECK(rc::check([&](const std::vector<unsigned>& choices) {
        Conversation first(words());
        Conversation second(words());
        const Question question = heaviest();
        for (const unsigned choice : choices) {
            std::string texts[2];
            for (Conversation* talk : {&first, &second}) {
                if (talk->state() == Conversation::State::idle ||
                    talk->state() == Conversation::State::done) {
                    talk->ask(question);
                }
                const Mark mark = talk->hear(said[choice % said.size()]);
                const Feedback feedback = talk->respond(mark, choice % 3 != 0);
                RC_ASSERT(!feedback.text.empty());
                RC_ASSERT(feedback.text.find('[') == std::string::npos);
                RC_ASSERT(feedback.ask_again == (talk->state() == Conversation::State::asked));
                texts[talk == &first ? 0 : 1] = feedback.text;
            }
            RC_ASSERT(texts[0] == texts[1]);
        }
    }));
}

TEST_CASE(
    "conversation: the opposite is named to who was asked for a thing, not for a reason or a "
    "place") {
    const Catalogue catalogue = english_words();
    const NamedLists lists{{"thing", {"wooden block", "metal block"}},
                           {"other", {"water", "metal"}}};
    const struct {
        const char *prompt, *answer, *said;
        bool is_named;
    } rows[] = {
        {"Look. Which block is lighter?", "[the] {thing} is <comparative:light>",
         "the metal block is heavier", true},
        {"A wooden block and a metal one: what is lighter?", "[the] {thing} is <comparative:light>",
         "the metal block is heavier", true},
        {"Why does the wooden block float?", "because it is <comparative:light> than [the] {other}",
         "Because it is heavier than water.", false},
        {"Why does it float?", "because [the] {thing} is <comparative:light> than [the] {other}",
         "because the metal block is heavier than water", false},
        {"Which way do you feel it?", "it is <comparative:light>", "it is heavier", false},
    };
    for (const auto& row : rows) {
        CAPTURE(row.prompt);
        Conversation talk(catalogue);
        talk.ask(compiled({"q", row.prompt, {row.answer}, lists}));
        const Mark mark = talk.hear(row.said);
        REQUIRE_FALSE(mark.opposite_said.empty());
        const Feedback feedback = talk.respond(mark, false);
        CHECK(feedback.kind == FeedbackKind::not_understood);
        CHECK((feedback.keys.front() == "feedback.opposite") == row.is_named);
    }
}

TEST_CASE("conversation: the ladder can be set, and a question has its own") {
    ConversationSettings settings;
    settings.ladder = {FeedbackStep::prompt, FeedbackStep::rule};
    Conversation talk(words(), settings);
    CHECK(answer(talk, heaviest(), "watermelon is heaviest").kind == FeedbackKind::prompt);
    const Feedback rule = answer(talk, heaviest(), "watermelon is heaviest");
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
    Conversation usual(words(), settings);
    for (const FeedbackKind kind :
         {FeedbackKind::recast, FeedbackKind::prompt, FeedbackKind::rule, FeedbackKind::rule}) {
        CHECK(answer(usual, heaviest(), "watermelon is heaviest").kind == kind);
    }
}

TEST_CASE("conversation: a step may let the hand feel it again, and nobody is held back by it") {
    ConversationSettings settings;
    settings.ladder = {FeedbackStep::replay, FeedbackStep::recast};
    Conversation talk(words(), settings);
    const Feedback felt = answer(talk, heaviest(), "watermelon is most heavy");
    CHECK(felt.kind == FeedbackKind::replay);
    CHECK(felt.replay);
    CHECK_FALSE(felt.ask_again);
    CHECK_FALSE(felt.may_repeat);
    CHECK(felt.text == "Yes. A watermelon is *the heaviest*.");
    CHECK(talk.state() == Conversation::State::done);
    CHECK_FALSE(answer(talk, heaviest(), "watermelon is most heavy").replay);
}

TEST_CASE(
    "conversation: a rule names the word that is missing or misspelt, and reads as a sentence") {
    ConversationSettings settings;
    settings.ladder = {FeedbackStep::rule};
    Conversation talk(words(), settings);
    CHECK(answer(talk, heaviest(), "an apple the heaviest").text ==
          "Yes. An apple *is* the heaviest. Every sentence needs a verb, here is.");
    CHECK(answer(talk, heaviest(), "an appel is the heaviest").text ==
          "Yes. *An apple* is the heaviest. The right spelling: apple.");
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
