#include "runtime/app/interrupt.h"

#include <catch2/catch.hpp>

#include <csignal>
#include <unistd.h>

using namespace fulcrum::runtime;

TEST_CASE(
    "interrupt: the wish to end is noted; a closed pipe and a file too long are ordinary errors") {
    watch_for_interrupts();
    CHECK_FALSE(interrupted());
    int ends[2] = {};
    REQUIRE(pipe(ends) == 0);
    (void)close(ends[0]);
    CHECK(write(ends[1], "x", 1) == -1);
    (void)close(ends[1]);
    (void)std::raise(SIGXFSZ);
    CHECK_FALSE(interrupted());
    CHECK(interrupt_exit_code() == 0);
    (void)std::raise(SIGTERM);
    CHECK(interrupted());
    CHECK(interrupt_exit_code() == 128 + SIGTERM);
}
