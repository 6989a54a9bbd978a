#include "runtime/render/overlay/draw_list.h"
#include "runtime/render/text/directions.h"
#include "runtime/render/text/faces.h"
#include "runtime/render/text/fallback_font.h"
#include "runtime/render/text/shaper.h"
#include "tests/unit/runtime/render/overlay/overlay_fixture.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

constexpr int kSize_px = 96;  // letters stand at whole pixels
constexpr int kInk = 96;      // of 255: more than an edge's shine

/// A line as it is drawn: its letters' pixels from the atlas, where the list of triangles has them.
struct DrawnLine {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> ink;
    [[nodiscard]] int at(int x, int y) const {
        return x < 0 || x >= width ? 0 : ink[static_cast<std::size_t>(y * width + x)];
    }
    [[nodiscard]] bool has_column(int x) const {
        for (int y = 0; y < height; ++y) {
            if (at(x, y) > kInk) {
                return true;
            }
        }
        return false;
    }
    [[nodiscard]] int first_column() const {
        int x = 0;
        while (x < width && !has_column(x)) {
            ++x;
        }
        return x;
    }
    /// Columns with ink, and how often they are interrupted.
    [[nodiscard]] int gaps() const {
        int count = 0;
        for (int x = first_column(); x + 1 < width; ++x) {
            count += has_column(x) && !has_column(x + 1) ? 1 : 0;
        }
        return count - 1;
    }
    [[nodiscard]] int first_row() const {
        for (int y = 0; y < height; ++y) {
            if (middle_of_row(y) >= 0.0) {
                return y;
            }
        }
        return height;
    }
    /// Between its leftmost and its rightmost ink; negative without any.
    [[nodiscard]] double middle_of_row(int y) const {
        int left = -1;
        int right = -1;
        for (int x = 0; x < width; ++x) {
            if (at(x, y) > kInk) {
                left = left < 0 ? x : left;
                right = x;
            }
        }
        return left < 0 ? -1.0 : 0.5 * (left + right);
    }
    /// The other picture's ink, moved right by so much, is all in this one.
    [[nodiscard]] bool holds(const DrawnLine& other, int right) const {
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < other.width; ++x) {
                if (other.at(x, y) > kInk && at(x + right, y) < kInk / 2) {
                    return false;
                }
            }
        }
        return true;
    }
};

DrawnLine draw(const std::string& words) {
    Font font = andika();
    DrawList list(font);
    const Paragraph paragraph = set_text(font, plain_text(words), {kSize_px});
    list.text(paragraph, 8.0F, 0.0F, 0.0F, 0.0F, {}, {});
    DrawnLine line;
    line.width = static_cast<int>(paragraph.width_px) + 16;
    line.height = 2 * kSize_px;
    line.ink.assign(static_cast<std::size_t>(line.width * line.height), 0);
    const auto& corners = list.corners();
    for (std::size_t i = 0; i + 5 < corners.size(); i += 6) {
        // Upper left and lower right.
        const OverlayCorner& a = corners[i];
        const OverlayCorner& b = corners[i + 2];
        for (int y = 0; y < static_cast<int>(b.y - a.y); ++y) {
            for (int x = 0; x < static_cast<int>(b.x - a.x); ++x) {
                const int to_x = static_cast<int>(a.x) + x;
                const int to_y = static_cast<int>(a.y) + y;
                if (to_x < 0 || to_x >= line.width || to_y < 0 || to_y >= line.height) {
                    continue;
                }
                const auto from = static_cast<std::size_t>(
                    (static_cast<int>(std::lround(a.v * kAtlasSide)) + y) * kAtlasSide +
                    static_cast<int>(std::lround(a.u * kAtlasSide)) + x);
                auto& pixel = line.ink[static_cast<std::size_t>(to_y * line.width + to_x)];
                pixel = std::max(pixel, font.atlas()[from]);
            }
        }
    }
    return line;
}

float width_px(const std::string& words) {
    const Font font = andika();
    return set_text(font, plain_text(words), {kSize_px}).width_px;
}

/// The characters that the letters stand for, from left to right.
std::u32string from_left(const std::string& words) {
    const Font font = andika();
    const Paragraph paragraph = set_text(font, plain_text(words), {kSize_px});
    std::u32string shown;
    for (const PlacedLetter& letter : paragraph.lines.front().letters) {
        shown.push_back(letter.character);
    }
    return shown;
}

bool has_font(std::u32string_view characters, const char* package) {
    if (find_font_with(characters, false)) {
        return true;
    }
    WARN("skipped: no font has these letters; the package " << package << " is missing");
    return false;
}

}  // namespace

