// Splits a model file into its JSON text and its binary part, for .glb and .gltf alike.
//
// Source: Khronos Group, glTF 2.0 Specification, 2021, section 4.4 (GLB).
#pragma once

#include "haptics/base/error.h"

#include <cstddef>
#include <span>
#include <string_view>

namespace fulcrum::runtime::gltf {

/// Views into the file's bytes, valid as long as these.
struct Container {
    std::string_view json;
    std::span<const std::byte> binary;  ///< the GLB's binary chunk, empty when there is none
};

/// Refuses a file that is empty, too large, of another version, or whose chunks do not add up.
[[nodiscard]] Expected<Container> split_container(std::span<const std::byte> file);

}  // namespace fulcrum::runtime::gltf
