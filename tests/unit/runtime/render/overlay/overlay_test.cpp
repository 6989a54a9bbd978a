#include "runtime/render/overlay/labels.h"
#include "runtime/render/overlay/menu.h"
#include "runtime/render/overlay/panels.h"
#include "runtime/render/renderer.h"
#include "tests/unit/runtime/render/overlay/overlay_fixture.h"
#include "tests/unit/runtime/rig.h"

#include <numbers>
#include <random>

using namespace fulcrum::runtime::test;

namespace {

View menu_of(int count, int chosen) {
    View view;
    view.title = "What shall we play?";
    for (int i = 0; i < count; ++i) {
        view.menu.push_back({"Lesson " + std::to_string(i), "A1", "apple"});
    }
    view.menu_selected = chosen;
    return view;
}

MenuLayout menu(const View& view, const Measure& measure) {
    return lay_out_menu(view, measure, std::vector<Box>{});
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

TEST_CASE("panels: words can be read, each has a room of its own, and what was said is shown") {
    Font font = andika();
    const Measure measure(1280, 720);
    SECTION("words are at least 24 px in a picture 720 px high, and grow with it") {
        for (const auto& [width, height] : {std::pair{1280, 720}, {1920, 1080}, {3840, 2160}}) {
            const PanelLayout layout = lay_out_panels(busy(), font, Measure(width, height));
            for (const Panel* panel : {&layout.banner, &layout.level, &layout.score,
                                       &layout.feedback, &layout.caption, &layout.input}) {
                CHECK(panel->words.size_px * 720 >= 24 * height);
            }
            CHECK(layout.level.second.size_px * 720 >= 24 * height);
        }
    }
    SECTION("each lies inside the picture and beside the others") {
        for (const auto& [width, height] :
             {std::pair{1280, 720}, {1024, 768}, {2560, 1080}, {640, 480}}) {
            const Measure page(width, height);
            const std::vector<Box> boxes = lay_out_panels(busy(), font, page).shown();
            CHECK(boxes.size() == 10);
            check_apart(boxes, page);
        }
    }
    SECTION("what was said moves away from the hand, and then stays where it is") {
        View view = busy();
        const auto laid = [&](const Box& hand, const MovedPanels& place) {
            return lay_out_panels(view, font, measure, hand, place);
        };
        const PanelLayout free = laid({}, {});
        CHECK_FALSE(free.moved.feedback_is_low);
        const Box under = {free.feedback.box.middle_x(), free.feedback.box.y, 60.0F, 60.0F};
        const PanelLayout low = laid(under, free.moved);
        CHECK(low.moved.feedback_is_low);
        CHECK_FALSE(overlap(low.feedback.box, under));
        check_apart(low.shown(), measure);
        // The hand is gone: the same words stay, new ones begin above again.
        CHECK(laid({}, low.moved).feedback.box.y == low.feedback.box.y);
        CHECK(laid(low.feedback.box, low.moved).feedback.box.y == free.feedback.box.y);
        view.feedback = "Not yet. Try again.";
        CHECK_FALSE(laid({}, low.moved).moved.feedback_is_low);
        // A hand as large as the picture is hidden anyway.
        CHECK_FALSE(laid({0.0F, 0.0F, 1280.0F, 720.0F}, {}).moved.feedback_is_low);
    }
    SECTION("what the view does not say is not shown") {
        const PanelLayout empty = lay_out_panels(View{}, font, measure);
        CHECK(empty.shown().size() == 1);  // the score
        View end;
        end.stars = 0;
        CHECK(lay_out_panels(end, font, measure).stars.box.width > 0.0F);
        CHECK(lay_out_panels(menu_of(3, 0), font, measure).shown().empty());
    }
    SECTION("a long answer shows what was typed last") {
        View view = busy();
        view.input = std::string(300, 'a') + "END";
        const PanelLayout layout = lay_out_panels(view, font, measure);
        const auto& letters = layout.input.words.lines.front().letters;
        REQUIRE(letters.size() > 3);
        CHECK(letters.back().character == U'D');
        CHECK(letters.size() < 303);
        CHECK(layout.input.words.width_px < layout.input.box.width);
    }
}

TEST_CASE("labels: each stands beside its own thing and hides nothing") {
    Font font = andika();
    const Measure measure(1280, 720);
    SECTION("none hides another, a panel, or leaves the picture") {
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
            check_apart(boxes_of(placed, &PlacedLabel::box), measure);
            for (const PlacedLabel& label : placed) {
                for (const Box& box : taken) {
                    CHECK_FALSE(overlap(label.box, box));
                }
            }
        }
    }
    SECTION("a force's words come first and stand left of its arrow") {
        SceneLabel apple{{640, 360}, 30, "apple"};
        SceneLabel force{{640, 360}, 20, "3 N", true};
        const auto placed = place_labels({apple, force}, {}, font, measure);
        REQUIRE(placed.size() == 2);
        CHECK(placed[0].label.is_force);
        CHECK(placed[0].box.right() <= 640.0F - 20.0F);
        CHECK(placed[1].box.x >= 640.0F + 30.0F);
    }
    SECTION("a torque's words do not hide its lever arm while there is room elsewhere") {
        SceneLabel torque{{1000, 360}, 20, "1.1 N x 0.99 m = 1.09 N m", true};
        torque.covers = {980, 310, 40, 100};
        const auto box_with = [&](Point2 axis) {
            torque.arm_from = axis;
            torque.arm_to = {1000, 360};
            const auto placed = place_labels({torque}, {}, font, measure);
            REQUIRE(placed.size() == 1);
            return placed[0].box;
        };
        // It comes from the left, where the words would stand; right of the arrow there is no room for them.
        const Box box = box_with({200, 380});
        CHECK((box.y > 380.0F || box.bottom() < 340.0F));
        CHECK_FALSE(overlap(box, torque.covers));
        CHECK(box_with({1000, 360}).right() < 980.0F);  // no arm
        CHECK(box_with({1000, 700}).right() < 980.0F);  // one from below
    }
    SECTION("each stands beside its own thing, over no other while there is room") {
        const std::vector<SceneLabel> in_a_row = {
            {.middle_px = {400, 360}, .radius_px = 80, .text = "spaceship"},
            {.middle_px = {640, 360}, .radius_px = 100, .text = "table"},
            {.middle_px = {880, 360}, .radius_px = 80, .text = "statue"}};
        const auto placed = place_labels(in_a_row, {}, font, measure);
        REQUIRE(placed.size() == 3);
        for (const PlacedLabel& label : placed) {
            for (const SceneLabel& thing : in_a_row) {
                const float half = 0.7F * thing.radius_px;
                const Box its{thing.middle_px[0] - half, thing.middle_px[1] - half, 2 * half,
                              2 * half};
                INFO(label.label.text << " and " << thing.text);
                CHECK_FALSE(overlap(label.box, its));
            }
        }
        // Nothing beside it: right of the thing, as ever.
        const auto alone = place_labels({in_a_row[1]}, {}, font, measure);
        REQUIRE(alone.size() == 1);
        CHECK(alone[0].box.x >= 740.0F);
        // Where the hand is there, on its other side; the hand in front of the thing itself moves nothing.
        const Box hand{745, 300, 90, 120};
        const auto aside = place_labels({in_a_row[1]}, {}, font, measure, hand);
        REQUIRE(aside.size() == 1);
        CHECK_FALSE(overlap(aside[0].box, hand));
        const auto before = place_labels({in_a_row[1]}, {}, font, measure, {600, 320, 80, 80});
        CHECK(before[0].box.x == alone[0].box.x);
        // Without such room a label still stands somewhere.
        std::vector<SceneLabel> crowd;
        for (int i = 0; i < 12; ++i) {
            crowd.push_back({.middle_px = {100.0F + 98.0F * static_cast<float>(i), 360},
                             .radius_px = 300,
                             .text = "a"});
        }
        CHECK(place_labels(crowd, {}, font, measure).size() == 12);
    }
}

TEST_CASE("menu: the chosen card is in sight, and what is seen at a place is what is there") {
    Font font = andika();
    const Measure measure(1280, 720);
    SECTION("the chosen card is always in sight, cards neither overlap nor leave the picture") {
        for (const auto& [width, height] :
             {std::pair{1280, 720}, {800, 600}, {480, 800}, {3840, 2160}}) {
            const Measure page(width, height);
            for (const int count : {1, 2, 3, 7, 8, 9, 40}) {
                for (int chosen = -1; chosen <= count; ++chosen) {
                    const View view = menu_of(count, chosen);
                    const MenuLayout layout = menu(view, page);
                    REQUIRE_FALSE(layout.cards.empty());
                    CHECK(std::count_if(layout.cards.begin(), layout.cards.end(),
                                        [](const MenuCard& card) { return card.chosen; }) == 1);
                    check_apart(boxes_of(layout.cards, &MenuCard::box), page);
                    CHECK(std::ranges::all_of(layout.cards, [](const MenuCard& card) {
                        return card.icon.height > 0.0F;
                    }));
                    const bool all = layout.cards.size() == view.menu.size();
                    CHECK(all == !(layout.earlier.width > 0.0F || layout.later.width > 0.0F));
                }
            }
        }
    }
    SECTION("what is seen at a place is the card drawn there, and nothing beside the cards") {
        for (const auto& [width, height] : {std::pair{1280, 720},
                                            {1024, 768},
                                            {800, 600},
                                            {480, 800},
                                            {1920, 1080},
                                            {3840, 2160}}) {
            const Measure page(width, height);
            for (const int count : {1, 2, 4, 7, 12, 40}) {
                const MenuLayout layout = menu(menu_of(count, count / 2), page);
                for (const MenuCard& card : layout.cards) {
                    const auto at = [&](float x, float y) {
                        return menu_spot_at(layout, static_cast<double>(x), static_cast<double>(y));
                    };
                    const auto hits = [&](const MenuSpot& spot) {
                        return spot.place == MenuPlace::card && spot.index == card.index;
                    };
                    const Box& seen = card.paper;
                    CHECK(hits(at(seen.middle_x(), seen.middle_y())));
                    // The first pixel of each side is the card's, the first one past it is not.
                    CHECK(hits(at(seen.x, seen.y)));
                    CHECK(hits(at(seen.right() - 0.5F, seen.bottom() - 0.5F)));
                    for (const MenuSpot& beside :
                         {at(seen.x - 0.5F, seen.middle_y()), at(seen.right(), seen.middle_y()),
                          at(seen.middle_x(), seen.y - 0.5F), at(seen.middle_x(), seen.bottom())}) {
                        CHECK(beside.place != MenuPlace::card);
                    }
                    CHECK(seen.width == Approx(card.box.width + (card.chosen ? page.px(16) : 0)));
                }
            }
        }
    }
    SECTION("between two cards there is nothing to point at") {
        const MenuLayout layout = menu(menu_of(4, 0), measure);
        REQUIRE(layout.cards.size() == 4);
        for (std::size_t i = 1; i < layout.cards.size(); ++i) {
            const Box& left = layout.cards[i - 1].paper;
            const Box& right = layout.cards[i].paper;
            REQUIRE(right.x > left.right());
            const double x = 0.5 * static_cast<double>(left.right() + right.x);
            CHECK(menu_spot_at(layout, x, static_cast<double>(right.middle_y())).place ==
                  MenuPlace::nothing);
        }
        const double nan = std::nan("");
        CHECK(menu_spot_at(layout, nan, nan).place == MenuPlace::nothing);
        CHECK(menu_spot_at(layout, 640.0, -1.0).place == MenuPlace::nothing);
        const MenuLayout none = menu(View{}, measure);
        CHECK(menu_spot_at(none, 640.0, 360.0).place == MenuPlace::nothing);
    }
    SECTION("choosing a card in sight moves no card") {
        for (const auto& [width, height] : {std::pair{1280, 720}, {800, 600}, {480, 800}}) {
            const Measure page(width, height);
            for (int first_row = 0; first_row < 10; ++first_row) {
                View view = menu_of(30, 0);
                view.menu_first_row = first_row;
                view.menu_selected = std::min(29, first_row * 6);
                const MenuLayout before = menu(view, page);
                view.menu_first_row = before.first_row;
                for (const MenuCard& card : before.cards) {
                    view.menu_selected = static_cast<int>(card.index);
                    const MenuLayout after = menu(view, page);
                    REQUIRE(after.cards.size() == before.cards.size());
                    for (std::size_t i = 0; i < after.cards.size(); ++i) {
                        CHECK(after.cards[i].index == before.cards[i].index);
                        CHECK(after.cards[i].box.x == before.cards[i].box.x);
                        CHECK(after.cards[i].box.y == before.cards[i].box.y);
                    }
                }
            }
        }
    }
    SECTION("a banner takes the headline's place and moves no card") {
        View view = menu_of(7, 1);
        view.caption = "Choose a lesson.";
        const MenuLayout calm =
            lay_out_menu(view, measure, lay_out_panels(view, font, measure).shown());
        view.banner = "scenarios/kite/lesson.lua:42: unexpected symbol near '='; mend the line.";
        view.banner_is_error = true;
        const PanelLayout panels = lay_out_panels(view, font, measure);
        const MenuLayout warned = lay_out_menu(view, measure, panels.shown());
        CHECK(calm.headline);
        CHECK_FALSE(warned.headline);
        REQUIRE(warned.cards.size() == calm.cards.size());
        for (std::size_t i = 0; i < calm.cards.size(); ++i) {
            CHECK(warned.cards[i].box.y == calm.cards[i].box.y);
            CHECK_FALSE(overlap(warned.cards[i].paper, panels.banner.box));
        }
    }
    SECTION("signs say where there are more rows, and can be pointed at") {
        View view = menu_of(12, 0);
        const MenuLayout top = menu(view, measure);
        REQUIRE(top.all_rows > top.rows);
        CHECK(top.earlier.width == 0.0F);
        const auto place = [](const MenuLayout& layout, const Box& sign) {
            return menu_spot_at(layout, static_cast<double>(sign.middle_x()),
                                static_cast<double>(sign.bottom() - 1.0F))
                .place;
        };
        CHECK(place(top, top.later) == MenuPlace::later);
        view.menu_selected = 11;
        const MenuLayout end = menu(view, measure);
        CHECK(end.first_row == end.all_rows - end.rows);
        CHECK(end.later.width == 0.0F);
        CHECK(menu_spot_at(end, static_cast<double>(end.earlier.middle_x()),
                           static_cast<double>(end.earlier.y + 1.0F))
                  .place == MenuPlace::earlier);
    }
}

TEST_CASE("draw list: shapes cover their area") {
    Font font = andika();
    DrawList list(font);
    const auto take_covered_px = [&] {
        const double area = covered_px(list);
        list.clear();
        return area;
    };
    list.fill_box({10, 10, 100, 50}, 0.0F, Colour{});
    CHECK(take_covered_px() == Approx(5000.0).epsilon(0.02));
    list.fill_disc({100, 100}, 40.0F, Colour{});
    CHECK(take_covered_px() == Approx(std::numbers::pi * 1600.0).epsilon(0.02));
    list.line({0, 0}, {100, 0}, 10.0F, Colour{});
    CHECK(take_covered_px() == Approx(1000.0 + std::numbers::pi * 25.0).epsilon(0.02));
    list.frame_box({0, 0, 200, 100}, 0.0F, 4.0F, Colour{});
    CHECK(take_covered_px() == Approx(200.0 * 100.0 - 192.0 * 92.0).epsilon(0.03));
    list.fill_box({10, 10, 100, 50}, 0.0F, Colour{0, 0, 0, 0.5F});
    CHECK(take_covered_px() == Approx(2500.0).epsilon(0.02));
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
