#include "runtime/render/overlay/why_panel.h"

#include "runtime/render/overlay/paper.h"
#include "runtime/render/theme.h"

#include <algorithm>

namespace fulcrum::runtime {
namespace {

// At 720; see Measure.
constexpr float kWhyPad = 18.0F;
constexpr float kWhyWidth = 400.0F;
constexpr float kBarHeight = 10.0F;
constexpr float kRowGap = 8.0F;
constexpr float kNameShare = 0.5F;  // of a row's width, at least
constexpr int kMostLines = 2;       // of a name, or of an amount

Paragraph set_lines(const Font& font, const Measure& m, const std::string& text, float width_px,
                    int lines, Face face = Face::regular) {
    ParagraphSettings settings;
    settings.size_px = m.text_px(kSmallText);
    settings.face = face;
    settings.width_px = width_px;
    settings.most_lines = lines;
    return set_text(font, plain_text(text), settings);
}

}  // namespace

WhyLayout lay_out_why(const ViewWhy& why, const Font& font, const Measure& measure,
                      const Box& room) {
    WhyLayout layout;
    const Measure& m = measure;
    const float width = std::min(m.px(kWhyWidth), room.width);
    const float words = width - 2.0F * m.px(kWhyPad);
    if (!why.visible || why.shares.empty() || words < m.px(kSmallText)) {
        return layout;
    }
    layout.title = set_lines(font, m, why.title, words, 1, Face::bold);
    const float x = room.x + m.px(kWhyPad);
    float y = room.y + m.px(kWhyPad) + layout.title.height_px;
    for (const ViewShare& share : why.shares) {
        WhyRow row;
        // A short amount leaves its room to a long name; where both are long they take two lines.
        const auto beside = [&](const Paragraph& other) {
            return words - other.width_px - m.px(kRowGap);
        };
        row.amount = set_lines(font, m, share.amount, words, 1);
        row.name = set_lines(
            font, m, share.name,
            share.amount.empty() ? words : std::max(beside(row.amount), kNameShare * words),
            kMostLines);
        row.amount = set_lines(font, m, share.amount, beside(row.name), kMostLines);
        row.top = y + m.px(kRowGap);
        const float below = row.top + std::max(row.name.height_px, row.amount.height_px);
        // A sentence without an amount has no bar.
        row.bar = {x, below, words, share.amount.empty() ? 0.0F : m.px(kBarHeight)};
        row.part = std::clamp(share.part, 0.0, 1.0);
        row.against = share.against;
        if (row.bar.bottom() + m.px(kWhyPad) > room.bottom()) {
            break;
        }
        y = row.bar.bottom();
        layout.rows.push_back(std::move(row));
    }
    if (!layout.rows.empty()) {
        layout.box = {room.x, room.y, width, y + m.px(kWhyPad) - room.y};
    }
    return layout;
}

// What pulls with the felt force is blue and begins at the left; what acts against it is vermillion, begins at the right and says so in its
// words: not by colour alone.
void draw_why(const WhyLayout& layout, const Measure& measure, DrawList& list) {
    if (layout.box.width <= 0.0F) {
        return;
    }
    const Measure& m = measure;
    draw_paper(list, layout.box, m, list.colours().paper);
    const float x = layout.box.x + m.px(kWhyPad);
    const float words = layout.box.width - 2.0F * m.px(kWhyPad);
    list.text(layout.title, x, layout.box.y + m.px(kWhyPad), words, 0.0F, list.colours().ink,
              list.colours().emphasis_ink);
    for (const WhyRow& row : layout.rows) {
        list.text(row.name, x, row.top, 0.0F, 0.0F, list.colours().ink,
                  list.colours().emphasis_ink);
        list.text(row.amount, x, row.top, words, 1.0F, list.colours().soft_ink,
                  list.colours().emphasis_ink);
        if (row.bar.height <= 0.0F) {
            continue;
        }
        const float radius = 0.5F * row.bar.height;
        list.fill_box(row.bar, radius, list.colours().icon_paper);
        if (row.part <= 0.0) {
            continue;
        }
        Box part = row.bar;
        part.width = std::max(static_cast<float>(row.part) * row.bar.width, row.bar.height);
        if (row.against) {
            part.x = row.bar.right() - part.width;
        }
        list.fill_box(part, radius, row.against ? theme::kVermillion : theme::kBlue);
    }
}

}  // namespace fulcrum::runtime
