// What a kite, its line and the wind are drawn with: made by rule, from the kite's own sheets.
//
// Thread: any. Cost: a few thousand corners.
#pragma once

#include "haptics/flight/kite.h"
#include "runtime/scene/model.h"

#include <vector>

namespace fulcrum::runtime {

/// The kite in its design frame (kite.h), metres, and under the names of shape_models.h a bar of its line, a piece of its tail, a
/// wisp of the wind, all of length and radius 1 along y, and the reel. Takes settings that `validate` accepted.
[[nodiscard]] std::vector<LoadedModel> make_kite_models(const KiteSettings& design);

}  // namespace fulcrum::runtime
