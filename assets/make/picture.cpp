#include "assets/make/picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>

namespace fulcrum::assets {
namespace {

using Bytes = std::vector<std::uint8_t>;

double to_linear(double c) {
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

std::uint8_t to_srgb_byte(double c) {
    const double bounded = std::clamp(c, 0.0, 1.0);
    const double coded =
        bounded <= 0.0031308 ? 12.92 * bounded : 1.055 * std::pow(bounded, 1.0 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(255.0 * coded));
}

void put_big_endian(Bytes& to, std::uint32_t value) {
    for (const int shift : {24, 16, 8, 0}) {
        to.push_back(static_cast<std::uint8_t>(value >> shift & 0xFFU));
    }
}

/// CRC-32 as PNG wants it.
std::uint32_t crc32(std::span<const std::uint8_t> bytes) {
    std::uint32_t crc = ~0U;
    for (const std::uint8_t byte : bytes) {
        crc ^= byte;
        for (int bit = 0; bit < 8; ++bit) {
            crc = crc >> 1 ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
        }
    }
    return ~crc;
}

void put_chunk(Bytes& file, std::string_view type, const Bytes& data) {
    put_big_endian(file, static_cast<std::uint32_t>(data.size()));
    const std::size_t covered_from = file.size();
    file.insert(file.end(), type.begin(), type.end());
    file.insert(file.end(), data.begin(), data.end());
    put_big_endian(file, crc32(std::span(file).subspan(covered_from)));
}

/// A zlib stream of stored blocks.
Bytes zlib_stored(const Bytes& raw) {
    constexpr std::size_t kBlock = 65535;
    Bytes out{0x78, 0x01};
    for (std::size_t at = 0; at < raw.size(); at += kBlock) {
        const std::size_t n = std::min(kBlock, raw.size() - at);
        out.push_back(at + n == raw.size() ? 1 : 0);
        for (const std::size_t word : {n, ~n}) {
            out.push_back(static_cast<std::uint8_t>(word & 0xFFU));
            out.push_back(static_cast<std::uint8_t>(word >> 8 & 0xFFU));
        }
        const auto from = raw.begin() + static_cast<std::ptrdiff_t>(at);
        out.insert(out.end(), from, from + static_cast<std::ptrdiff_t>(n));
    }
    std::uint32_t a = 1;
    std::uint32_t b = 0;
    for (const std::uint8_t byte : raw) {  // Adler-32
        a = (a + byte) % 65521;
        b = (b + a) % 65521;
    }
    put_big_endian(out, b << 16 | a);
    return out;
}

}  // namespace

Colour srgb(std::uint32_t hex) {
    return {to_linear((hex >> 16 & 0xFFU) / 255.0), to_linear((hex >> 8 & 0xFFU) / 255.0),
            to_linear((hex & 0xFFU) / 255.0)};
}

Colour blend(const Colour& a, const Colour& b, double t) {
    return a + (b - a) * std::clamp(t, 0.0, 1.0);
}

Picture paint(int width, int height, const std::function<Colour(double u, double v)>& colour) {
    Picture picture{width, height, {}};
    picture.rgb.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const Colour c = colour((x + 0.5) / width, (y + 0.5) / height);
            for (int k = 0; k < 3; ++k) {
                picture.rgb.push_back(to_srgb_byte(c[k]));
            }
        }
    }
    return picture;
}

Bytes encode_png(const Picture& picture) {
    Bytes header;
    put_big_endian(header, static_cast<std::uint32_t>(picture.width));
    put_big_endian(header, static_cast<std::uint32_t>(picture.height));
    header.insert(header.end(), {8, 2, 0, 0, 0});  // 8 bits, RGB, not interlaced

    const auto row_bytes = static_cast<std::ptrdiff_t>(picture.width) * 3;
    Bytes rows;
    for (int y = 0; y < picture.height; ++y) {
        rows.push_back(0);  // no filter
        const auto row = picture.rgb.begin() + y * row_bytes;
        rows.insert(rows.end(), row, row + row_bytes);
    }

    Bytes file{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    put_chunk(file, "IHDR", header);
    put_chunk(file, "IDAT", zlib_stored(rows));
    put_chunk(file, "IEND", {});
    return file;
}

}  // namespace fulcrum::assets
