// The materials that come with the program. Where each number is from stands beside it (materials.cpp); "chosen" says why.
//
// Thread: load.
#pragma once

#include "haptics/surface/material.h"

#include <span>
#include <string_view>

namespace fulcrum {

/// Wood, metal, rock, rubber, glass, paper, sandpaper.
[[nodiscard]] std::span<const Material> shipped_materials();

/// By its name; null when there is none of that name.
[[nodiscard]] const Material* find_material(std::string_view name);

}  // namespace fulcrum
