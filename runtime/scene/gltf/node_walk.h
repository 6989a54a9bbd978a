// Which meshes a model shows, and where: walks the nodes of its scene once, without recursion.
//
//   X_MN = X_MP * X_PN      model from node = model from parent * parent from node; column vectors,
//   metres
//
// Source: Khronos Group, glTF 2.0 Specification, 2021, sections 3.5.2 and 3.5.3.
#pragma once

#include "haptics/base/error.h"
#include "haptics/math/matrix.h"

#include <vector>

namespace tinygltf {
class Model;
}

namespace fulcrum::runtime::gltf {

/// A mesh and the transform that brings it into model space.
struct PlacedMesh {
    std::size_t mesh = 0;
    Matrix4 X_MN = Matrix4::Identity();  ///< affine, invertible, finite
};

/// Refuses cycles, a node with two parents, more than kMaxNodeDepth levels, and a transform that is
/// singular or not finite. A model without scenes shows all its root nodes.
[[nodiscard]] Expected<std::vector<PlacedMesh>> place_meshes(const tinygltf::Model& model);

}  // namespace fulcrum::runtime::gltf
