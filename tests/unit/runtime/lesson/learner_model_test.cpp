#include "runtime/lesson/learner_model.h"

#include "dialogue/marking/mark.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

dialogue::Question heaviest() {
    return value_of(
        dialogue::compile_question({"heaviest",
                                    "Which one is the heaviest?",
                                    {"[a|an|the] {thing} is the <superlative:heavy> [one]"},
                                    {{"thing", {"watermelon", "apple", "banana", "egg"}}}}));
}

Expected<bool> is_watermelon(const AnswerSlots& slots) {
    return slots == AnswerSlots{{"thing", "watermelon"}};
}

/// How many of 400 answers are right, wrong, right with an error of form, and not understood.
struct Counts {
    int right = 0;
    int wrong = 0;
    int form = 0;
    int unclear = 0;
};

Counts count(const LearnerRates& rates) {
    LearnerModel model(rates, 7);
    const dialogue::Question question = heaviest();
    Counts counts;
    for (int i = 0; i < 400; ++i) {
        const auto said = value_of(model.answer(question, is_watermelon));
        const dialogue::Mark mark = dialogue::mark_answer(question, said);
        if (!mark.understood) {
            ++counts.unclear;
        } else if (!*is_watermelon(mark.slots)) {
            ++counts.wrong;
        } else {
            ++(mark.form_right() ? counts.right : counts.form);
        }
    }
    return counts;
}

}  // namespace

TEST_CASE("learner model: who makes no mistakes is always right") {
    CHECK(count({}).right == 400);
}

TEST_CASE("learner model: mistakes come as often as the rates say") {
    const Counts counts = count({.wrong = 0.2, .form = 0.3, .unclear = 0.1});
    // Four standard deviations of 400 draws: 4 sqrt(400 p (1 - p)).
    CHECK(std::abs(counts.wrong - 80) < 32);
    CHECK(std::abs(counts.form - 120) < 37);
    CHECK(std::abs(counts.unclear - 40) < 24);
    CHECK(count({.wrong = 1.0}).wrong == 400);
    CHECK(count({.form = 1.0}).form == 400);
}

TEST_CASE("learner model: the same seed says the same, another seed something else") {
    const auto said = [](std::uint64_t seed) {
        LearnerModel model({.wrong = 0.3, .form = 0.5}, seed);
        const dialogue::Question question = heaviest();
        std::string all;
        for (int i = 0; i < 20; ++i) {
            all += *model.answer(question, is_watermelon) + '\n';
        }
        return all;
    };
    CHECK(said(1) == said(1));
    CHECK(said(1) != said(2));
}

TEST_CASE("learner model: where nothing is right it gives up; a lesson's error is passed on") {
    LearnerModel model({}, 1);
    const auto gives_up = value_of(
        model.answer(heaviest(), [](const AnswerSlots&) { return Expected<bool>(false); }));
    CHECK(gives_up == "I don't know");
    CHECK(error_of(model.answer(heaviest(), [](const AnswerSlots&) -> Expected<bool> {
              return fail("it broke");
          })).message == "it broke");
}
