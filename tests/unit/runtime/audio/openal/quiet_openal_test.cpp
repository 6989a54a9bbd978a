#include "runtime/audio/openal/openal_microphone.h"
#include "runtime/audio/openal/openal_player.h"
#include "runtime/audio/openal/quiet_backends.h"
#include "tests/unit/runtime/rig.h"

#include <cstdio>
#include <unistd.h>

using namespace fulcrum::runtime::test;

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

// A machine for tests seldom has one; ear_test.cpp hears recordings that play its part.
TEST_CASE("openal microphone: it opens and never waits, or there is one sentence") {
    const OpenMicrophone open = microphone_opener();
    for (int i = 0; i < 2; ++i) {
        auto microphone = open();
        if (!microphone) {
            CHECK(to_sentence(microphone.error()) ==
                  "no microphone was found; plug one in, or type.");
            continue;
        }
        std::array<std::int16_t, 160> samples{};
        const auto n = (*microphone)->read(samples);
        REQUIRE(n);
        CHECK(*n <= samples.size());
    }
}

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
