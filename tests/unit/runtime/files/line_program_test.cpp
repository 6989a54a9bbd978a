#include "runtime/files/line_program.h"

#include "haptics/base/clock.h"

#include <catch2/catch.hpp>

#include <cerrno>
#include <csignal>
#include <string>

using namespace fulcrum;
using namespace fulcrum::runtime;

namespace {

constexpr double kPatience_s = 20.0;

std::unique_ptr<LineProgram> start_shell(const std::string& script) {
    return LineProgram::start({"sh", "-c", script}).value();
}

}  // namespace

TEST_CASE("line program: lines come back as they were sent, in order, however long") {
    const auto program = start_shell("cat");
    CHECK_FALSE(program->take());
    const std::string longest(600'000, 'x');
    for (const std::string& line :
         {std::string("one"), std::string(), longest, std::string("ä \"")}) {
        program->send(line);
    }
    CHECK(program->wait(kPatience_s) == "one");
    CHECK(program->wait(kPatience_s) == "");
    CHECK(program->wait(kPatience_s) == longest);
    CHECK(program->wait(kPatience_s) == "ä \"");
    CHECK_FALSE(program->wait(0.05));
    CHECK(program->trouble().empty());
}

TEST_CASE("line program: what it said before it ended is heard, and then that it has") {
    const auto program = start_shell("echo last words; exit 0");
    CHECK(program->wait(kPatience_s) == "last words");
    CHECK_FALSE(program->wait(kPatience_s));
    CHECK(program->trouble() == "the program sh has ended");
    program->send("anybody there?");
    CHECK_FALSE(program->take());
}

TEST_CASE("line program: a line without end, and nobody who takes what is sent, are ended") {
    const auto program = start_shell("yes x | tr -d '\\n'");
    CHECK_FALSE(program->wait(kPatience_s));
    CHECK(program->trouble() == "the program sh says a line that is too long");
    CHECK_FALSE(program->take());
    const auto silent_line = start_shell("tr '\\0' a </dev/zero");
    while (silent_line->trouble().empty()) {
        REQUIRE_FALSE(silent_line->wait(kPatience_s));
    }
    CHECK(silent_line->trouble() == "the program sh says a line that is too long");
    const auto deaf = start_shell("sleep 100");
    const std::string line(1'000'000, 'x');
    for (int i = 0; i < 20; ++i) {
        deaf->send(line);
    }
    CHECK(deaf->trouble() == "the program sh takes nothing");
}

TEST_CASE("line program: the longest line comes, and one byte more is refused") {
    const auto program = start_shell("cat");
    const std::string longest(LineProgram::kLongestLine_bytes, 'x');
    program->send(longest);
    program->send("short");
    CHECK(program->wait(kPatience_s) == longest);
    CHECK(program->wait(kPatience_s) == "short");
    program->send(longest + 'x');
    CHECK_FALSE(program->wait(kPatience_s));
    CHECK(program->trouble() == "the program sh says a line that is too long");
}

TEST_CASE("line program: one that never stops talking is heard line by line, and waits") {
    const auto program = start_shell("yes");
    constexpr int kLines = 1000;
    const double begun_s = monotonic_now_s();
    for (int i = 0; i < kLines; ++i) {
        REQUIRE(program->wait(kPatience_s) == "y");
    }
    CHECK(monotonic_now_s() - begun_s < kPatience_s);
    CHECK(program->trouble().empty());
}

TEST_CASE("line program: whom somebody ends is gone with all that it said") {
    const auto program = start_shell("echo $$; echo more; exec sleep 100");
    const auto id = program->wait(kPatience_s);
    REQUIRE(id);
    CHECK(kill(std::stoi(*id), 0) == 0);
    program->end("says too much");
    CHECK(kill(std::stoi(*id), 0) == -1);
    CHECK(errno == ESRCH);
    CHECK_FALSE(program->take());
    program->send("anybody there?");
    program->end("twice");
    CHECK(program->trouble() == "the program sh says too much");
}

TEST_CASE("line program: what is not there is one sentence; nothing waits for its end") {
    CHECK(to_sentence(LineProgram::start({"no_such_program_2"}).error())
              .find("the program no_such_program_2 can't be started") == 0);
    CHECK_FALSE(LineProgram::start({}));
    const double begun_s = monotonic_now_s();
    start_shell("trap '' TERM; sleep 100 & sleep 100");
    CHECK(monotonic_now_s() - begun_s < kPatience_s);
}
