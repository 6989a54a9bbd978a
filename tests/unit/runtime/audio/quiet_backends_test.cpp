#include "runtime/audio/openal/quiet_backends.h"

#include "runtime/audio/openal/openal_player.h"

#include <catch2/catch.hpp>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <set>
#include <string>
#include <unistd.h>

using namespace fulcrum::runtime;

namespace {

/// Bytes that `action` wrote to standard error, by whatever library.
template <class Action>
long written_to_stderr(Action action) {
    std::FILE* captured = std::tmpfile();
    REQUIRE(captured != nullptr);
    std::fflush(stderr);
    const int saved = ::dup(2);
    ::dup2(::fileno(captured), 2);
    action();
    std::fflush(stderr);
    ::dup2(saved, 2);
    ::close(saved);
    const long written = ::lseek(::fileno(captured), 0, SEEK_END);
    std::fclose(captured);
    return written;
}

}  // namespace

TEST_CASE("quiet backends: looking for a sound card writes nothing to the terminal") {
    // The measure itself works.
    CHECK(written_to_stderr([] { std::fputs("four", stderr); }) == 4);
    CHECK(written_to_stderr([] { (void)open_openal_device({}); }) == 0);
}

TEST_CASE("quiet backends: a log level that the user has set is kept") {
    quieten_backends();
    REQUIRE(std::getenv("ALSOFT_LOGLEVEL") != nullptr);
    ::setenv("ALSOFT_LOGLEVEL", "2", 1);
    quieten_backends();
    CHECK(std::getenv("ALSOFT_LOGLEVEL") == std::string("2"));
    ::setenv("ALSOFT_LOGLEVEL", "0", 1);
}

TEST_CASE("quiet backends: OpenAL finds short periods in the file that it reads last") {
    ask_for_short_periods();
    const char* name = std::getenv("ALSOFT_CONF");
    REQUIRE(name != nullptr);
    std::ifstream file(name);
    std::string line;
    std::set<std::string> lines;
    while (std::getline(file, line)) {
        lines.insert(line);
    }
    CHECK(lines == std::set<std::string>{"[general]", "period_size = 256", "periods = 3"});
    ask_for_short_periods();
    CHECK(std::getenv("ALSOFT_CONF") == std::string(name));
}
