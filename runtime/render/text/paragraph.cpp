#include "runtime/render/text/paragraph.h"

#include "runtime/render/text/directions.h"
#include "runtime/text/utf8.h"

#include <algorithm>
#include <map>

namespace fulcrum::runtime {

namespace {

constexpr char32_t kEllipsis = 0x2026;

/// Characters that stand or fall together, in the order in which they are read.
struct Cluster {
    std::size_t first_letter = 0;  // of all letters
    std::size_t letters_end = 0;
    std::size_t first = 0;  // of the text's characters
    char32_t character = U' ';
    char32_t last_character = U' ';
    float advance_px = 0.0F;
    std::uint8_t level = 0;
    bool emphasised = false;
};

/// Chinese and Japanese signs, between which a line may end. Korean words are kept whole, as Latin ones.
bool is_ideograph(char32_t c) {
    return (c >= 0x2E80 && c <= 0x30FF) || (c >= 0x3400 && c <= 0x9FFF) ||
           (c >= 0xF900 && c <= 0xFAFF) || (c >= 0xFF01 && c <= 0xFF60) ||
           (c >= 0x20000 && c <= 0x3FFFF);
}

/// A line may end between the two. Brackets are kept with what they hold, stops with what they end.
bool may_break_between(char32_t left, char32_t right) {
    constexpr std::u32string_view kNotLast = U"「『（［｛〈《【〔“‘(";
    constexpr std::u32string_view kNotFirst =
        U"」』）］｝〉》】〕”’)、。，．：；？！ー々ぁぃぅぇぉっゃゅょァィゥェォッャュョ,.:;?!";
    return left == U' ' || ((is_ideograph(left) || is_ideograph(right)) &&
                            kNotLast.find(left) == std::u32string_view::npos &&
                            kNotFirst.find(right) == std::u32string_view::npos);
}

/// A text's clusters, with their letters.
class Shaped {
  public:
    Shaped(const Font& font, const ParagraphSettings& settings, std::size_t characters)
        : font_(font), settings_(settings) {
        letters_.reserve(characters + 1);
        clusters_.reserve(characters + 1);
    }

    /// Adds what lies between two line breaks.
    void add_piece(const MarkedText& text, std::size_t first, std::size_t end) {
        const std::u32string_view all(text.characters);
        const Directions directions = find_directions(all.substr(first, end - first));
        base_ = directions.base;
        const auto is_one_word = [&](std::size_t a, std::size_t b) {
            return all[a] != U' ' && all[b] != U' ' && text.emphasised[a] == text.emphasised[b] &&
                   directions.levels[a - first] == directions.levels[b - first];
        };
        for (std::size_t i = first; i < end;) {
            std::size_t word_end = i + 1;
            while (word_end < end && is_one_word(i, word_end)) {
                ++word_end;
            }
            add_word(all.substr(i, word_end - i), i, text.emphasised[i],
                     directions.levels[i - first]);
            i = word_end;
        }
    }
    void add_break(std::size_t at) {
        Cluster cluster;
        cluster.first_letter = cluster.letters_end = letters_.size();
        cluster.first = at;
        cluster.character = cluster.last_character = U'\n';
        clusters_.push_back(cluster);
    }
    /// Letters that run as the whole text does; the cluster is the last one.
    void add_ellipsis(std::size_t at) {
        const std::u32string dots(1, kEllipsis);
        add_word(dots, at, false, base_);
    }

    [[nodiscard]] const std::vector<Cluster>& clusters() const { return clusters_; }

    /// A line of clusters, its letters in their order.
    [[nodiscard]] TextLine place(const std::vector<std::size_t>& line) const;

  private:
    void add_word(std::u32string_view word, std::size_t first, bool emphasised, std::uint8_t level);

    const Font& font_;
    const ParagraphSettings& settings_;
    std::vector<ShapedLetter> letters_;
    std::vector<Cluster> clusters_;
    std::uint8_t base_ = 0;
};

void Shaped::add_word(std::u32string_view word, std::size_t first, bool emphasised,
                      std::uint8_t level) {
    const bool right_to_left = level % 2 == 1;
    const auto& shaped = font_.shape(emphasised ? Face::bold : settings_.face, word, right_to_left);
    const std::size_t from = letters_.size();
    letters_.insert(letters_.end(), shaped.begin(), shaped.end());
    // Letters of one cluster stand side by side; from right to left the word's first comes last.
    const std::size_t first_new = clusters_.size();
    for (std::size_t i = from; i < letters_.size();) {
        Cluster cluster;
        cluster.first_letter = i;
        cluster.first = first + letters_[i].first;
        for (; i < letters_.size() && first + letters_[i].first == cluster.first; ++i) {
            cluster.advance_px += letters_[i].advance_em * static_cast<float>(settings_.size_px);
        }
        cluster.letters_end = i;
        cluster.character = word[cluster.first - first];
        cluster.level = level;
        cluster.emphasised = emphasised;
        clusters_.push_back(cluster);
    }
    if (right_to_left) {
        std::reverse(clusters_.begin() + static_cast<long>(first_new), clusters_.end());
    }
    for (std::size_t i = first_new; i < clusters_.size(); ++i) {
        const bool last = i + 1 == clusters_.size();
        clusters_[i].last_character =
            word[(last ? first + word.size() : clusters_[i + 1].first) - first - 1];
    }
    for (std::size_t i = from; i < letters_.size(); ++i) {
        letters_[i].first += static_cast<std::uint32_t>(first);
    }
}

TextLine Shaped::place(const std::vector<std::size_t>& line) const {
    std::vector<std::uint8_t> levels;
    levels.reserve(line.size());
    for (const std::size_t at : line) {
        levels.push_back(clusters_[at].level);
    }
    TextLine placed;
    for (const std::size_t at : order_in_line(levels)) {
        const Cluster& cluster = clusters_[line[at]];
        const float left_px = placed.width_px;
        for (std::size_t i = cluster.first_letter; i < cluster.letters_end; ++i) {
            const float advance_px = letters_[i].advance_em * static_cast<float>(settings_.size_px);
            placed.letters.push_back(
                {letters_[i], cluster.character, placed.width_px, advance_px, cluster.emphasised});
            placed.width_px += advance_px;
        }
        if (at + 1 == line.size()) {
            placed.ends_left = cluster.level % 2 == 1;
            placed.end_px = placed.ends_left ? left_px : placed.width_px;
        }
    }
    return placed;
}

/// Breaks a text into lines.
class Breaker {
  public:
    Breaker(const std::vector<Cluster>& clusters, const ParagraphSettings& settings)
        : clusters_(clusters), settings_(settings) {}

