// scripts/lib/numbers.lua, run in a lesson as teachers use it.
#include "tests/unit/runtime/lua/lesson_player.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {
namespace {

std::string printed(const std::string& lines) {
    test::Player player;
    player.start("local numbers = require 'numbers'\nfunction L:start(world)\n" + lines + "\nend");
    return player.prints;
}

std::string mistake(const std::string& line) {
    const test::LessonFolder folder;
    auto process = folder.start(test::lesson_text(
        "local numbers = require 'numbers'\nfunction L:start(world)\n" + line + "\nend"));
    return process ? std::string("started") : to_sentence(process.error());
}

}  // namespace

TEST_CASE("numbers: are said as people say them") {
    CHECK(
        printed("for _, n in ipairs { 0, 1, 10, 19, 20, 21, 99, 100, 105, 318, 1000, 1001, 2100, "
                "999999 } do print(numbers.word(n)) end") ==
        "no;one;ten;nineteen;twenty;twenty-one;ninety-nine;one hundred;one hundred and five;three "
        "hundred and eighteen;one thousand;one thousand and one;two thousand one hundred;nine "
        "hundred and ninety-nine thousand nine hundred and ninety-nine;");
}

TEST_CASE("numbers: what is said is what was meant") {
    CHECK(printed("local wrong = 0 for n = 0, 20000, 7 do if numbers.value(numbers.word(n)) ~= n "
                  "then wrong = wrong + 1 end end print(wrong)") == "0;");
    CHECK(printed("print(numbers.value 'a hundred', numbers.value 'many', numbers.value '', "
                  "numbers.value(nil))") == "nil\tnil\tnil\tnil;");
}

TEST_CASE("numbers: words for a list have every way to say them") {
    CHECK(printed("print(table.concat(numbers.words(0, 3), ', '))") ==
          "no|zero|none, one|a|an, two, three;");
    CHECK(printed("print(table.concat(numbers.words { 10, 100, 1000 }, ', '))") ==
          "ten, one hundred|a hundred|hundred, one thousand|a thousand|thousand;");
}

TEST_CASE("numbers: what it is given wrong is told at the lesson's line") {
    CHECK(mistake("numbers.word(-1)") ==
          "lesson.lua:4: numbers.word takes whole numbers from 0 to 999999; got -1.");
    CHECK(
        mistake("numbers.words { 'one' }") ==
        "lesson.lua:4: numbers.words takes whole numbers from 0 to 999999; got the text \"one\".");
    CHECK(mistake("numbers.words(1)") ==
          "lesson.lua:4: numbers.words takes whole numbers from 0 to 999999; got nothing.");
    CHECK(mistake("numbers.wrd(1)") == "lesson.lua:4: numbers has no wrd; did you mean word?");
}

}  // namespace fulcrum::runtime
