// Writes a model as one .glb file: positions, normals, uvs, indices and PNG pictures, all embedded.
//
// Source: Khronos Group, glTF 2.0 Specification, 2021, sections 3.6, 3.7, 3.9 and 4.4.
#pragma once

#include "assets/make/mesh.h"

#include <cstdint>
#include <vector>

namespace fulcrum::assets {

/// The whole file; the same model always gives the same bytes.
[[nodiscard]] std::vector<std::uint8_t> encode_glb(const Model& model);

}  // namespace fulcrum::assets
