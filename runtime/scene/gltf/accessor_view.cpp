#include "runtime/scene/gltf/accessor_view.h"

#include "runtime/scene/gltf/limits.h"

#include <tiny_gltf.h>

#include <cstring>

namespace fulcrum::runtime::gltf {
namespace {

template <class T>
T read_as(std::span<const std::uint8_t> bytes, std::size_t at) {
    T value;
    std::memcpy(&value, bytes.data() + at, sizeof(T));
    return value;
}

std::size_t component_bytes(int type) {
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return 1;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return 2;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        case TINYGLTF_COMPONENT_TYPE_FLOAT:
            return 4;
        default:
            return 0;  // no role allows it
    }
}

/// Section 3.7.2.1, the table of attributes: which types a role may have.
bool type_allowed(const tinygltf::Accessor& accessor, AccessorRole role) {
    const int component = accessor.componentType;
    const bool is_float = component == TINYGLTF_COMPONENT_TYPE_FLOAT;
    const bool is_small = component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                          component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
    switch (role) {
        case AccessorRole::positions:
        case AccessorRole::normals:
            return accessor.type == TINYGLTF_TYPE_VEC3 && is_float;
        case AccessorRole::uvs:
            return accessor.type == TINYGLTF_TYPE_VEC2 &&
                   (is_float || (is_small && accessor.normalized));
        case AccessorRole::indices:
            return accessor.type == TINYGLTF_TYPE_SCALAR && !accessor.normalized &&
                   (is_small || component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT);
    }
    return false;
}

std::size_t components_of(AccessorRole role) {
    return role == AccessorRole::indices ? 1 : role == AccessorRole::uvs ? 2 : 3;
}

template <class List>
bool has(const List& list, int index) {
    return index >= 0 && static_cast<std::size_t>(index) < list.size();
}

}  // namespace

float AccessorView::number(std::size_t i, std::size_t component) const noexcept {
    const std::size_t at = i * stride_bytes;
    switch (component_type) {
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return static_cast<float>(bytes[at + component]) / 255.0F;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return static_cast<float>(read_as<std::uint16_t>(bytes, at + 2 * component)) / 65535.0F;
        default:
            return read_as<float>(bytes, at + 4 * component);
    }
}

std::uint32_t AccessorView::index(std::size_t i) const noexcept {
    const std::size_t at = i * stride_bytes;
    switch (component_type) {
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return bytes[at];
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return read_as<std::uint16_t>(bytes, at);
        default:
            return read_as<std::uint32_t>(bytes, at);
    }
}

Expected<AccessorView> view_accessor(const tinygltf::Model& model, int index, AccessorRole role,
                                     const std::string& place) {
    const auto refuse = [&](const char* why) { return fail(place + " " + why, {}, kExportAgain); };
    if (!has(model.accessors, index)) {
        return refuse("points to no accessor");
    }
    const auto& accessor = model.accessors[static_cast<std::size_t>(index)];
    if (!type_allowed(accessor, role)) {
        return refuse("has a type that is not allowed there");
    }
    if (accessor.sparse.isSparse || !has(model.bufferViews, accessor.bufferView)) {
        return refuse("has no data");
    }
    const auto& view = model.bufferViews[static_cast<std::size_t>(accessor.bufferView)];
    if (!has(model.buffers, view.buffer)) {
        return refuse("has no buffer");
    }
    const auto& data = model.buffers[static_cast<std::size_t>(view.buffer)].data;
    if (view.byteOffset > data.size() || view.byteLength > data.size() - view.byteOffset) {
        return refuse("reaches past its buffer");
    }
    if (accessor.count == 0 || accessor.count > kMaxCorners) {
        return refuse("does not have 1 to 3000000 elements");
    }

    // The last element must end inside the view; every product below is far from overflowing.
    const std::size_t component = component_bytes(accessor.componentType);
    const std::size_t element = component * components_of(role);
    const std::size_t stride = view.byteStride == 0 ? element : view.byteStride;
    if (stride < element || (role == AccessorRole::indices && view.byteStride != 0)) {
        return refuse("has a byteStride that does not fit its type");
    }
    if (accessor.byteOffset % component != 0 || view.byteOffset % component != 0) {
        return refuse("is not aligned to its component type");
    }
    const std::size_t needed = (accessor.count - 1) * stride + element;
    if (accessor.byteOffset > view.byteLength || needed > view.byteLength - accessor.byteOffset) {
        return refuse("reaches past its buffer view");
    }
    const std::span<const std::uint8_t> bytes(data);
    return AccessorView{bytes.subspan(view.byteOffset + accessor.byteOffset, needed),
                        accessor.count, stride, accessor.componentType};
}

}  // namespace fulcrum::runtime::gltf
