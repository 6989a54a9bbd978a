#include "runtime/render/overlay/buttons.h"
#include "runtime/render/overlay/draw_panels.h"
#include "runtime/render/overlay/measure.h"
#include "runtime/render/overlay/microphone.h"
#include "runtime/render/overlay/overlay_pass.h"
#include "runtime/render/overlay/panels.h"
#include "runtime/render/renderer.h"
#include "tests/unit/runtime/render/overlay/overlay_fixture.h"
#include "tests/unit/runtime/render/picture_fixture.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

const Measure kMeasure(1280, 720);
constexpr Point2 kRightMiddle{600.0F, 400.0F};

std::vector<OverlayCorner> drawn(const ViewMicrophone& microphone) {
    Font font(RendererSettings{}.font_folder);
    DrawList list(font);
    draw_microphone(list, kRightMiddle, kMeasure, microphone);
    return list.corners();
}

// How high the bars stand above their middle, right of the microphone itself.
float bars_px(double level) {
    float top = kRightMiddle[1];
    for (const OverlayCorner& corner : drawn({true, false, level, {}})) {
        const bool is_bar = corner.x > kRightMiddle[0] - kMeasure.px(45.0F);
        top = is_bar ? std::min(top, corner.y) : top;
    }
    return kRightMiddle[1] - top;
}

PanelLayout laid_out(const View& view) {
    Font font(RendererSettings{}.font_folder);
    return lay_out_panels(view, font, kMeasure);
}

}  // namespace

TEST_CASE(
    "buttons: one after the other, large enough for a finger, where they were when a banner "
    "comes") {
    View view = busy();
    for (const auto& [width, height] : {std::pair{1280, 720}, {1024, 768}, {640, 480}}) {
        const Measure measure(width, height);
        Font font = andika();
        view.banner = "Pause.";
        const PanelLayout warned = lay_out_panels(view, font, measure);
        view.banner.clear();
        const PanelLayout layout = lay_out_panels(view, font, measure);
        REQUIRE(layout.buttons.size() == 4);
        for (std::size_t i = 0; i < 4; ++i) {
            CHECK(layout.buttons[i].width >= measure.px(44.0F));
            CHECK(layout.buttons[i].x == warned.buttons[i].x);
            CHECK(layout.buttons[i].y == warned.buttons[i].y);
            CHECK((i == 0 || layout.buttons[i].x > layout.buttons[i - 1].right()));
        }
    }
    view.buttons.clear();
    CHECK(laid_out(view).buttons.empty());
}

TEST_CASE("buttons: each has a sign of its own, and a pause shows how to go on") {
    std::vector<std::vector<OverlayCorner>> signs;
    constexpr ScreenButton buttons[] = {ScreenButton::ask, ScreenButton::why,
                                        ScreenButton::say_again, ScreenButton::settings,
                                        ScreenButton::pause};
    constexpr std::size_t n_buttons = std::size(buttons);
    for (const bool paused : {false, true}) {
        for (const ScreenButton button : buttons) {
            View view;
            view.buttons = {button};
            view.paused = paused;
            Font font(RendererSettings{}.font_folder);
            DrawList list(font);
            draw_buttons(view, {{10.0F, 10.0F, 52.0F, 52.0F}}, kMeasure, list);
            signs.push_back(list.corners());
        }
    }
    const auto is_same = [&](std::size_t i, std::size_t j) {
        return std::ranges::equal(signs[i], signs[j], [](const auto& a, const auto& b) {
            return a.x == b.x && a.y == b.y;
        });
    };
    for (std::size_t i = 0; i < n_buttons; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            CHECK_FALSE(is_same(i, j));
        }
        CHECK(is_same(i, i + n_buttons) == (i != n_buttons - 1));  // the last one is the pause's
    }
}

TEST_CASE("panels: below the stars stands why, in their paper and beside all else") {
    View view = busy();
    view.banner.clear();
    view.input_visible = false;
    view.stars = 2;
    view.choices = {{"Play again", {}}, {"Next: What is it made of?", {}}, {"Back", {}}};
    const Panel bare = laid_out(view).stars;
    view.end_note = "You answered 4 of 5 questions at the first try.";
    const PanelLayout layout = laid_out(view);
    CHECK(bare.words.lines.empty());
    CHECK(layout.stars.words.lines.size() == 1);
    CHECK(layout.stars.box.height >= bare.box.height + layout.stars.words.height_px);
    CHECK(layout.stars.box.width >= layout.stars.words.width_px);
    check_apart(layout.shown(), kMeasure);
}

