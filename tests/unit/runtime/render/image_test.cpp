#include "runtime/render/image.h"

#include <catch2/catch.hpp>

#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

using namespace fulcrum;
using namespace fulcrum::runtime;

namespace {

using Bytes = std::vector<std::uint8_t>;

/// Reads DEFLATE with fixed codes, straight from RFC 1951, apart from the writer under test.
class Inflater {
  public:
    explicit Inflater(const Bytes& data) : data_(data) {}

    Bytes read() {
        Bytes out;
        REQUIRE(bits(1) == 1);
        REQUIRE(bits(2) == 1);
        for (unsigned symbol = next_symbol(); symbol != 256; symbol = next_symbol()) {
            if (symbol < 256) {
                out.push_back(static_cast<std::uint8_t>(symbol));
                continue;
            }
            const std::size_t length = length_of(symbol);
            const std::size_t distance = distance_of(code(5));
            REQUIRE(distance <= out.size());
            for (std::size_t i = 0; i < length; ++i) {
                out.push_back(out[out.size() - distance]);
            }
        }
        return out;
    }

  private:
    unsigned bit() {
        REQUIRE(place_ / 8 < data_.size());
        const unsigned value = (data_[place_ / 8] >> (place_ % 8)) & 1U;
        ++place_;
        return value;
    }
    unsigned bits(unsigned count) {
        unsigned value = 0;
        for (unsigned i = 0; i < count; ++i) {
            value |= bit() << i;
        }
        return value;
    }
    unsigned code(unsigned count) {
        unsigned value = 0;
        for (unsigned i = 0; i < count; ++i) {
            value = (value << 1U) | bit();
        }
        return value;
    }
    unsigned next_symbol() {
        unsigned value = code(7);
        if (value < 24) {
            return 256 + value;
        }
        value = (value << 1U) | bit();
        if (value >= 48 && value < 192) {
            return value - 48;
        }
        if (value >= 192 && value < 200) {
            return 280 + value - 192;
        }
        value = (value << 1U) | bit();
        return 144 + value - 400;
    }
    std::size_t length_of(unsigned symbol) {
        if (symbol == 285) {
            return 258;
        }
        const unsigned n = symbol - 257;
        if (n < 8) {
            return 3 + n;
        }
        const unsigned extra = n / 4 - 1;
        return 3 + ((4 + n % 4) << extra) + bits(extra);
    }
    std::size_t distance_of(unsigned n) {
        if (n < 4) {
            return 1 + n;
        }
        const unsigned extra = n / 2 - 1;
        return 1 + ((2 + n % 2) << extra) + bits(extra);
    }

