// The colours of forces, as arrows and beside their words.
//
// Thread: constants.
#pragma once

#include "runtime/render/theme.h"
#include "runtime/scene/view.h"

namespace fulcrum::runtime {

[[nodiscard]] constexpr Colour colour_of(ForceLook look) noexcept {
    constexpr std::array<Colour, kForceLooks> kColours{theme::kForceArrow, theme::kLoadArrow,
                                                       theme::kLiftArrow, theme::kDragArrow};
    return kColours[static_cast<std::size_t>(look)];
}

}  // namespace fulcrum::runtime
