#include "runtime/render/overlay/overlay_pass.h"

#include "tests/unit/runtime/render/picture_fixture.h"

using namespace fulcrum;
using namespace fulcrum::runtime;
using namespace fulcrum::runtime::test;

TEST_CASE("picture: every panel changes its own place") {
    const auto studio = open_studio();
    if (!studio) {
        return;
    }
    const runtime::View plain = nothing();
    const Image before = studio->draw(plain);
    const auto check = [&](const runtime::View& view, const Box& box) {
        const Image after = studio->draw(view);
        const int inside = changed(before, after, box);
        CHECK(inside > static_cast<int>(0.5F * box.width * box.height));
        // Beyond its shadow nothing else changes.
        CHECK(changed(before, after) <= changed(before, after, box.grown(20.0F)));
    };
    runtime::View caption = plain;
    caption.caption = "Catch the fruit.";
    check(caption, panels_of(caption).caption.box);
    runtime::View feedback = plain;
    feedback.feedback = "A melon is *the heaviest*.";
    check(feedback, panels_of(feedback).feedback.box);
    runtime::View input = plain;
    input.input_visible = true;
    check(input, panels_of(input).input.box);
    runtime::View level = plain;
    level.level = 2;
    level.level_title = "Three fruits";
    check(level, panels_of(level).level.box);
    runtime::View stars = plain;
    stars.stars = 2;
    check(stars, panels_of(stars).stars.box);
}

TEST_CASE("picture: a banner lies over a scene that is still seen") {
    const auto studio = open_studio();
    if (!studio) {
        return;
    }
    runtime::View view = nothing();
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

TEST_CASE("picture: score, stars and typed words are told apart") {
    const auto studio = open_studio();
    if (!studio || !has_words()) {
        return;
    }
    runtime::View view = nothing();
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

TEST_CASE("picture: emphasis changes words, and words are dark on light") {
    const auto studio = open_studio();
    if (!studio || !has_words()) {
        return;
    }
    runtime::View view = nothing();
    view.feedback = "the heaviest";
    const Image plain = studio->draw(view);
    const Box box = panels_of(view).feedback.box;
    int darkest = 765;
    for (int x = static_cast<int>(box.x) + 40; x < static_cast<int>(box.right()); ++x) {
        darkest = std::min(darkest, brightness(pixel(plain, x, static_cast<int>(box.middle_y()))));
    }
    CHECK(darkest < 200);
    view.feedback = "*the heaviest*";
    CHECK(changed(plain, studio->draw(view)) > 100);
}

TEST_CASE("picture: the menu shows cards instead of the scene, and which one is chosen") {
    const auto studio = open_studio();
    if (!studio) {
        return;
    }
    runtime::View view = nothing();
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
