// A picture in memory and its PNG file.
//
//   file = signature, IHDR, IDAT (zlib: each row filtered, then LZ77 with fixed Huffman codes),
//   IEND
//
// Thread: any; plain data. Cost: one pass over the pixels, a few nanoseconds a byte.
// Source: W3C, Portable Network Graphics Specification, second edition, 2003, sections 5, 9, 11;
// P. Deutsch, DEFLATE Compressed Data Format Specification, RFC 1951, 1996, section 3.2.6.
#pragma once

#include "haptics/base/error.h"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace fulcrum::runtime {

/// Rows from the top, 8 bits a channel, sRGB colours with straight alpha.
struct Image {
    int width = 0;                   ///< pixels
    int height = 0;                  ///< pixels
    std::vector<std::uint8_t> rgba;  ///< 4 bytes a pixel (height x width x 4)
};

/// The bytes of a PNG file that holds the picture. An error when a side is not positive or `rgba`
/// has the wrong length.
[[nodiscard]] Expected<std::vector<std::uint8_t>> encode_png(const Image& image);

/// Writes the picture to a file, replacing it. An error names the file.
[[nodiscard]] Expected<void> save_png(const std::filesystem::path& path, const Image& image);

}  // namespace fulcrum::runtime
