// The document of a model, cut down to what we read: every field known, of the right type, every
// reference inside its list. Extras, extensions, animations, skins and cameras are dropped here, so
// that nobody after us meets them.
//
// Source: Khronos Group, glTF 2.0 Specification, 2021, section 5 (properties reference).
#pragma once

#include "haptics/base/error.h"

#include <nlohmann/json_fwd.hpp>
#include <string_view>

namespace fulcrum::runtime::gltf {

/// Parses JSON text (checked by check_json_text before) and hands back the clean copy.
[[nodiscard]] Expected<nlohmann::json> read_document(std::string_view text);

}  // namespace fulcrum::runtime::gltf
