// Words set into lines: wrapped, emphasised, cut off where there is no room.
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
    char32_t character = U' ';
    float x_px = 0.0F;
    float advance_px = 0.0F;
    bool emphasised = false;
};

struct TextLine {
    std::vector<PlacedLetter> letters;
    float width_px = 0.0F;
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

}  // namespace fulcrum::runtime
