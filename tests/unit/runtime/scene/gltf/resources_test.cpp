// Buffers, buffer views and where pictures lie.
#include "runtime/scene/gltf/resources.h"

#include "tests/unit/runtime/scene/gltf/gltf_bytes.h"

#include <catch2/catch.hpp>

#include <limits>

using namespace fulcrum;
using namespace fulcrum::runtime;
using namespace fulcrum::test;
using Catch::Matchers::Contains;

TEST_CASE("gltf refuses: any file at all when read from memory") {
    Gltf gltf;
    gltf.at("/buffers/0/uri") = "points.bin";
    CHECK_THAT(refusal(gltf), Contains("another file"));
}

TEST_CASE("gltf refuses: data uris that are broken or of another length") {
    Gltf gltf;
    const std::string good = "data:application/octet-stream;base64," + base64(gltf.binary);
    for (const std::string& uri :
         {good.substr(0, good.size() - 8), good.substr(0, 37) + "AAAA" + good.substr(37),
          std::string("data:"), std::string("data:text/html;base64,AAAA"),
          std::string("data:application/octet-stream;base64,@@@@")}) {
        CAPTURE(uri);
        gltf.at("/buffers/0/uri") = uri;
        refusal(read_gltf(to_bytes(gltf.document.dump()), "test.gltf"));
    }
}

TEST_CASE("gltf refuses: buffers longer than their bytes, of no length, or past all memory") {
    for (const json& length : {json(105), json(0), json(1'000'000'000'000), json(-1), json(1e30),
                               json(nullptr), json(std::numeric_limits<std::uint64_t>::max())}) {
        CAPTURE(length);
        Gltf gltf;
        gltf.at("/buffers/0/byteLength") = length;
        refusal(gltf);
    }
    Gltf second;  // only the first buffer may be the binary chunk
    second.document["buffers"].push_back({{"byteLength", 4}});
    CHECK_THAT(refusal(second), Contains("shorter"));
}

TEST_CASE("gltf refuses: buffer views that reach past their buffer or have odd strides") {
    const auto with = [](const char* name, const json& value) {
        Gltf gltf;
        gltf.at("/bufferViews/0")[name] = value;
        return refusal(gltf);
    };
    const std::uint64_t largest = std::numeric_limits<std::uint64_t>::max();
    CHECK_THAT(with("byteLength", 105), Contains("bufferViews[0] reaches past its buffer"));
    CHECK_THAT(with("byteLength", largest), Contains("bufferViews[0] reaches past its buffer"));
    CHECK_THAT(with("byteLength", 0), Contains("bufferViews[0] reaches past its buffer"));
    CHECK_THAT(with("byteOffset", 69), Contains("bufferViews[0] reaches past its buffer"));
    CHECK_THAT(with("byteOffset", largest - 3), Contains("bufferViews[0] reaches past its buffer"));
    CHECK_THAT(with("byteStride", 2), Contains("byteStride"));
    CHECK_THAT(with("byteStride", 0), Contains("byteStride"));
    CHECK_THAT(with("byteStride", 14), Contains("byteStride"));
    CHECK_THAT(with("byteStride", 256), Contains("byteStride"));
    CHECK_THAT(with("byteStride", 8), Contains("byteStride"));  // a VEC3 of floats has 12 bytes
    CHECK_THAT(with("byteStride", 16), Contains("past its buffer view"));
}

TEST_CASE("gltf refuses: more pictures than 64, and pictures from two places or none") {
    Gltf many;
    for (int i = 0; i < 65; ++i) {
        many.add_picture(small_png());
    }
    CHECK_THAT(refusal(many), Contains("64 pictures"));
    Gltf both;
    both.add_picture(small_png());
    both.at("/images/0/uri") = "x.png";
    CHECK_THAT(refusal(both), Contains("either"));
    Gltf none;
    none.add_picture(small_png());
    none.at("/images/0").erase("bufferView");
    CHECK_THAT(refusal(none), Contains("either"));
}

TEST_CASE("gltf: buffers and pictures may be data uris in a .gltf") {
    Gltf gltf;
    gltf.add_picture(small_png());
    gltf.at("/images/0") = {{"uri", "data:image/png;base64," + base64(text_of(small_png()))}};
    gltf.at("/buffers/0/uri") = "data:application/octet-stream;base64," + base64(gltf.binary);
    const auto model = read_gltf(to_bytes(gltf.document.dump()), "test.gltf");
    INFO((model ? "" : to_sentence(model.error())));
    REQUIRE(model.has_value());
    CHECK(model->primitives[0].indices == Indices{0, 1, 2});
    CHECK(model->images.at(0).width == 2);
}

TEST_CASE("gltf refuses: a picture whose bytes would reach past the buffer") {
    Gltf gltf;
    gltf.add_picture(small_png());
    gltf.at("/bufferViews/4/byteOffset") = gltf.at("/bufferViews/4/byteOffset").get<int>() + 4;
    CHECK_THAT(refusal(gltf), Contains("bufferViews[4] reaches past its buffer"));
}
