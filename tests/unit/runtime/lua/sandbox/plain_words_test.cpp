#include "runtime/lua/sandbox/plain_words.h"

#include "tests/unit/runtime/lua/hosted_lesson.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {
namespace {

TEST_CASE("plain words: a { that is missing is told where it is missing") {
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

}  // namespace
}  // namespace fulcrum::runtime
