#include "runtime/lua/sandbox/plain_words.h"

#include "tests/unit/runtime/lua/hosted_lesson.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {
namespace {

std::string load(const std::string& text) {
    return test::HostedLesson().load(text);
}

TEST_CASE("plain words: what Lua cannot read is told with what to do") {
    const struct {
        const char *text, *sentence;
    } rows[] = {
        {"local t = { a = 1 b = 2 }",
         "lesson.lua:2: '}' expected near 'b'; put a comma between two fields."},
        {"print(1 2)",
         "lesson.lua:2: ')' expected near '2'; put a comma between two values, and a ) behind the "
         "last."},
        {"function L:start()\nif true then\nend",
         "lesson.lua:6: 'end' expected (to close 'function' at line 2) near <eof>; write the end "
         "that belongs to the function of line 2."},
        {"print(function()\nend\nend",
         "lesson.lua:4: ')' expected (to close '(' at line 2) near 'end'; write the ) that belongs "
         "to the ( of line 2."},
        {"local a = 10cm",
         "lesson.lua:2: malformed number near '10cm'; write a number without its unit, and with a "
         "point: 0.5."},
        {"local a = \xE2\x80\x9Chello\xE2\x80\x9D",
         "lesson.lua:2: unexpected symbol near '<\\226>'; only plain signs belong there; write "
         "straight quotation marks, \"…\"."},
        {"if 1 != 2 then end", "lesson.lua:2: 'then' expected near '!'; \"is not\" is written ~=."},
        {"local a = 1 if a = 1 then end",
         "lesson.lua:2: 'then' expected near '='; two values are compared with ==."},
        {"local a = \"one\nlocal b",
         "lesson.lua:2: unfinished string near '\"one'; a text ends on its own line, with the "
         "quotation mark that it began with."},
        {"local t = {\n  a = 1,\n\nlocal b = 2",
         "lesson.lua:5: unexpected symbol near 'local'; is a } missing before it?"},
        {"local t = {\n  a = f { }\n\nlocal b = 2",
         "lesson.lua:5: '}' expected (to close '{' at line 2) near 'local'; write the } that "
         "belongs "
         "to the { of line 2."},
        {"local t = {\n  a = f { },\nfunction L:start() end",
         "lesson.lua:4: '(' expected near 'L'; a function with a name stands outside all braces; "
         "is a } "
         "missing before it?"},
        {"local t = {\n  a = function()\n    return 1,\n  b = 2 }",
         "lesson.lua:5: 'end' expected (to close 'function' at line 3) near '='; write the end of "
         "that "
         "function before this, or == where two values are compared."},
        {"print(1)\nend",
         "lesson.lua:3: <eof> expected near 'end'; take out this end, or one before it."},
    };
    for (const auto& row : rows) {
        INFO(row.text);
        CHECK(load(row.text) == row.sentence);
    }
}

TEST_CASE("plain words: a { that is missing is told where it is missing") {
    CHECK(load("L:question \"float\"\n  prompt = \"Which?\",\n  answers = { \"x\" },\n}") ==
          "lesson.lua:2: the { behind L:question \"float\" is missing.");
    CHECK(load("L:test\n\n  say = { \"x\" },\n  expect = { },\n}") ==
          "lesson.lua:2: the { behind L:test is missing.");
    CHECK(find_missing_brace("local w = world:body\n  name = 'x',\n", 2)->call ==
          "local w = world:body");
    // Not where all have it, nor where what follows is no field.
    CHECK_FALSE(find_missing_brace("L:question \"a\" {\n  prompt = \"x\"\n  answers = 1 }", 3));
    CHECK_FALSE(find_missing_brace("world:caption \"a\"\nscore = = 3", 2));
    CHECK_FALSE(find_missing_brace("game.ask \"a\"\nscore = = 3", 2));
    CHECK_FALSE(find_missing_brace("L:test\nprint(1)\nx = = 3", 3));
    CHECK_FALSE(find_missing_brace("", 1));
    CHECK_FALSE(find_missing_brace("\"\n'\n:", 3));
}

TEST_CASE("plain words: what fails while it runs is told with what to do") {
    const struct {
        const char *text, *sentence;
    } rows[] = {
        {"local t = {} t.a.b = 1",
         "lesson.lua:2: attempt to index a nil value (field 'a'); a has no value here; where it "
         "may be left out, ask first: if ….a then … end."},
        {"local other = nil print(other.weight)",
         "lesson.lua:2: attempt to index a nil value (local 'other'); other has no value here; "
         "where it may be left out, ask first: if other then … end."},
        {"local t = { a = 1 } local k = \"b\" print(\"is \" .. t[k])",
         "lesson.lua:2: attempt to concatenate a nil value (field '?'); the table has nothing "
         "under "
         "the name that is looked for."},
        {"local n = nil print(n + 1)",
         "lesson.lua:2: attempt to perform arithmetic on a nil value (local 'n'); n has no value "
         "here."},
        {"L:questoin()",
         "lesson.lua:2: attempt to call a nil value (method 'questoin'); there is no function "
         "questoin here; is it spelt right, and is the function around it written with a colon, "
         "as function L:start(world)?"},
        {"for a in { 1 } do end",
         "lesson.lua:2: attempt to call a table value (for iterator 'for iterator'); write for i, "
         "thing in ipairs(…), or for name, thing in pairs(…)."},
        {"print(1 < 'a')",
         "lesson.lua:2: attempt to compare number with string; only two numbers can be compared, "
         "or two texts."},
        {"local function f() return 1 + f() end f()",
         "lesson.lua:2: this calls itself too deeply (a function that never stops calling "
         "itself?)."},
    };
    for (const auto& row : rows) {
        INFO(row.text);
        CHECK(load(row.text) == row.sentence);
    }
}

TEST_CASE("plain words: other messages stay as they are") {
    CHECK(in_plain_words("body has no field \"a\"") == "body has no field \"a\"");
    CHECK(in_plain_words("unexpected symbol near '='") == "unexpected symbol near '='");
    CHECK(in_plain_words("attempt to index a nil value") == "attempt to index a nil value");
    CHECK(in_plain_words("(to close '") == "(to close '");
    CHECK(in_plain_words("") == "");
}

}  // namespace
}  // namespace fulcrum::runtime
