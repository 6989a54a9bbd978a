// Whole models, from bytes to what is drawn and touched.
#include "runtime/scene/gltf/gltf_model.h"

#include "runtime/scene/gltf/collision_from_model.h"
#include "tests/unit/runtime/rig.h"
#include "tests/unit/runtime/scene/gltf/gltf_bytes.h"

using namespace fulcrum::runtime::test;

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

TEST_CASE("collision: a model's triangles become a mesh that can be touched, corners welded") {
    Gltf gltf;
    gltf.document["nodes"] = json::array({{{"mesh", 0}}, {{"mesh", 0}, {"scale", {1, -1, 1}}}});
    gltf.at("/scenes/0/nodes") = {0, 1};
    const auto mesh = value_of(collision_from_model(loaded(gltf), "test.glb"));
    CHECK(mesh.triangles().size() == 2);
    CHECK(mesh.vertices_B().size() == 4);  // the two triangles share an edge
    CHECK(mesh.lower_B().isApprox(Vector3(0, -1, 0)));
    CHECK(mesh.upper_B().isApprox(Vector3(1, 1, 0)));
    // Both still face +z, though one was mirrored.
    for (const auto& t : mesh.triangles()) {
        const auto& v = mesh.vertices_B();
        const auto at = [&](std::size_t k) { return v[static_cast<std::size_t>(t[k])]; };
        CHECK((at(1) - at(0)).cross(at(2) - at(0)).z() > 0.0);
    }
    CHECK_FALSE(collision_from_model(LoadedModel{}, "empty").has_value());
}
