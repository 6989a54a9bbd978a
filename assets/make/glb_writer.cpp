#include "assets/make/glb_writer.h"

#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

namespace fulcrum::assets {
namespace {

using nlohmann::json;
using Bytes = std::vector<std::uint8_t>;

constexpr int kUnsignedInt = 5125;
constexpr int kFloat = 5126;
constexpr int kArrayBuffer = 34962;
constexpr int kElementArrayBuffer = 34963;

template <class T>
void put(Bytes& to, T value) {
    const std::size_t at = to.size();
    to.resize(at + sizeof(T));
    std::memcpy(to.data() + at, &value, sizeof(T));
}

void pad(Bytes& bytes, std::uint8_t filler) {
    while (bytes.size() % 4 != 0) {
        bytes.push_back(filler);
    }
}

/// The document and its one buffer, growing together.
class GlbWriter {
  public:
    explicit GlbWriter(const Model& model) : model_(model) {
        document_["asset"] = {{"version", "2.0"}, {"generator", "fulcrum_make_assets"}};
        document_["scene"] = 0;
        document_["scenes"] = json::array({{{"nodes", {0}}}});
        document_["nodes"] = json::array({{{"mesh", 0}, {"name", model.name}}});
    }

    Bytes write() {
        json primitives = json::array();
        for (const MeshPart& part : model_.parts) {
            primitives.push_back(primitive(part));
        }
        document_["meshes"] = json::array({{{"primitives", primitives}}});
        for (const Picture& picture : model_.pictures) {
            const int view = add_view(encode_png(picture), 0);
            document_["images"].push_back({{"bufferView", view}, {"mimeType", "image/png"}});
            document_["textures"].push_back({{"source", document_["images"].size() - 1}});
        }
        document_["buffers"] = json::array({{{"byteLength", buffer_.size()}}});
        return container();
    }

  private:
    int add_view(const Bytes& bytes, int target) {
        pad(buffer_, 0);
        json view = {{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", bytes.size()}};
        if (target != 0) {
            view["target"] = target;
        }
        buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
        document_["bufferViews"].push_back(view);
        return static_cast<int>(document_["bufferViews"].size()) - 1;
    }

    int add_accessor(json accessor) {
        document_["accessors"].push_back(std::move(accessor));
        return static_cast<int>(document_["accessors"].size()) - 1;
    }

    /// Vectors as floats; positions carry their bounds, as the specification asks.
    template <class Vector>
    int add_vectors(const std::vector<Vector>& vectors, const char* type, bool bounds) {
        Bytes bytes;
        Vector3f low = Vector3f::Constant(std::numeric_limits<float>::max());
        Vector3f high = -low;
        for (const Vector& vector : vectors) {
            for (int k = 0; k < vector.size(); ++k) {
                const auto value = static_cast<float>(vector[k]);
                put(bytes, value);
                low[k] = std::min(low[k], value);
                high[k] = std::max(high[k], value);
            }
        }
        json accessor = {{"bufferView", add_view(bytes, kArrayBuffer)},
                         {"componentType", kFloat},
                         {"count", vectors.size()},
                         {"type", type}};
        if (bounds) {
            accessor["min"] = {low[0], low[1], low[2]};
            accessor["max"] = {high[0], high[1], high[2]};
        }
        return add_accessor(std::move(accessor));
    }

    json primitive(const MeshPart& part) {
        Bytes indices;
        for (const std::uint32_t index : part.indices) {
            put(indices, index);
        }
        json made;
        made["attributes"] = {{"POSITION", add_vectors(part.positions, "VEC3", true)},
                              {"NORMAL", add_vectors(part.normals, "VEC3", false)},
                              {"TEXCOORD_0", add_vectors(part.uvs, "VEC2", false)}};
        made["indices"] = add_accessor({{"bufferView", add_view(indices, kElementArrayBuffer)},
                                        {"componentType", kUnsignedInt},
                                        {"count", part.indices.size()},
                                        {"type", "SCALAR"}});
        made["material"] = material(part);
        return made;
    }

    std::size_t material(const MeshPart& part) {
        json pbr = {
            {"baseColorFactor", {part.colour[0], part.colour[1], part.colour[2], part.alpha}},
            {"metallicFactor", 0.0},
            {"roughnessFactor", part.roughness}};
        if (part.picture >= 0) {
            pbr["baseColorTexture"] = {{"index", part.picture}};
        }
        json made = {{"pbrMetallicRoughness", pbr}};
        if (part.alpha < 1.0) {
            made["alphaMode"] = "BLEND";
        }
        document_["materials"].push_back(made);
        return document_["materials"].size() - 1;
    }

    Bytes container() {
        const std::string text = document_.dump();
        Bytes json_chunk(text.begin(), text.end());
        pad(json_chunk, ' ');
        pad(buffer_, 0);
        Bytes file{'g', 'l', 'T', 'F'};
        put(file, std::uint32_t{2});
        put(file, static_cast<std::uint32_t>(12 + 8 + json_chunk.size() + 8 + buffer_.size()));
        put(file, static_cast<std::uint32_t>(json_chunk.size()));
        file.insert(file.end(), {'J', 'S', 'O', 'N'});
        file.insert(file.end(), json_chunk.begin(), json_chunk.end());
        put(file, static_cast<std::uint32_t>(buffer_.size()));
        file.insert(file.end(), {'B', 'I', 'N', 0});
        file.insert(file.end(), buffer_.begin(), buffer_.end());
        return file;
    }

    const Model& model_;
    json document_;
    Bytes buffer_;
};

}  // namespace

std::vector<std::uint8_t> encode_glb(const Model& model) {
    return GlbWriter(model).write();
}

}  // namespace fulcrum::assets
