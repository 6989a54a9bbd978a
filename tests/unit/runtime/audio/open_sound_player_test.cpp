#include "runtime/audio/null/null_player.h"
#include "runtime/audio/openal/openal_player.h"
#include "runtime/audio/sound_player.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace fulcrum;
using namespace fulcrum::runtime;

TEST_CASE("sound player: unknown names at opening are errors for every kind") {
    const SoundSettings settings{{"click", "moo"}, true, 1.0};
    CHECK_FALSE(open_sound_player(settings));
    CHECK_FALSE(open_openal_loopback(settings));
    CHECK_FALSE(NullPlayer::open(settings));
    CHECK_FALSE(NullPlayer::open({{}, true, 1.5}));
    CHECK_FALSE(NullPlayer::open({{}, true, std::nan("")}));
}

TEST_CASE("sound player: without a sound card there is a silent player and a sentence") {
    auto opened = open_sound_player({});
    REQUIRE(opened.has_value());
    REQUIRE(opened->player != nullptr);
    CHECK(opened->player->audible() == opened->notice.empty());
    CHECK(opened->notice.find('\n') == std::string::npos);
    CHECK(opened->player->play("click"));
    CHECK_FALSE(opened->player->play("moo"));
    opened->player->set_force_sound(2.0);
    opened->player->update(0.01);
    opened->player->stop();
}
