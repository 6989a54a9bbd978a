// Nodes: transforms, circles, scenes.
#include "runtime/scene/gltf/node_walk.h"

#include "tests/unit/runtime/scene/gltf/gltf_bytes.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace fulcrum;
using namespace fulcrum::runtime;
using namespace fulcrum::test;
using Catch::Matchers::Contains;

TEST_CASE("gltf refuses: transforms that flatten, blow up or bend space") {
    const auto with = [](const char* name, const json& value) {
        Gltf gltf;
        gltf.at("/nodes/0")[name] = value;
        CAPTURE(name, value);
        return refusal(gltf);
    };
    CHECK_THAT(with("scale", {1, 0, 1}), Contains("transform"));
    CHECK_THAT(with("scale", {1e30, 1e30, 1e30}), Contains("10 km"));
    CHECK_THAT(with("scale", {1e200, 1e200, 1e200}), Contains("transform"));
    CHECK_THAT(with("scale", {1, 1}), Contains("3 numbers"));
    CHECK_THAT(with("translation", {1e9, 0, 0}), Contains("10 km"));
    CHECK_THAT(with("translation", {"a", 0, 0}), Contains("number"));
    CHECK_THAT(with("rotation", {0, 0, 0, 0}), Contains("transform"));
    CHECK_THAT(with("rotation", {0, 0, 1e200, 1e200}), Contains("transform"));
    CHECK_THAT(with("matrix", json::array({1, 2, 3})), Contains("16 numbers"));
    CHECK_THAT(with("matrix", {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}),
               Contains("transform"));
    CHECK_THAT(with("matrix", json(std::vector<int>(16, 0))), Contains("transform"));
}

TEST_CASE("gltf refuses: nodes in circles, with two parents, or very deep") {
    const auto with = [](const json& nodes, const json& roots) {
        Gltf gltf;
        gltf.document["nodes"] = nodes;
        gltf.at("/scenes/0/nodes") = roots;
        return refusal(gltf);
    };
    CHECK_THAT(with(json::parse(R"([{"mesh": 0, "children": [0]}])"), {0}),
               Contains("another's child"));
    CHECK_THAT(with(json::parse(R"([{"mesh": 0, "children": [1]}, {"children": [0]}])"), {0}),
               Contains("another's child"));
    CHECK_THAT(with(json::parse(R"([{"children": [1, 1]}, {"mesh": 0}])"), {0}),
               Contains("child of two"));
    CHECK_THAT(
        with(json::parse(R"([{"children": [1]}, {"mesh": 0, "children": [2]}, {"children": [1]}])"),
             {0}),
        Contains("child of two"));
    CHECK_THAT(with(json::parse(R"([{"mesh": 0}])"), {0, 0}), Contains("twice"));
    // A circle that no root reaches shows nothing.
    CHECK_THAT(with(json::parse(R"([{}, {"mesh": 0, "children": [2]}, {"children": [1]}])"), {0}),
               Contains("shows nothing"));

    json deep = json::array();
    for (int i = 0; i < 65; ++i) {
        deep.push_back(i < 64 ? json{{"children", {i + 1}}} : json{{"mesh", 0}});
    }
    CHECK_THAT(with(deep, {0}), Contains("64 nodes deep"));
    Gltf only_circles;
    only_circles.document["nodes"] =
        json::parse(R"([{"mesh": 0, "children": [1]}, {"children": [0]}])");
    only_circles.document.erase("scenes");
    only_circles.document.erase("scene");
    CHECK_THAT(refusal(only_circles), Contains("shows nothing"));
}

TEST_CASE("gltf: translation, rotation and scale are applied in that order, parents first") {
    Gltf gltf;
    const double half = std::sqrt(0.5);
    gltf.document["nodes"] = json::array({{{"children", {1}}, {"translation", {10, 0, 0}}},
                                          {{"mesh", 0},
                                           {"rotation", {0, 0, half, half}},
                                           {"scale", {2, 3, 4}},
                                           {"translation", {0, 1, 0}}}});
    const auto model = loaded(gltf);
    // Scale, a quarter turn about z, then both translations: (x, y) -> (10 - 3y, 1 + 2x).
    const Floats expected{10, 1, 0, 10, 3, 0, 7, 1, 0};
    for (std::size_t i = 0; i < expected.size(); ++i) {
        CHECK(model.primitives[0].positions[i] == Approx(expected[i]).margin(1e-6));
    }
}

TEST_CASE("gltf: a matrix is column by column, and a mirroring one turns triangles around") {
    Gltf gltf;
    gltf.at("/nodes/0/matrix") = {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1};
    const auto model = loaded(gltf);
    CHECK(model.primitives[0].positions == Floats{5, 6, 7, 4, 6, 7, 5, 7, 7});
    CHECK(model.primitives[0].indices == Indices{0, 2, 1});
}

TEST_CASE("gltf: a mesh used by two nodes comes twice; without scenes all roots are shown") {
    Gltf gltf;
    gltf.document["nodes"] =
        json::array({{{"mesh", 0}}, {{"mesh", 0}, {"translation", {0, 0, 2}}}});
    gltf.at("/scenes/0/nodes") = {0, 1};
    CHECK(loaded(gltf).primitives.size() == 2);
    gltf.document.erase("scene");
    gltf.document.erase("scenes");
    CHECK(loaded(gltf).primitives.size() == 2);
}

TEST_CASE("gltf: the default scene is the one shown") {
    Gltf gltf;
    gltf.document["nodes"].push_back({{"mesh", 0}, {"translation", {0, 0, 2}}});
    gltf.document["scenes"].push_back({{"nodes", {1}}});
    gltf.document["scene"] = 1;
    const auto model = loaded(gltf);
    REQUIRE(model.primitives.size() == 1);
    CHECK(model.primitives[0].positions[2] == 2.0F);
}
