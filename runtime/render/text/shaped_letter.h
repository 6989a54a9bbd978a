// What stands for a word's characters in a font, at all sizes.
//
// Thread: any. Cost: none.
#pragma once

#include <cstdint>

namespace fulcrum::runtime {

enum class Face : std::uint8_t { regular, bold };

/// A letter of a face where its word wants it. In ems.
struct ShapedLetter {
    std::uint32_t glyph = 0;  ///< its number in the face; 0 draws nothing
    std::uint8_t face = 0;    ///< its place in the list of faces
    std::uint32_t first = 0;  ///< of the word's characters that it stands for, with others maybe
    float advance_em = 0.5F;
    float shift_em = 0.0F;  ///< to the right of the pen
    float rise_em = 0.0F;   ///< above the base line
};

}  // namespace fulcrum::runtime
