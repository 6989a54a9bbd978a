// A teacher's photo or drawing as numbers: any PNG or JPEG, from 0 (black) to 1 (white).
//
//   value = 0.299 R + 0.587 G + 0.114 B of the stored values, 8 or 16 bits a channel; transparency is not looked at
//
// The file is not trusted: its size is checked before memory is promised, what is damaged is refused, and a file that
// takes long to decode (many passes over the same pixels) as well.
//
// Thread: any. Cost: some 10 ns a pixel, kMaxGreySide_px squared of them at most.
// Source: ITU-R, Recommendation BT.601, section 2.5.1 (luma).
#pragma once

#include "haptics/base/error.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace fulcrum::runtime {

/// Width and height of a picture that is to be felt, pixels: at 0.1 mm a pixel it is 40 cm wide.
inline constexpr std::uint32_t kMaxGreySide_px = 4096;
inline constexpr std::size_t kMaxGreyFile_bytes = std::size_t{32} << 20;

struct GreyPicture {
    std::size_t width = 0;      ///< pixels, 1 to kMaxGreySide_px
    std::size_t height = 0;     ///< pixels, 1 to kMaxGreySide_px
    std::vector<float> values;  ///< 0 to 1, rows from the top (height x width)
};

/// True for one grey all over, to half a step of 8 bits: nothing of it can be felt.
[[nodiscard]] bool is_flat(const GreyPicture& picture);

/// Decodes the bytes of a PNG or JPEG; an error's message begins with "the picture".
[[nodiscard]] Expected<GreyPicture> read_grey_picture(std::span<const std::byte> file);

/// The same from a file, which may be no link; an error names the file.
[[nodiscard]] Expected<GreyPicture> load_grey_picture(const std::filesystem::path& path);

}  // namespace fulcrum::runtime
