#include "tests/unit/runtime/lua/hosted_lesson.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {
namespace {

constexpr auto run = [](auto&&... arguments) { return test::run_script(arguments...); };

TEST_CASE("safe string: rep makes what it should, up to a megabyte") {
    CHECK(run("return ('ab'):rep(3)") == "ababab");
    CHECK(run("return ('ab'):rep(3, '-')") == "ab-ab-ab");
    CHECK(run("return ('ab'):rep(0) .. ('ab'):rep(-1) .. (''):rep(1000000000)") == "");
    CHECK(run("return #('x'):rep(1048576)") == "1048576");
    CHECK(run("('x'):rep(1048577)") ==
          "test.lua:1: string.rep would make a text of more than 1 MB.");
    CHECK(run("('x'):rep(math.maxinteger, ('y'):rep(1000))") ==
          "test.lua:1: string.rep would make a text of more than 1 MB.");
}

TEST_CASE("safe string: format writes numbers and texts, things as words, and no addresses") {
    CHECK(run("return string.format('%5.2f|%-3d|%s|%q|%%|%x', 1.5, 7, 'a', 'b', 255)") ==
          " 1.50|7  |a|\"b\"|%|ff");
    CHECK(run("return string.format('%s %s', {}, print)") == "table function");
    CHECK(run("string.format('%p', {})") == "test.lua:1: string.format has no %p in lessons.");
    CHECK(run("string.format('%-20p', {})") == "test.lua:1: string.format has no %p in lessons.");
    CHECK(run("return string.format('%%p')") == "%p");
}

TEST_CASE("safe string: gsub is bounded in length, and gives the count") {
    CHECK(run("return (('aXbXc'):gsub('X', '-'))") == "a-b-c");
    CHECK(run("local _, n = ('aXbXc'):gsub('X', '-', 1) return n") == "1");
    CHECK(run("(('a'):rep(1000000)):gsub('a', 'bb')") ==
          "test.lua:1: string.gsub would make a text of more than 1 MB.");
}

TEST_CASE("safe string: methods of texts are the bounded functions") {
    CHECK(run("return tostring(('x').rep == string.rep and ('x').find == string.find)") == "true");
    CHECK(run("string.rep = nil return tostring(('x').rep)") == "nil");
}

TEST_CASE("safe string: a malformed pattern is told at the teacher's line") {
    CHECK(run("\n\n('x'):find('[a')") == "test.lua:3: missing ']' in the pattern.");
    CHECK(run("('x'):find('%')") == "test.lua:1: the pattern ends with '%'.");
}

TEST_CASE("safe string: long plain searches are charged for") {
    ScriptState state({});
    CHECK_THAT(run(state, "(('a'):rep(1000000)):find(('a'):rep(500000) .. 'b', 1, true)", 200'000),
               Catch::Contains("too long"));
}

}  // namespace
}  // namespace fulcrum::runtime
