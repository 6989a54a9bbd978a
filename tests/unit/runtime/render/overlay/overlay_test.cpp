#include "runtime/render/overlay/labels.h"
#include "runtime/render/overlay/menu.h"
#include "runtime/render/overlay/panels.h"
#include "runtime/render/renderer.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

using namespace fulcrum::runtime;

namespace {

Font andika() {
    return Font(RendererSettings{}.font_folder);
}

bool overlap(const Box& a, const Box& b) {
    constexpr float kTouch = 0.01F;
    return a.x + kTouch < b.right() && b.x + kTouch < a.right() && a.y + kTouch < b.bottom() &&
           b.y + kTouch < a.bottom();
}

bool inside(const Box& box, const Measure& m) {
    return box.x >= -0.01F && box.y >= -0.01F && box.right() <= m.width_px + 0.01F &&
           box.bottom() <= m.height_px + 0.01F;
}

View busy() {
    View view;
    view.title = "Which fruit is the heaviest?";
    view.level = 3;
    view.level_title = "Four fruits";
    view.caption = "Weigh the apple, then the watermelon. Move the bucket under each and wait.";
    view.feedback = "Yes. A watermelon is *the heaviest*.";
    view.input_visible = true;
    view.input = "the watermelon";
    view.banner = "The arm is not plugged in, so the mouse moves the bucket.";
    view.score = 12;
    return view;
}

View menu_of(int count, int chosen) {
    View view;
    view.title = "What shall we play?";
    for (int i = 0; i < count; ++i) {
        view.menu.push_back({"Lesson " + std::to_string(i), "A1", "apple"});
    }
    view.menu_selected = chosen;
    return view;
}

/// The area that a list's corners cover with their alpha, in full pixels.
double covered_px(const DrawList& list) {
    double area = 0.0;
    const auto& c = list.corners();
    for (std::size_t i = 0; i + 2 < c.size(); i += 3) {
        const double twice =
            std::abs(static_cast<double>((c[i + 1].x - c[i].x) * (c[i + 2].y - c[i].y) -
                                         (c[i + 2].x - c[i].x) * (c[i + 1].y - c[i].y)));
        const double alpha = (c[i].rgba[3] + c[i + 1].rgba[3] + c[i + 2].rgba[3]) / 3.0 / 255.0;
        area += 0.5 * twice * alpha;
    }
    return area;
}

}  // namespace

TEST_CASE("panels: words are at least 24 px in a picture 720 px high, and grow with it") {
    Font font = andika();
    for (const auto& [width, height] : {std::pair{1280, 720}, {1920, 1080}, {3840, 2160}}) {
        const PanelLayout layout = lay_out_panels(busy(), font, Measure(width, height));
        for (const Panel* panel : {&layout.banner, &layout.level, &layout.score, &layout.feedback,
                                   &layout.caption, &layout.input}) {
            CHECK(panel->words.size_px * 720 >= 24 * height);
        }
        CHECK(layout.level.second.size_px * 720 >= 24 * height);
    }
}

TEST_CASE("panels: each lies inside the picture and beside the others") {
    Font font = andika();
    for (const auto& [width, height] :
         {std::pair{1280, 720}, {1024, 768}, {2560, 1080}, {640, 480}}) {
        const Measure measure(width, height);
        const std::vector<Box> boxes = lay_out_panels(busy(), font, measure).shown();
        CHECK(boxes.size() == 6);
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            CHECK(inside(boxes[i], measure));
            for (std::size_t j = 0; j < i; ++j) {
                CHECK_FALSE(overlap(boxes[i], boxes[j]));
            }
        }
    }
}

TEST_CASE("panels: what the view does not say is not shown") {
    Font font = andika();
    const PanelLayout empty = lay_out_panels(View{}, font, Measure(1280, 720));
    CHECK(empty.shown().size() == 1);  // the score
    View end;
    end.stars = 0;
    CHECK(lay_out_panels(end, font, Measure(1280, 720)).stars.box.width > 0.0F);
    const PanelLayout menu = lay_out_panels(menu_of(3, 0), font, Measure(1280, 720));
    CHECK(menu.shown().empty());
}

TEST_CASE("panels: a long answer shows what was typed last") {
    Font font = andika();
    View view = busy();
    view.input = std::string(300, 'a') + "END";
    const PanelLayout layout = lay_out_panels(view, font, Measure(1280, 720));
    const auto& letters = layout.input.words.lines.front().letters;
    REQUIRE(letters.size() > 3);
    CHECK(letters.back().character == U'D');
    CHECK(letters.size() < 303);
    CHECK(layout.input.words.width_px < layout.input.box.width);
}

