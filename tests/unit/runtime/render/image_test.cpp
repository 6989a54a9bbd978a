#include "runtime/render/image.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <png.h>
#include <random>
#include <string>

using namespace fulcrum;
using namespace fulcrum::runtime;

namespace {

using Bytes = std::vector<std::uint8_t>;

/// The names of a PNG's chunks, each with a blank behind it.
std::string chunks_of(const Bytes& png) {
    std::string names;
    for (std::size_t at = 8; at + 12 <= png.size();) {
        names.append(png.begin() + static_cast<long>(at + 4),
                     png.begin() + static_cast<long>(at + 8));
        names += ' ';
        at += 12 + (std::size_t{png[at]} << 24U | std::size_t{png[at + 1]} << 16U |
                    std::size_t{png[at + 2]} << 8U | png[at + 3]);
    }
    return names;
}

/// Takes a PNG apart by libpng, which checks signature, checksums, codes and filters, and complains of nothing.
Image decode(const Bytes& png) {
    png_image reader{};
    reader.version = PNG_IMAGE_VERSION;
    REQUIRE(png_image_begin_read_from_memory(&reader, png.data(), png.size()) != 0);
    CHECK(reader.format == PNG_FORMAT_RGBA);
    CHECK(png[24] == 8);  // bits a channel
    CHECK(chunks_of(png) == "IHDR sRGB IDAT IEND ");
    Image image{static_cast<int>(reader.width), static_cast<int>(reader.height),
                Bytes(PNG_IMAGE_SIZE(reader))};
    REQUIRE(png_image_finish_read(&reader, nullptr, image.rgba.data(), 0, nullptr) != 0);
    CHECK(reader.warning_or_error == 0);
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
