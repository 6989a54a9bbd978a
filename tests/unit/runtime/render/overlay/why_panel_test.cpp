// The panel that says why a force is felt, among the other panels.
#include "runtime/render/overlay/why_panel.h"

#include "runtime/render/overlay/panels.h"
#include "runtime/render/renderer.h"
#include "tests/unit/runtime/render/overlay/overlay_fixture.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

View asking_why(int n_shares) {
    View view = busy();
    view.input.clear();
    view.why = {true, "Why do I feel this?", {}};
    for (int i = 0; i < n_shares; ++i) {
        view.why.shares.push_back({"force number " + std::to_string(i + 1),
                                   "1.8 N down and away from you", 1.0 / (1 + i), i == 1});
    }
    return view;
}

}  // namespace

TEST_CASE("why panel: it lies in the picture beside the others, wherever the words before are") {
    Font font = andika();
    for (const auto& [width, height] : {std::pair{1280, 720},
                                        {1024, 768},
                                        {2560, 1080},
                                        {640, 480},
                                        {800, 600},
                                        {1920, 1080},
                                        {3840, 2160},
                                        {600, 1000}}) {
        const Measure measure(width, height);
        for (const bool is_low : {false, true}) {
            View view = asking_why(6);
            if (is_low) {
                view.banner.clear();
            }
            const PanelLayout layout =
                lay_out_panels(view, font, measure, {}, {view.feedback, is_low});
            const std::vector<Box> boxes = layout.shown();
            check_apart(boxes, measure);
            // Where there is room at all the strongest shares are there.
            if (width == 1280) {
                CHECK(layout.why.rows.size() >= 2);
                CHECK(boxes.size() == (is_low ? 10 : 11));
            }
        }
    }
}

TEST_CASE("why panel: each row and bar lies inside it, no row in another, and no word is small") {
    Font font = andika();
    const Measure measure(1280, 720);
    View view = asking_why(4);
    view.banner.clear();
    view.feedback.clear();
    const WhyLayout why = lay_out_panels(view, font, measure).why;
    REQUIRE(why.rows.size() == 4);
    float above = why.box.y + why.title.height_px;
    for (const WhyRow& row : why.rows) {
        CHECK(row.top >= above);
        CHECK(row.bar.x >= why.box.x);
        CHECK(row.bar.right() <= why.box.right());
        CHECK(row.bar.bottom() <= why.box.bottom());
        CHECK(row.name.size_px >= 24);
        CHECK(row.name.width_px + row.amount.width_px <= row.bar.width);
        above = row.bar.bottom();
    }
    CHECK(why.rows[1].against);
    CHECK(why.rows[1].part == 0.5);
}

TEST_CASE("why panel: it moves away from the hand, stays there, and is in nobody's way there") {
    Font font = andika();
    for (const auto& [width, height] : {std::pair{1280, 720}, {1024, 768}, {3840, 2160}}) {
        const Measure measure(width, height);
        View view = asking_why(4);
        view.banner.clear();
        view.feedback.clear();
        const auto laid = [&](const Box& hand, const MovedPanels& before) {
            return lay_out_panels(view, font, measure, hand, before);
        };
        const PanelLayout left = laid({}, {});
        CHECK_FALSE(left.moved.why_is_right);
        const Box under{left.why.box.middle_x(), left.why.box.middle_y(), 40.0F, 40.0F};
        const PanelLayout right = laid(under, left.moved);
        INFO(width << " x " << height);
        CHECK(right.moved.why_is_right);
        CHECK_FALSE(overlap(right.why.box, under));
        CHECK(right.why.rows.size() == left.why.rows.size());
        CHECK(right.why.rows[0].bar.x > right.why.box.x);
        check_apart(right.shown(), measure);
        // The hand is gone: it stays. The hand comes here too: it goes back. Where it is asked for anew it begins on the left.
        CHECK(laid({}, right.moved).why.box.x == right.why.box.x);
        CHECK(laid(right.why.box, right.moved).why.box.x == left.why.box.x);
        view.why.visible = false;
        CHECK_FALSE(laid(under, right.moved).moved.why_is_right);
        // A hand as large as the picture is hidden anyway.
        view.why.visible = true;
        CHECK_FALSE(laid({0.0F, 0.0F, measure.width_px, measure.height_px}, {}).moved.why_is_right);
    }
}

TEST_CASE("why panel: it is there when it is asked for, and not over the stars or the menu") {
    Font font = andika();
    const Measure measure(1280, 720);
    View view = asking_why(2);
    CHECK(lay_out_panels(view, font, measure).why.box.width > 0.0F);
    View end = view;
    end.stars = 2;
    CHECK(lay_out_panels(end, font, measure).why.box.width == 0.0F);
    View menu = view;
    menu.menu.push_back({"Lesson", "A1", "apple"});
    CHECK(lay_out_panels(menu, font, measure).why.box.width == 0.0F);
    view.why.visible = false;
    CHECK(lay_out_panels(view, font, measure).why.box.width == 0.0F);
    // Where choices leave no room for a row there is no empty sheet.
    View full = asking_why(3);
    for (int i = 0; i < 9; ++i) {
        full.choices.push_back({"The watermelon is the heaviest.", "apple"});
    }
    const PanelLayout layout = lay_out_panels(full, font, measure);
    CHECK(layout.why.rows.empty() == (layout.why.box.width == 0.0F));
}

TEST_CASE("why panel: a bar is as long as its share; what acts against begins at the other end") {
    Font font = andika();
    const Measure measure(1280, 720);
    const auto drawn = [&](double part, bool against) {
        ViewWhy why{true, "Why?", {{"weight", "1 N down", part, against}}};
        const WhyLayout layout = lay_out_why(why, font, measure, {20.0F, 100.0F, 400.0F, 400.0F});
        DrawList list(font);
        draw_why(layout, measure, list);
        // The last box that was drawn is the filled part.
        float left = 1e9F;
        float right = -1e9F;
        const auto& colour = list.corners().back().rgba;
        for (const OverlayCorner& corner : list.corners()) {
            if (corner.rgba[0] == colour[0] && corner.rgba[1] == colour[1] &&
                corner.rgba[2] == colour[2] && corner.rgba[3] == 255) {
                left = std::min(left, corner.x);
                right = std::max(right, corner.x);
            }
        }
        return std::pair{left - layout.rows[0].bar.x, layout.rows[0].bar.right() - right};
    };
    constexpr float kEdge_px = 1.5F;  // edges are softened
    const auto [whole_left, whole_right] = drawn(1.0, false);
    CHECK(std::abs(whole_left) < kEdge_px);
    CHECK(std::abs(whole_right) < kEdge_px);
    const auto [half_left, half_right] = drawn(0.5, false);
    CHECK(std::abs(half_left) < kEdge_px);
    CHECK(std::abs(half_right - 182.0F) < kEdge_px);  // half of 400 less twice 18
    const auto [against_left, against_right] = drawn(0.5, true);
    CHECK(std::abs(against_left - 182.0F) < kEdge_px);
    CHECK(std::abs(against_right) < kEdge_px);
}
