// The container: a .glb's header and chunks, a .gltf's text.
#include "runtime/scene/gltf/container.h"

#include "tests/unit/runtime/scene/gltf/gltf_bytes.h"

#include <catch2/catch.hpp>

using namespace fulcrum;
using namespace fulcrum::runtime;
using namespace fulcrum::test;
using Catch::Matchers::Contains;

TEST_CASE("gltf refuses: an empty file, text that is no JSON, JSON that is no model") {
    CHECK_THAT(refusal_of_text(""), Contains("empty"));
    CHECK_THAT(refusal_of_text("hello"), Contains("not JSON"));
    CHECK_THAT(refusal_of_text("{\"asset\":"), Contains("not JSON"));
    CHECK_THAT(refusal_of_text("[1, 2]"), Contains("not an object"));
    CHECK_THAT(refusal_of_text("{}"), Contains("asset is missing"));
    CHECK_THAT(refusal_of_text("{\"a\": \"\xFF\xFE\"}"), Contains("not JSON"));
    CHECK_THAT(refusal_of_text("{\"a\": 1e999}"), Contains("not JSON"));
    CHECK_THAT(refusal_of_text("{\"a\": NaN}"), Contains("not JSON"));
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
    CHECK_THAT(with(4, 1), Contains("version 2"));
    CHECK_THAT(with(8, 12), Contains("not as long"));
    CHECK_THAT(with(8, 0xFFFFFFFF), Contains("not as long"));
    CHECK_THAT(with(12, 0xFFFFFFFC), Contains("past the end"));
    CHECK_THAT(with(12, 3), Contains("past the end"));
    CHECK_THAT(with(16, 0x004E4942), Contains("not JSON"));
    CHECK_THAT(refusal(read_gltf(to_bytes(file + "xxxx"), "test.glb")), Contains("not as long"));
}
