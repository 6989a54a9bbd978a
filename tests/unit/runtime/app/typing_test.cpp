#include "runtime/app/typing.h"

#include "tests/unit/runtime/rig.h"

using fulcrum::runtime::TypedLine;

TEST_CASE("typing: letters come in, return takes the line") {
    TypedLine line;
    line.add("an ");
    line.add("apple");
    CHECK(line.text() == "an apple");
    CHECK(line.take() == "an apple");
    CHECK(line.text().empty());
    CHECK_FALSE(line.take());
}

TEST_CASE("typing: backspace takes whole characters, also those of several bytes") {
    TypedLine line;
    line.add("aé사");
    line.backspace();
    CHECK(line.text() == "aé");
    line.backspace();
    CHECK(line.text() == "a");
    line.backspace();
    line.backspace();
    CHECK(line.text().empty());
}

TEST_CASE("typing: control characters and overlong lines are left out, no part of a character") {
    TypedLine line;
    line.add("a\nb\tc\x7f");
    CHECK(line.text() == "abc");
    line.clear();
    for (int i = 0; i < 100; ++i) {
        line.add("é");
    }
    CHECK(line.text().size() == 160);
    line.add("é");
    CHECK(line.text().size() == 160);
}

TEST_CASE("typing: blanks alone are no answer") {
    TypedLine line;
    line.add("   ");
    CHECK_FALSE(line.take());
    CHECK(line.text().empty());
}
