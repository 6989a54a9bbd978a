// Triangles: indices, numbers, normals, material.
#include "runtime/scene/gltf/primitive.h"

#include "tests/unit/runtime/scene/gltf/gltf_bytes.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace fulcrum;
using namespace fulcrum::runtime;
using namespace fulcrum::test;
using Catch::Matchers::Contains;

TEST_CASE("gltf refuses: an index past its corners") {
    Gltf gltf;
    gltf.binary[100] = 3;
    CHECK_THAT(refusal(gltf), Contains("index past its corners"));
    gltf.binary[101] = char(0xFF);
    CHECK_THAT(refusal(gltf), Contains("index past its corners"));
}

TEST_CASE(
    "gltf refuses: coordinates, normals and texture coordinates that are not finite, and far "
    "corners") {
    const float kBad[] = {std::nanf(""), std::numeric_limits<float>::infinity(),
                          -std::numeric_limits<float>::infinity()};
    for (const float bad : kBad) {
        for (const std::size_t byte : {std::size_t{0}, std::size_t{32}, std::size_t{36},
                                       std::size_t{68}, std::size_t{72}, std::size_t{92}}) {
            CAPTURE(bad, byte);
            Gltf gltf;
            gltf.set_float(byte, bad);
            CHECK_THAT(refusal(gltf), Contains("not finite"));
        }
    }
    Gltf far;
    far.set_float(0, 1e30F);
    CHECK_THAT(refusal(far), Contains("10 km"));
}

TEST_CASE("gltf refuses: primitives that are not triangles, or have no corners") {
    for (const int mode : {0, 1, 2, 3, 5, 6, 77}) {
        Gltf gltf;
        gltf.primitive()["mode"] = mode;
        CHECK_THAT(refusal(gltf), Contains("triangles"));
    }
    Gltf bare;
    bare.primitive()["attributes"] = {{"NORMAL", 1}};
    CHECK_THAT(refusal(bare), Contains("POSITION"));
    Gltf none;
    none.primitive().erase("attributes");
    CHECK_THAT(refusal(none), Contains("attributes is missing"));
}

TEST_CASE("gltf: missing normals, or some without length, become flat ones that face the front") {
    Gltf missing;
    missing.primitive()["attributes"].erase("NORMAL");
    Gltf zero;
    zero.set_float(36 + 8, 0.0F);
    for (const Gltf& gltf : {missing, zero}) {
        const auto model = loaded(gltf);
        CHECK(model.primitives[0].normals == Floats{0, 0, 1, 0, 0, 1, 0, 0, 1});
        CHECK(model.primitives[0].uvs == Floats{0, 0, 1, 0, 0, 1});
    }
    // The back is seen when the corners run the other way.
    missing.primitive()["indices"] = 3;
    missing.binary[98] = 2;
    missing.binary[100] = 1;
    CHECK(loaded(missing).primitives[0].normals == Floats{0, 0, -1, 0, 0, -1, 0, 0, -1});
}

TEST_CASE("gltf: long normals are shortened to one") {
    Gltf gltf;
    for (std::size_t i = 0; i < 3; ++i) {
        gltf.set_float(36 + 12 * i + 8, 5.0F);
    }
    CHECK(loaded(gltf).primitives[0].normals == Floats{0, 0, 1, 0, 0, 1, 0, 0, 1});
}

TEST_CASE("gltf: the material's colour, roughness and picture are read") {
    Gltf gltf;
    gltf.document["materials"] = json::parse(R"([{"pbrMetallicRoughness":
        {"baseColorFactor": [0.25, 0.5, 0.75, 0.5], "roughnessFactor": 0.125}}])");
    gltf.primitive()["material"] = 0;
    const auto model = loaded(gltf);
    CHECK(model.primitives[0].base_colour == std::array<float, 4>{0.25F, 0.5F, 0.75F, 0.5F});
    CHECK(model.primitives[0].roughness == 0.125F);
}

TEST_CASE("gltf: normals turn by the inverse transpose") {
    Gltf gltf;
    // Normals (0, 1, 1), flattened by 1/2 along y: they lean towards y, as (0, 2, 1).
    for (std::size_t i = 0; i < 3; ++i) {
        gltf.set_float(36 + 12 * i + 4, 1.0F);
    }
    gltf.at("/nodes/0/scale") = {1, 0.5, 1};
    const auto model = loaded(gltf);
    CHECK(model.primitives[0].normals[1] == Approx(2.0 / std::sqrt(5.0)));
    CHECK(model.primitives[0].normals[2] == Approx(1.0 / std::sqrt(5.0)));
}

TEST_CASE("gltf: a plain triangle comes out as it was written") {
    const auto model = loaded(Gltf());
    CHECK(model.name == "test");
    REQUIRE(model.primitives.size() == 1);
    const auto& p = model.primitives[0];
    CHECK(p.positions == Floats{0, 0, 0, 1, 0, 0, 0, 1, 0});
    CHECK(p.normals == Floats{0, 0, 1, 0, 0, 1, 0, 0, 1});
    CHECK(p.uvs == Floats{0, 0, 1, 0, 0, 1});
    CHECK(p.indices == Indices{0, 1, 2});
    CHECK(p.image == -1);
    CHECK(model.images.empty());
}
