#include "runtime/scene/gltf/gltf_model.h"

#include "runtime/scene/gltf/container.h"
#include "runtime/scene/gltf/document.h"
#include "runtime/scene/gltf/json_text.h"
#include "runtime/scene/gltf/limits.h"
#include "runtime/scene/gltf/node_walk.h"
#include "runtime/scene/gltf/picture_header.h"
#include "runtime/scene/gltf/primitive.h"
#include "runtime/scene/gltf/resources.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <utility>

namespace fulcrum::runtime {
namespace {

using namespace gltf;

/// What tinygltf's callbacks know.
struct LoaderContext {
    ResourceMap resources;
    MemoryBudget* budget = nullptr;
    std::set<int> shown_images;  ///< the others (normal maps and so on) are not decoded
    std::optional<Error> picture_error;
};

// ---- callbacks: tinygltf sees our names and our bytes, never the disk

bool resource_exists(const std::string& name, void* context) {
    return static_cast<LoaderContext*>(context)->resources.count(name) != 0;
}

std::string same_name(const std::string& name, void* /*context*/) {
    return name;
}

bool read_resource(std::vector<unsigned char>* out, std::string* /*err*/, const std::string& name,
                   void* context) {
    const auto& resources = static_cast<LoaderContext*>(context)->resources;
    const auto found = resources.find(name);
    if (found == resources.end()) {
        return false;
    }
    out->resize(found->second.size());
    std::memcpy(out->data(), found->second.data(), found->second.size());
    return true;
}

bool refuse_writing(std::string* /*err*/, const std::string& /*name*/,
                    const std::vector<unsigned char>& /*bytes*/, void* /*context*/) {
    return false;
}

/// Decodes a picture only after its header said that it fits.
bool load_picture(tinygltf::Image* image, const int index, std::string* err, std::string* warn,
                  int /*width*/, int /*height*/, const unsigned char* bytes, int size,
                  void* context_pointer) {
    auto& context = *static_cast<LoaderContext*>(context_pointer);
    if (context.shown_images.count(index) == 0) {
        image->width = image->height = 1;
        image->component = 4;
        image->bits = 8;
        image->image = {255, 255, 255, 255};
        return true;
    }
    const auto header = read_picture_header({bytes, static_cast<std::size_t>(size)});
    if (!header) {
        context.picture_error = header.error();
        return false;
    }
    if (!context.budget->charge(header->decoding_bytes)) {
        context.picture_error = Error{kTooMuchMemory, {}, kReduce};
        return false;
    }
    return tinygltf::LoadImageData(image, index, err, warn, static_cast<int>(header->width),
                                   static_cast<int>(header->height), bytes, size, nullptr);
}

/// Pictures that some material's base colour uses.
std::set<int> find_shown_images(const nlohmann::json& document) {
    const nlohmann::json::json_pointer index("/pbrMetallicRoughness/baseColorTexture/index");
    std::set<int> shown;
    for (const auto& material : document.value("materials", nlohmann::json::array())) {
        if (material.contains(index)) {
            const auto& texture = document["textures"][material[index].get<std::size_t>()];
            shown.insert(texture.value("source", -1));
        }
    }
    return shown;
}

// ---- steps

/// The first line of a vendor's message, short enough to be part of a sentence.
std::string first_line(const std::string& text) {
    constexpr std::size_t kMaxQuoted = 120;
    std::string line = text.substr(0, std::min(text.find('\n'), kMaxQuoted));
    while (!line.empty() && (line.back() == '.' || line.back() == ' ')) {
        line.pop_back();
    }
    return line;
}

Expected<tinygltf::Model> parse(const nlohmann::json& document, LoaderContext& context) {
    tinygltf::TinyGLTF loader;
    loader.SetFsCallbacks({resource_exists, same_name, read_resource, refuse_writing, &context});
    loader.SetImageLoader(load_picture, &context);
    const std::string text = document.dump();
    tinygltf::Model model;
    std::string problem;
    std::string warning;
    const bool ok = loader.LoadASCIIFromString(&model, &problem, &warning, text.c_str(),
                                               static_cast<unsigned int>(text.size()), "");
    if (context.picture_error) {
        return tl::unexpected(*context.picture_error);
    }
    if (!ok) {
        return fail("it cannot be parsed (" + first_line(problem) + ")", {}, kExportAgain);
    }
    return model;
}

Expected<ModelImage> copy_image(const tinygltf::Image& image) {
    ModelImage copy{image.width, image.height, {}};
    const std::size_t n =
        static_cast<std::size_t>(copy.width) * static_cast<std::size_t>(copy.height) * 4;
    const std::size_t step = image.bits == 16 ? 2 : 1;
    if (n == 0 || image.component != 4 || image.image.size() != n * step) {
        return fail("a picture could not be decoded", {}, "save the picture again as PNG");
    }
    copy.rgba.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        copy.rgba[i] =
            image.image[i * step + (step - 1)];  // the high byte on a little-endian machine
    }
    return copy;
}

Expected<LoadedModel> flatten(const tinygltf::Model& model, MemoryBudget& budget) {
    LoadedModel loaded;
    for (const auto& image : model.images) {
        auto copy = copy_image(image);
        if (!copy) {
            return tl::unexpected(copy.error());
        }
        loaded.images.push_back(std::move(*copy));
    }
    const auto placed = place_meshes(model);
    if (!placed) {
        return tl::unexpected(placed.error());
    }
    std::size_t n_corners = 0;
    for (const PlacedMesh& place : *placed) {
        const auto& primitives = model.meshes[place.mesh].primitives;
        for (std::size_t i = 0; i < primitives.size(); ++i) {
            const std::string where =
                "meshes[" + std::to_string(place.mesh) + "].primitives[" + std::to_string(i) + "]";
            auto made = read_primitive(model, primitives[i], place.X_MN, where, budget);
            if (!made) {
                return tl::unexpected(made.error());
            }
            n_corners += made->indices.size();
            loaded.primitives.push_back(std::move(*made));
            if (n_corners > kMaxCorners || loaded.primitives.size() > kMaxItems) {
                return fail("it shows more than a million triangles or 10000 primitives", {},
                            "reduce its triangles");
            }
        }
    }
    if (loaded.primitives.empty()) {
        return fail("it shows nothing: no node of its scene has a mesh", {}, kExportAgain);
    }
    return loaded;
}

Expected<LoadedModel> read_checked(std::span<const std::byte> bytes,
                                   const std::optional<std::filesystem::path>& folder) {
    const auto container = split_container(bytes);
    if (!container) {
        return tl::unexpected(container.error());
    }
    if (auto text = check_json_text(container->json); !text) {
        return tl::unexpected(text.error());
    }
    auto document = read_document(container->json);
    if (!document) {
        return tl::unexpected(document.error());
    }
    MemoryBudget budget;
    auto resources = gather_resources(*document, {container->binary, folder}, budget);
    if (!resources) {
        return tl::unexpected(resources.error());
    }
    LoaderContext context{std::move(*resources), &budget, find_shown_images(*document),
                          std::nullopt};
    const auto model = parse(*document, context);
    if (!model) {
        return tl::unexpected(model.error());
    }
    return flatten(*model, budget);
}

/// Runs the steps; whatever is thrown inside becomes an error, and every error gets its place.
Expected<LoadedModel> read_guarded(std::span<const std::byte> bytes,
                                   const std::optional<std::filesystem::path>& folder,
                                   std::string where, std::string name) {
    Expected<LoadedModel> loaded = fail("it could not be read", {}, kExportAgain);
    try {
        loaded = read_checked(bytes, folder);
    } catch (const std::exception& problem) {
        loaded =
            fail("it could not be read (" + first_line(problem.what()) + ")", {}, kExportAgain);
    } catch (...) {
        loaded = fail("it could not be read (an unknown fault)", {}, kExportAgain);
    }
    if (!loaded) {
        loaded.error().where = std::move(where);
        return loaded;
    }
    loaded->name = std::move(name);
    return loaded;
}

}  // namespace

Expected<LoadedModel> load_gltf(const std::filesystem::path& path) {
    auto bytes = read_regular_file(path, kMaxFile_bytes, true);
    if (!bytes) {
        bytes.error().where = path.string();
        return tl::unexpected(bytes.error());
    }
    return read_guarded(*bytes, path.parent_path(), path.string(), path.stem().string());
}

Expected<LoadedModel> read_gltf(std::span<const std::byte> bytes, std::string where) {
    std::string name = std::filesystem::path(where).stem().string();
    return read_guarded(bytes, std::nullopt, std::move(where), std::move(name));
}

}  // namespace fulcrum::runtime
