// The faces that letters are taken from: the wished one, a spare, and what is found for characters
// that both lack.
//
// Thread: one. Cost: a character's first use asks each face, and where none has it fontconfig
// (fallback_font.h); later a look-up.
#pragma once

#include "runtime/render/text/shaped_letter.h"

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

// FreeType's and HarfBuzz's own; whoever asks them includes their headers.
struct FT_LibraryRec_;
struct FT_FaceRec_;
struct hb_font_t;

namespace fulcrum::runtime {

/// One face of one file, for what draws outlines and for what shapes.
struct OpenFace {
    FT_FaceRec_* outlines = nullptr;
    hb_font_t* shaper = nullptr;  ///< in the face's own units
    float units_per_em = 1.0F;
};

class Faces {
  public:
    explicit Faces(const std::filesystem::path& folder);
    Faces(const Faces&) = delete;
    Faces& operator=(const Faces&) = delete;
    ~Faces();

    /// As Font::notice.
    [[nodiscard]] const std::string& notice() const { return notice_; }
    /// The wished regular face, or what stands for it; nothing where there is none.
    [[nodiscard]] const OpenFace* usual() const;

    /// The first face that has all of a letter's characters (a base and its marks), else the first
    /// that has its base; kNoFace where none has that.
    [[nodiscard]] std::size_t face_of(Face style, std::u32string_view letter);
    [[nodiscard]] const OpenFace& at(std::size_t face) const { return all_[face]; }

    static constexpr std::size_t kNoFace = 255;

  private:
    bool open(Face style, const std::string& file, int index);
    [[nodiscard]] std::size_t first_with(Face style, std::u32string_view characters);
    [[nodiscard]] std::vector<std::size_t>& list(Face style);

    FT_LibraryRec_* library_ = nullptr;
    std::vector<OpenFace> all_;
    std::array<std::vector<std::size_t>, 2> by_style_;
    std::array<std::unordered_map<std::u32string, std::size_t>, 2> known_;
    std::string notice_;
    int asked_in_vain_ = 0;
};

/// Characters that draw nothing of their own but shape their neighbours (ZWNJ, ZWJ).
[[nodiscard]] constexpr bool is_joiner(char32_t c) {
    return c == 0x200C || c == 0x200D;
}

}  // namespace fulcrum::runtime
