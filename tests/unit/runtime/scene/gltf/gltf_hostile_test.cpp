// Models that must be refused with one sentence, each for its own reason.
#include "tests/unit/runtime/scene/gltf/gltf_bytes.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sys/stat.h>
#include <unistd.h>

using namespace fulcrum;
using namespace fulcrum::runtime;
using namespace fulcrum::test;

namespace {

/// The sentence of a refusal; fails the test when the model loaded, or when the sentence is not one.
std::string refusal(const Expected<LoadedModel>& model) {
    REQUIRE_FALSE(model.has_value());
    const std::string sentence = to_sentence(model.error());
    CHECK(sentence.find('\n') == std::string::npos);
    CHECK(sentence.size() < 400);
    CHECK(model.error().where.find("test") != std::string::npos);
    CHECK_FALSE(model.error().what_to_do.empty());
    return sentence;
}

std::string refusal(const Gltf& gltf) {
    return refusal(gltf.read());
}
std::string refusal_of_text(const std::string& text) {
    return refusal(read_gltf(to_bytes(text), "test.gltf"));
}

using Catch::Matchers::Contains;

struct Folder {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() /
        ("fulcrum_gltf_test_" + std::to_string(::getpid()) + "_" + std::to_string(++counter));
    Folder() { std::filesystem::create_directories(path / "models"); }
    ~Folder() { std::filesystem::remove_all(path); }
    [[nodiscard]] std::filesystem::path model() const { return path / "models" / "test.gltf"; }
    static inline int counter = 0;
};

void write(const std::filesystem::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

}  // namespace

// ---- the container

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

TEST_CASE("gltf refuses: a file above its size limit, before reading it") {
    CHECK_THAT(refusal(read_gltf(Bytes((std::size_t{64} << 20) + 1), "test.glb")),
               Contains("64 MiB"));
    const Folder folder;
    write(folder.model(), "x");
    std::filesystem::resize_file(folder.model(), std::uintmax_t{1} << 40);  // sparse: takes no disk
    CHECK_THAT(refusal(load_gltf(folder.model())), Contains("64 MiB"));
}

TEST_CASE("gltf refuses: a path that is missing, a folder, a pipe or a device") {
    const Folder folder;
    CHECK_THAT(refusal(load_gltf(folder.model())), Contains("cannot be read"));
    CHECK_THAT(refusal(load_gltf(folder.path)), Contains("is not a file"));
    REQUIRE(::mkfifo(folder.model().c_str(), 0600) == 0);
    CHECK_THAT(refusal(load_gltf(folder.model())), Contains("is not a file"));
    CHECK_FALSE(load_gltf("/dev/zero").has_value());
}

// ---- JSON

TEST_CASE("gltf refuses: JSON nested deep, in extras and anywhere, before a parser sees it") {
    for (const int depth : {65, 20'000, 1'000'000}) {
        const auto n = static_cast<std::size_t>(depth);
        CHECK_THAT(refusal_of_text(std::string(n, '[') + std::string(n, ']')), Contains("nested"));
        std::string deep = Gltf().document.dump();
        deep.insert(1, "\"extras\":" + std::string(n, '[') + std::string(n, ']') + ",");
        CHECK_THAT(refusal(read_gltf(to_bytes(Gltf().glb(deep)), "test.glb")), Contains("nested"));
    }
    std::string objects;
    for (int i = 0; i < 20'000; ++i) {
        objects += "{\"extras\":";
    }
    CHECK_THAT(refusal_of_text(objects), Contains("nested"));
}

TEST_CASE("gltf refuses: JSON with too many values") {
    std::string many = "{\"a\":[0";
    for (int i = 0; i < 300'000; ++i) {
        many += ",0";
    }
    CHECK_THAT(refusal_of_text(many + "]}"), Contains("values"));
    std::string arrays = "{\"a\":[[]";
    for (int i = 0; i < 200'000; ++i) {
        arrays += ",[]";
    }
    CHECK_THAT(refusal_of_text(arrays + "]}"), Contains("values"));
}

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

// ---- bytes from elsewhere

TEST_CASE("gltf refuses: uris that leave the model's folder, whatever lies there") {
    const Folder folder;
    Gltf gltf;
    write(folder.path / "secret.bin", gltf.binary);
    const std::string absolute = (folder.path / "secret.bin").string();
    const std::string kUris[] = {".",
                                 "..",
                                 "",
                                 "../secret.bin",
                                 "./../secret.bin",
                                 "%2e%2e/secret.bin",
                                 "..%2fsecret.bin",
                                 "%2E%2E%2Fsecret.bin",
                                 absolute,
                                 "file://" + absolute,
                                 "..\\secret.bin",
                                 "C:secret.bin",
                                 "http://example.com/x.bin",
                                 "a/b.bin",
                                 std::string("x\0y", 3),
                                 "x%00y",
                                 std::string(300, 'x')};
    for (const std::string& uri : kUris) {
        CAPTURE(uri);
        Gltf by_buffer;
        by_buffer.at("/buffers/0/uri") = uri;
        write(folder.model(), by_buffer.document.dump());
        CHECK_THAT(refusal(load_gltf(folder.model())), Contains("own folder"));
        Gltf by_image;
        by_image.document["images"] = json::array({{{"uri", uri}}});
        write(folder.model(), by_image.glb_text());
        CHECK_THAT(refusal(load_gltf(folder.model())), Contains("own folder"));
    }
}

TEST_CASE("gltf refuses: a link, a pipe, a folder or nothing in place of a named file") {
    const Folder folder;
    Gltf gltf;
    gltf.at("/buffers/0/uri") = "points.bin";
    write(folder.model(), gltf.document.dump());
    write(folder.path / "secret.bin", gltf.binary);
    const auto points = folder.path / "models" / "points.bin";
    CHECK_THAT(refusal(load_gltf(folder.model())), Contains("points.bin"));
    std::filesystem::create_symlink(folder.path / "secret.bin", points);
    CHECK_THAT(refusal(load_gltf(folder.model())), Contains("is a link"));
    std::filesystem::remove(points);
    REQUIRE(::mkfifo(points.c_str(), 0600) == 0);
    CHECK_THAT(refusal(load_gltf(folder.model())), Contains("is not a file"));
    std::filesystem::remove(points);
    std::filesystem::create_directory(points);
    CHECK_THAT(refusal(load_gltf(folder.model())), Contains("is not a file"));
}

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

// ---- views and accessors

TEST_CASE("gltf refuses: buffer views that reach past their buffer or have odd strides") {
    const auto with = [](const char* name, const json& value) {
        Gltf gltf;
        gltf.at("/bufferViews/0")[name] = value;
        return refusal(gltf);
    };
    const std::uint64_t largest = std::numeric_limits<std::uint64_t>::max();
    CHECK_THAT(with("byteLength", 105), Contains("past its buffer"));
    CHECK_THAT(with("byteLength", largest), Contains("past its buffer"));
    CHECK_THAT(with("byteLength", 0), Contains("past its buffer"));
    CHECK_THAT(with("byteOffset", 69), Contains("past its buffer"));
    CHECK_THAT(with("byteOffset", largest - 3), Contains("past its buffer"));
    CHECK_THAT(with("byteStride", 2), Contains("byteStride"));
    CHECK_THAT(with("byteStride", 0), Contains("byteStride"));
    CHECK_THAT(with("byteStride", 14), Contains("byteStride"));
    CHECK_THAT(with("byteStride", 256), Contains("byteStride"));
    CHECK_THAT(with("byteStride", 8), Contains("byteStride"));  // a VEC3 of floats has 12 bytes
    CHECK_THAT(with("byteStride", 16), Contains("past its buffer view"));
}

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

TEST_CASE("gltf refuses: an index past its corners") {
    Gltf gltf;
    gltf.binary[100] = 3;
    CHECK_THAT(refusal(gltf), Contains("index past its corners"));
    gltf.binary[101] = char(0xFF);
    CHECK_THAT(refusal(gltf), Contains("index past its corners"));
}

TEST_CASE("gltf refuses: indices with a stride") {
    Gltf gltf;
    gltf.at("/accessors/3/bufferView") = gltf.add_view(Octets(12, 0));
    gltf.at("/bufferViews/4/byteStride") = 4;
    CHECK_THAT(refusal(gltf), Contains("byteStride"));
}

// ---- numbers

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

// ---- nodes

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

// ---- pictures

TEST_CASE("gltf refuses: pictures that would take gigabytes") {
    const auto with = [](const Octets& file) {
        Gltf gltf;
        gltf.add_picture(file);
        return refusal(gltf);
    };
    CHECK_THAT(with(png({16'000, 16'000}, zlib_stored({0}))), Contains("16000 x 16000"));
    CHECK_THAT(with(png({0, 4}, zlib_stored({0}))), Contains("0 x 4"));
    CHECK_THAT(with(png({0x80000000U, 1}, zlib_stored({0}))), Contains("pixels"));
    // A JPEG's frame header with 16000 x 16000.
    CHECK_THAT(with({0xFF, 0xD8, 0xFF, 0xC0, 0, 17, 8, 0x3E, 0x80, 0x3E, 0x80, 3, 0, 0, 0}),
               Contains("16000 x 16000"));
    // A small picture whose rows expand to 100 000 zeros.
    const Octets bomb{0x78, 0xDA, 0xED, 0xC1, 0x31, 0x01, 0x00, 0x00, 0x00,
                      0xC2, 0xA0, 0xF5, 0x4F, 0x6D, 0x0D, 0x0F, 0xA0};
    Octets padded = bomb;
    padded.resize(112, 0);
    padded.insert(padded.end(), {0x80, 0x57, 0x03, 0x86, 0xAF, 0x00, 0x01});
    CHECK_THAT(with(png({2, 2}, padded)), Contains("not as long"));
}

TEST_CASE("gltf refuses: pictures of other kinds, cut off, or malformed") {
    const auto with = [](const Octets& file) {
        Gltf gltf;
        gltf.add_picture(file);
        return refusal(gltf);
    };
    CHECK_THAT(with({'G', 'I', 'F', '8', '9', 'a', 1, 0, 1, 0}), Contains("neither PNG nor JPEG"));
    CHECK_THAT(with({'B', 'M', 1, 0, 0, 0}), Contains("neither PNG nor JPEG"));
    const Octets good = small_png();
    for (std::size_t n = 1; n < good.size() - 4; ++n) {
        CAPTURE(n);
        Gltf gltf;
        gltf.add_picture({good.begin(), good.begin() + static_cast<std::ptrdiff_t>(n)});
        REQUIRE_FALSE(gltf.read().has_value());
    }
    CHECK_THAT(with(png({}, {1, 2, 3})), Contains("not as long"));
    CHECK_THAT(with(png({}, zlib_stored({0, 1, 2}))), Contains("not as long"));
    CHECK_THAT(with(png({2, 2, 7, 2, 0}, zlib_stored({0}))), Contains("header"));
    CHECK_THAT(with(png({2, 2, 8, 5, 0}, zlib_stored({0}))), Contains("header"));
    CHECK_THAT(with({0xFF, 0xD8, 0xFF, 0xC2, 0, 17, 8, 0, 8, 0, 8, 3, 0, 0, 0}),
               Contains("progressive"));
    CHECK_THAT(with({0xFF, 0xD8, 0x00, 0x00, 0, 0}), Contains("markers"));
    CHECK_THAT(with({0xFF, 0xD8, 0xFF, 0xE0, 0xFF, 0xFF}), Contains("markers"));
    Octets scans{0xFF, 0xD8, 0xFF, 0xC0, 0, 11, 8, 0, 8, 0, 8, 1, 1, 0x11, 0};
    for (int i = 0; i < 9; ++i) {
        scans.insert(scans.end(), {0xFF, 0xDA});
    }
    CHECK_THAT(with(scans), Contains("scans"));
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