    /// One cluster more; false when no line is left for it.
    bool take(std::size_t cluster) {
        const char32_t character = clusters_[cluster].character;
        if (character == U'\n') {
            return break_line(line_.size());
        }
        if (character == U' ' && line_.empty() && !lines_.empty()) {
            return true;
        }
        append(cluster);
        if (width_px_ <= settings_.width_px || line_.size() == 1 || character == U' ') {
            return true;
        }
        // The line is too wide: break at its last place for it, or else before this cluster.
        std::size_t start = line_.size() - 1;
        for (std::size_t i = line_.size() - 1; i > 0; --i) {
            if (may_break_between(clusters_[line_[i - 1]].last_character,
                                  clusters_[line_[i]].character)) {
                start = i;
                break;
            }
        }
        return break_line(start);
    }

    /// The last line where it does not hold all: ends so that `ellipsis` fits.
    void shorten(std::size_t ellipsis) {
        while (!line_.empty() && width_px_ + clusters_[ellipsis].advance_px > settings_.width_px) {
            drop_last();
        }
        trim();
        append(ellipsis);
    }

    std::vector<std::vector<std::size_t>> finish() {
        if (!line_.empty() || lines_.empty()) {
            trim();
            lines_.push_back(std::move(line_));
        }
        return std::move(lines_);
    }

  private:
    void append(std::size_t cluster) {
        line_.push_back(cluster);
        width_px_ += clusters_[cluster].advance_px;
    }
    void drop_last() {
        width_px_ -= clusters_[line_.back()].advance_px;
        line_.pop_back();
    }
    void trim() {
        while (!line_.empty() && clusters_[line_.back()].character == U' ') {
            drop_last();
        }
    }
    /// Ends the line before its cluster `start`; those from there begin the next one.
    bool break_line(std::size_t start) {
        if (lines_.size() + 1 >= static_cast<std::size_t>(settings_.most_lines)) {
            return false;
        }
        const std::vector<std::size_t> moved(line_.begin() + static_cast<long>(start), line_.end());
        line_.resize(start);
        trim();
        lines_.push_back(std::move(line_));
        line_ = {};
        width_px_ = 0.0F;
        for (const std::size_t cluster : moved) {
            append(cluster);
        }
        return true;
    }

    const std::vector<Cluster>& clusters_;
    const ParagraphSettings& settings_;
    std::vector<std::vector<std::size_t>> lines_;
    std::vector<std::size_t> line_;
    float width_px_ = 0.0F;
};

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

    Shaped shaped(font, used, text.characters.size());
    for (std::size_t i = 0; i < text.characters.size();) {
        const std::size_t end = std::min(text.characters.find(U'\n', i), text.characters.size());
        shaped.add_piece(text, i, end);
        if (end < text.characters.size()) {
            shaped.add_break(end);
        }
        i = end + 1;
    }
    Breaker breaker(shaped.clusters(), used);
    const std::size_t count = shaped.clusters().size();
    for (std::size_t i = 0; i < count && !paragraph.shortened; ++i) {
        paragraph.shortened = !breaker.take(i);
    }
    if (paragraph.shortened) {
        shaped.add_ellipsis(text.characters.size());
        breaker.shorten(count);
    }
    for (const auto& line : breaker.finish()) {
        paragraph.lines.push_back(shaped.place(line));
    }
    for (const TextLine& line : paragraph.lines) {
        paragraph.width_px = std::max(paragraph.width_px, line.width_px);
    }
    paragraph.height_px = paragraph.metrics.line_px * static_cast<float>(paragraph.lines.size());
    return paragraph;
}

std::size_t characters_to_drop(const TextLine& line, float width_px) {
    // Clusters in the order in which they were typed.
    std::map<std::size_t, float> widths_px;
    for (const PlacedLetter& letter : line.letters) {
        widths_px[letter.shaped.first] += letter.advance_px;
    }
    float kept_px = 0.0F;
    std::size_t kept = widths_px.empty() ? 0 : kMostCodePoints;
    for (auto cluster = widths_px.rbegin(); cluster != widths_px.rend(); ++cluster) {
        kept_px += cluster->second;
        if (kept_px > width_px) {
            break;
        }
        kept = cluster->first;
    }
    return kept;
}

}  // namespace fulcrum::runtime
