// The document's fields, lists and references.
#include "runtime/scene/gltf/document.h"

#include "tests/unit/runtime/scene/gltf/gltf_bytes.h"

#include <catch2/catch.hpp>

using namespace fulcrum;
using namespace fulcrum::runtime;
using namespace fulcrum::test;
using Catch::Matchers::Contains;

TEST_CASE("gltf refuses: another version, and extensions that it cannot do without") {
    Gltf old;
    old.at("/asset/version") = "1.0";
    CHECK_THAT(refusal(old), Contains("version 2"));
    Gltf later;
    later.at("/asset/minVersion") = "2.1";
    CHECK_THAT(refusal(later), Contains("version 2"));
    Gltf draco;
    draco.document["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    CHECK_THAT(refusal(draco), Contains("KHR_draco_mesh_compression"));
    Gltf odd;
    odd.document["extensionsRequired"] = 7;
    CHECK_THAT(refusal(odd), Contains("extension"));
}

TEST_CASE("gltf refuses: lists that are none, are too long, or hold no objects") {
    for (const char* list : {"/nodes", "/meshes", "/accessors", "/bufferViews", "/buffers"}) {
        CAPTURE(list);
        Gltf text;
        text.at(list) = "many";
        refusal(text);
        Gltf numbers;
        numbers.at(list) = {1, 2};
        refusal(numbers);
        Gltf nothing;
        nothing.at(list) = nullptr;
        refusal(nothing);
        Gltf gone;
        gone.document.erase(std::string(list).substr(1));
        refusal(gone);
    }
    Gltf crowd;
    crowd.document["nodes"] = json::array();
    for (int i = 0; i < 10'001; ++i) {
        crowd.document["nodes"].push_back({{"mesh", 0}});
    }
    CHECK_THAT(refusal(crowd), Contains("10000"));
}

TEST_CASE("gltf refuses: every reference that points outside its list") {
    const char* const kReferences[] = {"/scene",
                                       "/scenes/0/nodes/0",
                                       "/nodes/0/mesh",
                                       "/meshes/0/primitives/0/indices",
                                       "/meshes/0/primitives/0/attributes/POSITION",
                                       "/meshes/0/primitives/0/attributes/NORMAL",
                                       "/accessors/0/bufferView",
                                       "/bufferViews/0/buffer",
                                       "/meshes/0/primitives/0/material",
                                       "/materials/0/pbrMetallicRoughness/baseColorTexture/index",
                                       "/textures/0/source",
                                       "/images/0/bufferView"};
    const json kWrong[] = {99, -1, 1.5, "0", json(nullptr), 4'294'967'296, json::array({0})};
    for (const char* reference : kReferences) {
        for (const json& wrong : kWrong) {
            CAPTURE(reference, wrong);
            Gltf gltf;
            gltf.add_picture(small_png());
            gltf.at(reference) = wrong;
            refusal(gltf);
        }
    }
}

TEST_CASE("gltf: extras, optional extensions, animations and unknown fields are left aside") {
    Gltf gltf;
    gltf.document["extras"] = json::parse(R"({"note": [[["deep"]]], "extras": {"a": 1}})");
    gltf.document["extensionsUsed"] = {"KHR_lights_punctual"};
    gltf.document["extensions"] = json::parse(R"({"KHR_lights_punctual": {"lights": 7}})");
    gltf.document["animations"] = "none";
    gltf.document["skins"] = json::array({1, 2, 3});
    gltf.document["materials"] = json::array();
    gltf.document["extensionsRequired"] = json::array();
    gltf.at("/nodes/0/camera") = -5;
    CHECK(loaded(gltf).primitives.size() == 1);
}
