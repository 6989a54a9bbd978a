#include "runtime/render/text/font.h"

#include "dialogue/unicode.h"
#include "runtime/text/utf8.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <unordered_map>
#include <utility>

namespace fulcrum::runtime {

namespace {

constexpr int kWhiteSide = 4;  // full pixels in the atlas' first corner, for plain shapes
constexpr int kLetterGap = 1;  // between letters, so that no neighbour shines in
constexpr std::size_t kFaceCount = 2;
constexpr const char* kSpareFolder = "/usr/share/fonts/truetype/dejavu";

/// Where a character is found: which face of the list, which glyph in it.
struct Found {
    std::size_t face = 0;
    FT_UInt glyph = 0;
    float advance_em = 0.5F;
};

std::uint64_t key_of(Face face, int size_px, char32_t character, int quarter) {
    return (static_cast<std::uint64_t>(character) << 16U) |
           (static_cast<std::uint64_t>(size_px) << 4U) |
           (static_cast<std::uint64_t>(quarter) << 1U) | static_cast<std::uint64_t>(face);
}

}  // namespace

struct Font::Parts {
    FT_Library library = nullptr;
    // For each style the wished face, then the spare one; either may be missing.
    std::array<std::vector<FT_Face>, kFaceCount> faces;
    std::string notice;
    mutable std::unordered_map<std::uint64_t, Found> found;
    std::unordered_map<std::uint64_t, Glyph> glyphs;
    std::vector<std::uint8_t> atlas;
    int shelf_x = 0;
    int shelf_y = 0;
    int shelf_height = 0;
    bool full = false;
    int changed_first = 0;
    int changed_end = 0;

    ~Parts() {
        for (auto& list : faces) {
            for (FT_Face face : list) {
                FT_Done_Face(face);
            }
        }
        if (library != nullptr) {
            FT_Done_FreeType(library);
        }
    }

    bool open(Face style, const std::filesystem::path& file) {
        FT_Face opened = nullptr;
        if (FT_New_Face(library, file.c_str(), 0, &opened) != 0) {
            return false;
        }
        if (!FT_IS_SCALABLE(opened) || FT_Select_Charmap(opened, FT_ENCODING_UNICODE) != 0) {
            FT_Done_Face(opened);
            return false;
        }
        faces[static_cast<std::size_t>(style)].push_back(opened);
        return true;
    }

