#include "runtime/render/text/font.h"

#include "runtime/render/text/faces.h"
#include "runtime/render/text/shaper.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <algorithm>
#include <cmath>
#include <cstring>
#include <unordered_map>
#include <utility>

namespace fulcrum::runtime {

namespace {

constexpr int kWhiteSide = 4;  // full pixels in the atlas' first corner, for plain shapes
constexpr int kLetterGap = 1;  // between letters, so that no neighbour shines in

std::uint64_t key_of(const ShapedLetter& letter, int size_px, int quarter) {
    return (static_cast<std::uint64_t>(letter.glyph) << 24U) |
           (static_cast<std::uint64_t>(letter.face) << 16U) |
           (static_cast<std::uint64_t>(size_px) << 4U) | static_cast<std::uint64_t>(quarter);
}

}  // namespace

struct Font::Parts {
    explicit Parts(const std::filesystem::path& folder) : faces(folder) {}

    Faces faces;
    Shaper shaper{faces};
    std::unordered_map<std::uint64_t, Glyph> glyphs;
    std::vector<std::uint8_t> atlas;
    int shelf_x = 0;
    int shelf_y = 0;
    int shelf_height = 0;
    bool full = false;
    int changed_first = 0;
    int changed_end = 0;

    [[nodiscard]] bool reserve(int width, int height, int& x, int& y);
    [[nodiscard]] Glyph draw(const ShapedLetter& letter, int size_px, int quarter);
};

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

Glyph Font::Parts::draw(const ShapedLetter& letter, int size_px, int quarter) {
    Glyph glyph;
    if (letter.glyph == 0) {
        return glyph;
    }
    FT_Face opened = faces.at(letter.face).outlines;
    FT_Set_Pixel_Sizes(opened, 0, static_cast<FT_UInt>(size_px));
    FT_GlyphSlot slot = opened->glyph;
    if (FT_Load_Glyph(opened, letter.glyph, FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP) != 0) {
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

Font::Font(const std::filesystem::path& folder) : parts_(std::make_unique<Parts>(folder)) {
    parts_->atlas.resize(static_cast<std::size_t>(kAtlasSide) * kAtlasSide);
    clear();
}

Font::~Font() = default;

const std::string& Font::notice() const {
    return parts_->faces.notice();
}

const std::vector<ShapedLetter>& Font::shape(Face style, std::u32string_view word,
                                             bool right_to_left) const {
    return parts_->shaper.shape(style, word, right_to_left);
}

LineMetrics Font::metrics(int size_px) const {
    const auto size = static_cast<float>(size_px);
    const OpenFace* regular = parts_->faces.usual();
    if (regular == nullptr) {
        return {0.8F * size, 0.2F * size, 1.25F * size};
    }
    // Andika's own line is very open; early readers' lines stay apart at 1.3 of the size.
    constexpr float kLine = 1.3F;
    const FT_Face face = regular->outlines;
    const float unit = size / regular->units_per_em;
    const float ascent = static_cast<float>(face->ascender) * unit;
    const float descent = -static_cast<float>(face->descender) * unit;
    const float shrink = std::min(1.0F, kLine * size / std::max(ascent + descent, 1.0F));
    return {ascent * shrink, descent * shrink, kLine * size};
}

Glyph Font::glyph(const ShapedLetter& letter, int size_px, int quarter) {
    const int size = std::clamp(size_px, 1, kLargestText_px);
    const std::uint64_t key = key_of(letter, size, quarter & 3);
    if (const auto known = parts_->glyphs.find(key); known != parts_->glyphs.end()) {
        return known->second;
    }
    const Glyph glyph = parts_->draw(letter, size, quarter & 3);
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
