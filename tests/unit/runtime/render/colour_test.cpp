#include "runtime/render/colour.h"

#include "runtime/render/theme.h"

#include <catch2/catch.hpp>

using namespace fulcrum::runtime;

TEST_CASE("colour: contrast in closed form") {
    const Colour black = from_hex(0x000000);
    const Colour white = from_hex(0xFFFFFF);
    CHECK(contrast_ratio(black, white) == Approx(21.0));
    CHECK(contrast_ratio(white, black) == Approx(21.0));
    CHECK(contrast_ratio(white, white) == Approx(1.0));
    // White is ten times as bright as black on the projector.
    CHECK(contrast_ratio(black, white, kProjectorStrayLight) == Approx(10.0));
    // A grey that is known to be just below and above the limit on white (WCAG 2.1).
    CHECK(contrast_ratio(from_hex(0x777777), white) < 4.5);
    CHECK(contrast_ratio(from_hex(0x767676), white) > 4.5);
}

TEST_CASE("colour: sRGB decoding in closed form") {
    CHECK(to_linear(0.0F) == 0.0F);
    CHECK(to_linear(1.0F) == Approx(1.0F));
    CHECK(to_linear(0.5F) == Approx(0.21404F).epsilon(1e-4));
    CHECK(to_linear(0.04F) == Approx(0.04F / 12.92F));
    const Colour colour = from_hex(0xFF8000, 0.25F);
    CHECK(colour.r == 1.0F);
    CHECK(colour.g == Approx(128.0F / 255.0F));
    CHECK(colour.b == 0.0F);
    CHECK(colour.a == 0.25F);
}

TEST_CASE("theme: every pair of ink and paper can be read, also on a washed-out projector") {
    for (const theme::InkOnPaper& words : theme::kWords) {
        INFO(words.where);
        CHECK(contrast_ratio(words.ink, words.paper) >= theme::kLeastContrast);
        CHECK(contrast_ratio(words.ink, words.paper, kProjectorStrayLight) >=
              theme::kLeastContrast);
        CHECK(words.ink.a == 1.0F);
        CHECK(words.paper.a == 1.0F);
    }
}
