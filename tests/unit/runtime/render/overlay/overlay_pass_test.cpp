#include "runtime/render/overlay/overlay_pass.h"

#include "tests/unit/runtime/render/picture_fixture.h"

using namespace fulcrum;
using namespace fulcrum::runtime;
using namespace fulcrum::runtime::test;

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
