// The cards of a class, and those of secret pictures, as they are laid out.
#include "runtime/render/overlay/menu.h"
#include "tests/unit/runtime/render/overlay/overlay_fixture.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

// Pupils with two pictures each, and behind them a guest with one.
View class_of(int n_cards) {
    View view;
    view.title = "Who are you?";
    view.menu_is_small = true;
    view.menu_selected = n_cards / 2;
    for (int i = 0; i < n_cards; ++i) {
        ViewMenuItem item;
        item.title = "Pupil " + std::to_string(i);
        item.icon = "apple";
        item.second_icon = i + 1 < n_cards ? "kite" : "";
        view.menu.push_back(item);
    }
    return view;
}

MenuLayout laid(const View& view, const Measure& page) {
    return lay_out_menu(view, page, std::vector<Box>{});
}

}  // namespace

TEST_CASE(
    "class cards: 36 pupils and a guest stand on one picture, apart, with pictures and name") {
    const Measure page(1280, 720);
    Font font = andika();
    for (const int count : {2, 5, 9, 13, 16, 31, 35, 37}) {
        const View view = class_of(count);
        const MenuLayout layout = laid(view, page);
        INFO(count << " cards");
        CHECK(layout.cards.size() == view.menu.size());
        CHECK(layout.rows == layout.all_rows);
        check_apart(boxes_of(layout.cards, &MenuCard::box), page);
        check_apart(boxes_of(layout.cards, &MenuCard::paper), page);
        for (const MenuCard& card : layout.cards) {
            // What a child tells apart: no picture is smaller than two lines of the smallest words.
            const float side = std::min(card.icon.width, card.icon.height);
            CHECK(side >= 2.0F * kSmallText);
            CHECK(card.box.bottom() - card.icon.bottom() >= 1.3F * kSmallText);
            CHECK(card.box.width >= 5.0F * kSmallText);
            const bool has_second = card.index + 1 < view.menu.size();
            CHECK((card.second_icon.width > 0.0F) == has_second);
            if (has_second) {
                check_apart({card.icon, card.second_icon}, page);
                CHECK(card.second_icon.right() <= card.box.right());
                CHECK(card.second_icon.height == card.icon.height);
            }
        }
    }
    // Names alone fill their cards.
    View names = class_of(31);
    for (ViewMenuItem& item : names.menu) {
        item.icon = item.second_icon = "";
    }
    for (const MenuCard& card : laid(names, page).cards) {
        CHECK(card.icon.width == 0.0F);
        CHECK(card.box.bottom() - card.icon.bottom() >= 2.6F * kBodyText);
    }
    // Thirty pupils: a first name of ten letters is whole.
    ParagraphSettings words;
    words.size_px = page.text_px(kSmallText);
    words.face = Face::bold;
    const float name = set_text(font, plain_text("Maximilian"), words).width_px;
    const MenuCard card = laid(class_of(31), page).cards[0];
    CHECK(card.second_icon.right() - card.icon.x > name);
}
