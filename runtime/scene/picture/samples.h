// What a decoder of pictures hands over, before colours become grey.
#pragma once

#include "haptics/base/error.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace fulcrum::runtime::picture {

struct Samples {
    std::size_t width = 0;
    std::size_t height = 0;
    int channels = 1;                 ///< 1 grey, 3 red, green and blue
    int bytes_a_channel = 1;          ///< 1 or 2; two as the machine stores a std::uint16_t
    std::vector<std::uint8_t> bytes;  ///< rows from the top
};

inline constexpr const char* kSaveAgain = "save it again as PNG or JPEG";

/// What a file that looked like a picture and is none gets.
[[nodiscard]] inline tl::unexpected<Error> damaged_picture() {
    return fail("the picture is damaged", {}, kSaveAgain);
}

/// Refuses sides of 0 or of more than kMaxGreySide_px.
[[nodiscard]] Expected<void> check_sides(std::size_t width, std::size_t height);

/// libpng's side and libjpeg-turbo's. `file` begins with the format's signature.
[[nodiscard]] Expected<Samples> decode_png(std::span<const std::uint8_t> file);
[[nodiscard]] Expected<Samples> decode_jpeg(std::span<const std::uint8_t> file);

}  // namespace fulcrum::runtime::picture
