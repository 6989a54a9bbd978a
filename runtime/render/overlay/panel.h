// One panel: a box and the words in it, and the sizes that all of them share.
//
// Thread: one (it asks the font). Cost: setting the words.
#pragma once

#include "runtime/render/overlay/draw_list.h"
#include "runtime/render/overlay/measure.h"

namespace fulcrum::runtime {

/// One panel and the words in it.
struct Panel {
    Box box;
    Paragraph words;
    Paragraph second;  ///< a line below, may be empty
};

// At 720; see Measure.
inline constexpr float kMargin = 20.0F;
inline constexpr float kGap = 10.0F;
inline constexpr float kPadX = 26.0F;
inline constexpr float kPadY = 8.0F;
inline constexpr float kIcon = 19.0F;      ///< radius of an icon in a line of words
inline constexpr float kIconRoom = 54.0F;  ///< from a panel's padding to the words behind an icon
inline constexpr float kWidestWords = 1000.0F;
inline constexpr float kInputWidth = 760.0F;
inline constexpr float kLevelPad = 14.0F;
inline constexpr float kLightSign = 30.0F;  ///< from one light's sign to the next
inline constexpr std::size_t kMostLightSigns = 12;
inline constexpr float kCursor = 3.0F;
inline constexpr float kEndStar = 62.0F;
inline constexpr float kEndStars = 3.0F * kEndStar;  // the height of their row
inline constexpr float kEndNote = 820.0F;            // the widest words below them
inline constexpr int kMostSpokenLines = 3;

struct WordSettings {
    float size = kSpokenText;
    float width = kWidestWords;  ///< in pixels
    int lines = kMostSpokenLines;
    Face face = Face::regular;
};

inline Paragraph set_words(const Font& font, const Measure& m, const MarkedText& text,
                           const WordSettings& settings) {
    ParagraphSettings p;
    p.size_px = m.text_px(settings.size);
    p.face = settings.face;
    p.width_px = settings.width;
    p.most_lines = settings.lines;
    return set_text(font, text, p);
}

}  // namespace fulcrum::runtime
