// A place on a body that turns: where its hinge is, where its load hangs.
//
// Thread: that of the lesson's process.
#pragma once

#include "haptics/math/spatial.h"
#include "runtime/scene/description.h"

struct lua_State;

namespace fulcrum::runtime {

/// The place from where the body is declared, metres; raises where it is farther away than kFarthestOnAxle_m. `what` is
/// there: "hinge", "load".
[[nodiscard]] Vector3 place_on_hinge(lua_State* lua, const BodyDescription& body, const char* what,
                                     const Vector3& place_W);

}  // namespace fulcrum::runtime
