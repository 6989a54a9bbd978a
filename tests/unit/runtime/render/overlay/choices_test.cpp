// Answers to choose, among the other panels.
#include "runtime/render/overlay/measure.h"
#include "runtime/render/overlay/panels.h"
#include "runtime/render/renderer.h"
#include "tests/unit/runtime/render/overlay/overlay_fixture.h"

#include <catch2/catch.hpp>

#include <utility>

using namespace fulcrum::runtime;

TEST_CASE(
    "panels: choices stand above the line to type in, none over another, each with room for its "
    "picture") {
    Font font = andika();
    View view = busy();
    view.banner.clear();
    view.input.clear();
    view.caption = "Which one is the heaviest?";
    view.feedback = "Not yet. Lift both again.";
    for (const char* said : {"The watermelon is the heaviest.", "The apple is the heaviest.",
                             "The egg is the heaviest.", "The banana is the heaviest."}) {
        view.choices.push_back({said, "apple"});
    }
    for (const int width : {1280, 800, 1920}) {
        const Measure measure(width, width * 9 / 16);
        const PanelLayout layout = lay_out_panels(view, font, measure);
        REQUIRE(layout.choices.size() == 4);
        float below = layout.input.box.y;
        for (std::size_t i = 4; i-- > 0;) {
            const Panel& choice = layout.choices[i];
            CHECK(inside(choice.box, measure));
            CHECK(choice.box.bottom() <= below);
            below = choice.box.y;
            const Box picture = choice_picture(choice, measure);
            CHECK(picture.x >= choice.box.x);
            CHECK(picture.right() < choice.box.x + 0.25F * choice.box.width);
            CHECK(picture.bottom() <= choice.box.bottom() + 0.01F);
        }
        CHECK(layout.caption.box.bottom() <= below);
        for (const Panel* other :
             {&layout.caption, &layout.feedback, &layout.level, &layout.score}) {
            for (const Panel& choice : layout.choices) {
                CHECK_FALSE(overlap(choice.box, other->box));
            }
        }
    }
    view.input_visible = false;
    CHECK(lay_out_panels(view, font, Measure(1280, 720)).choices.empty());
}

TEST_CASE(
    "panels: a hint on how to answer is read from its first letter to its last, however short the "
    "line") {
    Font font = andika();
    View view;
    view.input_visible = true;
    view.microphone.visible = true;
    view.microphone.words = "Choose with the up and down arrows. Then press Enter.";
    for (const auto& [width, height] : {std::pair{1280, 720}, {1920, 1080}, {800, 600}}) {
        const PanelLayout layout = lay_out_panels(view, font, Measure(width, height));
        const auto& letters = layout.input.words.lines.front().letters;
        INFO(width << " x " << height);
        REQUIRE_FALSE(letters.empty());
        CHECK(letters.front().character == U'C');
        CHECK(letters.back().character == U'.');
        CHECK(layout.input.words.width_px < layout.input.box.width);
    }
}
