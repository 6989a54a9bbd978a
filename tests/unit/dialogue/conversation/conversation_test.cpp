#include "dialogue/conversation/conversation.h"

#include "tests/unit/dialogue/questions.h"
#include "tests/unit/dialogue/words.h"

#include <catch2/catch.hpp>

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
