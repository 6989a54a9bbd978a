#include "runtime/scene/gltf/resources.h"

#include <cstdint>
#include <nlohmann/json.hpp>

namespace fulcrum::runtime::gltf {
namespace {

using nlohmann::json;

bool is_data_uri(const std::string& uri) {
    return uri.rfind("data:", 0) == 0;
}

std::uint64_t number_of(const json& object, const char* name) {
    return object.value(name, std::uint64_t{0});
}

/// The bytes of a file beside the model.
Expected<Bytes> read_beside(const std::string& uri, const ResourceOrigin& origin) {
    auto name = plain_file_name(uri);
    if (!name) {
        return tl::unexpected(name.error());
    }
    if (!origin.folder) {
        return fail("it refers to another file", {}, "embed pictures and buffers in the model");
    }
    return read_regular_file(*origin.folder / *name, kMaxFile_bytes, false);
}

/// The bytes of one buffer, exactly `length` of them.
Expected<Bytes> read_buffer(const json& buffer, std::size_t index, std::size_t length,
                            const ResourceOrigin& origin) {
    Bytes bytes;
    if (buffer.contains("uri")) {
        auto file = read_beside(buffer["uri"].get<std::string>(), origin);
        if (!file) {
            return file;
        }
        bytes = std::move(*file);
    } else if (index == 0) {
        bytes.assign(origin.binary.begin(), origin.binary.end());
    }
    if (bytes.size() < length) {
        return fail("buffers[" + std::to_string(index) + "] is shorter than its byteLength", {},
                    kExportAgain);
    }
    bytes.resize(length);
    return bytes;
}

Expected<void> gather_buffers(json& document, const ResourceOrigin& origin, MemoryBudget& budget,
                              ResourceMap& resources) {
    json& buffers = document["buffers"];
    for (std::size_t i = 0; i < buffers.size(); ++i) {
        const std::uint64_t length = number_of(buffers[i], "byteLength");
        if (length == 0) {
            return fail("buffers[" + std::to_string(i) + "] has no bytes", {}, kExportAgain);
        }
        if (!budget.charge(length)) {
            return fail(kTooMuchMemory, {}, kReduce);
        }
        if (buffers[i].contains("uri") && is_data_uri(buffers[i]["uri"].get<std::string>())) {
            continue;  // decoded by tinygltf, which insists on this length
        }
        auto bytes = read_buffer(buffers[i], i, length, origin);
        if (!bytes) {
            return tl::unexpected(bytes.error());
        }
        const std::string name = "buffer" + std::to_string(i);
        buffers[i]["uri"] = name;
        resources[name] = std::move(*bytes);
    }
    return {};
}

Expected<void> check_views(const json& document) {
    const json& views = document["bufferViews"];
    for (std::size_t i = 0; i < views.size(); ++i) {
        const json& view = views[i];
        const std::uint64_t room =
            number_of(document["buffers"][view["buffer"].get<std::size_t>()], "byteLength");
        const std::uint64_t offset = number_of(view, "byteOffset");
        const std::uint64_t length = number_of(view, "byteLength");
        const std::string place = "bufferViews[" + std::to_string(i) + "]";
        if (length == 0 || offset > room || length > room - offset) {
            return fail(place + " reaches past its buffer", {}, kExportAgain);
        }
        const std::uint64_t stride = number_of(view, "byteStride");
        if (view.contains("byteStride") && (stride < 4 || stride > 252 || stride % 4 != 0)) {
            return fail(place + " has a byteStride that is not 4, 8 … 252", {}, kExportAgain);
        }
    }
    return {};
}

Expected<void> gather_images(json& document, const ResourceOrigin& origin, MemoryBudget& budget,
                             ResourceMap& resources) {
    json& images = document["images"];
    if (images.size() > kMaxImages) {
        return fail("it has more than 64 pictures", {}, kReduce);
    }
    for (std::size_t i = 0; i < images.size(); ++i) {
        json& image = images[i];
        const std::string place = "images[" + std::to_string(i) + "]";
        if (image.contains("uri") == image.contains("bufferView")) {
            return fail(place + " must have either a uri or a bufferView", {}, kExportAgain);
        }
        if (image.contains("bufferView") || is_data_uri(image["uri"].get<std::string>())) {
            continue;
        }
        auto bytes = read_beside(image["uri"].get<std::string>(), origin);
        if (!bytes) {
            return tl::unexpected(bytes.error());
        }
        if (bytes->empty() || !budget.charge(bytes->size())) {
            return fail(bytes->empty() ? place + " is empty" : kTooMuchMemory, {}, kReduce);
        }
        const std::string name = "image" + std::to_string(i);
        image["uri"] = name;
        resources[name] = std::move(*bytes);
    }
    return {};
}

}  // namespace

Expected<ResourceMap> gather_resources(json& document, const ResourceOrigin& origin,
                                       MemoryBudget& budget) {
    for (const char* list : {"buffers", "bufferViews", "images"}) {
        if (!document.contains(list)) {
            document[list] = json::array();
        }
    }
    ResourceMap resources;
    if (auto done = gather_buffers(document, origin, budget, resources); !done) {
        return tl::unexpected(done.error());
    }
    if (auto done = check_views(document); !done) {
        return tl::unexpected(done.error());
    }
    if (auto done = gather_images(document, origin, budget, resources); !done) {
        return tl::unexpected(done.error());
    }
    return resources;
}

}  // namespace fulcrum::runtime::gltf
