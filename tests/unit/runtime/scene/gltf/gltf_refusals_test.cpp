// What a model is refused for: one value of it is another, or its bytes are, or it would become too large.
#include "tests/unit/runtime/rig.h"
#include "tests/unit/runtime/scene/gltf/gltf_bytes.h"

using namespace fulcrum::runtime::test;

namespace {

// A value of the document, as JSON; "" where it is taken away. What the sentence says.
struct OtherValue {
    const char *at, *value, *told;
};

constexpr OtherValue kOthers[] = {
    // The document.
    {"/asset/version", "\"1.0\"", "version 2"},
    {"/asset/minVersion", "\"2.1\"", "version 2"},
    {"/extensionsRequired", "[\"KHR_draco_mesh_compression\"]", "KHR_draco_mesh_compression"},
    {"/extensionsRequired", "7", "extension"},
    // Models that show nothing.
    {"/nodes", "[{}]", "shows nothing"},
    {"/meshes", "[]", ""},
    {"/meshes/0/primitives", "[]", ""},
    {"/scenes/0/nodes", "[]", "shows nothing"},
    // Accessors with counts, offsets or types that do not fit.
    {"/accessors/0/count", "4000000000", "elements"},
    {"/accessors/0/count", "18446744073709551615", "elements"},
    {"/accessors/0/count", "0", "elements"},
    {"/accessors/0/count", "4", "past its buffer view"},
    {"/accessors/3/count", "2", "three corners"},
    {"/accessors/3/count", "6", "past its buffer view"},
    {"/accessors/0/byteOffset", "4", "past its buffer view"},
    {"/accessors/0/byteOffset", "18446744073709551612", "past its buffer view"},
    {"/accessors/0/byteOffset", "2", "aligned"},
    {"/accessors/0/type", "\"VEC2\"", "type"},
    {"/accessors/0/type", "\"VEC9\"", "type"},
    {"/accessors/0/componentType", "5123", "type"},
    {"/accessors/0/componentType", "5130", "type"},
    {"/accessors/0/componentType", "0", "omponent"},
    {"/accessors/3/componentType", "5126", "type"},
    {"/accessors/3/componentType", "5122", "type"},
    {"/accessors/3/normalized", "true", "type"},
    {"/accessors/2/componentType", "5123", "type"},
    {"/accessors/1/count", "2", "another count"},
    {"/accessors/2/count", "2", "another count"},
    {"/accessors/0/sparse", "{}", "sparse"},
    // Any file at all where the model is read from memory; the first buffer alone may be the binary chunk.
    {"/buffers/0/uri", "\"points.bin\"", "another file"},
    {"/buffers", "[{\"byteLength\": 104}, {\"byteLength\": 4}]", "shorter"},
    // Buffers longer than their bytes, of no length, or past all memory.
    {"/buffers/0/byteLength", "105", ""},
    {"/buffers/0/byteLength", "0", ""},
    {"/buffers/0/byteLength", "1000000000000", ""},
    {"/buffers/0/byteLength", "-1", ""},
    {"/buffers/0/byteLength", "1e30", ""},
    {"/buffers/0/byteLength", "null", ""},
    {"/buffers/0/byteLength", "18446744073709551615", ""},
    // Buffer views that reach past their buffer or have odd strides: a VEC3 of floats has 12 bytes.
    {"/bufferViews/0/byteLength", "105", "bufferViews[0] reaches past its buffer"},
    {"/bufferViews/0/byteLength", "18446744073709551615", "bufferViews[0] reaches past its buffer"},
    {"/bufferViews/0/byteLength", "0", "bufferViews[0] reaches past its buffer"},
    {"/bufferViews/0/byteOffset", "69", "bufferViews[0] reaches past its buffer"},
    {"/bufferViews/0/byteOffset", "18446744073709551612", "bufferViews[0] reaches past its buffer"},
    {"/bufferViews/0/byteStride", "2", "byteStride"},
    {"/bufferViews/0/byteStride", "0", "byteStride"},
    {"/bufferViews/0/byteStride", "14", "byteStride"},
    {"/bufferViews/0/byteStride", "256", "byteStride"},
    {"/bufferViews/0/byteStride", "8", "byteStride"},
    {"/bufferViews/0/byteStride", "16", "past its buffer view"},
    // Transforms that flatten, blow up or bend space.
    {"/nodes/0/scale", "[1, 0, 1]", "transform"},
    {"/nodes/0/scale", "[1e30, 1e30, 1e30]", "10 km"},
    {"/nodes/0/scale", "[1e200, 1e200, 1e200]", "transform"},
    {"/nodes/0/scale", "[1, 1]", "3 numbers"},
    {"/nodes/0/translation", "[1e9, 0, 0]", "10 km"},
    {"/nodes/0/translation", "[\"a\", 0, 0]", "number"},
    {"/nodes/0/rotation", "[0, 0, 0, 0]", "transform"},
    {"/nodes/0/rotation", "[0, 0, 1e200, 1e200]", "transform"},
    {"/nodes/0/matrix", "[1, 2, 3]", "16 numbers"},
    {"/nodes/0/matrix", "[1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]", "transform"},
    {"/nodes/0/matrix", "[0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]", "transform"},
    // Nodes in circles, or with two parents; a circle that no root reaches shows nothing.
    {"/nodes", R"([{"mesh": 0, "children": [0]}])", "another's child"},
    {"/nodes", R"([{"mesh": 0, "children": [1]}, {"children": [0]}])", "another's child"},
    {"/nodes", R"([{"children": [1, 1]}, {"mesh": 0}])", "child of two"},
    {"/nodes", R"([{"children": [1]}, {"mesh": 0, "children": [2]}, {"children": [1]}])",
     "child of two"},
    {"/scenes/0/nodes", "[0, 0]", "twice"},
    {"/nodes", R"([{}, {"mesh": 0, "children": [2]}, {"children": [1]}])", "shows nothing"},
    // Primitives that are no triangles, or have no corners.
    {"/meshes/0/primitives/0/mode", "0", "triangles"},
    {"/meshes/0/primitives/0/mode", "1", "triangles"},
    {"/meshes/0/primitives/0/mode", "2", "triangles"},
    {"/meshes/0/primitives/0/mode", "3", "triangles"},
    {"/meshes/0/primitives/0/mode", "5", "triangles"},
    {"/meshes/0/primitives/0/mode", "6", "triangles"},
    {"/meshes/0/primitives/0/mode", "77", "triangles"},
    {"/meshes/0/primitives/0/attributes", "{\"NORMAL\": 1}", "POSITION"},
    {"/meshes/0/primitives/0/attributes", "", "attributes is missing"},
};

void check_refused(Gltf gltf, const OtherValue& other) {
    CAPTURE(other.at, other.value);
    const json::json_pointer at(other.at);
    if (std::string_view(other.value).empty()) {
        gltf.document.at(at.parent_pointer()).erase(at.back());
    } else {
        gltf.document[at] = json::parse(other.value);
    }
    check_says(refusal(gltf), {other.told});
}

}  // namespace

