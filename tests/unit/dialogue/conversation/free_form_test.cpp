#include "dialogue/conversation/conversation.h"
#include "tests/support/english_words.h"
#include "tests/unit/dialogue/questions.h"
#include "tests/unit/dialogue/rig.h"
#include "tests/unit/dialogue/talk.h"

#include <rapidcheck.h>

using namespace fulcrum::dialogue;

namespace {

const Catalogue& catalogue_words() {
    static const Catalogue catalogue = english_words();
    return catalogue;
}

/// Asks once and answers once, rightly in meaning.
Said answer_once(Talk& talk, const Question& question, std::string_view said) {
    talk.ask(question);
    return talk.respond(talk.hear(said), true);
}

/// Puts "goed" right.
CheckedText check_goed(std::string_view text) {
    CheckedText checked{{}, std::string(text), std::string(text)};
    if (const std::size_t at = text.find("goed"); at != std::string_view::npos) {
        checked.errors.push_back({ErrorCode::verb_inflection, at, at + 4, "goed", "went"});
        checked.corrected.replace(at, 4, "went");
        checked.marked.replace(at, 4, "*went*");
        checked.proven = true;
    }
    return checked;
}

Question where_it_went() {
    return compiled(
        {"went", "Where did it go?", {"(the stone|it) went {where}"}, {{"where", {"down", "up"}}}});
}

/// At an invitation to say it once more: "an apple is the most heavy", said twice.
Talk invited() {
    Talk talk(catalogue_words());
    CHECK(answer_once(talk, heaviest(), "an apple is the most heavy").kind == FeedbackKind::recast);
    REQUIRE(answer_once(talk, heaviest(), "an apple is the most heavy").kind ==
            FeedbackKind::prompt);
    REQUIRE(talk.state() == CourseState::invited);
    return talk;
}

}  // namespace

TEST_CASE(
    "conversation: a sentence that isn't proven is not said; of one error it is told what belongs "
    "there") {
    const struct {
        FreeError error;
        const char *text, *key;
    } rows[] = {
        {{ErrorCode::agreement, 3, 7, "have", "has"},
         "Here we say *has*, not have. ",
         "feedback.free_words"},
        {{ErrorCode::missing_determiner, 12, 12, "", "a "},
         "Before ring we say *a*. ",
         "feedback.free_missing"},
        {{ErrorCode::extra_pronoun, 3, 8, "have ", ""},
         "Here we do not say have. ",
         "feedback.free_extra"},
        {{ErrorCode::agreement, 2, 4, "'s", " are"}, "", "feedback.not_understood.1"},
        // Of these only all of the sentence could tell.
        {{ErrorCode::missing_verb, 3, 3, "", "is ", false}, "", "feedback.not_understood.1"},
        {{ErrorCode::extra_determiner, 8, 12, "own ", ""},
         "Here we say *ring*, not own ring. ",
         "feedback.free_words"},
    };
    for (const auto& row : rows) {
        Talk talk(catalogue_words());
        talk.set_form_check([&](std::string_view) {
            CheckedText checked;
            checked.errors = {row.error};
            checked.corrected = checked.marked = "It are has ring";
            return checked;
        });
        const Said feedback = answer_once(talk, heaviest(), "it have own ring");
        CHECK(feedback.text ==
              row.text + std::string("I did not understand. Please say it again."));
        CHECK(feedback.keys.back() == row.key);
        CHECK(feedback.free_errors.size() == 1);
    }
}

TEST_CASE(
    "conversation: where the good English for it is an answer, that was meant, with an error") {
    Talk talk(catalogue_words());
    talk.set_form_check(check_goed);
    const Question question = where_it_went();
    talk.ask(question);
    const Mark mark = talk.hear("the stone goed down");
    REQUIRE(mark.understood);
    CHECK(mark.said == "the stone goed down");
    CHECK(mark.slot("where") == "down");
    CHECK(mark.corrected == "The stone went down.");
    CHECK(mark.emphasised == "The stone *went* down.");
    CHECK(mark.gapped == "The stone … down.");
    REQUIRE(mark.form_errors.size() == 1);
    CHECK(mark.form_errors[0].errant() == "R:VERB:INFL");
    CHECK(mark.form_errors[0].begin == 10);
    CHECK(mark.form_errors[0].end == 14);
}

