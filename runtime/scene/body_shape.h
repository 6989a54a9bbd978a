// What a lesson may make of a body's model: a ball, a box, a cylinder or a capsule, each as large as the model reaches; its hull; or its
// mesh as it is.
//
// Thread: load path.
#pragma once

#include "haptics/base/error.h"
#include "haptics/collision/solid_shape.h"
#include "haptics/geometry/triangle_mesh.h"
#include "haptics/math/spatial.h"
#include "runtime/scene/description.h"

#include <string_view>

namespace fulcrum::runtime {

/// What a model is by its name: a ball, a box, a cylinder or a capsule; `model` of any other.
[[nodiscard]] BodyShape shape_of_model(std::string_view model) noexcept;

struct PlacedShape {
    SolidShape shape;
    Pose shape_B{};  ///< where it lies in the body; what is made of triangles lies where they are
};

/// What the hand feels, for any `kind` but `model`: where the model's middle is. A cylinder or capsule lies along the model's own axis
/// across which it is nearest to a square; along y unless another is clearly so.
[[nodiscard]] Expected<PlacedShape> make_felt_shape(BodyShape kind, const MeshShape& model);
/// What a rigid body collides as, for any `kind` but `model`: about the model's origin, and upright. Refuses a ball, cylinder or capsule
/// whose model's middle is not its origin; a box is the hull of its corners there.
[[nodiscard]] Expected<SolidShape> make_body_shape(BodyShape kind, const MeshShape& model);

/// The triangles of what is felt in closed form, with so many sides where it is round: a multiple of 4, 16 or more. Refuses other shapes.
[[nodiscard]] Expected<TriangleMesh> make_shape_triangles(const SolidShape& shape, int n_round);

/// A mesh of any shape, in the body's frame, for tools: of 11 520 triangles of a ball.
[[nodiscard]] Expected<MeshShape> make_shape_mesh(const SolidShape& shape,
                                                  const Pose& shape_B = {});

/// What the hand feels of a body, for people: "ball", "box", "capsule" or "cylinder" in closed form, or the "hull" or "mesh" of its
/// triangles; the model of a box is a "box" of twelve.
[[nodiscard]] std::string_view name_of_felt(const BodyDescription& body, const SolidShape& shape);

}  // namespace fulcrum::runtime
