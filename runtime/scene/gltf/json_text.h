// Looks at JSON text before any parser does: how deep it nests and how many values it has. One
// pass, no recursion, no memory. Whether it is JSON at all is left to the parser.
#pragma once

#include "haptics/base/error.h"

#include <string_view>

namespace fulcrum::runtime::gltf {

/// Refuses text nested deeper than kMaxJsonDepth or with more than kMaxJsonValues values.
[[nodiscard]] Expected<void> check_json_text(std::string_view text);

}  // namespace fulcrum::runtime::gltf
