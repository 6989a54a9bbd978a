#include "runtime/scene/gltf/picture_header.h"

#include "runtime/scene/gltf/deflate_length.h"
#include "runtime/scene/gltf/limits.h"
#include "runtime/scene/picture/kind.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace fulcrum::runtime::gltf {
namespace {

using Span = std::span<const std::uint8_t>;

constexpr std::size_t kMaxJpegScans = 8;
/// Rows as decoded, converted to four channels, kept by the parser, and our copy; with 16 bits a
/// channel all but the copy are twice as large.
constexpr std::size_t kDecoding_bytes_per_px = 16;
constexpr std::size_t kDecoding16_bytes_per_px = 28;

tl::unexpected<Error> bad(const char* why) {
    return fail(why, {}, "save the picture again as PNG or as baseline JPEG");
}

std::uint32_t big_endian(Span bytes, std::size_t at, std::size_t n) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < n; ++i) {
        value = value << 8 | bytes[at + i];
    }
    return value;
}

Expected<PictureHeader> sized(std::uint32_t width, std::uint32_t height) {
    if (width == 0 || height == 0 || width > kMaxPictureSide_px || height > kMaxPictureSide_px) {
        return fail("the picture is " + std::to_string(width) + " x " + std::to_string(height) +
                        " pixels, 1 to 4096 a side are allowed",
                    {}, "make the picture smaller");
    }
    return PictureHeader{width, height, std::size_t{width} * height * kDecoding_bytes_per_px};
}

// ---- PNG

struct PngLayout {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::size_t bits_per_px = 0;
    bool interlaced = false;
    bool deep = false;  ///< 16 bits a channel
};

std::size_t rows_bytes(std::size_t width, std::size_t height, std::size_t bits_per_px) {
    return width == 0 ? 0 : height * (1 + (width * bits_per_px + 7) / 8);
}

/// Bytes of all filtered rows. Section 8.2: an interlaced picture is seven small ones.
std::size_t png_rows_bytes(const PngLayout& png) {
    if (!png.interlaced) {
        return rows_bytes(png.width, png.height, png.bits_per_px);
    }
    constexpr std::size_t kStart[7][2] = {{0, 0}, {4, 0}, {0, 4}, {2, 0}, {0, 2}, {1, 0}, {0, 1}};
    constexpr std::size_t kStep[7][2] = {{8, 8}, {8, 8}, {4, 8}, {4, 4}, {2, 4}, {2, 2}, {1, 2}};
    std::size_t total = 0;
    for (std::size_t pass = 0; pass < 7; ++pass) {
        const auto part = [&](std::size_t size, std::size_t axis) {
            return (size + kStep[pass][axis] - 1 - kStart[pass][axis]) / kStep[pass][axis];
        };
        total += rows_bytes(part(png.width, 0), part(png.height, 1), png.bits_per_px);
    }
    return total;
}

/// The 13 bytes of IHDR. Section 11.2.2.
bool read_ihdr(Span data, PngLayout& png) {
    constexpr std::array<std::size_t, 7> kChannels{1, 0, 3, 1, 2, 0, 4};
    const std::uint8_t depth = data[8];
    const std::uint8_t colour = data[9];
    const bool known_depth = depth == 1 || depth == 2 || depth == 4 || depth == 8 || depth == 16;
    if (!known_depth || colour > 6 || kChannels[colour] == 0 || data[10] != 0 || data[11] != 0 ||
        data[12] > 1) {
        return false;
    }
    png = {big_endian(data, 0, 4), big_endian(data, 4, 4), depth * kChannels[colour], data[12] == 1,
           depth == 16};
    return true;
}

/// The compressed rows: all IDAT chunks between IHDR and IEND, put together. False when a chunk is
/// cut off.
bool collect_idat(Span file, std::size_t at, std::vector<std::uint8_t>& idat) {
    while (file.size() - at >= 12) {
        const std::size_t length = big_endian(file, at, 4);
        const std::uint32_t type = big_endian(file, at + 4, 4);
        if (length > file.size() - at - 12) {
            return false;
        }
        if (type == 0x49454E44) {  // IEND
            return true;
        }
        if (type == 0x49444154) {  // IDAT
            const Span data = file.subspan(at + 8, length);
            idat.insert(idat.end(), data.begin(), data.end());
        }
        at += 12 + length;
    }
    return false;
}

Expected<PictureHeader> read_png(Span file) {
    constexpr std::size_t kIhdrEnd = 8 + 8 + 13 + 4;
    PngLayout png;
    if (file.size() < kIhdrEnd || big_endian(file, 8, 4) != 13 ||
        big_endian(file, 12, 4) != 0x49484452 || !read_ihdr(file.subspan(16, 13), png)) {
        return bad("the picture's PNG header is malformed");
    }
    auto header = sized(png.width, png.height);
    if (!header) {
        return header;
    }
    std::vector<std::uint8_t> idat;
    if (!collect_idat(file, kIhdrEnd, idat)) {
        return bad("the picture is cut off");
    }
    const std::size_t expected = png_rows_bytes(png);
    if (inflated_length(idat, expected) != expected) {
        return bad("the picture's data are not as long as its header says");
    }
    if (png.deep) {
        header->decoding_bytes = std::size_t{png.width} * png.height * kDecoding16_bytes_per_px;
    }
    header->decoding_bytes += idat.size();
    return header;
}

// ---- JPEG

Expected<PictureHeader> read_jpeg_frame(Span file, std::size_t at) {
    if (file.size() - at < 10) {
        return bad("the picture is cut off");
    }
    // Every scan decodes the whole picture again; in scan data the pair FF DA does not occur.
    std::size_t scans = 0;
    for (std::size_t i = at; i + 1 < file.size(); ++i) {
        scans += file[i] == 0xFF && file[i + 1] == 0xDA ? 1 : 0;
    }
    if (scans > kMaxJpegScans) {
        return bad("the picture's JPEG has more than 8 scans");
    }
    return sized(big_endian(file, at + 7, 2), big_endian(file, at + 5, 2));
}

Expected<PictureHeader> read_jpeg(Span file) {
    std::size_t at = 2;
    while (file.size() - at >= 4) {
        if (file[at] != 0xFF) {
            return bad("the picture's JPEG markers are malformed");
        }
        const std::uint8_t marker = file[at + 1];
        if (marker == 0xFF) {  // fill byte
            ++at;
            continue;
        }
        if (marker == 0xC0 || marker == 0xC1) {
            return read_jpeg_frame(file, at);
        }
        const bool other_frame = marker >= 0xC2 && marker <= 0xCF && marker != 0xC4;
        if (other_frame) {
            return bad("the picture is a progressive or unusual JPEG");
        }
        const std::size_t length = big_endian(file, at + 2, 2);
        if (marker < 0xC0 || (marker >= 0xD0 && marker <= 0xDA) || length < 2 ||
            length > file.size() - at - 2) {
            return bad("the picture's JPEG markers are malformed");
        }
        at += 2 + length;
    }
    return bad("the picture is cut off");
}

}  // namespace

Expected<PictureHeader> read_picture_header(Span file) {
    switch (picture::kind_of(file)) {
        case picture::Kind::png:
            return read_png(file);
        case picture::Kind::jpeg:
            return read_jpeg(file);
        case picture::Kind::neither:
            break;
    }
    return bad("the picture is neither PNG nor JPEG");
}

}  // namespace fulcrum::runtime::gltf
