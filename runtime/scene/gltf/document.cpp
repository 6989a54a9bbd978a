#include "runtime/scene/gltf/document.h"

#include "runtime/scene/gltf/limits.h"

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

namespace fulcrum::runtime::gltf {
namespace {

using nlohmann::json;

enum class Kind {
    index,        ///< position in the list named `list`
    index_list,   ///< array of such
    index_map,    ///< object whose values are such
    count,        ///< non-negative integer
    flag,         ///< true or false
    text,         ///< string
    number,       ///< one finite number
    numbers,      ///< array of `size` finite numbers
    object,       ///< object of shape `inner`
    object_list,  ///< array of such
};

struct Shape;

struct Field {
    const char* name = nullptr;
    Kind kind = Kind::flag;
    bool required = false;
    const char* list = nullptr;
    std::size_t size = 0;
    const Shape* inner = nullptr;
};

struct Shape {
    std::span<const Field> fields;
};

// ---- what we read of each property

constexpr bool kRequired = true;

constexpr Field kAssetFields[] = {{"version", Kind::text, kRequired}, {"minVersion", Kind::text}};
constexpr Field kSceneFields[] = {{"nodes", Kind::index_list, false, "nodes"}};
constexpr Field kNodeFields[] = {{"mesh", Kind::index, false, "meshes"},
                                 {"children", Kind::index_list, false, "nodes"},
                                 {"matrix", Kind::numbers, false, nullptr, 16},
                                 {"translation", Kind::numbers, false, nullptr, 3},
                                 {"rotation", Kind::numbers, false, nullptr, 4},
                                 {"scale", Kind::numbers, false, nullptr, 3}};
constexpr Field kPrimitiveFields[] = {{"attributes", Kind::index_map, kRequired, "accessors"},
                                      {"indices", Kind::index, false, "accessors"},
                                      {"material", Kind::index, false, "materials"},
                                      {"mode", Kind::count}};
constexpr Shape kPrimitive{kPrimitiveFields};
constexpr Field kMeshFields[] = {
    {"primitives", Kind::object_list, kRequired, nullptr, 0, &kPrimitive}};
constexpr Field kAccessorFields[] = {{"bufferView", Kind::index, kRequired, "bufferViews"},
                                     {"byteOffset", Kind::count},
                                     {"componentType", Kind::count, kRequired},
                                     {"normalized", Kind::flag},
                                     {"count", Kind::count, kRequired},
                                     {"type", Kind::text, kRequired}};
constexpr Field kViewFields[] = {{"buffer", Kind::index, kRequired, "buffers"},
                                 {"byteOffset", Kind::count},
                                 {"byteLength", Kind::count, kRequired},
                                 {"byteStride", Kind::count}};
constexpr Field kBufferFields[] = {{"uri", Kind::text}, {"byteLength", Kind::count, kRequired}};
constexpr Field kTextureInfoFields[] = {{"index", Kind::index, kRequired, "textures"},
                                        {"texCoord", Kind::count}};
constexpr Shape kTextureInfo{kTextureInfoFields};
constexpr Field kPbrFields[] = {
    {"baseColorFactor", Kind::numbers, false, nullptr, 4},
    {"roughnessFactor", Kind::number},
    {"baseColorTexture", Kind::object, false, nullptr, 0, &kTextureInfo}};
constexpr Shape kPbr{kPbrFields};
constexpr Field kMaterialFields[] = {
    {"pbrMetallicRoughness", Kind::object, false, nullptr, 0, &kPbr}};
constexpr Field kTextureFields[] = {{"source", Kind::index, false, "images"}};
constexpr Field kImageFields[] = {{"uri", Kind::text},
                                  {"bufferView", Kind::index, false, "bufferViews"},
                                  {"mimeType", Kind::text}};

constexpr Shape kAsset{kAssetFields}, kScene{kSceneFields}, kNode{kNodeFields}, kMesh{kMeshFields},
    kAccessor{kAccessorFields}, kView{kViewFields}, kBuffer{kBufferFields},
    kMaterial{kMaterialFields}, kTexture{kTextureFields}, kImage{kImageFields};

constexpr Field kRootFields[] = {{"asset", Kind::object, kRequired, nullptr, 0, &kAsset},
                                 {"scene", Kind::index, false, "scenes"},
                                 {"scenes", Kind::object_list, false, nullptr, 0, &kScene},
                                 {"nodes", Kind::object_list, false, nullptr, 0, &kNode},
                                 {"meshes", Kind::object_list, kRequired, nullptr, 0, &kMesh},
                                 {"accessors", Kind::object_list, false, nullptr, 0, &kAccessor},
                                 {"bufferViews", Kind::object_list, false, nullptr, 0, &kView},
                                 {"buffers", Kind::object_list, false, nullptr, 0, &kBuffer},
                                 {"materials", Kind::object_list, false, nullptr, 0, &kMaterial},
                                 {"textures", Kind::object_list, false, nullptr, 0, &kTexture},
                                 {"images", Kind::object_list, false, nullptr, 0, &kImage}};
constexpr Shape kRoot{kRootFields};

// ---- copying it

/// Copies by shape; the first fault is kept as a sentence with the place where it is.
class Copier {
  public:
    explicit Copier(const json& root) : root_(root) {}

