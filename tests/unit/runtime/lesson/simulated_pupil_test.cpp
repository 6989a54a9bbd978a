#include "runtime/lesson/simulated_pupil.h"

#include "tests/unit/runtime/rig.h"

#include <cstdio>

using namespace fulcrum::runtime::test;

namespace {

Expected<bool> anything(const AnswerSlots&) {
    return true;
}

std::optional<std::string> answer(SimulatedPupil& pupil, double asked_at_s, double now_s) {
    const auto question =
        value_of(fulcrum::dialogue::compile_question({"q", "Which?", {"an egg"}}));
    return value_of(pupil.answer(asked_at_s, now_s, question, anything));
}

}  // namespace

TEST_CASE("simulated pupil: thinks first, then says one line a question") {
    SimulatedPupil pupil({"first", "second"}, 1.0);
    CHECK_FALSE(answer(pupil, 10.0, 10.5));
    CHECK(answer(pupil, 10.0, 11.0) == "first");
    CHECK_FALSE(answer(pupil, 10.0, 12.0));
    CHECK_FALSE(answer(pupil, 20.0, 20.9));
    CHECK(answer(pupil, 20.0, 21.5) == "second");
    CHECK_FALSE(answer(pupil, 30.0, 40.0));
}

TEST_CASE("simulated pupil: one who is a model never runs out of answers, and thinks as long") {
    SimulatedPupil pupil(LearnerModel({}, 1), 1.0);
    CHECK_FALSE(answer(pupil, 10.0, 10.5));
    for (const double asked_at_s : {10.0, 20.0, 30.0}) {
        CHECK(answer(pupil, asked_at_s, asked_at_s + 1.0) == "An egg.");
    }
}

TEST_CASE("simulated pupil: what is to be asked comes in its turn, and an open question waits") {
    SimulatedPupil pupil({"first", "?how heavy is it", "?what is this", "second"}, 1.0);
    CHECK(answer(pupil, 10.0, 11.0) == "first");
    CHECK_FALSE(answer(pupil, 12.0, 13.5));
    CHECK(answer(pupil, 12.0, 14.0) == "how heavy is it");
    CHECK_FALSE(answer(pupil, 12.0, 16.0));
    CHECK(pupil.ask(17.0) == "what is this");
    CHECK_FALSE(pupil.ask(30.0));
    CHECK(answer(pupil, 12.0, 18.0) == "second");
    CHECK_FALSE(answer(pupil, 12.0, 30.0));
}

TEST_CASE("simulated pupil: blank lines and remarks in the file are passed over") {
    char path[] = "pupil_XXXXXX";
    const int file = mkstemp(path);
    REQUIRE(file >= 0);
    std::ofstream(path) << "# remark\n\n  a watermelon is the heaviest \r\n\t\nthe egg";
    const auto lines = SimulatedPupil::read_lines(path);
    std::remove(path);
    REQUIRE(lines);
    REQUIRE(lines->size() == 2);
    CHECK((*lines)[0] == "a watermelon is the heaviest");
    CHECK((*lines)[1] == "the egg");
}

TEST_CASE("simulated pupil: a missing file is one sentence with its path") {
    CHECK(error_of(SimulatedPupil::read_lines("no/such/file.txt")).where == "no/such/file.txt");
}
