#include "haptics/math/split_mix.h"

#include <catch2/catch.hpp>

using namespace fulcrum;

TEST_CASE("split mix: the numbers of its authors' own program") {
    // java.util.SplittableRandom and prng.di.unimi.it/splitmix64.c, seed 1234567.
    SplitMix random(1234567);
    for (const std::uint64_t expected :
         {6457827717110365317U, 3203168211198807973U, 9817491932198370423U, 4593380528125082431U,
          16408922859458223821U}) {
        CHECK(random.draw() == expected);
    }
}

TEST_CASE("split mix: any number can be had without those before it, and lies in [0, 1)") {
    SplitMix random(42);
    for (std::uint64_t n = 1; n <= 1000; ++n) {
        const double chance = random.draw_chance();
        REQUIRE(chance == to_chance(compute_split_mix(42 + n * kSplitMixGamma)));
        REQUIRE(chance >= 0.0);
        REQUIRE(chance < 1.0);
    }
    CHECK(to_chance(~std::uint64_t{0}) < 1.0);
}