TEST_CASE("panels: a hint is read from its first letter to its last, however short the line") {
    Font font = andika();
    View view;
    view.input_visible = true;
    view.microphone.visible = true;
    view.microphone.words = "Choose with the arrow keys. Then press Enter.";
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

TEST_CASE("microphone: it stays in its room, and its bars rise with the sound") {
    for (const double level : {0.0, 0.5, 1.0}) {
        for (const bool hears : {false, true}) {
            for (const OverlayCorner& corner : drawn({true, hears, level, {}})) {
                CHECK(corner.x > kRightMiddle[0] - microphone_width_px(kMeasure) - 3.0F);
                CHECK(corner.x < kRightMiddle[0] + 3.0F);
                CHECK(std::abs(corner.y - kRightMiddle[1]) < kMeasure.px(22.0F));
            }
        }
    }
    CHECK(bars_px(0.0) < kMeasure.px(4.0F));
    CHECK(bars_px(0.5) > 2.0F * bars_px(0.0));
    CHECK(bars_px(1.0) > 1.3F * bars_px(0.5));
    CHECK(bars_px(7.0) == bars_px(1.0));
    CHECK(bars_px(-1.0) == bars_px(0.0));
}

TEST_CASE("microphone: whether it takes in what is said is seen by shape, not by colour alone") {
    CHECK(drawn({true, true, 0.0, {}}).size() > drawn({true, false, 0.0, {}}).size());
}

TEST_CASE("microphone: the line to type in says how to speak, until something is typed beside it") {
    View view;
    view.input_visible = true;
    view.microphone = {true, false, 0.0, "Hold Control and speak, or type."};
    CHECK(laid_out(view).input.words.width_px > kMeasure.px(300.0F));
    view.input = "it";
    CHECK(laid_out(view).input.words.width_px < kMeasure.px(60.0F));
    // Long words leave the microphone its room.
    view.input = std::string(300, 'a');
    const float beside = laid_out(view).input.words.width_px;
    view.microphone.visible = false;
    CHECK(laid_out(view).input.words.width_px - beside >
          microphone_width_px(kMeasure) - kMeasure.px(30.0F));
}

TEST_CASE("picture: panels and cards are where they are laid out, and told apart") {
    const auto studio = open_studio();
    if (!studio) {
        return;
    }
    runtime::View view = nothing();
    SECTION("every panel changes its own place") {
        const Image before = studio->draw(view);
        const auto check = [&](const auto& tell, auto PanelLayout::*panel) {
            runtime::View told = view;
            tell(told);
            const Box box = (panels_of(told).*panel).box;
            const Image after = studio->draw(told);
            const int inside = changed(before, after, box);
            CHECK(inside > static_cast<int>(0.5F * box.width * box.height));
            // Beyond its shadow nothing else changes.
            CHECK(changed(before, after) <= changed(before, after, box.grown(20.0F)));
        };
        using View = runtime::View;
        check([](View& v) { v.caption = "Catch the fruit."; }, &PanelLayout::caption);
        check([](View& v) { v.feedback = "A melon is *the heaviest*."; }, &PanelLayout::feedback);
        check([](View& v) { v.input_visible = true; }, &PanelLayout::input);
        check([](View& v) { v.level = 2, v.level_title = "Three fruits"; }, &PanelLayout::level);
        check([](View& v) { v.stars = 2; }, &PanelLayout::stars);
    }
    SECTION("a banner lies over a scene that is still seen") {
        view.bodies = {body("red", {0.0, 0.3, 0.0})};
        const Image before = studio->draw(view);
        view.banner = "lesson.lua:3: something is wrong.";
        view.banner_is_error = true;
        const Image error = studio->draw(view);
        CHECK(pixel_at(error, view, {0.0, 0.3, 0.1}) == pixel_at(before, view, {0.0, 0.3, 0.1}));
        view.banner_is_error = false;
        const Image notice = studio->draw(view);
        CHECK(changed(error, notice, panels_of(view).banner.box) > 500);
    }
    SECTION("the menu shows cards instead of the scene, and which one is chosen") {
        view.bodies = {body("red", {0.0, 0.4, 0.0})};
        view.menu = {{"One", "A1", "red"}, {"Two", "A2", "green"}, {"Three", "B1", "nobody"}};
        const Image first = studio->draw(view);
        view.menu_selected = 2;
        const Image last = studio->draw(view);
        CHECK(changed(first, last) > 1000);
        view.bodies.clear();
        CHECK(studio->draw(view).rgba == last.rgba);
        view.menu_selected = 1000;
        CHECK(studio->draw(view).rgba == last.rgba);
        // The icon of the first card is a red ball.
        int red = 0;
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth / 2; ++x) {
                const auto p = pixel(last, x, y);
                red += p[0] > 120 && p[0] > 2 * p[1] ? 1 : 0;
            }
        }
        CHECK(red > 500);
    }
}

TEST_CASE("picture: words are told apart, and dark on light") {
    const auto studio = open_studio();
    if (!studio || !has_words()) {
        return;
    }
    runtime::View view = nothing();
    SECTION("score, stars and typed words are told apart") {
        view.input_visible = true;
        view.stars = 1;
        const Image before = studio->draw(view);
        runtime::View other = view;
        other.score = 8;
        CHECK(changed(before, studio->draw(other)) > 20);
        other = view;
        other.stars = 2;
        CHECK(changed(before, studio->draw(other)) > 300);
        other = view;
        other.input = "the";
        CHECK(changed(before, studio->draw(other)) > 60);
    }
    SECTION("emphasis changes words, and words are dark on light") {
        view.feedback = "the heaviest";
        const Image plain = studio->draw(view);
        const Box box = panels_of(view).feedback.box;
        int darkest = 765;
        for (int x = static_cast<int>(box.x) + 40; x < static_cast<int>(box.right()); ++x) {
            darkest =
                std::min(darkest, brightness(pixel(plain, x, static_cast<int>(box.middle_y()))));
        }
        CHECK(darkest < 200);
        view.feedback = "*the heaviest*";
        CHECK(changed(plain, studio->draw(view)) > 100);
    }
}
