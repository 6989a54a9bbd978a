#include "runtime/render/overlay/labels.h"
#include "runtime/render/overlay/panels.h"
#include "tests/unit/runtime/render/overlay/overlay_fixture.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

const Measure kPage(1280, 720);

/// As a lesson begins, with its help on moving.
View helping() {
    View view = busy();
    view.feedback.clear();
    view.input_visible = false;
    view.banner =
        "Move the mouse. Turn the wheel: near and far. To press, move into a thing. "
        "Or press W, A, S, D. Tab: ask a question. F3: why do I feel this?";
    return view;
}

std::ptrdiff_t n_hidden(const Box& banner, const std::vector<Box>& things) {
    return std::ranges::count_if(things, [&](const Box& thing) { return overlap(thing, banner); });
}

std::vector<Box> row_of_things(float y, float first_x, float last_x) {
    std::vector<Box> things;
    for (float x = first_x; x <= last_x; x += 110.0F) {
        things.push_back({x, y, 40.0F, 40.0F});
    }
    return things;
}

}  // namespace

TEST_CASE("notice: it hides the hand nowhere, lies beside the others, and is read whole") {
    Font font = andika();
    for (const auto& [width, height] : {std::pair{1280, 720}, {1920, 1080}, {1024, 768}}) {
        const Measure page(width, height);
        // Among things everywhere: the hand goes before them.
        const std::vector<Box> things =
            row_of_things(0.5F * page.height_px, 0.0F, page.width_px - 40.0F);
        MovedPanels before;
        for (float y = 0.0F; y < page.height_px; y += 45.0F) {
            for (float x = 0.0F; x < page.width_px; x += 80.0F) {
                const Box hand{x, y, page.px(100.0F), page.px(100.0F)};
                const PanelLayout layout =
                    lay_out_panels(helping(), font, page, hand, before, things);
                INFO(width << " x " << height << ", hand at " << x << ", " << y);
                CHECK_FALSE(overlap(layout.banner.box, hand));
                CHECK_FALSE(layout.banner.words.shortened);
                check_apart(layout.shown(), page);
                before = layout.moved;
            }
        }
    }
}

TEST_CASE("notice: it leaves things free where there is room, and stays there") {
    Font font = andika();
    const auto laid = [&](const std::vector<Box>& things, const MovedPanels& before) {
        return lay_out_panels(helping(), font, kPage, {}, before, things);
    };
    const PanelLayout empty = laid({}, {});
    CHECK(empty.moved.notice_place == BannerPlace::across_top);
    // The upper planets of a solar system.
    const std::vector<Box> above = row_of_things(150.0F, 250.0F, 1100.0F);
    REQUIRE(n_hidden(empty.banner.box, above) > 0);
    const PanelLayout low = laid(above, {});
    CHECK(n_hidden(low.banner.box, above) == 0);
    CHECK(laid({}, low.moved).banner.box.y == low.banner.box.y);
    // And the lower ones: only the sides are free, or one of them.
    std::vector<Box> both = above;
    for (const float y : {450.0F, 500.0F, 550.0F}) {
        const std::vector<Box> below = row_of_things(y, 450.0F, 800.0F);
        both.insert(both.end(), below.begin(), below.end());
    }
    std::erase_if(both, [](const Box& thing) { return thing.x < 400.0F; });
    const PanelLayout left = laid(both, low.moved);
    CHECK(n_hidden(left.banner.box, both) == 0);
    CHECK(left.banner.box.right() < 400.0F);
    check_apart(left.shown(), kPage);
    // What is said, and why, needs the room beside.
    View view = helping();
    view.feedback = "Yes. A watermelon is *the heaviest*.";
    const PanelLayout said = lay_out_panels(view, font, kPage, {}, left.moved, both);
    CHECK(said.banner.box.width > 1000.0F);
    check_apart(said.shown(), kPage);
    // Other words begin at the top again.
    MovedPanels other = left.moved;
    other.notice = "P goes on.";
    CHECK(laid({}, other).moved.notice_place == BannerPlace::across_top);
}

TEST_CASE("notice: an error stands across the top, whatever is there") {
    Font font = andika();
    View view = helping();
    view.banner_is_error = true;
    const PanelLayout free = lay_out_panels(view, font, kPage);
    const PanelLayout layout = lay_out_panels(view, font, kPage, free.banner.box,
                                              {{}, false, false, view.banner, BannerPlace::left},
                                              row_of_things(150.0F, 20.0F, 1200.0F));
    CHECK(layout.banner.box.x == free.banner.box.x);
    CHECK(layout.banner.box.y == free.banner.box.y);
    CHECK(layout.banner.box.width == free.banner.box.width);
}

TEST_CASE("notice: what has words of its own is where it is seen") {
    SceneLabel thing;
    thing.middle_px = {100.0F, 50.0F};
    thing.radius_px = 10.0F;
    SceneLabel force;
    force.is_force = true;
    force.covers = {5.0F, 6.0F, 7.0F, 80.0F};
    const std::vector<Box> boxes = labelled_boxes({thing, force});
    REQUIRE(boxes.size() == 2);
    CHECK(boxes[0].x == 90.0F);
    CHECK(boxes[0].bottom() == 60.0F);
    CHECK(boxes[1].x == 5.0F);
    CHECK(boxes[1].height == 80.0F);
}
