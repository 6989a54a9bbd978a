// Words set into lines: wrapped, emphasised, cut off where there is no room.
//
//   A line is broken behind a space or beside an ideograph, in a word only where it is wider than a
//   line, and never in a cluster: a base with its marks, a syllable. Each line's words stand in the
//   order in which their scripts run (directions.h).
//
// Thread: one (it asks the font). Cost: linear in the text.
#pragma once

#include "runtime/render/text/font.h"

#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::runtime {

/// A text's characters; those between asterisks are emphasised, the asterisks are gone.
struct MarkedText {
    std::u32string characters;
    std::vector<bool> emphasised;  ///< one a character
};

/// Reads *emphasis*. An asterisk without a partner on its side stays an asterisk.
[[nodiscard]] MarkedText read_emphasis(std::string_view utf8);
/// Takes every character as it is.
[[nodiscard]] MarkedText plain_text(std::string_view utf8);

/// A letter and where its pen stands in its line.
struct PlacedLetter {
    ShapedLetter shaped;        ///< its `first` counts in the whole text
    char32_t character = U' ';  ///< the first of those that it stands for
    float x_px = 0.0F;
    float advance_px = 0.0F;
    bool emphasised = false;
};

/// From left to right.
struct TextLine {
    std::vector<PlacedLetter> letters;
    float width_px = 0.0F;
    float end_px = 0.0F;     ///< where what was written last ends: the caret's place
    bool ends_left = false;  ///< it was written from right to left
};

/// A text set for drawing.
struct Paragraph {
    std::vector<TextLine> lines;
    int size_px = 24;
    Face face = Face::regular;
    LineMetrics metrics;
    float width_px = 0.0F;   ///< of the widest line
    float height_px = 0.0F;  ///< of all lines
    bool shortened = false;  ///< something did not fit; the last line ends in an ellipsis
};

struct ParagraphSettings {
    int size_px = 24;
    Face face = Face::regular;  ///< emphasised letters are bold in any case
    float width_px = 1e9F;      ///< lines are broken to stay below it, in a word if need be
    int most_lines = 1000;
};

/// Sets a text. Spaces at a break are dropped; '\n' always breaks.
[[nodiscard]] Paragraph set_text(const Font& font, const MarkedText& text,
                                 const ParagraphSettings& settings);

/// How many of the text's first characters to leave out so that the rest of its one line is at most
/// so wide: what was typed last stays in sight. kMostCodePoints where nothing fits.
[[nodiscard]] std::size_t characters_to_drop(const TextLine& line, float width_px);

}  // namespace fulcrum::runtime
