// What a picture will cost, read from its first bytes, so that a small file cannot ask for
// gigabytes.
//
// PNG: size from IHDR, and the compressed rows are measured (deflate_length.h): they must make
// exactly the rows promised. JPEG: size from the frame header; only baseline, with few scans, since
// a progressive one can be made to decode for hours. Any other format is refused.
//
// Source: W3C, Portable Network Graphics Specification (Second Edition), 2003, sections 5, 8, 11;
// ITU-T T.81, 1992, annex B.
#pragma once

#include "haptics/base/error.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace fulcrum::runtime::gltf {

struct PictureHeader {
    std::uint32_t width = 0;         ///< pixels, 1 to kMaxPictureSide_px
    std::uint32_t height = 0;        ///< pixels, 1 to kMaxPictureSide_px
    std::size_t decoding_bytes = 0;  ///< most memory that decoding it takes, the result included
};

/// Reads and checks a PNG's or JPEG's structure; the messages begin with "the picture".
[[nodiscard]] Expected<PictureHeader> read_picture_header(std::span<const std::uint8_t> file);

}  // namespace fulcrum::runtime::gltf
