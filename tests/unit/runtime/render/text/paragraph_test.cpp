#include "runtime/render/text/paragraph.h"

#include "runtime/render/renderer.h"
#include "tests/unit/runtime/rig.h"

#include <random>

using namespace fulcrum::runtime::test;

namespace {

constexpr float kRounding_px = 0.01F;

Font andika() {
    return Font(RendererSettings{}.font_folder);
}

Glyph glyph_of(Font& font, Face face, int size_px, char32_t character) {
    const ShapedLetter letter = font.shape(face, std::u32string_view(&character, 1), false).at(0);
    return font.glyph(letter, size_px, 0);
}

std::u32string words_of(const TextLine& line) {
    std::u32string words;
    for (const PlacedLetter& letter : line.letters) {
        words.push_back(letter.character);
    }
    return words;
}

}  // namespace

TEST_CASE("paragraph: words are set as wide as they are, all of them, within the width") {
    const Font font = andika();
    SECTION("text grows wider with each letter and each size") {
        const std::string whole = "The quick brown f\xC3\xB6x: \xC5\xBE\xC3\xA9\xC3\xB1!";
        float before = -1.0F;
        for (std::size_t length = 0; length <= 14; ++length) {
            const Paragraph p = set_text(font, plain_text(whole.substr(0, length)), {32});
            // A space at the end of a line has no width until a letter follows.
            CHECK((p.width_px > before || whole[length - 1] == ' '));
            before = p.width_px;
        }
        float smaller = 0.0F;
        for (const int size : {12, 24, 48, 96}) {
            const Paragraph p = set_text(font, plain_text(whole), {size});
            CHECK(p.width_px == Approx(2.0F * smaller).margin(size == 12 ? 1e9 : 0.01));
            smaller = p.width_px;
        }
    }
    SECTION("bold words are wider than plain ones") {
        CHECK(set_text(font, plain_text("heaviest"), {32, Face::bold}).width_px >
              set_text(font, plain_text("heaviest"), {32}).width_px);
        CHECK(set_text(font, read_emphasis("*heaviest*"), {32}).width_px ==
              Approx(set_text(font, plain_text("heaviest"), {32, Face::bold}).width_px));
    }
    SECTION("wrapping keeps all words, in order, within the width") {
        const std::string text =
            "Weigh the apple, then the watermelon. Move the bucket under each of them and wait.";
        for (const float width : {120.0F, 250.0F, 400.0F, 2000.0F}) {
            const Paragraph p = set_text(font, plain_text(text), {28, Face::regular, width});
            std::u32string joined;
            for (const TextLine& line : p.lines) {
                CHECK(line.width_px <= width + kRounding_px);
                const std::u32string words = words_of(line);
                REQUIRE_FALSE(words.empty());
                CHECK(words.front() != U' ');
                CHECK(words.back() != U' ');
                joined += (joined.empty() ? U"" : U" ") + words;
            }
            // A word wider than the line is broken, which adds spaces to the joined text; none here is.
            if (width > 200.0F) {
                CHECK(joined == plain_text(text).characters);
            }
            CHECK(p.height_px == Approx(p.metrics.line_px * static_cast<float>(p.lines.size())));
            CHECK_FALSE(p.shortened);
        }
    }
    SECTION("a word without end is broken, a line break always breaks") {
        const Paragraph broken =
            set_text(font, plain_text(std::string(200, 'w')), {28, Face::regular, 300.0F});
        CHECK(broken.lines.size() > 5);
        for (const TextLine& line : broken.lines) {
            CHECK(line.width_px <= 300.0F);
        }
        CHECK(set_text(font, plain_text("a\n\nb"), {28}).lines.size() == 3);
    }
    SECTION("what does not fit ends in an ellipsis") {
        const Paragraph p =
            set_text(font, plain_text(std::string(40, 'm') + " and more words that never end"),
                     {28, Face::regular, 300.0F, 2});
        REQUIRE(p.lines.size() == 2);
        CHECK(p.shortened);
        CHECK(p.lines.back().letters.back().character == 0x2026);
        CHECK(p.lines.back().width_px <= 300.0F + kRounding_px);
    }
    SECTION("hostile text and widths are set without harm") {
        std::mt19937 random(11);
        for (int i = 0; i < 200; ++i) {
            std::string bytes(random() % 200, '\0');
            for (char& byte : bytes) {
                byte = static_cast<char>(random());
            }
            const float width = static_cast<float>(random() % 400) - 50.0F;
            const Paragraph p = set_text(font, read_emphasis(bytes),
                                         {static_cast<int>(random() % 600) - 100, Face::bold, width,
                                          static_cast<int>(random() % 5) - 1});
            CHECK(p.lines.size() <= 5000);
            CHECK(std::isfinite(p.width_px));
        }
        CHECK(set_text(font, plain_text(""), {24}).lines.size() == 1);
    }
}

