#include "dialogue/checking/link_grammar/link_judge.h"

#include "tests/unit/dialogue/checking/checked.h"

#include <clocale>
#include <string>

using namespace fulcrum::dialogue;

namespace {

std::unique_ptr<SentenceJudge> made_judge() {
    auto judge = make_link_judge();
    REQUIRE(judge);
    return std::move(*judge);
}

}  // namespace

TEST_CASE("link judge: good sentences have no misfits, bad ones have some") {
    const auto judge = made_judge();
    for (const char* good : {"it is an apple.", "the watermelon is heavier than the egg.",
                             "why is it heavy?", "I saw a moon.", "there are two moons."}) {
        INFO(good);
        CHECK(judge->misfits(good) == 0);
    }
    for (const char* bad :
         {"I saw moon.", "the planets goes around the sun.", "there is two moons."}) {
        INFO(bad);
        CHECK(judge->misfits(bad).value_or(9) > 0);
    }
}

TEST_CASE(
    "link judge: one that opens its dictionary for the first sentence judges as the others do") {
    auto late = make_link_judge(GrammarOpens::for_a_sentence);
    REQUIRE(late);
    const auto judge = made_judge();
    for (const char* sentence : {"it is an apple.", "I saw moon.", "there is two moons.", ""}) {
        INFO(sentence);
        CHECK((*late)->misfits(sentence) == judge->misfits(sentence));
    }
}

TEST_CASE("link judge: it says nothing of what is too long, empty or no text, and goes on") {
    const auto judge = made_judge();
    std::string endless;
    for (int i = 0; i < 1000; ++i) {
        endless += "big ";
    }
    CHECK_FALSE(judge->misfits(endless));
    for (const std::string& odd :
         {std::string{}, std::string("\x01\x02"), std::string("\xff\xfe"), std::string(3000, 'x'),
          std::string("((((((((("), std::string("수박")}) {
        (void)judge->misfits(odd);
    }
    CHECK(judge->misfits("it is an apple.") == 0);
}

TEST_CASE("link judge: the program's characters stay as they were") {
    const std::string before = std::setlocale(LC_CTYPE, nullptr);
    const auto judge = made_judge();
    CHECK(std::setlocale(LC_CTYPE, nullptr) == before);
}

TEST_CASE("link judge: with it a checker sees an article that is missing") {
    EnglishChecker checker(opened_lexicon(), made_judge());
    CHECK(checker.check("I saw moon.").corrected == "I saw a moon.");
    CHECK(checker.check("I saw a moon.").errors.empty());
    CHECK(checker.check("The planets goes around the sun.").corrected ==
          "The planets go around the sun.");
}

TEST_CASE("link judge: with it a checker offers only what it can prove, with all errors mended") {
    EnglishChecker checker(opened_lexicon(), made_judge());
    checker.set_things({"tail", "kite", "hand"});
    const struct {
        const char *said, *offered;
    } rows[] = {
        {"It need longer tail", "It needs a longer tail"},
        {"it want the a tail", "it wants a tail"},
        {"Earth have only moon", "Earth has only one moon"},
        {"the things is made by metals", "the things are made of metal"},
        {"I wants a apple because he have two moon", "I want an apple because he has two moons"}};
    for (const auto& row : rows) {
        INFO(row.said);
        const CheckedText checked = checker.advise(row.said);
        CHECK(checked.corrected == row.offered);
        CHECK(checked.proven);
        CHECK(checker.advise(checked.corrected).errors.empty());
    }
    for (const char* unproven :
         {"it's lift what holds up", "kite is fly", "the kite have longest tail",
          "The support have to come nearer hand", "Kite it fly because wind push he"}) {
        INFO(unproven);
        const CheckedText checked = checker.advise(unproven);
        CHECK((!checked.proven || checked.corrected == "The support has to come nearer the hand"));
    }
    // What nobody can prove isn't offered, whatever else was mended in it.
    for (const char* unproven :
         {"the kite fly very highly", "it push in up", "it wish a tail", "it miss the tail",
          "it make the kite to fly more high", "the Sun give light and warm", "it have not a tail",
          "it need a longer tail because wind is stronger"}) {
        INFO(unproven);
        CHECK_FALSE(checker.advise(unproven).errors.empty());
        CHECK_FALSE(checker.advise(unproven).proven);
    }
    CHECK(checker.advise("give it longer tail").corrected == "give it a longer tail");
    CHECK(checker.advise("it's lift what holds up").corrected != "it lift what holds up");
}
