// Pictures: what they cost and what they are.
#include "runtime/scene/gltf/picture_header.h"

#include "tests/unit/runtime/rig.h"
#include "tests/unit/runtime/scene/gltf/gltf_bytes.h"

using namespace fulcrum::runtime::test;

TEST_CASE("gltf refuses: pictures that would take gigabytes") {
    const auto with = [](const Octets& file) {
        Gltf gltf;
        gltf.add_picture(file);
        return refusal(gltf);
    };
    check_says(with(png({16'000, 16'000}, zlib_stored({0}))), {"16000 x 16000"});
    check_says(with(png({0, 4}, zlib_stored({0}))), {"0 x 4"});
    check_says(with(png({0x80000000U, 1}, zlib_stored({0}))), {"pixels"});
    // A JPEG's frame header with 16000 x 16000.
    check_says(with({0xFF, 0xD8, 0xFF, 0xC0, 0, 17, 8, 0x3E, 0x80, 0x3E, 0x80, 3, 0, 0, 0}),
               {"16000 x 16000"});
    // A small picture whose rows expand to 100 000 zeros.
    const Octets bomb{0x78, 0xDA, 0xED, 0xC1, 0x31, 0x01, 0x00, 0x00, 0x00,
                      0xC2, 0xA0, 0xF5, 0x4F, 0x6D, 0x0D, 0x0F, 0xA0};
    Octets padded = bomb;
    padded.resize(112, 0);
    padded.insert(padded.end(), {0x80, 0x57, 0x03, 0x86, 0xAF, 0x00, 0x01});
    check_says(with(png({2, 2}, padded)), {"not as long"});
}

TEST_CASE("gltf refuses: pictures of other kinds, cut off, or malformed") {
    const auto with = [](const Octets& file) {
        Gltf gltf;
        gltf.add_picture(file);
        return refusal(gltf);
    };
    check_says(with({'G', 'I', 'F', '8', '9', 'a', 1, 0, 1, 0}), {"neither PNG nor JPEG"});
    check_says(with({'B', 'M', 1, 0, 0, 0}), {"neither PNG nor JPEG"});
    const Octets good = small_png();
    for (std::size_t n = 1; n < good.size() - 4; ++n) {
        CAPTURE(n);
        Gltf gltf;
        gltf.add_picture({good.begin(), good.begin() + static_cast<std::ptrdiff_t>(n)});
        REQUIRE_FALSE(gltf.read().has_value());
    }
    check_says(with(png({}, {1, 2, 3})), {"not as long"});
    check_says(with(png({}, zlib_stored({0, 1, 2}))), {"not as long"});
    check_says(with(png({2, 2, 7, 2, 0}, zlib_stored({0}))), {"header"});
    check_says(with(png({2, 2, 8, 5, 0}, zlib_stored({0}))), {"header"});
    check_says(with({0xFF, 0xD8, 0xFF, 0xC2, 0, 17, 8, 0, 8, 0, 8, 3, 0, 0, 0}), {"progressive"});
    check_says(with({0xFF, 0xD8, 0x00, 0x00, 0, 0}), {"markers"});
    check_says(with({0xFF, 0xD8, 0xFF, 0xE0, 0xFF, 0xFF}), {"markers"});
    Octets scans{0xFF, 0xD8, 0xFF, 0xC0, 0, 11, 8, 0, 8, 0, 8, 1, 1, 0x11, 0};
    for (int i = 0; i < 9; ++i) {
        scans.insert(scans.end(), {0xFF, 0xDA});
    }
    check_says(with(scans), {"scans"});
}

