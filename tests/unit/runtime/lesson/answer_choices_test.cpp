#include "runtime/lesson/answer_choices.h"

#include "dialogue/marking/mark.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

dialogue::Question heaviest(const std::vector<std::string>& things) {
    return value_of(
        dialogue::compile_question({"heaviest",
                                    "Which one is the heaviest?",
                                    {"[a|an|the] {thing} is the <superlative:heavy> [one]"},
                                    {{"thing", things}}}));
}

Expected<bool> is_watermelon(const AnswerSlots& slots) {
    return slots == AnswerSlots{{"thing", "watermelon"}};
}

}  // namespace

TEST_CASE("answer choices: one is right, all are right in form, and no two mean the same") {
    const auto question = heaviest({"watermelon", "apple", "banana", "egg", "stone", "feather"});
    const auto choices = value_of(make_choices(question, is_watermelon));
    REQUIRE(choices.size() == kMostChoices);
    CHECK(std::ranges::count(choices, true, &AnswerChoice::right) == 1);
    std::set<AnswerSlots> meanings;
    for (const AnswerChoice& choice : choices) {
        const dialogue::Mark mark = dialogue::mark_answer(question, choice.said);
        INFO(choice.said);
        CHECK(mark.understood);
        CHECK(mark.form_right());
        CHECK(mark.slots == choice.meaning);
        CHECK(choice.right == (choice.meaning == AnswerSlots{{"thing", "watermelon"}}));
        meanings.insert(choice.meaning);
    }
    CHECK(meanings.size() == choices.size());
}

TEST_CASE("answer choices: one question gives the same ones; the right one is at various places") {
    const auto said = [](const Expected<std::vector<AnswerChoice>>& choices) {
        std::vector<std::string> all;
        for (const AnswerChoice& choice : *choices) {
            all.push_back(choice.said);
        }
        return all;
    };
    const auto question = heaviest({"watermelon", "apple", "banana", "egg"});
    CHECK(said(make_choices(question, is_watermelon)) ==
          said(make_choices(question, is_watermelon)));
    std::set<std::ptrdiff_t> places;
    for (const char* id : {"a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "l"}) {
        dialogue::Question other = question;
        other.id = id;
        const auto choices = value_of(make_choices(other, is_watermelon));
        places.insert(std::ranges::find(choices, true, &AnswerChoice::right) - choices.begin());
    }
    CHECK(places.size() >= 3);
}

TEST_CASE("answer choices: the right one of a hundred is found; of none, three others are given") {
    std::vector<std::string> many{"watermelon"};
    for (const char* first :
         {"red", "blue", "green", "grey", "black", "white", "brown", "pink", "gold", "silver"}) {
        for (const char* second :
             {"box", "cup", "ball", "hat", "shoe", "book", "pen", "bag", "lamp"}) {
            many.push_back(std::string(first) + " " + second);
        }
    }
    const auto choices = value_of(make_choices(heaviest(many), is_watermelon));
    CHECK(choices.size() == kMostChoices);
    CHECK(std::ranges::count(choices, true, &AnswerChoice::right) == 1);
    const auto wrong =
        value_of(make_choices(heaviest({"apple", "banana", "egg", "stone"}), is_watermelon));
    CHECK(wrong.size() == kMostChoices - 1);
    CHECK(std::ranges::count(wrong, true, &AnswerChoice::right) == 0);
}

TEST_CASE("answer choices: nothing is compared with itself") {
    const auto question = value_of(dialogue::compile_question(
        {"heavier",
         "Which one is heavier?",
         {"[a|an|the] {thing} is <comparative:heavy> [than [a|an|the] {other}]"},
         {{"thing", {"apple", "egg", "stone"}}, {"other", {"apple", "egg", "stone"}}}}));
    const auto choices = value_of(make_choices(question, [](const AnswerSlots& slots) {
        return Expected<bool>(slots.front().second == "stone");
    }));
    CHECK(choices.size() == kMostChoices);
    for (const AnswerChoice& choice : choices) {
        INFO(choice.said);
        CHECK((choice.meaning.size() < 2 || choice.meaning[0].second != choice.meaning[1].second));
    }
}

TEST_CASE("answer choices: a verdict that fails is the lesson's error") {
    CHECK(error_of(make_choices(heaviest({"egg", "apple"}), [](const AnswerSlots&) {
              return Expected<bool>(fail("the lesson broke", "lesson.lua:3", "mend it"));
          })).where == "lesson.lua:3");
}