    const Bytes& data_;
    std::size_t place_ = 0;
};

std::uint32_t big_endian(const Bytes& bytes, std::size_t at) {
    return (static_cast<std::uint32_t>(bytes[at]) << 24U) |
           (static_cast<std::uint32_t>(bytes[at + 1]) << 16U) |
           (static_cast<std::uint32_t>(bytes[at + 2]) << 8U) | bytes[at + 3];
}

/// CRC-32 bit by bit, apart from the table under test.
std::uint32_t slow_crc(const Bytes& bytes, std::size_t from, std::size_t to) {
    std::uint32_t crc = 0xFFFFFFFFU;
    for (std::size_t i = from; i < to; ++i) {
        crc ^= bytes[i];
        for (int k = 0; k < 8; ++k) {
            crc = (crc & 1U) != 0U ? (crc >> 1U) ^ 0xEDB88320U : crc >> 1U;
        }
    }
    return ~crc;
}

/// Takes a PNG apart again, checking its chunks.
Image decode(const Bytes& png) {
    const Bytes signature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    REQUIRE(png.size() > 8);
    REQUIRE(std::equal(signature.begin(), signature.end(), png.begin()));
    Image image;
    Bytes packed;
    std::string order;
    for (std::size_t at = 8; at < png.size();) {
        const std::size_t length = big_endian(png, at);
        const std::string type(png.begin() + static_cast<long>(at + 4),
                               png.begin() + static_cast<long>(at + 8));
        REQUIRE(at + 12 + length <= png.size());
        REQUIRE(big_endian(png, at + 8 + length) == slow_crc(png, at + 4, at + 8 + length));
        order += type + " ";
        if (type == "IHDR") {
            image.width = static_cast<int>(big_endian(png, at + 8));
            image.height = static_cast<int>(big_endian(png, at + 12));
            CHECK(png[at + 16] == 8);
            CHECK(png[at + 17] == 6);
        } else if (type == "IDAT") {
            packed.assign(png.begin() + static_cast<long>(at + 8 + 2),
                          png.begin() + static_cast<long>(at + 8 + length - 4));
        }
        at += 12 + length;
    }
    CHECK(order == "IHDR sRGB IDAT IEND ");
    const Bytes rows = Inflater(packed).read();
    const std::size_t width = 4 * static_cast<std::size_t>(image.width);
    REQUIRE(rows.size() == (width + 1) * static_cast<std::size_t>(image.height));
    for (std::size_t row = 0; row < static_cast<std::size_t>(image.height); ++row) {
        const int filter = rows[row * (width + 1)];
        for (std::size_t i = 0; i < width; ++i) {
            std::uint8_t value = rows[row * (width + 1) + 1 + i];
            if (filter == 1 && i >= 4) {
                value = static_cast<std::uint8_t>(value + image.rgba[image.rgba.size() - 4]);
            } else if (filter == 2 && row > 0) {
                value = static_cast<std::uint8_t>(value + image.rgba[image.rgba.size() - width]);
            }
            image.rgba.push_back(value);
        }
    }
    return image;
}

Image picture(int width, int height, int kind) {
    Image image{width, height, {}};
    std::mt19937 random(static_cast<unsigned>(kind));
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (int c = 0; c < 4; ++c) {
                const int value = kind == 0   ? 200
                                  : kind == 1 ? x + 3 * y + 50 * c
                                              : static_cast<int>(random());
                image.rgba.push_back(static_cast<std::uint8_t>(value & 255));
            }
        }
    }
    return image;
}

}  // namespace

TEST_CASE("png: what was written is read back, flat, sloped and random pictures") {
    for (const int kind : {0, 1, 2}) {
        for (const auto& [width, height] : {std::pair{1, 1}, {7, 5}, {640, 33}, {200, 300}}) {
            const Image image = picture(width, height, kind);
            const auto png = encode_png(image);
            REQUIRE(png);
            const Image back = decode(*png);
            CHECK(back.width == width);
            CHECK(back.height == height);
            CHECK(back.rgba == image.rgba);
        }
    }
}

TEST_CASE("png: a flat picture takes little room") {
    const auto png = encode_png(picture(640, 360, 0));
    REQUIRE(png);
    CHECK(png->size() < 640UL * 360UL * 4UL / 50UL);
}

TEST_CASE("png: a picture of a wrong size is refused in one sentence") {
    for (const Image& bad : {Image{}, Image{2, 2, Bytes(15)}, Image{-1, -4, Bytes(16)}}) {
        const auto png = encode_png(bad);
        REQUIRE_FALSE(png);
        CHECK(to_sentence(png.error()).find("picture") != std::string::npos);
    }
}

TEST_CASE("png: a file that cannot be written is named") {
    const auto saved = save_png("/no/such/folder/picture.png", picture(2, 2, 0));
    REQUIRE_FALSE(saved);
    CHECK(to_sentence(saved.error()).find("/no/such/folder/picture.png") == 0);
}

TEST_CASE("png: the file holds the encoded bytes") {
    const auto file = std::filesystem::temp_directory_path() / "fulcrum_image_test.png";
    const Image image = picture(9, 4, 1);
    REQUIRE(save_png(file, image));
    std::ifstream in(file, std::ios::binary);
    const Bytes bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    CHECK(bytes == *encode_png(image));
    std::filesystem::remove(file);
}
