#include "dialogue/template/variants.h"

#include "dialogue/marking/mark.h"
#include "tests/unit/dialogue/marking/marked_rows.h"
#include "tests/unit/dialogue/questions.h"

#include <catch2/catch.hpp>

#include <string>

using namespace fulcrum::dialogue;

namespace {

/// What is meant, and the errors found; "?" where it is not understood.
std::string meant(const Question& question, const std::string& said) {
    const Mark mark = mark_answer(question, said);
    if (!mark.understood) {
        return "?";
    }
    constexpr const char* kClaims[] = {"", "contrary ", "excluded ", "none ", "any "};
    std::string text = kClaims[static_cast<int>(mark.claim)];
    for (const auto& [slot, value] : mark.slots) {
        text += slot + "=" + value + " ";
    }
    for (const FormError& error : mark.form_errors) {
        text += std::string(error.errant()) + " ";
    }
    return text.empty() ? text : text.substr(0, text.size() - 1);
}

Question blocks() {
    return compiled({"heavier",
                     "Which block is heavier: the wooden block or the metal block?",
                     {"[the|a] {thing} is <comparative:heavy> [than [the|a] {other}]"},
                     {{"thing", {"wooden block", "stone block", "metal block"}},
                      {"other", {"wooden block", "stone block", "metal block"}}}});
}

}  // namespace

TEST_CASE("variants: of two things, what is said of the other one says as much") {
    const Question question = heavier();  // an apple or an egg
    const std::string apple = "other=egg thing=apple";
    for (const char* said :
         {"the egg is not as heavy as the apple", "an egg isn't as heavy as an apple",
          "the egg is not so heavy as the apple", "the egg is not heavier than the apple",
          "the egg is less heavy than the apple", "the egg does not weigh as much as the apple"}) {
        INFO(said);
        CHECK(meant(question, said) == apple);
    }
    CHECK(meant(question, "the apple is not as light as the egg") == "thing=apple other=egg");
    CHECK(meant(question, "the apple is not lighter than the egg") == "thing=apple other=egg");
    // What compares nothing says nothing of the other one.
    CHECK(meant(question, "the egg is not heavy") == "excluded thing=egg");
    CHECK(meant(question, "the egg is not very heavy") == "excluded thing=egg");
    CHECK(meant(question, "the egg is not as heavy than the apple") == apple + " R:PREP");
    CHECK(meant(question, "the egg not as heavy as the apple") == apple + " M:VERB");
    CHECK(meant(question, "the egg is not as heavier as the apple") == apple + " R:ADJ:FORM");
    // The question names two: not the one is the other.
    for (const char* said :
         {"the egg is not heavier", "an egg isn't as heavy", "the egg doesn't weigh more"}) {
        INFO(said);
        CHECK(meant(question, said) == "thing=apple");
    }
}

TEST_CASE("variants: one of several that is ruled out leaves the answer open") {
    CHECK(meant(heaviest(), "the egg is not the heaviest") == "excluded thing=egg");
    CHECK(meant(heaviest(), "the egg isn't as heavy as the others") == "excluded thing=egg");
    CHECK(meant(heaviest(), "the egg is not heavy") == "excluded thing=egg");
    CHECK(meant(heaviest(), "egg is not the heaviest") == "excluded thing=egg M:DET");
    CHECK(meant(blocks(), "the stone block is not heavier") == "excluded thing=stone block");
    CHECK(meant(blocks(), "the wooden block is not heavier") == "thing=metal block");
    CHECK(meant(made_of_what(), "a spaceship is not made of metal") ==
          "excluded thing=spaceship material=metal");
    CHECK(meant(made_of_what(), "it isn't metal") == "excluded material=metal");
}

