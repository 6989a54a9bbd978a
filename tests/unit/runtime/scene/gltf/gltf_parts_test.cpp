#include "runtime/scene/gltf/deflate_length.h"
#include "runtime/scene/gltf/json_text.h"
#include "runtime/scene/gltf/model_files.h"
#include "runtime/scene/gltf/picture_header.h"
#include "tests/unit/runtime/rig.h"
#include "tests/unit/runtime/scene/gltf/gltf_bytes.h"

#include <sys/stat.h>

using namespace fulcrum::runtime::test;
using namespace fulcrum::runtime::gltf;

namespace {

using Octets = std::vector<std::uint8_t>;

struct Stream {
    std::size_t length;
    Octets zlib;
};

/// Made by zlib 1.2 at level 9: dynamic codes, fixed codes, a run of zeros, stored.
const std::vector<Stream> kStreams{
    {600, {0x78, 0xDA, 0x63, 0x60, 0x62, 0x63, 0x62, 0x66, 0x63, 0x64, 0x64, 0x66,
           0x61, 0x66, 0x61, 0x61, 0x62, 0x62, 0x64, 0x65, 0x61, 0x62, 0x65, 0x66,
           0x18, 0x15, 0x1C, 0x15, 0xA4, 0x4C, 0x10, 0x00, 0x3F, 0xC9, 0x07, 0x08}},
    {33, {0x78, 0x01, 0x2B, 0xC9, 0x2F, 0x4D, 0xCE, 0x50, 0x28, 0xC1, 0x20, 0x13, 0xF3,
          0x52, 0x14, 0xCA, 0x53, 0x33, 0xD3, 0x33, 0x00, 0xD6, 0xE6, 0x0C, 0x74}},
    {5,
     {0x78, 0x01, 0x01, 0x05, 0x00, 0xFA, 0xFF, 0x68, 0x65, 0x6C, 0x6C, 0x6F, 0x06, 0x2C, 0x02,
      0x15}}};

/// 100 000 zeros in 120 bytes.
Octets zeros() {
    Octets zlib{0x78, 0xDA, 0xED, 0xC1, 0x31, 0x01, 0x00, 0x00, 0x00,
                0xC2, 0xA0, 0xF5, 0x4F, 0x6D, 0x0D, 0x0F, 0xA0};
    zlib.resize(113, 0);
    zlib.insert(zlib.end(), {0x80, 0x57, 0x03, 0x86, 0xAF, 0x00, 0x01});
    return zlib;
}

}  // namespace

