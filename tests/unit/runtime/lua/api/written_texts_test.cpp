#include "runtime/lua/api/written_texts.h"

#include <catch2/catch.hpp>

using namespace fulcrum::runtime;

namespace {

// "line:text", with an exclamation mark before what a learner reads.
std::string texts_in(std::string_view lua) {
    std::string told;
    for (const WrittenText& text : find_texts(lua)) {
        told += (told.empty() ? "" : " ") + std::string(text.is_shown ? "!" : "") +
                std::to_string(text.line) + ":" + text.text;
    }
    return told;
}

}  // namespace

TEST_CASE("written texts: each has its line, and what is plainly for the learner is known") {
    CHECK(texts_in("world:caption \"Lift it.\"\nworld:caption('And now')") ==
          "!1:Lift it. !2:And now");
    CHECK(texts_in("{ hint = \"Look.\",\n solution = \"An egg.\" }") == "!1:Look. !2:An egg.");
    CHECK(texts_in("{ name = \"egg\", about =\n  \"An egg.\" }") == "1:egg !2:An egg.");
}

TEST_CASE("written texts: what is joined, chosen or computed is no whole sentence") {
    CHECK(texts_in("world:caption(\"Lift the \" .. noun .. \" now.\")") == "1:Lift the  1: now.");
    CHECK(texts_in("world:caption((\"It weighs %d.\"):format(n))") == "!1:It weighs %d.");
    CHECK(texts_in("world:caption(caught and \"Yes!\" or \"No.\")") == "1:Yes! 1:No.");
    CHECK(texts_in("hints = { \"a\" } my_caption \"b\" captions(\"c\")") == "1:a 1:b 1:c");
}

TEST_CASE("written texts: none stand in comments and long brackets, and nothing has an end") {
    CHECK(texts_in("-- hint = \"a\"\n--[[ \"b\" ]] x = [[ \"c\" ]]").empty());
    CHECK(texts_in("hint = \"a") == "!1:a");
    CHECK(texts_in("hint =").empty());
    CHECK(texts_in("").empty());
}
