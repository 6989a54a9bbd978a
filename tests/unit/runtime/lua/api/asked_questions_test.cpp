#include "runtime/lua/api/asked_questions.h"

#include <catch2/catch.hpp>

using namespace fulcrum::runtime;

namespace {

// "name+" with a hint, "name-" without.
std::string asked_in(std::string_view text) {
    std::string told;
    for (const AskUse& use : find_asked(text)) {
        told += (told.empty() ? "" : " ") + use.name + (use.has_hint ? '+' : '-');
    }
    return told;
}

}  // namespace

TEST_CASE("asked questions: each call that asks, with or without a hint") {
    CHECK(asked_in("game.ask \"a\"\nstory.ask(world, \"b\") world:ask('c')") == "a- b- c-");
    CHECK(asked_in("game.ask(\"a\", { hint = \"Look.\", solution = \"Yes.\" })") == "a+");
    CHECK(asked_in("game.ask(\"a\", { solution = \"A hint = no.\" })") == "a-");
    CHECK(asked_in("game.ask(\"a\",\n{ again = function() f { hint = 1 } end })") == "a+");
    CHECK(asked_in("game.ask(\"a\", { solution = f { hint = 1 } })") == "a-");
    CHECK(asked_in("game.ask(\"a\", { hints = 1 })") == "a-");
}

TEST_CASE("asked questions: what is made elsewhere is not known, and may be a hint") {
    CHECK(asked_in("game.ask(\"a\", options)") == "a+");
    CHECK(asked_in("game.ask(name, { hint = h })") == "+");
    CHECK(asked_in("game.ask(name)") == "-");
    CHECK(asked_in("game.ask(name, options)") == "+");
    CHECK(asked_in("story.ask(world, name)") == "-");
    CHECK(asked_in("game.ask(\"a\" .. i)") == "-");
}

TEST_CASE("asked questions: comments, texts and other names ask nothing, and nothing has an end") {
    CHECK(asked_in("-- game.ask \"a\"\nlocal t = 'ask \"b\"' task \"c\" asked(\"d\")").empty());
    CHECK(asked_in("--[[ ask(\"a\") ]] x = [[ ask(\"b\") ]]").empty());
    CHECK(asked_in("game.ask(\"a\", { hint") == "a-");
    CHECK(asked_in("game.ask(") == "-");
    CHECK(asked_in("game.ask(\"a") == "a-");
}
