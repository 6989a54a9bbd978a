#include "runtime/audio/sound_bank.h"

#include "runtime/audio/synthesis.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace fulcrum;
using namespace fulcrum::runtime;

TEST_CASE("sound bank: no names means all, names mean these, each once") {
    const auto all = make_bank({});
    REQUIRE(all.has_value());
    CHECK(all->size() == sound_names().size());
    const auto some = make_bank({{"pop", "click", "pop"}, true, 1.0});
    REQUIRE(some.has_value());
    REQUIRE(some->size() == 2);
    for (const BankedSound& sound : *some) {
        CHECK(sound.samples == *synthesise(sound.name));
    }
}

TEST_CASE("sound bank: unknown names and loudness outside 0 to 1 are errors") {
    CHECK_FALSE(make_bank({{"moo"}, true, 1.0}));
    CHECK_FALSE(make_bank({{""}, true, 1.0}));
    for (const double gain : {-0.1, 1.1, std::nan("")}) {
        CHECK_FALSE(checked_names({{}, true, gain}));
    }
    const auto moo = make_bank({{"moo"}, true, 1.0});
    CHECK(moo.error().message.find("moo") != std::string::npos);
}

TEST_CASE("sound bank: gain and pitch are checked to their ends") {
    CHECK(check_play(0.0, 0.25));
    CHECK(check_play(1.0, 4.0));
    for (const auto& [gain, pitch] : {std::pair(-0.01, 1.0),
                                      {1.01, 1.0},
                                      {1.0, 0.24},
                                      {1.0, 4.01},
                                      {std::nan(""), 1.0},
                                      {1.0, std::nan("")}}) {
        CAPTURE(gain, pitch);
        CHECK_FALSE(check_play(gain, pitch));
    }
}
