// How planets are painted, for models that show one.
#pragma once

#include "assets/make/mesh.h"

namespace fulcrum::assets {

/// The Earth's colour at a place of the unit ball: +Y the north pole, Greenwich towards +x.
[[nodiscard]] Colour paint_earth(const Vector3& p);

}  // namespace fulcrum::assets
