// A checked window onto one accessor's numbers. Only what `view_accessor` let through is ever read.
//
// Source: Khronos Group, glTF 2.0 Specification, 2021, sections 3.6.2.2 to 3.6.2.5.
#pragma once

#include "haptics/base/error.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace tinygltf {
class Model;
}

namespace fulcrum::runtime::gltf {

/// What an accessor is used for; decides its type and component types.
enum class AccessorRole { positions, normals, uvs, indices };

struct AccessorView {
    std::span<const std::uint8_t> bytes;  ///< from the first element to the end of the buffer view
    std::size_t count = 0;                ///< elements, at least 1
    std::size_t stride_bytes = 0;
    int component_type = 0;  ///< as in the file, e.g. 5126 for float

    /// A number of element `i`; normalised integers come out as 0 to 1.
    [[nodiscard]] float number(std::size_t i, std::size_t component) const noexcept;
    /// An index, element `i`.
    [[nodiscard]] std::uint32_t index(std::size_t i) const noexcept;
};

/// Checks type, component type, count, stride, offset and range of accessor `index`; `place` begins
/// the message.
[[nodiscard]] Expected<AccessorView> view_accessor(const tinygltf::Model& model, int index,
                                                   AccessorRole role, const std::string& place);

}  // namespace fulcrum::runtime::gltf
