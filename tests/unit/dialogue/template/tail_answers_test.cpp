#include "dialogue/template/tail_answers.h"

#include "dialogue/marking/mark.h"
#include "tests/unit/dialogue/questions.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

namespace {

Question asked(std::vector<std::string> answers, NamedTexts rules = {}, NamedLists more = {}) {
    QuestionSource source;
    source.id = "where";
    source.prompt = "Where is the apple?";
    source.answers = std::move(answers);
    source.lists = std::move(more);
    source.lists.emplace_back("thing", std::vector<std::string>{"bowl", "box"});
    source.rules = std::move(rules);
    return compiled(source);
}

const NamedTexts kPlace{{"place", "(on|under|next to) the {thing}"}};

/// What is said back, where it is understood as short and right; else why not.
std::string said_back(const Question& question, const std::string& said) {
    const Mark mark = mark_answer(question, said);
    return !mark.understood               ? "not understood"
           : !mark.short_answer           ? "not short: " + mark.corrected
           : !mark.form_right()           ? "wrong: " + mark.corrected
           : mark.slot("thing") == "bowl" ? mark.corrected
                                          : "not the bowl";
}

}  // namespace

TEST_CASE(
    "tail answers: what a rule says is an answer alone, and is said back whole with its own "
    "words") {
    const Question question = asked({"the apple is <place>"}, kPlace);
    CHECK(said_back(question, "Next to the bowl.") == "The apple is next to the bowl.");
    CHECK(said_back(question, "under the bowl") == "The apple is under the bowl.");
    CHECK(said_back(question, "It's next to the bowl") == "It is next to the bowl.");
    CHECK(said_back(question, "it is under the bowl") == "It is under the bowl.");
    const Mark wrong = mark_answer(question, "next to bowl");
    REQUIRE(wrong.understood);
    CHECK(wrong.emphasised == "The apple is next to *the bowl*.");
}

TEST_CASE("tail answers: lists behind \"is\" go without a rule, and a rule without \"is\"") {
    const NamedLists places{{"place", {"next to", "under"}}};
    const Question listed = asked({"(it|the apple) is {place} the {thing}"}, {}, places);
    CHECK(said_back(listed, "Under the bowl.") == "It is under the bowl.");
    const Question put = asked({"I put it <place>"}, kPlace);
    CHECK(said_back(put, "Next to the bowl.") == "I put it next to the bowl.");
    CHECK(said_back(put, "it is next to the bowl") == "not understood");
    const Question several = asked({"the apples are <place>"}, kPlace);
    CHECK(said_back(several, "they are under the bowl") == "They are under the bowl.");
    CHECK(said_back(several, "it is under the bowl") == "wrong: They are under the bowl.");
}

TEST_CASE("tail answers: none where something would be missing, or the learner is to ask") {
    const NamedLists fruits{{"fruit", {"apple", "pear"}}};
    CHECK(said_back(asked({"the {fruit} is <place>"}, kPlace, fruits), "under the bowl") ==
          "not understood");
    CHECK(said_back(asked({"the apple is <place> [and not <other>]"},
                          {kPlace[0], {"other", "on the table"}}),
                    "under the bowl and not on the table") ==
          "The apple is under the bowl and not on the table.");
    const Question asks = asked({"where is <place>"}, kPlace);
    CHECK(said_back(asks, "under the bowl") == "not understood");
    CHECK(said_back(asked({"I see the <what>"}, {{"what", "[big] {thing}"}}), "big bowl") ==
          "not understood");
    // Behind "there" the verb goes with what is counted: "no planet" is an answer of the number's, said back with its verb.
    const NamedLists numbers{{"number", {"no", "eight"}}};
    const Question there =
        asked({"there are {number} <plural:planet> [in (our|the) sky]"}, {}, numbers);
    for (const char* said : {"no planet", "no planet on our sky", "no planet in a sky"}) {
        const std::string back = mark_answer(there, said).corrected;
        CHECK(back.find("are no planet ") == std::string::npos);
        CHECK(back.find("are no planet.") == std::string::npos);
    }
}

TEST_CASE("tail answers: where there is no room for them a question goes without") {
    NamedLists lists{{"place", {}}};
    for (int i = 0; i < 400; ++i) {
        lists[0].second.push_back("beside thing " + std::to_string(i));
    }
    std::vector<std::string> answers;
    for (int i = 0; i < 16; ++i) {
        answers.push_back("the apple is {place} the {thing} number " + std::to_string(i));
    }
    const Question question = asked(answers, {}, lists);
    CHECK(mark_answer(question, "the apple is beside thing 7 the bowl number 15").understood);
    CHECK(mark_answer(question, "beside thing 7 the bowl number 0").understood);
    CHECK_FALSE(mark_answer(question, "beside thing 7 the bowl number 15").understood);
}
