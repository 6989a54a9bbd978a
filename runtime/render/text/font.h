// Words shaped into letters, and letters as small pictures in one atlas, at the sizes asked for.
//
//   Which letters of the font stand for a word's characters, and where, is the script's own rule
//   (shaper.h). Each letter is drawn once for each face, size and quarter of a pixel it may stand at;
//   the pen moves by the font's own unhinted advances, so that words keep their shape at every size.
//
// Thread: one. Cost: a letter's first use at a size takes about 50 us, later uses a hash look-up;
// the atlas is kAtlasSide squared bytes.
// Source: FreeType 2.12 reference, "Glyph Retrieval", "Outline Processing".
#pragma once

#include "runtime/render/text/shaped_letter.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fulcrum::runtime {

/// A letter in the atlas. All in pixels.
struct Glyph {
    int x = 0;      ///< left column in the atlas
    int y = 0;      ///< top row in the atlas
    int width = 0;  ///< 0 for a letter that draws nothing
    int height = 0;
    int left = 0;  ///< from the pen to the left column
    int top = 0;   ///< from the base line up to the top row
};

/// The line measures of a size, in pixels.
struct LineMetrics {
    float ascent_px = 0.0F;
    float descent_px = 0.0F;  ///< below the base line, positive
    float line_px = 0.0F;     ///< from one base line to the next
};

inline constexpr int kAtlasSide = 2048;
inline constexpr int kLargestText_px = 256;

/// The faces, and the atlas of letters drawn so far.
class Font {
  public:
    /// Opens Andika in a folder; where it is missing, DejaVu Sans; where that is missing too, words
    /// have width but are not drawn. Never fails: `notice` says what was missing.
    explicit Font(const std::filesystem::path& folder);
    Font(const Font&) = delete;
    Font& operator=(const Font&) = delete;
    ~Font();

    /// One sentence, empty when all is as wished.
    [[nodiscard]] const std::string& notice() const;

    /// The letters of a word in one direction, from left to right. A character that no font on this
    /// machine has counts as U+FFFD. Holds until the next call.
    [[nodiscard]] const std::vector<ShapedLetter>& shape(Face style, std::u32string_view word,
                                                         bool right_to_left) const;
    [[nodiscard]] LineMetrics metrics(int size_px) const;

    /// The letter with its pen at `quarter`/4 of a pixel, drawn into the atlas when it is new. A
    /// letter that no longer fits has no width, and `is_full` says so.
    [[nodiscard]] Glyph glyph(const ShapedLetter& letter, int size_px, int quarter);

    [[nodiscard]] bool is_full() const;
    /// Forgets all letters; those drawn later take their places.
    void clear();

    /// kAtlasSide x kAtlasSide bytes of coverage, rows from the top; the first pixels are full.
    [[nodiscard]] const std::vector<std::uint8_t>& atlas() const;
    /// Rows that changed since the last call: first and one past the last; equal when none did.
    [[nodiscard]] std::pair<int, int> take_changed_rows();

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace fulcrum::runtime
