#include "runtime/render/text/paragraph.h"

#include "runtime/text/utf8.h"

#include <algorithm>

namespace fulcrum::runtime {

namespace {

constexpr char32_t kEllipsis = 0x2026;

/// Appends a letter behind the line's last one.
void append(const Font& font, const ParagraphSettings& settings, TextLine& line, char32_t character,
            bool emphasised) {
    const Face face = emphasised ? Face::bold : settings.face;
    PlacedLetter letter;
    letter.character = character;
    letter.emphasised = emphasised;
    letter.advance_px = font.advance_px(face, settings.size_px, character);
    letter.x_px = line.width_px;
    if (!line.letters.empty() && line.letters.back().emphasised == emphasised) {
        letter.x_px +=
            font.kerning_px(face, settings.size_px, line.letters.back().character, character);
    }
    line.width_px = letter.x_px + letter.advance_px;
    line.letters.push_back(letter);
}

void drop_last_letter(TextLine& line) {
    line.letters.pop_back();
    line.width_px =
        line.letters.empty() ? 0.0F : line.letters.back().x_px + line.letters.back().advance_px;
}

void trim(TextLine& line) {
    while (!line.letters.empty() && line.letters.back().character == U' ') {
        drop_last_letter(line);
    }
}

/// Breaks a text into lines.
class Setter {
  public:
    Setter(const Font& font, const ParagraphSettings& settings)
        : font_(font), settings_(settings) {}

    /// One character more; false when no line is left for it.
    bool take(char32_t character, bool emphasised) {
        if (character == U'\n') {
            return break_line(line_.letters.size());
        }
        const bool at_break = line_.letters.empty() && !lines_.empty();
        if (character == U' ' && at_break) {
            return true;
        }
        append(font_, settings_, line_, character, emphasised);
        if (line_.width_px <= settings_.width_px || line_.letters.size() == 1 ||
            character == U' ') {
            return true;
        }
        // The line is too wide: break behind its last space, or else before this letter.
        std::size_t start = line_.letters.size() - 1;
        for (std::size_t i = line_.letters.size(); i > 1; --i) {
            if (line_.letters[i - 1].character == U' ') {
                start = i;
                break;
            }
        }
        return break_line(start);
    }

    std::vector<TextLine> finish() {
        if (!line_.letters.empty() || lines_.empty()) {
            trim(line_);
            lines_.push_back(std::move(line_));
        }
        return std::move(lines_);
    }

  private:
    /// Ends the line before its letter `start`; the letters from there begin the next one.
    bool break_line(std::size_t start) {
        const std::vector<PlacedLetter> moved(line_.letters.begin() + static_cast<long>(start),
                                              line_.letters.end());
        const bool last = lines_.size() + 1 >= static_cast<std::size_t>(settings_.most_lines);
        if (last) {
            return false;
        }
        line_.letters.resize(start);
        if (!line_.letters.empty()) {
            line_.width_px = line_.letters.back().x_px + line_.letters.back().advance_px;
        }
        trim(line_);
        lines_.push_back(std::move(line_));
        line_ = {};
        for (const PlacedLetter& letter : moved) {
            append(font_, settings_, line_, letter.character, letter.emphasised);
        }
        return true;
    }

    const Font& font_;
    const ParagraphSettings& settings_;
    std::vector<TextLine> lines_;
    TextLine line_;
};

/// Ends a line in an ellipsis that fits.
void shorten(const Font& font, const ParagraphSettings& settings, TextLine& line) {
    const float dots_px = font.advance_px(settings.face, settings.size_px, kEllipsis);
    while (!line.letters.empty() && line.width_px + dots_px > settings.width_px) {
        drop_last_letter(line);
    }
    trim(line);
    append(font, settings, line, kEllipsis, false);
}

}  // namespace

MarkedText plain_text(std::string_view utf8) {
    MarkedText text;
    text.characters = decode_for_display(utf8);
    text.emphasised.assign(text.characters.size(), false);
    return text;
}

MarkedText read_emphasis(std::string_view utf8) {
    const std::u32string all = decode_for_display(utf8);
    std::size_t asterisks_left = static_cast<std::size_t>(std::count(all.begin(), all.end(), U'*'));
    MarkedText text;
    bool emphasised = false;
    for (const char32_t c : all) {
        if (c == U'*') {
            --asterisks_left;
            if (emphasised || asterisks_left > 0) {
                emphasised = !emphasised;
                continue;
            }
        }
        text.characters.push_back(c);
        text.emphasised.push_back(emphasised);
    }
    return text;
}

Paragraph set_text(const Font& font, const MarkedText& text, const ParagraphSettings& settings) {
    Paragraph paragraph;
    paragraph.size_px = std::clamp(settings.size_px, 1, kLargestText_px);
    paragraph.face = settings.face;
    paragraph.metrics = font.metrics(paragraph.size_px);
    ParagraphSettings used = settings;
    used.size_px = paragraph.size_px;
    used.most_lines = std::max(settings.most_lines, 1);

    Setter setter(font, used);
    for (std::size_t i = 0; i < text.characters.size(); ++i) {
        if (!setter.take(text.characters[i], text.emphasised[i])) {
            paragraph.shortened = true;
            break;
        }
    }
    paragraph.lines = setter.finish();
    if (paragraph.shortened) {
        shorten(font, used, paragraph.lines.back());
    }
    for (const TextLine& line : paragraph.lines) {
        paragraph.width_px = std::max(paragraph.width_px, line.width_px);
    }
    paragraph.height_px = paragraph.metrics.line_px * static_cast<float>(paragraph.lines.size());
    return paragraph;
}

}  // namespace fulcrum::runtime
