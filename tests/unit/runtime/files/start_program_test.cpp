#include "runtime/files/start_program.h"

#include "haptics/base/clock.h"

#include <catch2/catch.hpp>

#include <array>
#include <cerrno>
#include <string>
#include <unistd.h>

using namespace fulcrum;
using namespace fulcrum::runtime;

TEST_CASE("start program: input and output are where they are wanted, and its end is known") {
    std::array<int, 2> in{}, out{};
    REQUIRE(pipe(in.data()) == 0);
    REQUIRE(pipe(out.data()) == 0);
    StartedProgram program;
    REQUIRE(program.start({"sh", "-c", "read line; echo \"<$line>\"; exit 0"}, in[0], out[1]) == 0);
    REQUIRE(write(in[1], "abc\n", 4) == 4);
    close(out[1]);
    std::array<char, 16> answer{};
    REQUIRE(read(out[0], answer.data(), answer.size()) == 6);
    CHECK(std::string(answer.data()) == "<abc>\n");
    CHECK(program.ends_well(monotonic_now_s() + 20.0));
    CHECK_FALSE(program.ends_well(monotonic_now_s() + 20.0));  // it has ended
    StartedProgram failing;
    REQUIRE(failing.start({"sh", "-c", "exit 1"}, -1, in[1]) == 0);
    CHECK_FALSE(failing.ends_well(monotonic_now_s() + 20.0));
    StartedProgram missing;
    CHECK(missing.start({"no_such_program_3"}, -1, in[1]) == ENOENT);
    CHECK_FALSE(missing.ends_well(monotonic_now_s() + 20.0));
    close(in[0]);
    close(in[1]);
    close(out[0]);
}
