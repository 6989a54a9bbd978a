// The triangles of a model as something that can be touched.
//
// Thread: load. Cost: O(corners).
#pragma once

#include "haptics/base/error.h"
#include "haptics/geometry/triangle_mesh.h"
#include "runtime/scene/model.h"

namespace fulcrum::runtime {

/// All primitives as one mesh in model space, corners that coincide welded. Refuses what TriangleMesh refuses: a model of
/// which no triangle has an area. `where` names the model in the error.
[[nodiscard]] Expected<TriangleMesh> collision_from_model(const LoadedModel& model,
                                                          const std::string& where = {});

}  // namespace fulcrum::runtime