TEST_CASE("deflate length: is what the stream expands to") {
    for (const Stream& stream : kStreams) {
        CHECK(inflated_length(stream.zlib, 1'000'000) == stream.length);
        CHECK(inflated_length(stream.zlib, stream.length) == stream.length);
    }
    CHECK(inflated_length(zeros(), 1'000'000) == 100'000U);
}

TEST_CASE("deflate length: stops at the limit") {
    for (const Stream& stream : kStreams) {
        CHECK_FALSE(inflated_length(stream.zlib, stream.length - 1));
    }
    CHECK_FALSE(inflated_length(zeros(), 99'999));
    CHECK_FALSE(inflated_length(zeros(), 0));
}

TEST_CASE("deflate length: a stream cut short is malformed") {
    for (const Stream& stream : kStreams) {
        // The last four bytes are the checksum, which is not read.
        for (std::size_t n = 0; n + 4 < stream.zlib.size(); ++n) {
            CAPTURE(stream.length, n);
            CHECK_FALSE(inflated_length(std::span(stream.zlib).first(n), 1'000'000));
        }
    }
}

TEST_CASE("deflate length: bad headers, block kinds and codes are malformed") {
    CHECK_FALSE(inflated_length(Octets{0x79, 0x01, 0x01, 0, 0, 0xFF, 0xFF}, 10));  // method 9
    CHECK_FALSE(inflated_length(Octets{0x78, 0x02, 0x01, 0, 0, 0xFF, 0xFF}, 10));  // check bits
    CHECK_FALSE(
        inflated_length(Octets{0x78, 0x20, 0x01, 0, 0, 0xFF, 0xFF}, 10));  // preset dictionary
    CHECK_FALSE(inflated_length(Octets{0x78, 0x01, 0x07, 0, 0, 0, 0, 0, 0}, 10));  // block kind 3
    CHECK_FALSE(
        inflated_length(Octets{0x78, 0x01, 0x01, 5, 0, 0, 0, 1, 2, 3, 4, 5}, 10));  // length check
    CHECK(inflated_length(Octets{0x78, 0x01, 0x01, 0, 0, 0xFF, 0xFF}, 10) == 0U);
    // A dynamic block whose codes are all ones: more codes than there is room for.
    CHECK_FALSE(inflated_length(Octets(40, 0xFF), 10));
    Octets dynamic{0x78, 0x01, 0x05};
    dynamic.resize(60, 0xFF);
    CHECK_FALSE(inflated_length(dynamic, 1'000'000));
}

TEST_CASE("deflate length: more codes than there is room for are malformed") {
    Octets zlib{0x78, 0x01};
    int held = 8;
    const auto put = [&](unsigned value, int n) {
        for (int i = 0; i < n; ++i, ++held) {
            if (held == 8) {
                zlib.push_back(0);
                held = 0;
            }
            zlib.back() = static_cast<std::uint8_t>(zlib.back() | (value >> i & 1U) << held);
        }
    };
    // A last, dynamic block of 257 literals and one distance, whose lengths are coded by `n` codes of one bit.
    const auto block = [&](int n) {
        zlib.resize(2);
        held = 8;
        put(5, 3);
        put(0, 5);
        put(0, 5);
        put(15, 4);
        // In the format's order 16 17 18 0 8 7 9 6 10 5 11 4 12 3 13 2 14 1 15: symbols 0 and 1 come first.
        for (int i = 0; i < 19; ++i) {
            const bool used = i == 3 || i == 17 || (n > 2 && i > 3 && i < 2 + n);
            put(used ? 1 : 0, 3);
        }
        // 256 lengths of 0, length 1 for the end of the block, length 0 for the distance; then that end.
        put(0, 32);
        for (int i = 0; i < 7; ++i) {
            put(0, 32);
        }
        put(1, 1);
        put(0, 1);
        put(0, 1);
        return inflated_length(zlib, 10);
    };
    CHECK(block(2) == 0U);
    CHECK_FALSE(block(3));
    CHECK_FALSE(block(12));
}

TEST_CASE("gltf refuses: JSON nested deep, in extras and anywhere, before a parser sees it") {
    for (const int depth : {65, 20'000, 1'000'000}) {
        const auto n = static_cast<std::size_t>(depth);
        check_says(refusal_of_text(std::string(n, '[') + std::string(n, ']')), {"nested"});
        std::string deep = Gltf().document.dump();
        deep.insert(1, "\"extras\":" + std::string(n, '[') + std::string(n, ']') + ",");
        check_says(refusal(read_gltf(to_bytes(Gltf().glb(deep)), "test.glb")), {"nested"});
    }
    std::string objects;
    for (int i = 0; i < 20'000; ++i) {
        objects += "{\"extras\":";
    }
    check_says(refusal_of_text(objects), {"nested"});
}

TEST_CASE("gltf refuses: JSON with too many values") {
    std::string many = "{\"a\":[0";
    for (int i = 0; i < 300'000; ++i) {
        many += ",0";
    }
    check_says(refusal_of_text(many + "]}"), {"values"});
    std::string arrays = "{\"a\":[[]";
    for (int i = 0; i < 200'000; ++i) {
        arrays += ",[]";
    }
    check_says(refusal_of_text(arrays + "]}"), {"values"});
}

TEST_CASE("gltf: brackets and quotes inside names do not count as nesting") {
    Gltf gltf;
    gltf.at("/nodes/0/name") = std::string(500, '[') + "\"" + std::string(500, '{');
    CHECK(loaded(gltf).primitives.size() == 1);
}

TEST_CASE("gltf: the limits of depth and of values are exact") {
    const auto nested = [](std::size_t n) { return std::string(n, '[') + std::string(n, ']'); };
    CHECK(gltf::check_json_text(nested(64)).has_value());
    CHECK_FALSE(gltf::check_json_text(nested(65)).has_value());
    CHECK(gltf::check_json_text(nested(64) + nested(64)).has_value());
    CHECK(gltf::check_json_text("\"" + nested(100) + "\"").has_value());
    CHECK_FALSE(gltf::check_json_text("\"\\\"\"" + nested(100)).has_value());
    CHECK(gltf::check_json_text("\"never ends " + nested(100)).has_value());
    CHECK(gltf::check_json_text(std::string(249'999, ',')).has_value());
    CHECK_FALSE(gltf::check_json_text(std::string(250'000, ',')).has_value());
}

TEST_CASE("gltf refuses: a file above its size limit, before reading it") {
    check_says(refusal(read_gltf(Bytes((std::size_t{64} << 20) + 1), "test.glb")), {"64 MiB"});
    const Folder folder;
    write(folder.model(), "x");
    std::filesystem::resize_file(folder.model(), std::uintmax_t{1} << 40);  // sparse: takes no disk
    check_says(refusal(load_gltf(folder.model())), {"64 MiB"});
}

TEST_CASE("gltf refuses: a path that is missing, a folder, a pipe or a device") {
    const Folder folder;
    check_says(refusal(load_gltf(folder.model())), {"cannot be read"});
    check_says(refusal(load_gltf(folder.path)), {"is not a file"});
    REQUIRE(::mkfifo(folder.model().c_str(), 0600) == 0);
    check_says(refusal(load_gltf(folder.model())), {"is not a file"});
    CHECK_FALSE(load_gltf("/dev/zero").has_value());
}

TEST_CASE("gltf refuses: uris that leave the model's folder, whatever lies there") {
    const Folder folder;
    Gltf gltf;
    write(folder.path / "secret.bin", gltf.binary);
    const std::string absolute = (folder.path / "secret.bin").string();
    const std::string kUris[] = {".",
                                 "..",
                                 "",
                                 "../secret.bin",
                                 "./../secret.bin",
                                 "%2e%2e/secret.bin",
                                 "..%2fsecret.bin",
                                 "%2E%2E%2Fsecret.bin",
                                 absolute,
                                 "file://" + absolute,
                                 "..\\secret.bin",
                                 "C:secret.bin",
                                 "http://example.com/x.bin",
                                 "a/b.bin",
                                 std::string("x\0y", 3),
                                 "x%00y",
                                 std::string(300, 'x')};
    for (const std::string& uri : kUris) {
        CAPTURE(uri);
        Gltf by_buffer;
        by_buffer.at("/buffers/0/uri") = uri;
        write(folder.model(), by_buffer.document.dump());
        check_says(refusal(load_gltf(folder.model())), {"own folder"});
        Gltf by_image;
        by_image.document["images"] = json::array({{{"uri", uri}}});
        write(folder.model(), by_image.glb_text());
        check_says(refusal(load_gltf(folder.model())), {"own folder"});
    }
}

TEST_CASE("gltf refuses: a link, a pipe, a folder or nothing in place of a named file") {
    const Folder folder;
    Gltf gltf;
    gltf.at("/buffers/0/uri") = "points.bin";
    write(folder.model(), gltf.document.dump());
    write(folder.path / "secret.bin", gltf.binary);
    const auto points = folder.path / "models" / "points.bin";
    check_says(refusal(load_gltf(folder.model())), {"points.bin"});
    std::filesystem::create_symlink(folder.path / "secret.bin", points);
    check_says(refusal(load_gltf(folder.model())), {"is a link"});
    std::filesystem::remove(points);
    REQUIRE(::mkfifo(points.c_str(), 0600) == 0);
    check_says(refusal(load_gltf(folder.model())), {"is not a file"});
    std::filesystem::remove(points);
    std::filesystem::create_directory(points);
    check_says(refusal(load_gltf(folder.model())), {"is not a file"});
}

TEST_CASE("gltf: buffers and pictures may be plain files beside the model") {
    const Folder folder;
    Gltf gltf;
    gltf.add_picture(small_png());
    gltf.at("/images/0") = {{"uri", "my%20skin.png"}};
    gltf.at("/buffers/0/uri") = "points.bin";
    write(folder.model(), gltf.document.dump());
    write(folder.path / "models" / "points.bin", gltf.binary);
    write(folder.path / "models" / "my skin.png", text_of(small_png()));
    const auto model = load_gltf(folder.model());
    INFO((model ? "" : to_sentence(model.error())));
    REQUIRE(model.has_value());
    CHECK(model->name == "test");
    CHECK(model->images.at(0).rgba.size() == 16);
}

TEST_CASE("gltf: a file name is decoded before it is judged") {
    CHECK(gltf::plain_file_name("skin.png") == "skin.png");
    CHECK(gltf::plain_file_name("my%20skin%2Epng") == "my skin.png");
    CHECK(gltf::plain_file_name("50%.png") == "50%.png");
    CHECK(gltf::plain_file_name("...png") == "...png");
    for (const char* bad :
         {"", ".", "..", "%2e", "%2E%2e", "a/b", "a%2Fb", "a%5cb", "%00", "x%0A"}) {
        CAPTURE(bad);
        CHECK_FALSE(gltf::plain_file_name(bad).has_value());
    }
}

TEST_CASE("gltf: a model may itself be reached by a link") {
    const Folder folder;
    const Gltf gltf;
    write(folder.path / "real.glb", gltf.glb_text());
    std::filesystem::create_symlink(folder.path / "real.glb", folder.model());
    CHECK(load_gltf(folder.model()).has_value());
}

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
