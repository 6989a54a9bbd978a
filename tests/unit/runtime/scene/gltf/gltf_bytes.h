// Builds small glTF files for tests: a document that a test changes, and the buffer it points into.
#pragma once

#include "runtime/scene/gltf/gltf_model.h"

#include <catch2/catch.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <unistd.h>
#include <vector>

namespace fulcrum::runtime::test {

using nlohmann::json;
using Floats = std::vector<float>;
using Indices = std::vector<std::uint32_t>;
using Bytes = std::vector<std::byte>;
using Octets = std::vector<std::uint8_t>;

inline Bytes to_bytes(const std::string& text) {
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

template <class T>
void put(std::string& to, T value) {
    to.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

/// A document with one triangle in the plane z = 0: (0,0,0) (1,0,0) (0,1,0), normals +z, uvs, 16-bit indices.
struct Gltf {
    json document;
    std::string binary;

    Gltf() {
        for (const float x : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F}) {
            put(binary, x);  // bytes 0 to 36: positions
        }
        for (int i = 0; i < 3; ++i) {
            for (const float x : {0.F, 0.F, 1.F}) {
                put(binary, x);  // 36 to 72: normals
            }
        }
        for (const float x : {0.F, 0.F, 1.F, 0.F, 0.F, 1.F}) {
            put(binary, x);  // 72 to 96: uvs
        }
        for (const char i : {'\0', '\1', '\2', '\0'}) {
            binary += {i, '\0'};  // 96 to 104: indices, and 2 bytes to fill
        }
        document = json::parse(R"({
          "asset": {"version": "2.0"}, "scene": 0,
          "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
          "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2}, "indices": 3}]}],
          "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
            {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC3"},
            {"bufferView": 2, "componentType": 5126, "count": 3, "type": "VEC2"},
            {"bufferView": 3, "componentType": 5123, "count": 3, "type": "SCALAR"}],
          "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": 36},
            {"buffer": 0, "byteOffset": 36, "byteLength": 36},
            {"buffer": 0, "byteOffset": 72, "byteLength": 24},
            {"buffer": 0, "byteOffset": 96, "byteLength": 6}],
          "buffers": [{"byteLength": 104}]})");
    }

    json& at(const char* pointer) { return document[json::json_pointer(pointer)]; }
    json& primitive() { return at("/meshes/0/primitives/0"); }

    /// Overwrites a float of the buffer.
    void set_float(std::size_t byte, float value) {
        std::memcpy(&binary[byte], &value, sizeof(value));
    }

    /// Appends bytes and a view of them; the view's index.
    std::size_t add_view(const Octets& octets) {
        binary.resize((binary.size() + 3) / 4 * 4);
        at("/bufferViews")
            .push_back(
                {{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", octets.size()}});
        binary.append(octets.begin(), octets.end());
        at("/buffers/0/byteLength") = binary.size();
        return at("/bufferViews").size() - 1;
    }

    /// Gives the triangle a picture, embedded by a buffer view.
    void add_picture(const Octets& file) {
        const std::size_t view = add_view(file);
        document["images"].push_back({{"bufferView", view}, {"mimeType", "image/png"}});
        document["textures"].push_back({{"source", document["images"].size() - 1}});
        document["materials"].push_back(
            {{"pbrMetallicRoughness",
              {{"baseColorTexture", {{"index", document["textures"].size() - 1}}}}}});
        primitive()["material"] = document["materials"].size() - 1;
    }

    [[nodiscard]] std::string glb_text() const { return glb(document.dump()); }
    [[nodiscard]] Bytes glb() const { return to_bytes(glb_text()); }

    /// The container around any JSON text.
    [[nodiscard]] std::string glb(std::string text) const {
        text.resize((text.size() + 3) / 4 * 4, ' ');
        std::string buffer = binary;
        buffer.resize((buffer.size() + 3) / 4 * 4);
        std::string file = "glTF";
        put(file, std::uint32_t{2});
        put(file, static_cast<std::uint32_t>(12 + 8 + text.size() + 8 + buffer.size()));
        put(file, static_cast<std::uint32_t>(text.size()));
        file += "JSON" + text;
        put(file, static_cast<std::uint32_t>(buffer.size()));
        file += std::string("BIN\0", 4) + buffer;
        return file;
    }

    [[nodiscard]] Expected<LoadedModel> read() const { return read_gltf(glb(), "test.glb"); }
};

/// The model; the test fails when there is none.
inline LoadedModel loaded(const Gltf& gltf) {
    auto model = gltf.read();
    INFO((model ? "" : to_sentence(model.error())));
    REQUIRE(model.has_value());
    return *model;
}

/// The sentence of a refusal; the test fails when the model loaded, or when the sentence is not one.
inline std::string refusal(const Expected<LoadedModel>& model) {
    REQUIRE_FALSE(model.has_value());
    const std::string sentence = to_sentence(model.error());
    CHECK(sentence.find('\n') == std::string::npos);
    CHECK(sentence.size() < 400);
    CHECK(model.error().where.find("test") != std::string::npos);
    CHECK_FALSE(model.error().what_to_do.empty());
    return sentence;
}
inline std::string refusal(const Gltf& gltf) {
    return refusal(gltf.read());
}
inline std::string refusal_of_text(const std::string& text) {
    return refusal(read_gltf(to_bytes(text), "test.gltf"));
}

// ---- files

/// A folder of its own for one test, with a folder for models in it; gone afterwards.
struct Folder {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() /
        ("fulcrum_gltf_test_" + std::to_string(::getpid()) + "_" + std::to_string(++counter));
    Folder() { std::filesystem::create_directories(path / "models"); }
    ~Folder() { std::filesystem::remove_all(path); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    [[nodiscard]] std::filesystem::path model() const { return path / "models" / "test.gltf"; }
    static inline int counter = 0;
};

inline void write(const std::filesystem::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

inline std::string text_of(const Octets& octets) {
    return {octets.begin(), octets.end()};
}

inline std::string base64(const std::string& bytes) {
    static const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            group =
                group << 8 | (i + k < bytes.size() ? static_cast<std::uint8_t>(bytes[i + k]) : 0U);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            text += i + k > bytes.size() ? '=' : kDigits[group >> (18 - 6 * k) & 63U];
        }
    }
    return text;
}

// ---- pictures

inline void put_big(Octets& to, std::uint32_t value) {
    for (const int shift : {24, 16, 8, 0}) {
        to.push_back(static_cast<std::uint8_t>(value >> shift & 0xFFU));
    }
}

/// A chunk; its checksum is left zero, nobody compares it.
inline void put_chunk(Octets& file, const std::string& type, const Octets& data) {
    put_big(file, static_cast<std::uint32_t>(data.size()));
    file.insert(file.end(), type.begin(), type.end());
    file.insert(file.end(), data.begin(), data.end());
    put_big(file, 0);
}

/// A zlib stream of one stored block, up to 65535 bytes.
inline Octets zlib_stored(const Octets& raw) {
    const auto n = static_cast<std::uint16_t>(raw.size());
    const auto inverse = static_cast<std::uint16_t>(~n);
    Octets out{0x78, 0x01, 1};
    for (const std::uint16_t word : {n, inverse}) {
        out.push_back(static_cast<std::uint8_t>(word & 0xFFU));
        out.push_back(static_cast<std::uint8_t>(word >> 8));
    }
    out.insert(out.end(), raw.begin(), raw.end());
    put_big(out, 0);
    return out;
}

struct PngHead {
    std::uint32_t width = 2;
    std::uint32_t height = 2;
    std::uint8_t depth = 8;
    std::uint8_t colour = 2;  ///< RGB
    std::uint8_t interlace = 0;
};

/// A PNG with any header around any compressed rows.
inline Octets png(const PngHead& head, const Octets& zlib) {
    Octets ihdr;
    put_big(ihdr, head.width);
    put_big(ihdr, head.height);
    ihdr.insert(ihdr.end(), {head.depth, head.colour, 0, 0, head.interlace});
    Octets file{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    put_chunk(file, "IHDR", ihdr);
    put_chunk(file, "IDAT", zlib);
    put_chunk(file, "IEND", {});
    return file;
}

/// 2 x 2: red, green / blue, white.
inline Octets small_png() {
    return png({}, zlib_stored({0, 255, 0, 0, 0, 255, 0, 0, 0, 0, 255, 255, 255, 255}));
}

}  // namespace fulcrum::runtime::test
