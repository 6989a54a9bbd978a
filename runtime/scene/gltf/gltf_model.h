// Loads a glTF 2.0 model (.glb or .gltf) that nobody has vouched for.
//
//   bytes -> container -> JSON text (depth, counts) -> document (uris, sizes, views, extensions) ->
//   tinygltf
//         -> model (accessors, indices, nodes, numbers) -> flattened LoadedModel
//
// Each step refuses with one sentence before the next one sees the bytes, so tinygltf only ever
// reads what was checked: limits.h has every limit. Triangles only; skins, animations, cameras,
// lights and extras are left out.
//
// Thread: any; no shared state. Cost: linear in the file and its pictures; memory bounded by
// kMaxModelMemory_bytes. Source: Khronos Group, glTF 2.0 Specification, 2021, sections 3.4 to 3.9
// and 4.
#pragma once

#include "haptics/base/error.h"
#include "runtime/scene/model.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace fulcrum::runtime {

/// Reads a model file. Buffers and pictures may be embedded or lie as plain file names in the
/// model's own folder. Anything else, and anything malformed, is an error that names the file.
/// Throws nothing.
[[nodiscard]] Expected<LoadedModel> load_gltf(const std::filesystem::path& path);

/// Reads a model from memory; `where` names it in errors. Only embedded buffers and pictures are
/// accepted.
[[nodiscard]] Expected<LoadedModel> read_gltf(std::span<const std::byte> bytes, std::string where);

}  // namespace fulcrum::runtime
