#include "runtime/audio/openal/openal_microphone.h"

#include <catch2/catch.hpp>

#include <array>

using namespace fulcrum;
using namespace fulcrum::runtime;

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
