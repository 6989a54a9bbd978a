#include "runtime/app/walled_work.h"

#include "tests/unit/runtime/rig.h"

#include <csignal>
#include <cstdio>
#include <new>
#include <stdexcept>
#include <unistd.h>

using namespace fulcrum::runtime::test;

namespace {

struct Walled {
    int code = 0;
    std::string said;  // on the error output
};

Walled run(const std::function<int(StageTeller&)>& work, const WorkWalls& walls = {}) {
    const ScratchFolder folder;
    const std::string file = folder.file("said");
    (void)std::fflush(stderr);
    const int before = ::dup(STDERR_FILENO);
    std::FILE* const caught = std::fopen(file.c_str(), "w");
    REQUIRE(caught != nullptr);
    REQUIRE(::dup2(::fileno(caught), STDERR_FILENO) >= 0);
    Walled outcome;
    outcome.code = run_walled("litter", walls, work);
    (void)std::fflush(stderr);
    (void)::dup2(before, STDERR_FILENO);
    ::close(before);
    (void)std::fclose(caught);
    std::ifstream said(file);
    outcome.said = {std::istreambuf_iterator<char>(said), {}};
    return outcome;
}

// So that no compiler takes the work for nothing.
volatile int sink = 0;

}  // namespace

TEST_CASE("walled work: what it gives is given, and nothing is said of it") {
    for (const int code : {0, 1, 2, 3}) {
        const Walled outcome = run([&](StageTeller& stages) {
            stages.begin("one");
            return code;
        });
        CHECK(outcome.code == code);
        CHECK(outcome.said.empty());
    }
}

TEST_CASE("walled work: a crash, a loop without end and a flood are a sentence with the stage") {
    const auto stopped = [](const std::function<void()>& deed, const WorkWalls& walls) {
        const Walled outcome = run(
            [&](StageTeller& stages) {
                stages.begin("question first, lesson.lua:3");
                stages.begin("question second, lesson.lua:7");
                deed();
                return 0;
            },
            walls);
        CHECK(outcome.code == 2);
        CHECK(std::ranges::count(outcome.said, '\n') == 1);
        return outcome.said;
    };
    check_says(stopped([] { (void)::raise(SIGKILL); }, {}),
               {"litter: question second, lesson.lua:7: looking at this was ended from outside"});
    check_says(stopped([] { throw std::bad_alloc(); }, {}),
               {"lesson.lua:7", "more memory than 4096 MB"});
    check_says(stopped(
                   [] {
                       while (true) {
                           sink = sink + 1;
                       }
                   },
                   {.cpu_s = 1.0}),
               {"lesson.lua:7", "took more than 1 s of processor time"});
    check_says(stopped([] { throw std::runtime_error("a thing went wrong"); }, {}),
               {"a thing went wrong"});
}