    [[nodiscard]] Found look_up(Face style, char32_t character) const;
    [[nodiscard]] const std::vector<FT_Face>& list(Face style) const {
        const auto& bold = faces[static_cast<std::size_t>(Face::bold)];
        return style == Face::bold && !bold.empty()
                   ? bold
                   : faces[static_cast<std::size_t>(Face::regular)];
    }
    [[nodiscard]] bool reserve(int width, int height, int& x, int& y);
    [[nodiscard]] Glyph draw(Face style, int size_px, char32_t character, int quarter);
};

Found Font::Parts::look_up(Face style, char32_t character) const {
    const std::uint64_t key = key_of(style, 0, character, 0);
    if (const auto known = found.find(key); known != found.end()) {
        return known->second;
    }
    // The first face that has the character, else a sign for a missing one.
    Found result;
    const auto& candidates = list(style);
    for (const char32_t wanted : {character, dialogue::kReplacement, U'?'}) {
        for (std::size_t i = 0; i < candidates.size() && result.glyph == 0; ++i) {
            result.glyph = FT_Get_Char_Index(candidates[i], wanted);
            result.face = i;
        }
        if (result.glyph != 0) {
            break;
        }
    }
    if (result.glyph != 0) {
        FT_Face face = candidates[result.face];
        if (FT_Load_Glyph(face, result.glyph, FT_LOAD_NO_SCALE) == 0 && face->units_per_EM > 0) {
            result.advance_em = static_cast<float>(face->glyph->metrics.horiAdvance) /
                                static_cast<float>(face->units_per_EM);
        }
    }
    found[key] = result;
    return result;
}

/// Letters stand on shelves, left to right, shelves from top to bottom.
bool Font::Parts::reserve(int width, int height, int& x, int& y) {
    if (shelf_x + width + kLetterGap > kAtlasSide) {
        shelf_y += shelf_height;
        shelf_x = 0;
        shelf_height = 0;
    }
    if (width + kLetterGap > kAtlasSide || shelf_y + height + kLetterGap > kAtlasSide) {
        return false;
    }
    x = shelf_x;
    y = shelf_y;
    shelf_x += width + kLetterGap;
    shelf_height = std::max(shelf_height, height + kLetterGap);
    return true;
}

Glyph Font::Parts::draw(Face style, int size_px, char32_t character, int quarter) {
    Glyph glyph;
    const Found place = look_up(style, character);
    if (place.glyph == 0) {
        return glyph;
    }
    FT_Face opened = list(style)[place.face];
    FT_Set_Pixel_Sizes(opened, 0, static_cast<FT_UInt>(size_px));
    FT_GlyphSlot slot = opened->glyph;
    if (FT_Load_Glyph(opened, place.glyph, FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP) != 0) {
        return glyph;
    }
    FT_Outline_Translate(&slot->outline, FT_Pos{16} * quarter, 0);  // 26.6 fixed point: 64 a pixel
    if (FT_Render_Glyph(slot, FT_RENDER_MODE_NORMAL) != 0) {
        return glyph;
    }
    const FT_Bitmap& bitmap = slot->bitmap;
    const int width = static_cast<int>(bitmap.width);
    const int height = static_cast<int>(bitmap.rows);
    if (width == 0 || height == 0) {
        return glyph;
    }
    if (!reserve(width, height, glyph.x, glyph.y)) {
        full = true;
        return glyph;
    }
    for (int row = 0; row < height; ++row) {
        std::memcpy(atlas.data() + static_cast<std::size_t>(glyph.y + row) * kAtlasSide +
                        static_cast<std::size_t>(glyph.x),
                    bitmap.buffer + static_cast<long>(row) * bitmap.pitch,
                    static_cast<std::size_t>(width));
    }
    changed_first = changed_first == changed_end ? glyph.y : std::min(changed_first, glyph.y);
    changed_end = std::max(changed_end, glyph.y + height);
    glyph.width = width;
    glyph.height = height;
    glyph.left = slot->bitmap_left;
    glyph.top = slot->bitmap_top;
    return glyph;
}

Font::Font(const std::filesystem::path& folder) : parts_(std::make_unique<Parts>()) {
    parts_->atlas.resize(static_cast<std::size_t>(kAtlasSide) * kAtlasSide);
    clear();
    if (FT_Init_FreeType(&parts_->library) != 0) {
        parts_->library = nullptr;
        parts_->notice =
            "the library that draws letters did not start; install libfreetype6 again.";
        return;
    }
    const bool regular = parts_->open(Face::regular, folder / "Andika-Regular.ttf");
    parts_->open(Face::bold, folder / "Andika-Bold.ttf");
    const std::filesystem::path spare(kSpareFolder);
    const bool spare_regular = parts_->open(Face::regular, spare / "DejaVuSans.ttf");
    parts_->open(Face::bold, spare / "DejaVuSans-Bold.ttf");
    if (!regular) {
        parts_->notice = folder.string() + ": the font Andika is not there, so " +
                         (spare_regular ? "DejaVu Sans is used" : "no words can be drawn") +
                         "; install the package fonts-sil-andika.";
    }
}

Font::~Font() = default;

const std::string& Font::notice() const {
    return parts_->notice;
}

float Font::advance_px(Face face, int size_px, char32_t character) const {
    return parts_->look_up(face, character).advance_em * static_cast<float>(size_px);
}

float Font::kerning_px(Face face, int size_px, char32_t left, char32_t right) const {
    const Found first = parts_->look_up(face, left);
    const Found second = parts_->look_up(face, right);
    if (first.glyph == 0 || second.glyph == 0 || first.face != second.face) {
        return 0.0F;
    }
    FT_Face opened = parts_->list(face)[first.face];
    FT_Vector units{};
    if (!FT_HAS_KERNING(opened) || opened->units_per_EM == 0 ||
        FT_Get_Kerning(opened, first.glyph, second.glyph, FT_KERNING_UNSCALED, &units) != 0) {
        return 0.0F;
    }
    return static_cast<float>(units.x) * static_cast<float>(size_px) /
           static_cast<float>(opened->units_per_EM);
}

LineMetrics Font::metrics(int size_px) const {
    const auto size = static_cast<float>(size_px);
    const auto& regular = parts_->list(Face::regular);
    if (regular.empty() || regular.front()->units_per_EM == 0) {
        return {0.8F * size, 0.2F * size, 1.25F * size};
    }
    // Andika's own line is very open; early readers' lines stay apart at 1.3 of the size.
    constexpr float kLine = 1.3F;
    const FT_Face face = regular.front();
    const float unit = size / static_cast<float>(face->units_per_EM);
    const float ascent = static_cast<float>(face->ascender) * unit;
    const float descent = -static_cast<float>(face->descender) * unit;
    const float shrink = std::min(1.0F, kLine * size / std::max(ascent + descent, 1.0F));
    return {ascent * shrink, descent * shrink, kLine * size};
}

Glyph Font::glyph(Face face, int size_px, char32_t character, int quarter) {
    const int size = std::clamp(size_px, 1, kLargestText_px);
    const std::uint64_t key = key_of(face, size, character, quarter & 3);
    if (const auto known = parts_->glyphs.find(key); known != parts_->glyphs.end()) {
        return known->second;
    }
    const Glyph glyph = parts_->draw(face, size, character, quarter & 3);
    if (!parts_->full) {
        parts_->glyphs[key] = glyph;
    }
    return glyph;
}

bool Font::is_full() const {
    return parts_->full;
}

void Font::clear() {
    parts_->glyphs.clear();
    std::fill(parts_->atlas.begin(), parts_->atlas.end(), std::uint8_t{0});
    for (int row = 0; row < kWhiteSide; ++row) {
        std::memset(parts_->atlas.data() + static_cast<std::size_t>(row) * kAtlasSide, 255,
                    kWhiteSide);
    }
    parts_->shelf_x = kWhiteSide + kLetterGap;
    parts_->shelf_y = 0;
    parts_->shelf_height = kWhiteSide + kLetterGap;
    parts_->full = false;
    parts_->changed_first = 0;
    parts_->changed_end = kAtlasSide;
}

const std::vector<std::uint8_t>& Font::atlas() const {
    return parts_->atlas;
}

std::pair<int, int> Font::take_changed_rows() {
    const std::pair<int, int> rows{parts_->changed_first, parts_->changed_end};
    parts_->changed_first = 0;
    parts_->changed_end = 0;
    return rows;
}

}  // namespace fulcrum::runtime
