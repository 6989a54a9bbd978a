#include "runtime/app/interrupt.h"

#include "tests/unit/runtime/rig.h"

#include <csignal>
#include <sys/wait.h>
#include <unistd.h>

using namespace fulcrum::runtime::test;

namespace {

// What is noted is noted for good, and would end every run of this program: a process of its own tries it. 0 where all was right, else
// the number of what was not.
int try_signals() {
    watch_for_interrupts();
    if (interrupted()) {
        return 1;
    }
    int ends[2] = {};
    if (pipe(ends) != 0) {
        return 2;
    }
    (void)close(ends[0]);
    if (write(ends[1], "x", 1) != -1) {
        return 3;
    }
    (void)close(ends[1]);
    (void)std::raise(SIGXFSZ);
    if (interrupted() || interrupt_exit_code() != 0) {
        return 4;
    }
    (void)std::raise(SIGTERM);
    return interrupted() && interrupt_exit_code() == 128 + SIGTERM ? 0 : 5;
}

}  // namespace

TEST_CASE("interrupt: the wish to end is noted; a closed pipe, a file too long are usual errors") {
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        ::_exit(try_signals());
    }
    int status = 0;
    REQUIRE(::waitpid(child, &status, 0) == child);
    REQUIRE(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 0);
    CHECK_FALSE(interrupted());
}
