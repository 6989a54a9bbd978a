#include "runtime/app/stop_signal.h"

#include <catch2/catch.hpp>

#include <chrono>
#include <csignal>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

using namespace fulcrum;
using namespace fulcrum::runtime;

namespace {

// At most 15 letters are kept.
constexpr const char* kTestName = "fulcrum-tried";

// Another process that can be stopped: it ends with 0 once its switch is pressed, with 1 if nobody does.
int run_stoppable(int told) {
    watch_for_stop_signal(kTestName);
    static StopSwitch target;
    set_stop_target(&target);
    const char ready = 'r';
    (void)!::write(told, &ready, 1);
    for (int i = 0; i < 5000; ++i) {
        if (target.is_pressed()) {
            return stop_signals_seen() == 1 ? 0 : 2;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return 1;
}

}  // namespace

TEST_CASE("stop signal: presses the switch of every process that can be stopped, and of no other") {
    int pipe_ends[2];
    REQUIRE(::pipe(pipe_ends) == 0);
    const pid_t stoppable = ::fork();
    if (stoppable == 0) {
        ::_exit(run_stoppable(pipe_ends[1]));
    }
    const pid_t other = ::fork();
    if (other == 0) {
        // Says nothing of itself: a signal would end it.
        std::this_thread::sleep_for(std::chrono::milliseconds(500));
        ::_exit(0);
    }
    char ready = 0;
    REQUIRE(::read(pipe_ends[0], &ready, 1) == 1);
    const auto stopped = stop_all_hands(kTestName);
    REQUIRE(stopped);
    CHECK(*stopped == 1);
    for (const pid_t child : {stoppable, other}) {
        int status = 0;
        REQUIRE(::waitpid(child, &status, 0) == child);
        CHECK(WIFEXITED(status));
        CHECK(WEXITSTATUS(status) == 0);
    }
    ::close(pipe_ends[0]);
    ::close(pipe_ends[1]);
}