TEST_CASE("shaped text: Arabic letters join, and the first stands on the right") {
    if (!has_font(U"بيت", "fonts-dejavu-core")) {
        return;
    }
    // Three that all join their neighbours; between them ZWNJ, which keeps each by itself.
    const DrawnLine joined = draw("بيت");
    const DrawnLine apart = draw("ب\u200Cي\u200Cت");
    CHECK(joined.gaps() == 0);
    CHECK(apart.gaps() == 2);
    CHECK(width_px("بيت") < 0.8F * (width_px("ب") + width_px("ي") + width_px("ت")));
    CHECK(from_left("بيت") == U"تيب");
    // Lam and alef are one sign.
    CHECK(from_left("لا").size() == 1);
    // An alef joins nothing behind it.
    CHECK(draw("اب").gaps() == 1);
}

TEST_CASE(
    "shaped text: a Devanagari sign that is said last may stand first, and two letters be one") {
    if (!has_font(U"कि", "fonts-lohit-deva")) {
        return;
    }
    // The picture of ka is in that of ki, with the sign of i on its left; in that of kii on its right.
    const DrawnLine ka = draw("क");
    const DrawnLine ki = draw("कि");
    const DrawnLine kii = draw("की");
    const int moved = static_cast<int>(std::lround(width_px("कि") - width_px("क")));
    REQUIRE(moved > kSize_px / 10);
    const auto holds_near = [&](const DrawnLine& whole, int right) {
        return whole.holds(ka, right) || whole.holds(ka, right - 1) || whole.holds(ka, right + 1);
    };
    CHECK(holds_near(ki, moved));
    CHECK_FALSE(holds_near(ki, 0));
    CHECK(holds_near(kii, 0));
    // ka, the sign that takes its vowel, and ssa are one letter; ZWNJ keeps them two.
    CHECK(width_px("क्ष") < 0.75F * width_px("क्\u200Cष"));
    // The sign of e has no room of its own: it stands above its letter.
    CHECK(width_px("के") == Approx(width_px("क")));
    CHECK(draw("के").gaps() == 0);
}

TEST_CASE("shaped text: a syllable of Hangul is one sign, however it is written") {
    if (!has_font(U"한", "fonts-nanum")) {
        return;
    }
    const DrawnLine syllable = draw("한국어");
    CHECK(draw("\u1112\u1161\u11ABᄀ\u116E\u11A8어").ink == syllable.ink);
    CHECK(from_left("한국어") == U"한국어");
    CHECK(syllable.ink != draw("\uFFFD\uFFFD\uFFFD").ink);
    CHECK(draw("한").ink != draw("국").ink);
    CHECK(width_px("한국어") == Approx(3.0F * width_px("한")));
}

TEST_CASE(
    "shaped text: Hebrew runs from the right in English, and digits and brackets keep their own "
    "way") {
    CHECK(from_left("abc שלום 12.") == U"abc 12 םולש.");
    CHECK(from_left("שלום abc 123") == U"abc 123 םולש");
    // The number belongs to the name before it, so it stands on its left.
    CHECK(from_left("I am \u05E8\u05D5\u05EA (9).") == U"I am )9( \u05EA\u05D5\u05E8.");
    CHECK(from_left("רות (דן)") == U")ןד( תור");
    // A bracket that opens on the right is drawn as one that closes: its picture is turned round.
    const DrawnLine turned = draw("א(");
    CHECK(turned.holds(draw(")"), 0));
    // What was typed last is where the caret goes.
    const Font font = andika();
    const Paragraph typed = set_text(font, plain_text("Hi רות"), {kSize_px});
    CHECK(typed.lines.front().ends_left);
    CHECK(typed.lines.front().end_px == Approx(width_px("Hi ר") - width_px("ר")).margin(0.01));
    CHECK(set_text(font, plain_text("רות Hi"), {kSize_px}).lines.front().end_px ==
          Approx(width_px("Hi")).margin(0.01));
}

TEST_CASE("shaped text: Latin letters stay one by one, and their marks with them") {
    CHECK(from_left("fit offer flow") == U"fit offer flow");
    CHECK(width_px("fi") == Approx(width_px("f") + width_px("i")));
    // Composed or not, it is the same letter.
    CHECK(draw("e\u0301").ink == draw("\u00E9").ink);
    CHECK(width_px("x\u0323") == Approx(width_px("x")));
    // A mark stands in the middle above its letter, wide or narrow, and higher above a high one.
    constexpr double kPixel = 2.0;  // each letter is drawn at a whole one
    const auto top_middle = [](const DrawnLine& line) {
        return line.middle_of_row(line.first_row());
    };
    const DrawnLine bar = draw("|");
    const double from_left_px = top_middle(bar) - 0.5 * static_cast<double>(width_px("|"));
    for (const std::string base : {"m", "v"}) {
        CHECK(top_middle(draw(base + "\u0304")) - 0.5 * static_cast<double>(width_px(base)) ==
              Approx(from_left_px).margin(kPixel));
    }
    CHECK(draw("M\u0304").first_row() < draw("m\u0304").first_row() - kSize_px / 10);
}

