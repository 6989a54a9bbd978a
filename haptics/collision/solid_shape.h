// What a body that can be touched is made of, in its own frame, centred on the body's origin. A round shape's axis is y.
//
// Thread: made at load, then read from any thread.
#pragma once

#include "haptics/base/error.h"
#include "haptics/math/spatial.h"

#include <cstddef>
#include <memory>
#include <variant>

namespace fulcrum {

class CollisionMesh;  // collision_mesh.h

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

/// Any of them.
using SolidShape = std::variant<MeshShape, SphereShape, BoxShape, CapsuleShape, CylinderShape>;

/// Refuses a mesh that is not there, and sizes that are not between 1e-12 and 1e12 m (a capsule's length may be 0).
[[nodiscard]] Expected<void> validate(const SolidShape& shape);

/// With what it holds on the heap.
[[nodiscard]] std::size_t memory_bytes(const SolidShape& shape) noexcept;

}  // namespace fulcrum
