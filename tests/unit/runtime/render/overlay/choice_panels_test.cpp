#include "runtime/render/overlay/choice_panels.h"

#include "runtime/render/overlay/panels.h"
#include "runtime/scene/choice_columns.h"
#include "tests/support/longest_choice.h"
#include "tests/unit/runtime/render/overlay/overlay_fixture.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;
using fulcrum::test::kLongestChoice;

TEST_CASE("choice panels: choices stand without a line to type in, at the end of a lesson") {
    View view = busy();
    view.input_visible = false;
    view.choices = {{"Play again", {}}, {"Back to the lessons", {}}};
    Font font = andika();
    const Measure measure(1280, 720);
    const PanelLayout layout = lay_out_panels(view, font, measure);
    REQUIRE(layout.choices.size() == 2);
    CHECK(layout.input.box.width == 0.0F);
    check_apart(layout.shown(), measure);
}

TEST_CASE(
    "choice panels: choices stand above the typed line, apart, each with room for its picture") {
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
        check_apart(layout.shown(), measure);
        for (const Panel& choice : layout.choices) {
            CHECK(choice.box.bottom() <= layout.input.box.y);
            CHECK(layout.caption.box.bottom() <= choice.box.y);
            const Box picture = choice_picture(choice, measure);
            CHECK(picture.x >= choice.box.x);
            CHECK(picture.right() < choice.box.x + 0.25F * choice.box.width);
            CHECK(picture.y >= choice.box.y);
            CHECK(picture.bottom() <= choice.box.bottom() + 0.01F);
        }
    }
}

TEST_CASE(
    "choice panels: more than two choices stand in two columns, and the longest are read whole") {
    Font font = andika();
    for (const int n : {1, 2, 3, 4, 6}) {
        View view = busy();
        view.banner.clear();
        view.feedback.clear();
        view.choices.assign(static_cast<std::size_t>(n), ViewChoice{kLongestChoice, "apple"});
        for (const auto& [width, height] :
             {std::pair{1280, 720}, {1920, 1080}, {1024, 768}, {2560, 1080}, {800, 600}}) {
            const Measure measure(width, height);
            const PanelLayout layout = lay_out_panels(view, font, measure);
            INFO(n << " choices at " << width << " x " << height);
            check_apart(layout.shown(), measure);
            const auto rows = static_cast<std::size_t>(choice_rows(n));
            for (std::size_t i = 0; i < layout.choices.size(); ++i) {
                const Panel& choice = layout.choices[i];
                CHECK_FALSE(choice.words.shortened);
                CHECK(choice_picture(choice, measure).right() + choice.words.width_px <
                      choice.box.right());
                // As the keys go: down the first column, and then the second beside it.
                CHECK(choice.box.y == layout.choices[i % rows].box.y);
                CHECK((choice.box.x > layout.choices[0].box.x) == (i >= rows));
            }
        }
    }
}

TEST_CASE("choice panels: four short choices leave three fifths of the picture to the scene") {
    Font font = andika();
    View view;
    view.level = 1;
    view.title = "Can you turn a planet?";
    view.input_visible = true;
    view.choices.assign(4, ViewChoice{"How many moons does Neptune have?", {}});
    for (const auto& [width, height] : {std::pair{1280, 720}, {1920, 1080}}) {
        const PanelLayout layout = lay_out_panels(view, font, Measure(width, height));
        constexpr float kScene = 0.6F;
        CHECK(layout.choices[0].box.y - layout.level.box.bottom() >
              kScene * static_cast<float>(height));
    }
}

TEST_CASE(
    "choice panels: caption and choices hide neither the hand nor, where there is room, things") {
    Font font = andika();
    View view;
    view.level = 1;
    view.title = "Can you lift the Earth?";
    view.caption = "Where must the support go: to the Earth or to your hand?";
    view.input_visible = true;
    view.choices.assign(4, ViewChoice{"The support must go to the Earth.", {}});
    for (const auto& [width, height] : {std::pair{1280, 720}, {1920, 1080}, {1024, 768}}) {
        const Measure page(width, height);
        const PanelLayout free = lay_out_panels(view, font, page);
        const auto meets = [](const PanelLayout& layout, const Box& thing) {
            return overlap(layout.caption.box, thing) ||
                   std::ranges::any_of(layout.choices, [&](const Panel& choice) {
                       return overlap(choice.box, thing);
                   });
        };
        const auto hand_at = [&](float y) {
            return Box{0.5F * page.width_px, y, page.px(90.0F), page.px(90.0F)};
        };
        for (float y = page.px(120.0F); y < page.height_px - page.px(160.0F); y += 30.0F) {
            const PanelLayout layout = lay_out_panels(view, font, page, hand_at(y));
            INFO(width << " x " << height << ", hand at " << y);
            CHECK_FALSE(meets(layout, hand_at(y)));
            check_apart(layout.shown(), page);
            // A pointer that comes to choose finds them where they were, wherever they were.
            const Box& first = layout.choices[0].box;
            const PanelLayout come =
                lay_out_panels(view, font, page, hand_at(first.y), layout.moved);
            CHECK(come.choices[0].box.y == first.y);
            // Others may be elsewhere.
            View other = view;
            other.choices[1].said = "Nowhere.";
            CHECK_FALSE(meets(lay_out_panels(other, font, page, hand_at(first.y), layout.moved),
                              hand_at(first.y)));
        }
        // A lever and what lies on it; then they are gone, and nothing moves back.
        const float low = free.choices[0].box.y - page.px(30.0F);
        std::vector<Box> things;
        for (const float x : {0.3F, 0.5F, 0.7F}) {
            things.push_back({x * page.width_px, low, page.px(60.0F), page.px(60.0F)});
        }
        REQUIRE(std::ranges::any_of(things, [&](const Box& thing) { return meets(free, thing); }));
        const PanelLayout moved = lay_out_panels(view, font, page, {}, {}, things);
        CHECK(std::ranges::none_of(things, [&](const Box& thing) { return meets(moved, thing); }));
        CHECK(lay_out_panels(view, font, page, {}, moved.moved).choices[0].box.y ==
              moved.choices[0].box.y);
    }
}