TEST_CASE("gltf: a 16-bit PNG keeps the high byte, an interlaced one its places") {
    Gltf deep;
    deep.add_picture(png({1, 1, 16, 2, 0}, zlib_stored({0, 0x80, 0x12, 0x40, 0x34, 0xC0, 0x56})));
    CHECK(loaded(deep).images.at(0).rgba == Octets{0x80, 0x40, 0xC0, 255});

    // 2 x 2, Adam7: pass 1 has (0,0), pass 6 has (1,0), pass 7 the second row.
    Gltf laced;
    laced.add_picture(png({2, 2, 8, 2, 1},
                          zlib_stored({0, 255, 0, 0, 0, 0, 255, 0, 0, 0, 0, 255, 255, 255, 255})));
    CHECK(loaded(laced).images.at(0).rgba ==
          Octets{255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255});
}

TEST_CASE("gltf: a baseline JPEG is a picture too") {
    // 8 x 8 of one colour, grey: every coefficient but the first is zero.
    Octets jpeg{0xFF, 0xD8, 0xFF, 0xDB, 0x00, 0x43, 0x00};
    jpeg.insert(jpeg.end(), 64, 1);
    const Octets one_code{1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};  // bit 0 is symbol 0
    jpeg.insert(jpeg.end(), {0xFF, 0xC0, 0, 11, 8, 0, 8, 0, 8, 1, 1, 0x11, 0});  // frame
    jpeg.insert(jpeg.end(), {0xFF, 0xC4, 0, 20, 0x00});  // first coefficients
    jpeg.insert(jpeg.end(), one_code.begin(), one_code.end());
    jpeg.insert(jpeg.end(), {0xFF, 0xC4, 0, 20, 0x10});  // the other ones
    jpeg.insert(jpeg.end(), one_code.begin(), one_code.end());
    const Octets rest{0xFF, 0xDA, 0, 8, 1, 1, 0, 0, 63, 0, 0x3F, 0xFF, 0xD9};  // scan
    jpeg.insert(jpeg.end(), rest.begin(), rest.end());
    Gltf gltf;
    gltf.add_picture(jpeg);
    const auto model = loaded(gltf);
    CHECK(model.images.at(0).width == 8);
    CHECK(model.images.at(0).rgba[0] == 128);
    CHECK(model.images.at(0).rgba[3] == 255);
}

TEST_CASE("picture header: sizes are read, and 16 bits cost more than 8") {
    const auto eight = value_of(gltf::read_picture_header(small_png()));
    CHECK(eight.width == 2);
    CHECK(eight.height == 2);
    const auto sixteen =
        value_of(gltf::read_picture_header(png({2, 2, 16, 2, 0}, zlib_stored(Octets(26, 0)))));
    CHECK(sixteen.decoding_bytes > eight.decoding_bytes);
}

TEST_CASE("picture header: the rows of every kind of PNG are counted as the format says") {
    struct Kind {
        PngHead head;
        std::size_t rows_bytes;
    };
    // width, height, depth, colour, interlace: rows of 1 + ceil(bits / 8) bytes.
    const Kind kKinds[] = {{{5, 3, 1, 0, 0}, 3 * 2},   {{9, 2, 2, 3, 0}, 2 * 4},
                           {{3, 2, 4, 0, 0}, 2 * 3},   {{3, 2, 8, 4, 0}, 2 * 7},
                           {{3, 2, 8, 6, 0}, 2 * 13},  {{3, 2, 16, 6, 0}, 2 * 25},
                           {{1, 1, 8, 0, 1}, 2},       {{8, 8, 8, 0, 1}, 64 + 15},
                           {{5, 5, 8, 2, 1}, 75 + 11}, {{2, 1, 8, 0, 1}, 2 * 2}};
    for (const Kind& kind : kKinds) {
        CAPTURE(kind.head.width, kind.head.height, int(kind.head.depth), int(kind.head.interlace));
        CHECK(gltf::read_picture_header(png(kind.head, zlib_stored(Octets(kind.rows_bytes, 0))))
                  .has_value());
        CHECK_FALSE(
            gltf::read_picture_header(png(kind.head, zlib_stored(Octets(kind.rows_bytes + 1, 0))))
                .has_value());
        CHECK_FALSE(
            gltf::read_picture_header(png(kind.head, zlib_stored(Octets(kind.rows_bytes - 1, 0))))
                .has_value());
    }
}
