// What is refused before any parser sees the text.
#include "runtime/scene/gltf/json_text.h"

#include "tests/unit/runtime/rig.h"
#include "tests/unit/runtime/scene/gltf/gltf_bytes.h"

using namespace fulcrum::runtime::test;

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
