// How far a point is from a sphere, a box, a capsule and a cylinder, in closed form; negative inside.
//
// With q the shape's nearest point: outside, gap = |p - q| and normal = (p - q) / |p - q|; inside, minus the least depth under a face.
// All of these are convex functions of p. `find_bend` is the way along a direction until p sees another part of the shape.
//
// Thread: any. Cost: some ten operations.
#pragma once

#include "haptics/collision/obstacle.h"
#include "haptics/collision/solid_shape.h"
#include "haptics/math/spatial.h"

namespace fulcrum {

[[nodiscard]] Gap find_gap(const SphereShape& sphere, const Vector3& p_B) noexcept;
[[nodiscard]] Gap find_gap(const BoxShape& box, const Vector3& p_B) noexcept;
[[nodiscard]] Gap find_gap(const CapsuleShape& capsule, const Vector3& p_B) noexcept;
[[nodiscard]] Gap find_gap(const CylinderShape& cylinder, const Vector3& p_B) noexcept;

[[nodiscard]] double find_bend(const SphereShape& sphere, const Vector3& p_B,
                               const Vector3& direction_B) noexcept;
[[nodiscard]] double find_bend(const BoxShape& box, const Vector3& p_B,
                               const Vector3& direction_B) noexcept;
[[nodiscard]] double find_bend(const CapsuleShape& capsule, const Vector3& p_B,
                               const Vector3& direction_B) noexcept;
[[nodiscard]] double find_bend(const CylinderShape& cylinder, const Vector3& p_B,
                               const Vector3& direction_B) noexcept;

/// The radius of the sphere round the origin that holds the shape.
[[nodiscard]] double bounding_radius_m(const SphereShape& sphere) noexcept;
[[nodiscard]] double bounding_radius_m(const BoxShape& box) noexcept;
[[nodiscard]] double bounding_radius_m(const CapsuleShape& capsule) noexcept;
[[nodiscard]] double bounding_radius_m(const CylinderShape& cylinder) noexcept;

}  // namespace fulcrum
