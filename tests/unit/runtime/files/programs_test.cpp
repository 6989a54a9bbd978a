#include "haptics/base/clock.h"
#include "runtime/files/line_program.h"
#include "runtime/files/run_program.h"
#include "runtime/files/start_program.h"
#include "tests/unit/runtime/files/own_program.h"
#include "tests/unit/runtime/rig.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <thread>
#include <unistd.h>

using namespace fulcrum::runtime::test;

namespace {

constexpr double kPatience_s = 20.0;
constexpr std::size_t kPlenty = 1'000'000;

std::unique_ptr<LineProgram> start_shell(const std::string& script) {
    return LineProgram::start({"sh", "-c", script}).value();
}

Expected<std::string> run_shell(const std::string& script, double most_s = kPatience_s,
                                std::size_t most_bytes = kPlenty) {
    const std::atomic<bool> never{false};
    return run_program({{"sh", "-c", script}, most_bytes, most_s}, never);
}

std::string refusal(const Expected<std::string>& answer) {
    REQUIRE_FALSE(answer);
    return to_sentence(answer.error());
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

TEST_CASE("run program: gives every byte that it wrote, and its words arrive as they are") {
    const std::atomic<bool> never{false};
    const auto said =
        run_program({{"printf", "%s|%s", "a b; $(rm x)", "\"*\""}, kPlenty, 5.0}, never);
    REQUIRE(said);
    CHECK(*said == "a b; $(rm x)|\"*\"");
    const auto many = run_shell("head -c 300000 /dev/zero");
    REQUIRE(many);
    CHECK(many->size() == 300'000);
    CHECK(run_shell("cat; echo heard nothing >&2").value().empty());
}

TEST_CASE("run program: what is missing, fails, writes too much or takes too long is told") {
    const std::atomic<bool> never{false};
    CHECK(refusal(run_program({{"no_such_program_1"}, kPlenty, 5.0}, never))
              .find("the program no_such_program_1 can't be started") == 0);
    CHECK(refusal(run_program({{}, kPlenty, 5.0}, never)).find("no program is named") == 0);
    CHECK(refusal(run_shell("echo x; exit 3")).find("the program sh failed") == 0);
    CHECK(refusal(run_shell("kill -9 $$")).find("failed") != std::string::npos);
    CHECK(refusal(run_shell("yes", kPatience_s, 1000)).find("wrote more than 1000") !=
          std::string::npos);
    const double begun_s = monotonic_now_s();
    CHECK(refusal(run_shell("sleep 100", 0.1)).find("took too long") != std::string::npos);
    // Who closes his output and goes on is not waited for either.
    CHECK(refusal(run_shell("exec >&-; sleep 100", 0.3)).find("failed") != std::string::npos);
    CHECK(monotonic_now_s() - begun_s < 0.5 * kPatience_s);
}

TEST_CASE("run program: ends with all that it started as soon as nobody waits") {
    std::atomic<bool> cancelled{false};
    std::thread canceller([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        cancelled = true;
    });
    const double begun_s = monotonic_now_s();
    const auto answer =
        run_program({{"sh", "-c", "sleep 100 & sleep 100"}, kPlenty, 100.0}, cancelled);
    canceller.join();
    CHECK(refusal(answer).find("was stopped") != std::string::npos);
    CHECK(monotonic_now_s() - begun_s < kPatience_s);
}

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
