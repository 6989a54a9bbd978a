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

TEST_CASE("conversation: right meaning with wrong form gets a recast and goes on") {
    Conversation talk(words());
    const Feedback feedback = answer(talk, heaviest(), "watermelon is most heavy");
    CHECK(feedback.kind == FeedbackKind::recast);
    CHECK(feedback.text == "Yes. A watermelon is *the heaviest*.");
    CHECK(feedback.keys == std::vector<std::string>{"feedback.recast"});
    CHECK_FALSE(feedback.ask_again);
    CHECK(talk.state() == Conversation::State::done);
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

TEST_CASE("conversation: the ladder is recast, prompt, rule, and a right sentence begins it anew") {
    Conversation talk(words());
    CHECK(answer(talk, heaviest(), "a watermelon is the most heavy").kind == FeedbackKind::recast);
    const Feedback prompt = answer(talk, heaviest(), "an apple is the most heavy");
    CHECK(prompt.kind == FeedbackKind::prompt);
    CHECK(prompt.may_repeat);
    CHECK_FALSE(prompt.ask_again);
    CHECK(prompt.text == "Yes, you are right. Say it once more: An apple is …");
    const Feedback rule = answer(talk, heaviest(), "an egg is the most heavy");
    CHECK(rule.kind == FeedbackKind::rule);
    CHECK(rule.text ==
          "Yes. An egg is *the heaviest*. A short word gets -est: heavy, *the heaviest*.");
    CHECK(rule.keys == std::vector<std::string>{"feedback.rule", "rule.superlative.ending"});
    // Another error starts its own ladder.
    CHECK(answer(talk, heaviest(), "a apple is the heaviest").kind == FeedbackKind::recast);
    CHECK(answer(talk, heaviest(), "an apple is the heaviest").kind == FeedbackKind::praise);
    CHECK(answer(talk, heaviest(), "an egg is the most heavy").kind == FeedbackKind::recast);
}

TEST_CASE("conversation: who has said yes or no is not told yes before it") {
    Conversation talk(words());
    const Question question =
        compiled({"q",
                  "Is a watermelon heavier than an egg?",
                  {"(yes|no) [(a|the) watermelon (is|is not) <comparative:heavy>]"},
                  {}});
    CHECK(answer(talk, question, "yes a watermelon is more heavy").text ==
          "Right. Yes, a watermelon is *heavier*.");
    CHECK(answer(talk, question, "no the watermelon is not more heavy").may_repeat);
    CHECK(answer(talk, question, "no the watermelon is not more heavy").text ==
          "Right. No, the watermelon is not *heavier*. A short word gets -er: heavy, *heavier*.");
    CHECK(answer(talk, heaviest(), "its the apple").text == "Yes. *It is* the apple.");
    CHECK(answer(talk, heaviest(), "its the apple").may_repeat);
    CHECK(answer(talk, heaviest(), "its the apple").text ==
          "Yes. *It is* the apple. The short form has an apostrophe: *it's*.");
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

TEST_CASE("conversation: a wrong meaning is asked again and tells nothing, whatever the form") {
    Conversation talk(words());
    for (const char* said : {"an egg is the heaviest", "egg is most heavy", "egg"}) {
        const Feedback feedback = answer(talk, heaviest(), said, false);
        CHECK(feedback.kind == FeedbackKind::wrong_meaning);
        CHECK(feedback.text == "Not yet. Try again.");
        CHECK(feedback.ask_again);
        CHECK(feedback.replay);
        CHECK(talk.state() == Conversation::State::asked);
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

TEST_CASE("conversation: who wants help gets it at once, and then more") {
    for (const char* said : {"I don't know.", "i do not know", "Help me, please!"}) {
        Conversation talk(words());
        talk.ask(heavier());
        const Feedback first = talk.respond(talk.hear(said), false);
        CHECK(first.keys == std::vector<std::string>{"feedback.not_understood.2"});
        CHECK(first.ask_again);
        CHECK(talk.respond(talk.hear("mumble"), false).keys ==
              std::vector<std::string>{"feedback.not_understood.3"});
        // The next question begins anew.
        CHECK(answer(talk, heavier(), "mumble").keys ==
              std::vector<std::string>{"feedback.not_understood.1"});
    }
    Conversation talk(words());
    CHECK(answer(talk, heavier(), "I know").keys ==
          std::vector<std::string>{"feedback.not_understood.1"});
}

TEST_CASE("conversation: thing and material that changed places are a wrong meaning of their own") {
    Conversation talk(words());
    const Question question = made_of_what();
    const Feedback turned = answer(talk, question, "Metal is made of spaceship", false);
    CHECK(turned.kind == FeedbackKind::wrong_meaning);
    CHECK(turned.text == "Not yet. Say the thing first, then what it is made of.");
    CHECK(turned.ask_again);
    CHECK(talk.respond(talk.hear("a spaceship is made of wood"), false).text ==
          "Not yet. Try again.");
    // Such answers count among the tries.
    answer(talk, question, "Metal is made of spaceship", false);
    for (int i = 0; i < 2; ++i) {
        CHECK(talk.respond(talk.hear("Metal is made of a key"), false).ask_again);
    }
    CHECK(talk.respond(talk.hear("Metal is made of a key"), false).kind == FeedbackKind::moved_on);
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

TEST_CASE("conversation: who only points is asked for a name, and helped when that goes on") {
    Conversation talk(words());
    const Feedback first = answer(talk, heavier(), "this one is heavier", false);
    CHECK(first.kind == FeedbackKind::not_understood);
    CHECK(first.text == "Which one? Say its name.");
    CHECK(first.ask_again);
    CHECK(talk.respond(talk.hear("this is heavier"), false).text == "Which one? Say its name.");
    CHECK(talk.respond(talk.hear("this is heavier"), false).keys ==
          std::vector<std::string>{"feedback.not_understood.3"});
}

TEST_CASE("conversation: the passive climbs the ladder from recast to rule") {
    Conversation talk(words());
    const Question question = made_of_what();
    CHECK(answer(talk, question, "a spaceship makes of metal").text ==
          "Yes. A spaceship *is made* of metal.");
    CHECK(answer(talk, question, "a table makes of wood").text ==
          "Yes, you are right. Say it once more: A table … of wood.");
    CHECK(
        answer(talk, question, "scissors make of metal").text ==
        "Yes. Scissors *are made* of metal. The thing does not make anything. Somebody made it, so "
        "we say *are made of*.");
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

TEST_CASE("conversation: a learner who asks is answered like one who asks") {
    const Catalogue words = english_words();
    const Question ask = compiled({"ask",
                                   "Ask me!",
                                   {"how many moons does {planet} have"},
                                   {{"planet", {"Saturn", "Mars"}}},
                                   {},
                                   {"how many moons {planet} has"}});
    Conversation conversation(words);
    const auto reply = [&](const char* said) {
        (void)conversation.ask(ask);
        return conversation.respond(conversation.hear(said), true).text;
    };
    CHECK(reply("how many moons does Saturn have") == "Good question!");
    CHECK(reply("how many moons Saturn has") ==
          "Good question! We say: *How many moons does Saturn have*?");
    // The hints of who is not understood are sentences, too.
    (void)conversation.ask(ask);
    std::vector<std::string> hints;
    for (int i = 0; i < 3; ++i) {
        hints.push_back(conversation.respond(conversation.hear("bla"), false).text);
    }
    CHECK(hints[1] == "Please say it like this: How many moons does … have?");
    CHECK(hints[2] == "For example: How many moons does Saturn have?");
}

TEST_CASE("conversation: where no list has two words, the hint is a sentence, not an empty list") {
    const Catalogue words = english_words();
    const Question place = compiled({"place",
                                     "Where is it easier?",
                                     {"it is easier {far} from it"},
                                     {{"far", {"far"}}},
                                     {},
                                     {}});
    Conversation conversation(words);
    (void)conversation.ask(place);
    std::string hint;
    for (int i = 0; i < 3; ++i) {
        hint = conversation.respond(conversation.hear("bla"), false).text;
    }
    CHECK(hint == "For example: It is easier far from it.");
}

TEST_CASE("conversation: who is not understood never gets a hint of nothing but dots") {
    const Catalogue words = english_words();
    const Question place = compiled(
        {"place", "Where?", {"[it is] {place}"}, {{"place", {"near", "far"}}, {"own", {"have"}}}});
    Conversation conversation(words);
    (void)conversation.ask(place);
    (void)conversation.respond(conversation.hear("bla"), false);
    CHECK(conversation.respond(conversation.hear("bla"), false).text ==
          "You can say: near or far.");
}
