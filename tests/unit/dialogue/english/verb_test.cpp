#include "dialogue/english/verb.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace fulcrum::dialogue;

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
