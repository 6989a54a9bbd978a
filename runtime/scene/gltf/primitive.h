// One primitive of a mesh, brought into model space: positions, unit normals, uvs, indices.
//
//   p_M = X_MN p_N,   n_M = (X_MN's 3x3 part)^-T n_N, then unit;   a mirroring transform turns
//   triangles around
//
// Where normals are missing or have no length, triangles get flat ones, each its own corners.
#pragma once

#include "haptics/base/error.h"
#include "haptics/math/matrix.h"
#include "runtime/scene/gltf/limits.h"
#include "runtime/scene/model.h"

#include <string>

namespace tinygltf {
class Model;
struct Primitive;
}  // namespace tinygltf

namespace fulcrum::runtime::gltf {

/// Checks and copies; `place` begins every message. Refuses what is not triangles, an index past
/// the corners, a number that is not finite, a corner beyond kMaxExtent_m, and more corners than
/// the budget has room for.
[[nodiscard]] Expected<ModelPrimitive> read_primitive(const tinygltf::Model& model,
                                                      const tinygltf::Primitive& primitive,
                                                      const Matrix4& transform_MN,
                                                      const std::string& place,
                                                      MemoryBudget& budget);

}  // namespace fulcrum::runtime::gltf