TEST_CASE("gltf refuses: one value that is another") {
    for (const OtherValue& other : kOthers) {
        check_refused({}, other);
    }
    // Lists that are none, are gone, or hold no objects.
    for (const char* list : {"/nodes", "/meshes", "/accessors", "/bufferViews", "/buffers"}) {
        for (const char* value : {"\"many\"", "[1, 2]", "null", ""}) {
            check_refused({}, {list, value, ""});
        }
    }
}

TEST_CASE("gltf refuses: every reference that points outside its list") {
    Gltf gltf;
    gltf.add_picture(small_png());
    for (const char* reference :
         {"/scene", "/scenes/0/nodes/0", "/nodes/0/mesh", "/meshes/0/primitives/0/indices",
          "/meshes/0/primitives/0/attributes/POSITION", "/meshes/0/primitives/0/attributes/NORMAL",
          "/accessors/0/bufferView", "/bufferViews/0/buffer", "/meshes/0/primitives/0/material",
          "/materials/0/pbrMetallicRoughness/baseColorTexture/index", "/textures/0/source",
          "/images/0/bufferView"}) {
        for (const char* wrong : {"99", "-1", "1.5", "\"0\"", "null", "4294967296", "[0]"}) {
            check_refused(gltf, {reference, wrong, ""});
        }
    }
}

TEST_CASE("gltf refuses: more nodes, deeper ones and more pictures than there may be") {
    json crowd = json::array();
    for (int i = 0; i < 10'001; ++i) {
        crowd.push_back({{"mesh", 0}});
    }
    json deep = json::array();
    for (int i = 0; i < 65; ++i) {
        deep.push_back(i < 64 ? json{{"children", {i + 1}}} : json{{"mesh", 0}});
    }
    check_refused({}, {"/nodes", crowd.dump().c_str(), "10000"});
    check_refused({}, {"/nodes", deep.dump().c_str(), "64 nodes deep"});
    Gltf many;
    for (int i = 0; i < 65; ++i) {
        many.add_picture(small_png());
    }
    check_says(refusal(many), {"64 pictures"});
}

TEST_CASE("gltf refuses: nodes that are all in circles, where no scene says which are roots") {
    Gltf gltf;
    gltf.document["nodes"] = json::parse(R"([{"mesh": 0, "children": [1]}, {"children": [0]}])");
    gltf.document.erase("scenes");
    gltf.document.erase("scene");
    check_says(refusal(gltf), {"shows nothing"});
}

TEST_CASE("gltf refuses: a picture from two places or none, or past the buffer") {
    Gltf gltf;
    gltf.add_picture(small_png());
    check_refused(gltf, {"/images/0/uri", "\"x.png\"", "either"});
    check_refused(gltf, {"/images/0/bufferView", "", "either"});
    const int past = gltf.at("/bufferViews/4/byteOffset").get<int>() + 4;
    check_refused(gltf, {"/bufferViews/4/byteOffset", std::to_string(past).c_str(),
                         "bufferViews[4] reaches past its buffer"});
}

