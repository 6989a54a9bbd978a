#include "runtime/app/run_pupil.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {
namespace {

LessonDescription with_test(std::vector<std::string> say) {
    LessonDescription lesson;
    lesson.tests.emplace_back();
    lesson.tests.back().say = std::move(say);
    lesson.tests.back().line = 12;
    return lesson;
}

TEST_CASE("run pupil: given lines come before the lesson's own test, and that before nobody") {
    RunRequest request;
    request.own_test = true;
    const RunPupil own(with_test({"It is heavy."}), request);
    REQUIRE(own.simulated());
    CHECK(own.say_line() == 12);
    CHECK(own.n_given_lines() == 0);
    CHECK(own.simulated()->left().size() == 1);

    request.say = {"It is soft.", "It is hard."};
    const RunPupil given(with_test({"It is heavy."}), request);
    REQUIRE(given.simulated());
    CHECK(given.say_line() == 0);
    CHECK(given.n_given_lines() == 2);

    request.own_test = false;
    request.say.clear();
    CHECK_FALSE(RunPupil(with_test({"It is heavy."}), request).simulated());
    CHECK_FALSE(RunPupil().simulated());
    CHECK(RunPupil().replayed() == nullptr);
}

TEST_CASE(
    "run pupil: a learner who errs answers instead of the test's words, if one is asked for") {
    RunRequest request;
    request.own_test = true;
    request.learner_rates = LearnerRates{.wrong = 0.5};
    const RunPupil errs(with_test({"It is heavy."}), request);
    REQUIRE(errs.simulated());
    CHECK(errs.simulated()->left().empty());
    CHECK(errs.say_line() == 12);

    request.learner_rates.reset();
    request.learner_without_test = LearnerRates{};
    CHECK(RunPupil(with_test({"It is heavy."}), request).simulated()->left().size() == 1);
    CHECK(RunPupil(with_test({}), request).simulated()->left().empty());
}

}  // namespace
}  // namespace fulcrum::runtime
