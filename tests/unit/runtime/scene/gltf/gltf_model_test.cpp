// Whole models, from bytes to what is drawn.
#include "runtime/scene/gltf/gltf_model.h"

#include "tests/unit/runtime/scene/gltf/gltf_bytes.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace fulcrum;
using namespace fulcrum::runtime;
using namespace fulcrum::test;
using Catch::Matchers::Contains;

TEST_CASE("gltf refuses: models that show nothing") {
    Gltf no_mesh;
    no_mesh.document["nodes"] = json::array({json::object()});
    CHECK_THAT(refusal(no_mesh), Contains("shows nothing"));
    Gltf no_meshes;
    no_meshes.document["meshes"] = json::array();
    refusal(no_meshes);
    Gltf no_primitives;
    no_primitives.at("/meshes/0/primitives") = json::array();
    refusal(no_primitives);
    Gltf no_nodes;
    no_nodes.at("/scenes/0/nodes") = json::array();
    CHECK_THAT(refusal(no_nodes), Contains("shows nothing"));
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
    CHECK_THAT(refusal(gltf), Contains("triangles"));
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
    CHECK_THAT(refusal(gltf), Contains("512 MiB"));
}

TEST_CASE("gltf: a picture's pixels arrive in order, as sRGB bytes with alpha") {
    Gltf gltf;
    gltf.add_picture(small_png());
    const auto model = loaded(gltf);
    CHECK(model.primitives[0].image == 0);
    CHECK(model.images.at(0).rgba ==
          Octets{255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255});
}

TEST_CASE("gltf: a picture that no base colour uses is not decoded") {
    Gltf gltf;
    gltf.add_picture(small_png());
    // A normal map of an unknown format does not keep a model from loading.
    const std::size_t view = gltf.add_view({'G', 'I', 'F', '8'});
    gltf.at("/images").push_back({{"bufferView", view}});
    CHECK(loaded(gltf).images.size() == 2);
}