    // NOLINTNEXTLINE(misc-no-recursion): as deep as the shapes above, which are four
    json copy(const json& from, const Shape& shape, const std::string& place) {
        json to = json::object();
        if (!from.is_object()) {
            refuse(place + " is not an object");
            return to;
        }
        if (from.contains("sparse") && shape.fields.data() == kAccessorFields) {
            refuse(place + " is sparse, which is not supported");
        }
        for (const Field& field : shape.fields) {
            const auto found = from.find(field.name);
            const std::string inner_place = place.empty() ? field.name : place + "." + field.name;
            if (found == from.end()) {
                if (field.required) {
                    refuse(inner_place + " is missing");
                }
            } else if (refusal_.empty()) {
                to[field.name] = copy_field(*found, field, inner_place);
            }
        }
        return to;
    }

    [[nodiscard]] const std::string& refusal() const { return refusal_; }

  private:
    // NOLINTNEXTLINE(misc-no-recursion): as deep as the shapes above, which are four
    json copy_field(const json& value, const Field& field, const std::string& place) {
        switch (field.kind) {
            case Kind::index:
                return check_index(value, field.list, place);
            case Kind::index_list:
            case Kind::index_map:
                return copy_indices(value, field, place);
            case Kind::count:
                return value.is_number_unsigned() ? value
                                                  : refuse(place + " is not a whole number from 0");
            case Kind::flag:
                return value.is_boolean() ? value : refuse(place + " is not true or false");
            case Kind::text:
                return value.is_string() ? value : refuse(place + " is not a text");
            case Kind::number:
                return check_number(value, place);
            case Kind::numbers:
                return copy_numbers(value, field.size, place);
            case Kind::object:
                return copy(value, *field.inner, place);
            case Kind::object_list:
                return copy_objects(value, field, place);
        }
        return {};
    }

    json check_index(const json& value, const char* list, const std::string& place) {
        const auto found = root_.find(list);
        const std::size_t size = found != root_.end() && found->is_array() ? found->size() : 0;
        if (!value.is_number_unsigned() || value.get<std::uint64_t>() >= size) {
            return refuse(place + " points to none of the " + std::to_string(size) + " " + list);
        }
        return value;
    }

    json copy_indices(const json& value, const Field& field, const std::string& place) {
        const bool as_map = field.kind == Kind::index_map;
        if (as_map ? !value.is_object() : !value.is_array()) {
            return refuse(place + " is not a list");
        }
        for (const auto& [key, entry] : value.items()) {
            check_index(entry, field.list, place + "[" + key.substr(0, 40) + "]");
        }
        return value;
    }

    json check_number(const json& value, const std::string& place) {
        if (!value.is_number() || !std::isfinite(value.get<double>())) {
            return refuse(place + " is not a finite number");
        }
        return value;
    }

    json copy_numbers(const json& value, std::size_t size, const std::string& place) {
        if (!value.is_array() || value.size() != size) {
            return refuse(place + " does not hold " + std::to_string(size) + " numbers");
        }
        for (const json& entry : value) {
            check_number(entry, place);
        }
        return value;
    }

    // NOLINTNEXTLINE(misc-no-recursion): as deep as the shapes above, which are four
    json copy_objects(const json& value, const Field& field, const std::string& place) {
        if (!value.is_array() || (field.required && value.empty())) {
            return refuse(place + " is not a list with entries");
        }
        if (value.size() > kMaxItems) {
            return refuse(place + " has more than 10000 entries");
        }
        json list = json::array();
        for (std::size_t i = 0; i < value.size() && refusal_.empty(); ++i) {
            list.push_back(copy(value[i], *field.inner, place + "[" + std::to_string(i) + "]"));
        }
        return list;
    }

    json refuse(const std::string& why) {
        if (refusal_.empty()) {
            refusal_ = why;
        }
        return nullptr;
    }

    const json& root_;
    std::string refusal_;
};

/// A model that cannot be shown without an extension is refused; we have none.
Expected<void> check_extensions(const json& root) {
    const auto required = root.find("extensionsRequired");
    if (required == root.end() || (required->is_array() && required->empty())) {
        return {};
    }
    std::string name = "(not a list of names)";
    if (required->is_array() && (*required)[0].is_string()) {
        name = (*required)[0].get<std::string>().substr(0, 60);
    }
    return fail("it requires the extension " + name + ", which is not supported", {},
                "export the model without compression and extensions");
}

}  // namespace

Expected<json> read_document(std::string_view text) {
    const json root = json::parse(text, nullptr, false);
    if (root.is_discarded()) {
        return fail("it is not a glTF model: its text is not JSON", {}, kExportAgain);
    }
    if (!root.is_object()) {
        return fail("it is not a glTF model: its JSON is not an object", {}, kExportAgain);
    }
    if (auto extensions = check_extensions(root); !extensions) {
        return tl::unexpected(extensions.error());
    }
    Copier copier(root);
    json document = copier.copy(root, kRoot, "");
    if (!copier.refusal().empty()) {
        return fail(copier.refusal(), {}, kExportAgain);
    }
    const json& asset = document["asset"];
    if (asset["version"].get<std::string>().substr(0, 2) != "2." ||
        asset.value("minVersion", "2.0") != "2.0") {
        return fail("it is not glTF version 2", {}, kExportAgain);
    }
    return document;
}

}  // namespace fulcrum::runtime::gltf
