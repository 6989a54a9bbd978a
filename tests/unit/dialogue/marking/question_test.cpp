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

TEST_CASE("question: what is nearly an answer needs an answer that says it rightly") {
    const auto problem = [](const std::string& nearly) {
        const auto question = compile_question({"q",
                                                "?",
                                                {"it has {number} moons"},
                                                {{"number", {"one", "two"}}, {"who", {"Mars"}}},
                                                {},
                                                {"it have {number} moon", nearly}});
        return question ? std::string() : question.error().message;
    };
    CHECK(problem("have {number}").empty());
    CHECK_THAT(problem("it {who} {number}"), Catch::Contains("nearly 2: no answer says the same"));
    CHECK_THAT(problem("it have moons"), Catch::Contains("nearly 2: no answer says the same"));
    CHECK_THAT(problem("it have {numbr}"), Catch::Contains("nearly 2: there is no list"));
}
