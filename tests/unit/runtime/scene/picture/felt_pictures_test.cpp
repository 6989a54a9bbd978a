#include "runtime/scene/picture/felt_pictures.h"

#include "tests/unit/runtime/rig.h"

#include <numeric>
#include <rapidcheck.h>

using namespace fulcrum::runtime::test;
namespace fs = std::filesystem;

namespace {

GreyPicture ramp(std::size_t width, std::size_t height) {
    GreyPicture picture{width, height, {}};
    for (std::size_t i = 0; i < width * height; ++i) {
        picture.values.push_back(static_cast<float>(i % width) / static_cast<float>(width));
    }
    return picture;
}

double mean(const std::vector<float>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

FeltPicture load(FeltPictures& pictures, const std::string& file, double width_m) {
    auto picture = pictures.load(file, width_m);
    INFO(file << ": " << (picture ? "" : to_sentence(picture.error())));
    REQUIRE(picture.has_value());
    return *picture;
}

}  // namespace

TEST_CASE("felt picture: a smaller one is the mean over each new pixel's area") {
    const GreyPicture picture{4, 2, {0.0F, 0.2F, 0.4F, 0.8F, 1.0F, 0.6F, 0.0F, 0.0F}};
    const GreyPicture halved = shrink(picture, 2, 1);
    REQUIRE(halved.values.size() == 2);
    CHECK(halved.values[0] == Approx(0.45));
    CHECK(halved.values[1] == Approx(0.3));
    // A pixel that lies over two of the new ones goes to both, by its share.
    const GreyPicture uneven = shrink({3, 1, {0.0F, 1.0F, 0.0F}}, 2, 1);
    CHECK(uneven.values[0] == Approx(1.0 / 3.0));
    CHECK(uneven.values[1] == Approx(1.0 / 3.0));
    CHECK(shrink(picture, 4, 2).values == picture.values);
}

TEST_CASE("felt picture: whatever the size, the mean stays, and rows stay rows") {
    CHECK(rc::check([] {
        const auto width = *rc::gen::inRange<std::size_t>(1, 40);
        const auto height = *rc::gen::inRange<std::size_t>(1, 12);
        const auto n_u = *rc::gen::inRange<std::size_t>(1, width + 1);
        const auto n_v = *rc::gen::inRange<std::size_t>(1, height + 1);
        const GreyPicture small = shrink(ramp(width, height), n_u, n_v);
        RC_ASSERT(small.values.size() == n_u * n_v);
        RC_ASSERT(std::abs(mean(small.values) - mean(ramp(width, height).values)) < 1e-5);
        for (std::size_t i = 0; i < small.values.size(); ++i) {
            const float before = i % n_u == 0 ? 0.0F : small.values[i - 1];
            RC_ASSERT(small.values[i] >= before);
            RC_ASSERT(small.values[i] <= 1.0F);
        }
    }));
}

TEST_CASE("felt picture: no finer than a hand can tell, in its metres, and of the file's shape") {
    FeltPictures pictures(FULCRUM_PICTURES, 1.0);
    // 16 x 8 pixels: on 10 m each stays; on 0.4 mm only 0.05 mm a pixel are kept.
    const FeltPicture wide = load(pictures, "grey.jpg", 10.0);
    CHECK(wide.heights->n_u == 16);
    CHECK(wide.heights->n_v == 8);
    CHECK(wide.height_per_width == 0.5);
    const FeltPicture narrow = load(pictures, "grey.jpg", 4.0e-4);
    CHECK(narrow.heights->n_u == 8);
    CHECK(narrow.heights->n_v == 4);
    CHECK(narrow.heights->heights.size() == 32);
    const FeltPicture odd = load(pictures, "grey.jpg", 2.5e-4);
    CHECK(odd.heights->n_u == 5);
    CHECK(odd.heights->n_v == 3);
    CHECK(odd.height_per_width == 0.5);
    // A scene a hundred times as large as the hand's has pixels a hundred times as large.
    FeltPictures large(FULCRUM_PICTURES, 100.0);
    CHECK(load(large, "grey.jpg", 0.04).heights->n_u == 8);
}

TEST_CASE("felt picture: a file is kept once for each width") {
    FeltPictures pictures(FULCRUM_PICTURES, 1.0);
    const FeltPicture first = load(pictures, "grey.jpg", 0.05);
    CHECK(load(pictures, "grey.jpg", 0.05).heights == first.heights);
    CHECK(load(pictures, "grey.jpg", 5.0e-4).heights != first.heights);
    CHECK(load(pictures, "grey16.png", 0.05).heights != first.heights);
}

TEST_CASE("felt picture: what is not there or no picture is told with its file") {
    FeltPictures pictures(FULCRUM_PICTURES, 1.0);
    check_says(pictures.load("none.png", 0.05).error().message, {"none.png"});
    check_says(to_sentence(pictures.load("inks.jpg", 0.05).error()), {"inks.jpg: "});
}

TEST_CASE("felt picture: all of a lesson together have an end") {
    // 2049 pixels a side; each width of one file counts.
    FeltPictures pictures(FULCRUM_LARGE_PICTURE_FOLDER, 1.0);
    const FeltPicture whole = load(pictures, "large.png", 1.0);
    CHECK(static_cast<std::size_t>(whole.heights->n_u) == kMaxFeltSide_px);
    (void)load(pictures, "large.png", 1.0);  // the same again costs nothing
    const FeltPicture second = load(pictures, "large.png", (kMaxFeltSide_px - 1) * kFinestPixel_m);
    CHECK(static_cast<std::size_t>(second.heights->n_u) == kMaxFeltSide_px - 1);
    const auto third = error_of(pictures.load("large.png", (kMaxFeltSide_px - 2) * kFinestPixel_m));
    CHECK(third.where == "large.png");
    check_says(third.message, {"too large together"});
}
