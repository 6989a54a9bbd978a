// What a body that can be touched is made of, in its own frame, centred on the body's origin. A round shape's axis is y.
//
// Thread: made at load, then read from any thread.
#pragma once

#include "haptics/base/error.h"
#include "haptics/math/spatial.h"

#include <cstddef>
#include <memory>
#include <variant>
#include <vector>

namespace fulcrum {

class CollisionMesh;     // collision_mesh.h
class DistanceFunction;  // distance_function.h
struct HeightField;      // haptics/geometry/height_field.h

struct SphereShape {
    double radius_m = 0.05;
};
struct BoxShape {
    Vector3 half_size_m{0.05, 0.05, 0.05};
};
/// All points within `radius_m` of the segment from -half_length to +half_length on the axis.
struct CapsuleShape {
    double radius_m = 0.02;
    double half_length_m = 0.05;
};
struct CylinderShape {
    double radius_m = 0.02;
    double half_height_m = 0.05;
};
using MeshShape = std::shared_ptr<const CollisionMesh>;

/// The hull of a cloud of points (haptics/geometry/convex_hull.h), as the mesh of its faces.
struct HullShape {
    MeshShape mesh;
};
/// A ground of heights over a rectangle (haptics/geometry/height_field.h), as the mesh of its cells; both faces are solid.
struct HeightFieldShape {
    MeshShape mesh;
};
struct DistanceShape {
    std::shared_ptr<const DistanceFunction> function;
};

/// Any of them.
using SolidShape = std::variant<MeshShape, SphereShape, BoxShape, CapsuleShape, CylinderShape,
                                HullShape, HeightFieldShape, DistanceShape>;

/// Refuses a cloud without thickness.
[[nodiscard]] Expected<HullShape> make_hull_shape(const std::vector<Vector3>& points_B);
/// Refuses what `make_height_field` does.
[[nodiscard]] Expected<HeightFieldShape> make_height_field_shape(const HeightField& field);

/// The mesh of a shape that is made of triangles; none for another.
[[nodiscard]] const MeshShape* find_mesh(const SolidShape& shape) noexcept;

/// Refuses a mesh or function that is not there, a function without bound or size, and sizes that are not between 1e-12 and 1e12 m (a capsule's length may be 0).
[[nodiscard]] Expected<void> validate(const SolidShape& shape);

/// With what it holds on the heap.
[[nodiscard]] std::size_t memory_bytes(const SolidShape& shape) noexcept;

}  // namespace fulcrum
