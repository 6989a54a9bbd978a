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
