// Accessors: types, counts, strides, offsets.
#include "runtime/scene/gltf/accessor_view.h"

#include "tests/unit/runtime/scene/gltf/gltf_bytes.h"

#include <catch2/catch.hpp>

#include <limits>

using namespace fulcrum;
using namespace fulcrum::runtime;
using namespace fulcrum::test;
using Catch::Matchers::Contains;

TEST_CASE("gltf refuses: accessors with counts, offsets or types that do not fit") {
    const auto with = [](int accessor, const char* name, const json& value) {
        Gltf gltf;
        gltf.document["accessors"][static_cast<std::size_t>(accessor)][name] = value;
        CAPTURE(accessor, name, value);
        return refusal(gltf);
    };
    const std::uint64_t largest = std::numeric_limits<std::uint64_t>::max();
    CHECK_THAT(with(0, "count", 4'000'000'000U), Contains("elements"));
    CHECK_THAT(with(0, "count", largest), Contains("elements"));
    CHECK_THAT(with(0, "count", 0), Contains("elements"));
    CHECK_THAT(with(0, "count", 4), Contains("past its buffer view"));
    CHECK_THAT(with(3, "count", 2), Contains("three corners"));
    CHECK_THAT(with(3, "count", 6), Contains("past its buffer view"));
    CHECK_THAT(with(0, "byteOffset", 4), Contains("past its buffer view"));
    CHECK_THAT(with(0, "byteOffset", largest - 3), Contains("past its buffer view"));
    CHECK_THAT(with(0, "byteOffset", 2), Contains("aligned"));
    CHECK_THAT(with(0, "type", "VEC2"), Contains("type"));
    CHECK_THAT(with(0, "type", "VEC9"), Contains("type"));
    CHECK_THAT(with(0, "componentType", 5123), Contains("type"));
    CHECK_THAT(with(0, "componentType", 5130), Contains("type"));
    CHECK_THAT(with(0, "componentType", 0), Contains("omponent"));
    CHECK_THAT(with(3, "componentType", 5126), Contains("type"));
    CHECK_THAT(with(3, "componentType", 5122), Contains("type"));
    CHECK_THAT(with(3, "normalized", true), Contains("type"));
    CHECK_THAT(with(2, "componentType", 5123), Contains("type"));
    CHECK_THAT(with(1, "count", 2), Contains("another count"));
    CHECK_THAT(with(2, "count", 2), Contains("another count"));
    CHECK_THAT(with(0, "sparse", json::object()), Contains("sparse"));
}

TEST_CASE("gltf refuses: indices with a stride") {
    Gltf gltf;
    gltf.at("/accessors/3/bufferView") = gltf.add_view(Octets(12, 0));
    gltf.at("/bufferViews/4/byteStride") = 4;
    CHECK_THAT(refusal(gltf), Contains("byteStride"));
}

TEST_CASE("gltf: indices of one, two and four bytes, and none, give the same triangle") {
    for (const int type : {5121, 5123, 5125}) {
        Gltf gltf;
        const std::size_t bytes = type == 5121 ? 1 : type == 5123 ? 2 : 4;
        Octets indices(3 * bytes, 0);
        indices[bytes] = 1;
        indices[2 * bytes] = 2;
        gltf.at("/accessors/3/bufferView") = gltf.add_view(indices);
        gltf.at("/accessors/3/componentType") = type;
        CHECK(loaded(gltf).primitives[0].indices == Indices{0, 1, 2});
    }
    Gltf bare;
    bare.primitive().erase("indices");
    CHECK(loaded(bare).primitives[0].indices == Indices{0, 1, 2});
}

TEST_CASE("gltf: interleaved attributes are taken apart by their stride") {
    Gltf gltf;
    std::string mixed;
    for (int i = 0; i < 3; ++i) {
        mixed += gltf.binary.substr(static_cast<std::size_t>(12 * i), 12);       // position
        mixed += gltf.binary.substr(static_cast<std::size_t>(36 + 12 * i), 12);  // normal
    }
    const std::size_t view = gltf.add_view({mixed.begin(), mixed.end()});
    gltf.at("/bufferViews")[view]["byteStride"] = 24;
    gltf.at("/accessors/0/bufferView") = view;
    gltf.at("/accessors/1/bufferView") = view;
    gltf.at("/accessors/1/byteOffset") = 12;
    const auto model = loaded(gltf);
    CHECK(model.primitives[0].positions == Floats{0, 0, 0, 1, 0, 0, 0, 1, 0});
    CHECK(model.primitives[0].normals == Floats{0, 0, 1, 0, 0, 1, 0, 0, 1});
}

TEST_CASE("gltf: normalised bytes and shorts are texture coordinates from 0 to 1") {
    Gltf bytes;
    // Each corner's two bytes begin at a multiple of four.
    bytes.at("/accessors/2/bufferView") = bytes.add_view({0, 255, 0, 0, 51, 0, 0, 0, 255, 0, 0, 0});
    bytes.at("/bufferViews/4/byteStride") = 4;
    bytes.at("/accessors/2/componentType") = 5121;
    bytes.at("/accessors/2/normalized") = true;
    CHECK(loaded(bytes).primitives[0].uvs == Floats{0, 1, 0.2F, 0, 1, 0});
    Gltf shorts;
    shorts.at("/accessors/2/bufferView") =
        shorts.add_view({0, 0, 255, 255, 0, 0, 0, 0, 51, 51, 0, 0});
    shorts.at("/accessors/2/componentType") = 5123;
    shorts.at("/accessors/2/normalized") = true;
    CHECK(loaded(shorts).primitives[0].uvs == Floats{0, 1, 0, 0, 0.2F, 0});
}
