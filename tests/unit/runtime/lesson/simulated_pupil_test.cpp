#include "runtime/lesson/simulated_pupil.h"

#include <catch2/catch.hpp>

#include <cstdio>
#include <fstream>

using namespace fulcrum::runtime;

TEST_CASE("simulated pupil: thinks first, then says one line a question") {
    SimulatedPupil pupil({"first", "second"}, 1.0);
    CHECK_FALSE(pupil.answer(10.0, 10.5));
    CHECK(pupil.answer(10.0, 11.0) == "first");
    CHECK_FALSE(pupil.answer(10.0, 12.0));
    CHECK_FALSE(pupil.answer(20.0, 20.9));
    CHECK(pupil.answer(20.0, 21.5) == "second");
    CHECK(pupil.speechless());
    CHECK_FALSE(pupil.answer(30.0, 40.0));
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
    const auto lines = SimulatedPupil::read_lines("no/such/file.txt");
    REQUIRE_FALSE(lines);
    CHECK(lines.error().where == "no/such/file.txt");
}