TEST_CASE("variants: the others, and the verb that an adjective has") {
    for (const char* said :
         {"the egg weighs the most", "an egg weighs most", "the egg is heavier than the others",
          "the egg is heavier than all the others", "the egg is heavier than the rest",
          "the others are not as heavy as the egg", "nothing is heavier than the egg",
          "the egg weighs more than the others", "the egg is by far the heaviest",
          "the one that weighs the most is the egg", "the others are lighter than the egg"}) {
        INFO(said);
        CHECK(meant(heaviest(), said) == "thing=egg");
    }
    CHECK(meant(heaviest(), "the egg weigh the most") == "thing=egg R:VERB:SVA");
    CHECK(meant(heaviest(), "the egg weight the most") == "thing=egg R:MORPH");
    CHECK(meant(heaviest(), "the egg is heavier than others") == "thing=egg M:DET");
    CHECK(meant(heaviest(), "the egg weighs the most thing") == "?");
    for (const char* said : {"the egg weighs more", "the egg is heavier than the other one",
                             "the egg is the heavier one", "the heavier one is the egg",
                             "the egg is the heavier of the two", "the egg feels heavier"}) {
        INFO(said);
        CHECK(meant(heavier(), said) == "thing=egg");
    }
    CHECK(meant(heavier(), "the egg weighs more than the apple") == "thing=egg other=apple");
    CHECK(meant(biggest(), "Jupiter weighs the most") == "?");
    for (const char* said :
         {"the metal block is heavier than the other blocks", "the metal block has more weight",
          "the metal block is heavier than the other two blocks",
          "the metal block is heavier than the other two",
          "the metal block has a lot more weight than the other blocks"}) {
        INFO(said);
        CHECK(meant(blocks(), said) == "thing=metal block");
    }
    CHECK(meant(heavier(), "the egg has more weight than the apple") == "thing=egg other=apple");
    CHECK(meant(heavier(), "the egg has less weight") == "?");
    CHECK(meant(biggest(), "Jupiter has more size") == "?");
}

TEST_CASE("variants: that there is no difference, of whatever may be compared") {
    for (const char* said : {"they weigh the same", "both are the same", "both weigh the same",
                             "neither", "neither of them is heavier", "they are equally heavy",
                             "they are equal", "they have the same weight",
                             "they are as heavy as each other", "there is no difference"}) {
        INFO(said);
        CHECK(meant(heavier(), said) == "none");
        CHECK(mark_answer(heavier(), said).readings.size() == 4);
    }
    CHECK(meant(heaviest(), "they all weigh the same") == "none");
    CHECK(meant(heavier(), "the apple is as heavy as the egg") == "none thing=apple other=egg");
    CHECK(meant(heavier(), "the apple and the egg weigh the same") == "none thing=apple other=egg");
    CHECK(meant(heavier(), "they weighs the same") == "none R:VERB:SVA");
    CHECK(meant(biggest(), "they have the same size") == "none");
    CHECK(meant(biggest(), "they weigh the same") == "?");
    // Where it is not clear what is compared nothing is claimed.
    const Question where = compiled({"easier",
                                     "Where?",
                                     {"it is <comparative:easy> {place} it"},
                                     {{"place", {"near", "far from"}}}});
    CHECK(meant(where, "they are the same") == "?");
}

TEST_CASE("variants: what is told of a thing may be denied") {
    CHECK(meant(feels_how(), "metal is not hard") == "contrary material=metal feel=hard");
    CHECK(meant(feels_how(), "it isn't very hard") == "contrary feel=hard");
    CHECK(meant(feels_how(), "metal is not hardly") == "contrary material=metal feel=hard R:MORPH");
    const Question should = compiled({"should",
                                      "Where?",
                                      {"(it|the block) should be at the {place}"},
                                      {{"place", {"top", "bottom"}}}});
    CHECK(meant(should, "it shouldn't be at the top") == "excluded place=top");
    const Question shortly =
        compiled({"shortly", "Which?", {"it is the {thing}", "at the {thing}"}, fruit()});
    CHECK(meant(shortly, "not the egg") == "excluded thing=egg");
    CHECK(meant(shortly, "not at the egg") == "excluded thing=egg");
    CHECK(mark_answer(shortly, "not the egg").short_answer);
    // What says "not" or "yes" itself, and what asks, is left as it is.
    const Question yes =
        compiled({"yes", "Is it red?", {"{yes} it is red"}, {{"yes", {"yes", "no"}}}});
    CHECK(meant(yes, "yes it is not red") == "?");
    const Question asks = compiled({"asks", "Ask!", {"is it {thing}"}, fruit()});
    CHECK(meant(asks, "is it not egg") == "?");
}

TEST_CASE("variants: where there is no room they are left out") {
    NamedLists many{{"thing", {}}};
    for (int i = 0; i < 900; ++i) {
        many[0].second.push_back("word" + std::string(1, static_cast<char>('a' + i / 100)) +
                                 std::string(1, static_cast<char>('a' + i / 10 % 10)) +
                                 std::string(1, static_cast<char>('a' + i % 10)));
    }
    const Question question =
        compiled({"many", "Which?", {"the {thing} is the <superlative:heavy>"}, many});
    CHECK(mark_answer(question, "the wordaaa is the heaviest").understood);
}
