// The bytes that a document refers to: gathers buffers and pictures by our own rules, gives each a
// name of our own, and checks that every buffer view lies inside its buffer. After this no path,
// uri or size from the file is used again.
#pragma once

#include "haptics/base/error.h"
#include "runtime/scene/gltf/limits.h"
#include "runtime/scene/gltf/model_files.h"

#include <cstddef>
#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>

namespace fulcrum::runtime::gltf {

/// Bytes by the name that the document now knows them by ("buffer0", "image2").
using ResourceMap = std::map<std::string, Bytes>;

/// Where a document's bytes may come from.
struct ResourceOrigin {
    std::span<const std::byte> binary;            ///< of a GLB; the first buffer may use it
    std::optional<std::filesystem::path> folder;  ///< the model's own; none refuses every file
};

/// Gathers and checks; rewrites the uris of `document`. Data uris stay where they are.
[[nodiscard]] Expected<ResourceMap> gather_resources(nlohmann::json& document,
                                                     const ResourceOrigin& origin,
                                                     MemoryBudget& budget);

}  // namespace fulcrum::runtime::gltf
