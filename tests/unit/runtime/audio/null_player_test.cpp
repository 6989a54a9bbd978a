#include "runtime/audio/null/null_player.h"

#include <catch2/catch.hpp>

using namespace fulcrum;
using namespace fulcrum::runtime;

TEST_CASE("null player: counts what it was asked for and refuses what a real one would") {
    auto player = NullPlayer::open({{"pop", "click"}, true, 1.0});
    REQUIRE(player.has_value());
    SoundPlayer& face = **player;
    CHECK(face.play("pop"));
    CHECK(face.play("pop", 0.5, 2.0));
    CHECK_FALSE(face.play("pop", 2.0, 1.0));
    CHECK_FALSE(face.play("finish"));
    face.set_force_sound(2.5);
    CHECK((*player)->plays("pop") == 2);
    CHECK((*player)->plays("click") == 0);
    CHECK((*player)->force_N() == 2.5);
    face.stop();
    CHECK((*player)->force_N() == 0.0);
    CHECK_FALSE(face.audible());
}
