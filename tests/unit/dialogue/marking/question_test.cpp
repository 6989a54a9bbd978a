#include "dialogue/marking/question.h"

#include "tests/unit/dialogue/questions.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

TEST_CASE("question: compiles, and keeps what its author wrote") {
    const Question question =
        compiled({"q", "What is it?", {"it is big", "it is small"}, {}, {}, {}, "Feel it again."});
    CHECK(question.templates->answers == 2);
    CHECK(question.id == "q");
    CHECK(question.prompt == "What is it?");
    CHECK(question.again == "Feel it again.");
}

TEST_CASE("question: errors name the question, the answer and the column") {
    const auto no_list = compile_question({"q", "What?", {"it is big", "the {thing} is big"}});
    REQUIRE_FALSE(no_list);
    CHECK(no_list.error().message ==
          "question \"q\", answer 2: there is no list \"thing\"; the lists are: none");
    CHECK(no_list.error().column == 5);
    CHECK_FALSE(compile_question({"", "What?", {"it"}}));
    CHECK_FALSE(compile_question({"q", "", {"it"}}));
    CHECK_FALSE(compile_question({"q", "What?", {}}));
}