TEST_CASE(
    "conversation: where the meaning alone was heard nothing is said of form, nor learnt of it") {
    Talk talk(catalogue_words());
    for (const char* said : {"watermelon is most heavy", "a watermelon is the heaviest"}) {
        for (int i = 0; i < 4; ++i) {
            talk.ask(heaviest());
            const Mark mark = talk.hear(said, 0.9, false);
            CHECK(mark.understood);
            CHECK(mark.slot("thing") == "watermelon");
            CHECK(mark.form_errors.empty());
            CHECK_FALSE(mark.form_known);
            CHECK_FALSE(mark.form_right());  // not known is not right
            CHECK_FALSE(mark.target_right());
            const Said feedback = talk.respond(mark, true);
            CHECK(feedback.kind == FeedbackKind::praise);
            CHECK(feedback.text == "Yes! A watermelon is the heaviest.");
            CHECK(feedback.uptake == Uptake::none);
        }
    }
    talk.ask(heaviest());
    const Mark wrong = talk.hear("an egg is the heaviest", 0.9, false);
    CHECK(talk.respond(wrong, false).kind == FeedbackKind::wrong_meaning);
    // The ladder still stands at its foot.
    CHECK(answer_once(talk, heaviest(), "watermelon is most heavy").kind == FeedbackKind::recast);
}

TEST_CASE("conversation: typed or heard word for word the form is known, right or not") {
    Talk talk(catalogue_words());
    talk.ask(heaviest());
    CHECK(talk.hear("a watermelon is the heaviest").form_right());
    const Mark wrong = talk.hear("watermelon is most heavy", 0.9);
    CHECK(wrong.form_known);
    CHECK_FALSE(wrong.form_right());
    CHECK(talk.hear("nonsense").form_known);
    CHECK_FALSE(talk.hear("nonsense", 0.9, false).form_known);
}

TEST_CASE("conversation: a repeat that is heard badly is asked for again, and is not unrepaired") {
    constexpr double kBadly = 0.2;
    for (const char* said : {"an apple is the most heavy", "an apple is the heaviest", "what?"}) {
        for (const bool right : {true, false}) {
            CAPTURE(said, right);
            Talk talk = invited();
            const Said feedback = talk.respond(talk.hear(said, kBadly), right);
            CHECK(feedback.kind == FeedbackKind::heard_badly);
            CHECK(feedback.text == catalogue_words().say("feedback.heard_badly"));
            CHECK(feedback.uptake == Uptake::none);
            CHECK(feedback.ask_again);
            CHECK(talk.state() == CourseState::invited);
            const Said heard = talk.respond(talk.hear("an apple is the heaviest", 0.9), true);
            CHECK(heard.kind == FeedbackKind::praise);
            CHECK(heard.uptake == Uptake::repaired);
            CHECK(heard.attempt == 2);  // the badly heard one is none
            CHECK(talk.state() == CourseState::done);
        }
    }
}

TEST_CASE(
    "conversation: however well each is heard, low confidence never says wrong, and it ends") {
    CHECK(rc::check([](const std::vector<std::pair<unsigned, bool>>& heard) {
        const std::vector<std::string_view> said = {"an apple is the most heavy", "what?",
                                                    "an apple is the heaviest", "the apple"};
        ConversationSettings settings;
        Talk talk(catalogue_words(), settings);
        int asked_again = 0;
        for (const auto& [choice, well] : heard) {
            if (!listens(talk.state())) {
                talk.ask(heaviest());
                asked_again = 0;
            }
            const bool was_invited = talk.state() == CourseState::invited;
            const double confidence = settings.least_confidence + (well ? 0.0 : -0.01);
            const Mark mark = talk.hear(said[choice % said.size()], confidence);
            const Said feedback = talk.respond(mark, true);
            RC_ASSERT((feedback.kind == FeedbackKind::heard_badly) == !well);
            RC_ASSERT(well || feedback.uptake == Uptake::none);
            RC_ASSERT(!was_invited || well || talk.state() != CourseState::asked);
            asked_again += was_invited ? 1 : 0;
            RC_ASSERT(asked_again <= 3);
        }
    }));
}
