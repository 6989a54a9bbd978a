#include "dialogue/english/verb.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace fulcrum::dialogue;

TEST_CASE("verb: the forms that agree with one and with many") {
    const struct {
        const char *word, *one, *many;
    } rows[] = {
        {"is", "is", "are"},       {"are", "is", "are"},      {"was", "was", "were"},
        {"has", "has", "have"},    {"do", "does", "do"},      {"weighs", "weighs", "weigh"},
        {"fly", "flies", "fly"},   {"goes", "goes", "go"},    {"push", "pushes", "push"},
        {"stay", "stays", "stay"}, {"hold", "holds", "hold"}, {"carry", "carries", "carry"}};
    for (const auto& row : rows) {
        INFO(row.word);
        VerbForms forms;
        REQUIRE(understand_verb(row.word, forms));
        CHECK(forms.with(Number::singular) == row.one);
        CHECK(forms.with(Number::plural) == row.many);
    }
}

TEST_CASE("verb: only be may be left out, and other words are no verbs") {
    VerbForms forms;
    REQUIRE(understand_verb("is", forms));
    CHECK(forms.is_be);
    REQUIRE(understand_verb("weighs", forms));
    CHECK_FALSE(forms.is_be);
    for (const char* word : {"watermelon", "the", "", "heavy", "wo"}) {
        CHECK_FALSE(understand_verb(word, forms));
    }
}

TEST_CASE("verb: the noun is said for the verb weigh, and for no other") {
    for (const bool weighs : {false, true}) {
        VerbForms forms;
        REQUIRE(understand_verb(weighs ? "weighs" : "turns", forms));
        const auto wrong = learner_verbs(forms);
        CHECK(std::ranges::count_if(wrong, [](const LearnerVerb& verb) {
                  return verb.text == "weight" && verb.code == ErrorCode::morphology;
              }) == (weighs ? 1 : 0));
    }
}

TEST_CASE("verb: what learners say instead has a code and is neither number") {
    for (const char* word : {"is", "was", "weighs", "have"}) {
        VerbForms forms;
        REQUIRE(understand_verb(word, forms));
        for (const LearnerVerb& wrong : learner_verbs(forms)) {
            CHECK(wrong.code != ErrorCode::none);
            CHECK(wrong.text != forms.singular);
            CHECK(wrong.text != forms.plural);
        }
    }
}
