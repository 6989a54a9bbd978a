#include "dialogue/marking/said_spans.h"

#include "dialogue/template/tokens.h"

#include <catch2/catch.hpp>

#include <string>

using namespace fulcrum::dialogue;

namespace {

std::string parted(std::string_view text, bool clauses) {
    std::string parts;
    for (const SaidSpan& span : said_sentences(text, clauses)) {
        parts += (parts.empty() ? "" : "|") +
                 words_between_blanks(text.substr(span.begin, span.end - span.begin));
    }
    return parts;
}

}  // namespace

TEST_CASE("said spans: a sentence ends where English ends it") {
    CHECK(parted("Eight. There are eight!", false) == " eight | there are eight ");
    CHECK(parted("It is 3.5 newtons", false) == " it is three point five newtons ");
    CHECK(parted("Mr. Fox is here", false) == " mr fox is here ");
    CHECK(parted("e.g. a fox", false) == " e g a fox ");
    CHECK(parted("Well... the egg.", false) == " well | the egg ");
    CHECK(parted("The egg; it falls", false) == " the egg | it falls ");
    CHECK(parted("The egg. Because it is big.", false) == " the egg because it is big ");
    CHECK(parted("1,000 eggs", true) == " one thousand eggs ");
    CHECK(parted("the egg, not the apple", false) == " the egg not the apple ");
    CHECK(parted("the egg, not the apple", true) == " the egg | not the apple ");
    CHECK(parted("not hard but soft", true) == " not hard | soft ");
    CHECK(parted("hard and not soft, but wet", true) == " hard and not soft | wet ");
    CHECK(parted("the egg and the apple", true) == " the egg and the apple ");
    CHECK(parted("it is hard and it is wet", true) == " it is hard | it is wet ");
    CHECK(parted("", true).empty());
    CHECK(parted("...", true).empty());
}

TEST_CASE("said spans: a list stands behind a colon, or of two and more behind a comma") {
    const auto size = [](std::string_view text) {
        const auto list = list_behind(text);
        return list ? static_cast<int>(list->items.size()) : 0;
    };
    CHECK(size("four: lift, drag, weight and tension") == 4);
    CHECK(size("two, Phobos and Deimos") == 2);
    CHECK(size("one: the Moon") == 1);
    CHECK(size("one, the Moon") == 0);
    CHECK(size("two: Phobos, not Deimos") == 0);
    CHECK(size("two: this is not true") == 0);
    CHECK(size("two") == 0);
    CHECK(size("two:") == 0);
    CHECK(size("a: b: c") == 0);
}
