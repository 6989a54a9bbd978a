// Pictures to be felt. The files are ramps from black on the left to white on the right.
#include "runtime/scene/picture/grey_picture.h"

#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

fs::path file(const std::string& name) {
    return fs::path(FULCRUM_PICTURES) / name;
}

GreyPicture load(const std::string& name) {
    auto picture = load_grey_picture(file(name));
    INFO(name << ": " << (picture ? "" : to_sentence(picture.error())));
    REQUIRE(picture.has_value());
    REQUIRE(picture->values.size() == picture->width * picture->height);
    return std::move(*picture);
}

std::vector<std::byte> bytes_of(const std::string& name) {
    std::ifstream stream(file(name), std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    const auto* first = reinterpret_cast<const std::byte*>(text.data());
    return {first, first + text.size()};
}

/// The largest distance from the ramp.
float off_ramp(const GreyPicture& picture) {
    float most = 0.0F;
    for (std::size_t i = 0; i < picture.values.size(); ++i) {
        const auto x = static_cast<float>(i % picture.width);
        most =
            std::max(most, std::abs(picture.values[i] - x / static_cast<float>(picture.width - 1)));
    }
    return most;
}

}  // namespace

TEST_CASE("picture: a PNG's values are exact, in 16 bits, interlaced, with transparency") {
    CHECK(load("grey16.png").width == 9);
    CHECK(load("grey16.png").height == 3);
    CHECK(off_ramp(load("grey16.png")) < 1.0F / 65535.0F);
    CHECK(off_ramp(load("interlaced.png")) < 0.5F / 255.0F + 1e-6F);
    CHECK(off_ramp(load("alpha16.png")) < 1.0F / 65535.0F);
    const GreyPicture palette = load("palette.png");
    CHECK(palette.values == std::vector<float>{0, 0, 0, 0, 1, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 1});
}

TEST_CASE("picture: red, green and blue count as an eye weighs them") {
    const GreyPicture picture = load("primaries.png");
    REQUIRE(picture.values.size() == 3);
    CHECK(picture.values[0] == Approx(0.299));
    CHECK(picture.values[1] == Approx(0.587));
    CHECK(picture.values[2] == Approx(0.114));
}

TEST_CASE("picture: a JPEG's ramp is a ramp, grey, in colours, and progressive") {
    constexpr float kCoding = 0.02F;  // quality 95 loses some, and colours more
    for (const char* name : {"grey.jpg", "colour.jpg", "progressive.jpg"}) {
        CAPTURE(name);
        const GreyPicture picture = load(name);
        CHECK(picture.width == 16);
        CHECK(picture.height == 8);
        CHECK(off_ramp(picture) < kCoding);
    }
}

TEST_CASE("picture: what is cut off anywhere is refused") {
    for (const char* name : {"interlaced.png", "grey.jpg", "progressive.jpg"}) {
        const std::vector<std::byte> whole = bytes_of(name);
        REQUIRE(read_grey_picture(whole).has_value());
        for (std::size_t n = 0; n + 4 < whole.size(); ++n) {
            CAPTURE(name, n);
            REQUIRE_THAT(error_of(read_grey_picture(std::span(whole).first(n))).message,
                         Contains("the picture"));
        }
    }
}

TEST_CASE("picture: too large, of inks, of another kind, or no file at all is one sentence") {
    std::vector<std::byte> huge = bytes_of("grey.jpg");
    // The frame header FF C0, length, precision, height, width.
    for (std::size_t i = 0; i + 8 < huge.size(); ++i) {
        if (huge[i] == std::byte{0xFF} && huge[i + 1] == std::byte{0xC0}) {
            huge[i + 5] = std::byte{0x10};
            huge[i + 6] = std::byte{0x01};
            break;
        }
    }
    check_says(read_grey_picture(huge).error().message, {"16 x 4097 pixels"});
    const auto inks = load_grey_picture(file("inks.jpg"));
    check_says(inks.error().message, {"CMYK"});
    check_says(inks.error().what_to_do, {"RGB"});
    const std::array<std::byte, 4> other{std::byte{'G'}, std::byte{'I'}, std::byte{'F'},
                                         std::byte{'8'}};
    check_says(read_grey_picture(other).error().message, {"neither PNG nor JPEG"});
    const auto none = load_grey_picture(file("none.png"));
    check_says(to_sentence(none.error()), {"none.png cannot be read"});
    check_says(to_sentence(load_grey_picture(file(".")).error()), {"not a file"});
}

TEST_CASE("picture: one grey all over is flat, a step of 8 bits is not") {
    GreyPicture picture{2, 2, {0.5F, 0.5F, 0.5F, 0.5F}};
    CHECK(is_flat(picture));
    picture.values[3] += 0.001F;
    CHECK(is_flat(picture));
    picture.values[3] = 0.5F + 1.0F / 255.0F;
    CHECK_FALSE(is_flat(picture));
    CHECK(is_flat({}));
}
