#include "dialogue/conversation/conversation.h"
#include "tests/unit/dialogue/questions.h"
#include "tests/unit/dialogue/words.h"

#include <catch2/catch.hpp>

#include <string_view>

using namespace fulcrum::dialogue;

namespace {

const Catalogue& catalogue_words() {
    static const Catalogue catalogue = english_words();
    return catalogue;
}

Feedback answer_once(Conversation& talk, const Question& question, std::string_view said) {
    talk.ask(question);
    return talk.respond(talk.hear(said), true);
}

/// Finds one error in every text that has "have", none in others.
CheckedText check_have(std::string_view text) {
    CheckedText checked;
    checked.corrected = checked.marked = std::string(text);
    if (const std::size_t at = text.find("have"); at != std::string_view::npos) {
        checked.errors.push_back({ErrorCode::agreement, at, at + 4, "have", "has"});
        checked.corrected.replace(at, 4, "has");
        checked.marked.replace(at, 4, "*has*");
    }
    return checked;
}

}  // namespace

TEST_CASE(
    "conversation: good English is shown for words that fit no answer, and nothing is called "
    "wrong") {
    Conversation talk(catalogue_words());
    talk.set_form_check(check_have);
    const Feedback feedback = answer_once(talk, heaviest(), "it have a ring");
    CHECK(feedback.kind == FeedbackKind::not_understood);
    CHECK(feedback.ask_again);
    CHECK(feedback.text ==
          "In English we say: It *has* a ring. I did not understand. Please say it again.");
    REQUIRE(feedback.free_errors.size() == 1);
    CHECK(feedback.free_errors[0].code == ErrorCode::agreement);
    CHECK(feedback.keys.back() == "feedback.free_form");
    // Each sentence with its capital, whatever was put right in it.
    CHECK(answer_once(talk, heaviest(), "i like it. have i it?").text ==
          "In English we say: I like it. *Has* I it? I did not understand. Please say it again.");
}

TEST_CASE(
    "conversation: nothing is shown where no error is seen, where nobody checks, or where a "
    "template takes it") {
    Conversation talk(catalogue_words());
    const Feedback unchecked = answer_once(talk, heaviest(), "it have a ring");
    CHECK(unchecked.free_errors.empty());
    CHECK(unchecked.text == "I did not understand. Please say it again.");
    talk.set_form_check(check_have);
    CHECK(answer_once(talk, heaviest(), "it is a ring").text == unchecked.text);
    CHECK(answer_once(talk, heaviest(), "watermelon is most heavy").text ==
          "Yes. A watermelon is *the heaviest*.");
    talk.set_form_check({});
    CHECK(answer_once(talk, heaviest(), "it have a ring").text == unchecked.text);
}