TEST_CASE("shaped text: lines end between ideographs, at spaces in Korean, never in a cluster") {
    const Font font = andika();
    const auto lines_of = [&](const std::string& text, float width) {
        std::vector<std::u32string> lines;
        for (const TextLine& line :
             set_text(font, plain_text(text), {kSize_px, Face::regular, width}).lines) {
            std::u32string words;
            for (const PlacedLetter& letter : line.letters) {
                words.push_back(letter.character);
            }
            lines.push_back(words);
            CHECK(line.width_px <= width + 0.01F);
        }
        return lines;
    };
    if (has_font(U"日本語。한국어", "fonts-nanum")) {
        // A stop does not begin a line; a bracket does not end one.
        const float three = width_px("日本語") + 1.0F;
        CHECK(lines_of("日本語。日", three) == std::vector<std::u32string>{U"日本", U"語。日"});
        CHECK(lines_of("日本「語", three) == std::vector<std::u32string>{U"日本", U"「語"});
        CHECK(lines_of("가나 다라마", width_px("가나 다") + 1.0F) ==
              std::vector<std::u32string>{U"가나", U"다라마"});
    }
    // A word wider than its line is broken behind a base's last mark.
    std::string marked;
    for (int i = 0; i < 12; ++i) {
        marked += "x\u0323\u0302";
    }
    std::size_t shown = 0;
    for (const std::u32string& line : lines_of(marked, width_px("xxxxx") + 1.0F)) {
        CHECK(line.size() % 3 == 0);
        shown += line.size();
    }
    CHECK(shown == 36);
}

TEST_CASE("shaped text: what was typed last stays in sight, whichever way it runs") {
    const Font font = andika();
    const auto kept = [&](const std::string& text, float width) {
        const MarkedText typed = plain_text(text);
        const std::size_t dropped =
            characters_to_drop(set_text(font, typed, {kSize_px}).lines.front(), width);
        return typed.characters.substr(std::min(dropped, typed.characters.size()));
    };
    CHECK(kept("abcdef", 1e9F) == U"abcdef");
    CHECK(kept("abcdef", width_px("def") + 0.5F) == U"def");
    CHECK(kept("abcdef", 0.0F).empty());
    CHECK(kept("אבגדה", width_px("גדה") + 0.5F) == U"גדה");
    CHECK(kept("ax\u0323b", width_px("b") + 0.5F * width_px("x")) == U"b");
}

TEST_CASE(
    "fallback: fontconfig is asked for what the fonts lack, and what none has is the sign for it") {
    CHECK_FALSE(find_font_with(U"\U0010FFFF", false));
    const Font font = andika();
    const auto shape = [&](std::u32string_view word) {
        return std::vector<ShapedLetter>(font.shape(Face::regular, word, false));
    };
    const auto missing = shape(U"\U0010FFFF");
    REQUIRE(missing.size() == 1);
    CHECK(missing[0].glyph == shape(U"\uFFFD")[0].glyph);
    CHECK(missing[0].advance_em == shape(U"\uFFFD")[0].advance_em);
    if (has_font(U"한", "fonts-nanum")) {
        CHECK(shape(U"한")[0].glyph != missing[0].glyph);
        // Found once, it serves all letters of the script.
        CHECK(shape(U"국")[0].face == shape(U"한")[0].face);
        CHECK(shape(U"한")[0].face != shape(U"a")[0].face);
    }
}

TEST_CASE("directions: levels are those of the standard, and deeper ones are turned round first") {
    const Directions plain = find_directions(U"one, two");
    CHECK(plain.base == 0);
    CHECK(plain.levels == std::vector<std::uint8_t>(8, 0));
    const Directions mixed = find_directions(U"אב 12");
    CHECK(mixed.base == 1);
    CHECK(mixed.levels == std::vector<std::uint8_t>{1, 1, 1, 2, 2});
    CHECK(order_in_line(mixed.levels) == std::vector<std::size_t>{3, 4, 2, 1, 0});
    CHECK(order_in_line({0, 1, 1, 0}) == std::vector<std::size_t>{0, 2, 1, 3});
    CHECK(order_in_line({}).empty());
}
