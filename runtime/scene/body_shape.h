// What a lesson may make of a body's model: a ball, a box, or an upright cylinder or capsule round the model's own axis y, each as large
// as the model reaches; its hull; or its mesh as it is.
//
// Thread: load path.
#pragma once

#include "haptics/base/error.h"
#include "haptics/collision/solid_shape.h"
#include "haptics/geometry/triangle_mesh.h"
#include "runtime/scene/description.h"

#include <string_view>

namespace fulcrum::runtime {

/// Any `kind` but `model`. Refuses a ball, cylinder or capsule whose model's middle is not its origin; `field` is the lesson's word for the
/// shape. A box off the origin is the hull of its corners.
[[nodiscard]] Expected<SolidShape> make_body_shape(BodyShape kind, std::string_view field,
                                                   const MeshShape& model);

/// The triangles of what is felt in closed form, with so many sides where it is round: a multiple of 4, 16 or more. Refuses other shapes.
[[nodiscard]] Expected<TriangleMesh> make_shape_triangles(const SolidShape& shape, int n_round);

/// A mesh of any shape, for tools: of 11 520 triangles of a ball.
[[nodiscard]] Expected<MeshShape> make_shape_mesh(const SolidShape& shape);

/// "ball", "box", "capsule" or "cylinder" of what is felt in closed form; empty for what is made of triangles.
[[nodiscard]] std::string_view name_of_formula(const SolidShape& shape);

}  // namespace fulcrum::runtime
