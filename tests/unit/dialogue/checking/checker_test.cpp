#include "tests/unit/dialogue/checking/checked.h"

#include <rapidcheck.h>
#include <string>

using namespace fulcrum::dialogue;

namespace {

void require_whole(std::string_view text, const CheckedText& result) {
    std::size_t at = 0;
    for (const FreeError& error : result.errors) {
        RC_ASSERT(error.code != ErrorCode::none);
        RC_ASSERT(error.begin <= error.end);
        RC_ASSERT(error.end <= text.size());
        RC_ASSERT(at <= error.begin);
        RC_ASSERT(error.said == text.substr(error.begin, error.end - error.begin));
        at = error.end;
    }
}

}  // namespace

TEST_CASE("checker: a word that is missing stands alone where its noun follows, and no verb does") {
    EnglishChecker checker = words_alone();
    checker.set_things({"tail"});
    const auto alone = [&](std::string_view text) {
        const CheckedText checked = checker.check(text);
        return !checked.errors.empty() && checked.errors.front().alone;
    };
    CHECK(alone("It have wings."));
    CHECK(alone("It needs tail."));
    CHECK_FALSE(alone("It needs longer tail."));
    CHECK_FALSE(alone("It heavy."));
    CHECK_FALSE(alone("Is very heavy."));
}

TEST_CASE("checker: several errors of a text, each at its place") {
    EnglishChecker checker = words_alone();
    const CheckedText result = checker.check("It have a moon.");
    REQUIRE(result.errors.size() == 1);
    CHECK(result.errors[0].begin == 3);
    CHECK(result.errors[0].end == 7);
    CHECK(result.errors[0].said == "have");
    CHECK(result.errors[0].right == "has");
    CHECK(result.corrected == "It has a moon.");
}

TEST_CASE("checker: what one error hides is found when that one is mended") {
    EnglishChecker checker = words_alone();
    checker.set_things({"tail", "kite"});
    const CheckedText result = checker.check("it need more longer tail");
    CHECK(result.marked == "it *needs* *a* *longer* tail");
    CHECK(result.settled);
    REQUIRE(result.errors.size() == 3);
    CHECK(result.errors[1].begin == 8);
    CHECK(result.errors[2].said == "more longer");
    CHECK_FALSE(result.proven);
}

TEST_CASE("checker: nobody proves what no judge can tell") {
    EnglishChecker checker = words_alone();
    CHECK(checker.advise("It have a moon.").errors.size() == 1);
    CHECK_FALSE(checker.advise("It have a moon.").proven);
}

TEST_CASE("checker: two that only a judge can tell are found together") {
    EnglishChecker checker(opened_lexicon(),
                           std::make_unique<ToldJudge>(std::map<std::string, int, std::less<>>{
                               {"I saw moon near planet.", 2},
                               {"I saw a moon near planet.", 1},
                               {"I saw moon near a planet.", 1},
                               {"I saw a moon near a planet.", 0}}));
    const CheckedText result = checker.advise("I saw moon near planet.");
    CHECK(result.corrected == "I saw a moon near a planet.");
    CHECK(result.proven);
}

TEST_CASE(
    "checker: a missing article is marked where the judge finds the sentence better with it") {
    const auto judged = [](int without, int with) {
        EnglishChecker checker(opened_lexicon(),
                               std::make_unique<ToldJudge>(std::map<std::string, int, std::less<>>{
                                   {"I saw moon.", without}, {"I saw a moon.", with}}));
        return checker.check("I saw moon.").corrected;
    };
    CHECK(judged(1, 0) == "I saw a moon.");
    CHECK(judged(0, 0) == "I saw moon.");
    CHECK(judged(2, 1) == "I saw moon.");
    // The words alone do not tell.
    CHECK(words_alone().check("I saw moon.").errors.empty());
}

TEST_CASE("checker: what isn't English, or no text at all, is left as it is") {
    for (const std::string& text :
         {std::string{}, std::string(" \n\t"), std::string("수박이 제일 무거워요"),
          std::string("\x00\x01\x7f\x1b[31m", 8), std::string("\xff\xfe\xc3"),
          std::string("Ça va très bien."), std::string("%s%n{}*…*")}) {
        CHECK(words_alone().check(text).errors.empty());
        CHECK(words_alone().check(text).corrected == text);
    }
}

TEST_CASE("checker: of ten megabytes the beginning is looked at and all is kept") {
    std::string text = "it have two moon. ";
    while (text.size() < 10'000'000) {
        text += "it have two moon ";
    }
    EnglishChecker checker = words_alone();
    const CheckedText result = checker.check(text);
    CHECK(result.errors.size() ==
          2);  // what has no end within the first thousand bytes is too long
    CHECK(result.corrected.size() == text.size() - 4 + 3 + 1);
    CHECK(result.corrected.ends_with("it have two moon "));
}

TEST_CASE("checker: any bytes give errors in order within them, and nothing between them is lost") {
    CHECK(rc::check([](const std::string& text) {
        static EnglishChecker checker = words_alone();
        const CheckedText result = checker.check(text);
        require_whole(text, result);
        RC_ASSERT(!result.errors.empty() || result.corrected == text);
    }));
}

TEST_CASE("checker: any words give errors in order within them") {
    static const std::vector<std::string> kWords = {
        "it",    "they",  "I",     "is",    "are",     "have", "has",  "the",  "a",      "an",
        "apple", "moons", "moon",  "heavy", "heavier", "most", "more", "than", "then",   "made",
        "of",    "metal", "two",   "there", "why",     "?",    ".",    ",",    "very",   "hardly",
        "this",  "these", "feels", "like",  "one",     "be",   "not",  "what", "Jupiter"};
    CHECK(rc::check([] {
        static EnglishChecker checker = words_alone();
        std::string text;
        const int n_words = *rc::gen::inRange(0, 14);
        for (int i = 0; i < n_words; ++i) {
            text += *rc::gen::elementOf(kWords) + " ";
        }
        require_whole(text, checker.check(text));
    }));
}