TEST_CASE("emphasis: words between asterisks are marked and the asterisks gone") {
    const MarkedText text = read_emphasis("A melon is *the heaviest*.");
    CHECK(text.characters == U"A melon is the heaviest.");
    for (std::size_t i = 0; i < text.characters.size(); ++i) {
        CHECK(text.emphasised[i] == (i >= 11 && i < 23));
    }
}

TEST_CASE("emphasis: a lonely asterisk stays") {
    CHECK(read_emphasis("2 * 3").characters == U"2 * 3");
    CHECK(read_emphasis("*a* b * c").characters == U"a b * c");
    CHECK(read_emphasis("*").characters == U"*");
    CHECK(read_emphasis("**").characters.empty());
    CHECK(plain_text("*a*").characters == U"*a*");
}

TEST_CASE("font: a missing folder is one sentence, and letters keep a width") {
    const Font font(std::filesystem::path("/no/such/fonts"));
    CHECK(font.notice().find("/no/such/fonts") == 0);
    CHECK(font.notice().find("fonts-sil-andika") != std::string::npos);
    CHECK(font.notice().back() == '.');
    CHECK(set_text(font, plain_text("words"), {24}).width_px > 0.0F);
}

TEST_CASE("font: letters are drawn once and lie in the atlas") {
    Font font = andika();
    (void)font.take_changed_rows();
    const Glyph first = glyph_of(font, Face::regular, 40, U'g');
    if (first.width == 0) {
        WARN("no font is installed, so no letter can be looked at");
        return;
    }
    CHECK(first.x + first.width <= kAtlasSide);
    const auto changed = font.take_changed_rows();
    CHECK(changed.first <= first.y);
    CHECK(changed.second >= first.y + first.height);
    const Glyph again = glyph_of(font, Face::regular, 40, U'g');
    CHECK(again.x == first.x);
    CHECK(again.y == first.y);
    CHECK(font.take_changed_rows() == std::pair{0, 0});
    // Some pixel of it is full, and its surroundings are empty.
    int fullest = 0;
    for (int y = 0; y < first.height; ++y) {
        for (int x = 0; x < first.width; ++x) {
            fullest = std::max<int>(
                fullest,
                font.atlas()[static_cast<std::size_t>((first.y + y) * kAtlasSide + first.x + x)]);
        }
    }
    CHECK(fullest > 200);
}

TEST_CASE("font: a full atlas says so and starts again") {
    Font font = andika();
    for (char32_t c = 0x21; c < 0x3000 && !font.is_full(); ++c) {
        (void)glyph_of(font, Face::bold, kLargestText_px, c);
    }
    if (glyph_of(font, Face::bold, 20, U'a').width == 0 && !font.is_full()) {
        WARN("no font is installed, so the atlas cannot be filled");
        return;
    }
    REQUIRE(font.is_full());
    font.clear();
    CHECK_FALSE(font.is_full());
    CHECK(glyph_of(font, Face::bold, 30, U'a').width > 0);
    CHECK(font.atlas()[0] == 255);
}