TEST_CASE("labels: none hides another, a panel, or leaves the picture") {
    Font font = andika();
    const Measure measure(1280, 720);
    const std::vector<Box> taken{{0, 0, 400, 100}, {300, 620, 700, 80}};
    std::mt19937 random(5);
    for (int round = 0; round < 20; ++round) {
        std::vector<SceneLabel> labels;
        for (int i = 0; i < 12; ++i) {
            SceneLabel label;
            label.middle_px = {static_cast<float>(random() % 1400) - 60.0F,
                               static_cast<float>(random() % 840) - 60.0F};
            label.radius_px = static_cast<float>(random() % 60);
            label.text = "watermelon " + std::to_string(i);
            label.is_force = i == 11;
            labels.push_back(label);
        }
        const auto placed = place_labels(labels, taken, font, measure);
        CHECK_FALSE(placed.empty());
        for (std::size_t i = 0; i < placed.size(); ++i) {
            CHECK(inside(placed[i].box, measure));
            for (const Box& box : taken) {
                CHECK_FALSE(overlap(placed[i].box, box));
            }
            for (std::size_t j = 0; j < i; ++j) {
                CHECK_FALSE(overlap(placed[i].box, placed[j].box));
            }
        }
    }
}

TEST_CASE("labels: a force's words come first and stand left of its arrow") {
    Font font = andika();
    SceneLabel apple{{640, 360}, 30, "apple", false, {0, 1}};
    SceneLabel force{{640, 360}, 20, "3 N", true, {0, 1}};
    const auto placed = place_labels({apple, force}, {}, font, Measure(1280, 720));
    REQUIRE(placed.size() == 2);
    CHECK(placed[0].label.is_force);
    CHECK(placed[0].box.right() <= 640.0F - 20.0F);
    CHECK(placed[1].box.x >= 640.0F + 30.0F);
}

TEST_CASE("menu: the chosen card is always in sight, cards neither overlap nor leave the picture") {
    for (const auto& [width, height] :
         {std::pair{1280, 720}, {800, 600}, {480, 800}, {3840, 2160}}) {
        const Measure measure(width, height);
        for (const int count : {1, 2, 3, 7, 8, 9, 40}) {
            for (int chosen = -1; chosen <= count; ++chosen) {
                const View view = menu_of(count, chosen);
                const MenuLayout layout = lay_out_menu(view, measure, std::vector<Box>{});
                REQUIRE_FALSE(layout.cards.empty());
                CHECK(std::count_if(layout.cards.begin(), layout.cards.end(),
                                    [](const MenuCard& card) { return card.chosen; }) == 1);
                for (std::size_t i = 0; i < layout.cards.size(); ++i) {
                    CHECK(inside(layout.cards[i].box, measure));
                    CHECK(layout.cards[i].icon.height > 0.0F);
                    for (std::size_t j = 0; j < i; ++j) {
                        CHECK_FALSE(overlap(layout.cards[i].box, layout.cards[j].box));
                    }
                }
                const bool all = layout.cards.size() == view.menu.size();
                CHECK(all == !(layout.more_above || layout.more_below));
            }
        }
    }
}

TEST_CASE("draw list: shapes cover their area") {
    Font font = andika();
    DrawList list(font);
    list.fill_box({10, 10, 100, 50}, 0.0F, Colour{});
    CHECK(covered_px(list) == Approx(5000.0).epsilon(0.02));
    list.clear();
    list.fill_disc({100, 100}, 40.0F, Colour{});
    CHECK(covered_px(list) == Approx(std::numbers::pi * 1600.0).epsilon(0.02));
    list.clear();
    list.line({0, 0}, {100, 0}, 10.0F, Colour{});
    CHECK(covered_px(list) == Approx(1000.0 + std::numbers::pi * 25.0).epsilon(0.02));
    list.clear();
    list.frame_box({0, 0, 200, 100}, 0.0F, 4.0F, Colour{});
    CHECK(covered_px(list) == Approx(200.0 * 100.0 - 192.0 * 92.0).epsilon(0.03));
    list.clear();
    list.fill_box({10, 10, 100, 50}, 0.0F, Colour{0, 0, 0, 0.5F});
    CHECK(covered_px(list) == Approx(2500.0).epsilon(0.02));
}

TEST_CASE("draw list: any text stays within the bound of one frame") {
    Font font = andika();
    DrawList list(font);
    std::string nonsense;
    for (int i = 0; i < 60'000; ++i) {
        nonsense += static_cast<char>(i * 7919 + i / 256);
    }
    ParagraphSettings settings;
    settings.size_px = 60;
    settings.width_px = 800.0F;
    const Paragraph paragraph = set_text(font, read_emphasis(nonsense), settings);
    for (int i = 0; i < 100; ++i) {
        list.text(paragraph, 0.0F, 0.0F, 800.0F, 0.5F, Colour{}, Colour{});
    }
    CHECK(list.corners().size() <= 600'000);
}