TEST_CASE("gltf refuses: indices with a stride") {
    Gltf gltf;
    gltf.at("/accessors/3/bufferView") = gltf.add_view(Octets(12, 0));
    gltf.at("/bufferViews/4/byteStride") = 4;
    check_says(refusal(gltf), {"byteStride"});
}

TEST_CASE("gltf refuses: an index past its corners") {
    Gltf gltf;
    gltf.binary[100] = 3;
    check_says(refusal(gltf), {"index past its corners"});
    gltf.binary[101] = char(0xFF);
    check_says(refusal(gltf), {"index past its corners"});
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

TEST_CASE("gltf refuses: an empty file, text that is no JSON, JSON that is no model") {
    check_says(refusal_of_text(""), {"empty"});
    check_says(refusal_of_text("hello"), {"not JSON"});
    check_says(refusal_of_text("{\"asset\":"), {"not JSON"});
    check_says(refusal_of_text("[1, 2]"), {"not an object"});
    check_says(refusal_of_text("{}"), {"asset is missing"});
    check_says(refusal_of_text("{\"a\": \"\xFF\xFE\"}"), {"not JSON"});
    check_says(refusal_of_text("{\"a\": 1e999}"), {"not JSON"});
    check_says(refusal_of_text("{\"a\": NaN}"), {"not JSON"});
}

TEST_CASE("gltf refuses: every way to cut a file short") {
    const std::string file = Gltf().glb_text();
    for (std::size_t n = 0; n < file.size(); ++n) {
        CAPTURE(n);
        REQUIRE_FALSE(read_gltf(to_bytes(file.substr(0, n)), "test.glb").has_value());
    }
}

TEST_CASE("gltf refuses: headers and chunks that do not add up") {
    const std::string file = Gltf().glb_text();
    const auto with = [&](std::size_t at, std::uint32_t value) {
        std::string changed = file;
        std::memcpy(&changed[at], &value, 4);
        return refusal(read_gltf(to_bytes(changed), "test.glb"));
    };
    check_says(with(4, 1), {"version 2"});
    check_says(with(8, 12), {"not as long"});
    check_says(with(8, 0xFFFFFFFF), {"not as long"});
    check_says(with(12, 0xFFFFFFFC), {"past the end"});
    check_says(with(12, 3), {"past the end"});
    check_says(with(16, 0x004E4942), {"not JSON"});
    check_says(refusal(read_gltf(to_bytes(file + "xxxx"), "test.glb")), {"not as long"});
}

TEST_CASE("gltf refuses: coordinates and normals that are not finite, and far corners") {
    const float kBad[] = {std::nanf(""), std::numeric_limits<float>::infinity(),
                          -std::numeric_limits<float>::infinity()};
    for (const float bad : kBad) {
        for (const std::size_t byte : {std::size_t{0}, std::size_t{32}, std::size_t{36},
                                       std::size_t{68}, std::size_t{72}, std::size_t{92}}) {
            CAPTURE(bad, byte);
            Gltf gltf;
            gltf.set_float(byte, bad);
            check_says(refusal(gltf), {"not finite"});
        }
    }
    Gltf far;
    far.set_float(0, 1e30F);
    check_says(refusal(far), {"10 km"});
}

TEST_CASE("gltf refuses: a small mesh shown so often that it becomes a huge one") {
    Gltf gltf;
    // 1000 triangles, shown by 5000 nodes: 15 million corners from a file of 200 kB.
    gltf.at("/accessors/3/bufferView") = gltf.add_view(Octets(6000, 0));
    gltf.at("/accessors/3/count") = 3000;
    gltf.document["nodes"] = json::array();
    gltf.at("/scenes/0/nodes") = json::array();
    for (int i = 0; i < 5000; ++i) {
        gltf.document["nodes"].push_back({{"mesh", 0}});
        gltf.at("/scenes/0/nodes").push_back(i);
    }
    check_says(refusal(gltf), {"triangles"});
}

TEST_CASE("gltf refuses: pictures that fit one by one and not together") {
    // 4096 x 4096 with one bit a pixel is 2 MB of rows and 256 MB once decoded; the rows are all zero.
    Octets zlib{0x78, 0x01};
    std::size_t left = 4096UL * 513UL;
    while (left > 0) {
        const std::size_t n = std::min<std::size_t>(left, 65535);
        left -= n;
        for (const std::size_t byte : {left == 0 ? std::size_t{1} : std::size_t{0}, n & 0xFFU,
                                       n >> 8, ~n & 0xFFU, ~n >> 8 & 0xFFU}) {
            zlib.push_back(static_cast<std::uint8_t>(byte));
        }
        zlib.insert(zlib.end(), n, 0);
    }
    put_big(zlib, 0);
    const Octets file = png({4096, 4096, 1, 0, 0}, zlib);
    Gltf gltf;
    for (int i = 0; i < 3; ++i) {
        gltf.add_picture(file);
    }
    check_says(refusal(gltf), {"512 MiB"});
}
