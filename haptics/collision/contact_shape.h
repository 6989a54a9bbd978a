// A convex shape made ready to meet others: its core, its faces, and which of them looks in a direction.
//
// Every shape is a core with a radius round it (convex_gap.h): sphere and capsule a point and a segment; box, cylinder and hull are
// their own core. A half space is all below the plane y = 0 of its frame: the ground. A mesh that need not be convex meets a half space
// as the hull round it, all else by samples (sampled_contacts.h). What of a core lies farthest in a direction is
// given as a `SupportFeature`: a face, a segment or a point, which holds the farthest point and spans what may touch beside it.
//   box       the face that looks most along the direction
//   cylinder  an end as a polygon of 16 corners where the direction is within 45 degrees of the axis, else the line of the side. An end
//             that is tilted has a corner at its farthest point, one that is not keeps its corners still in its own frame
//   hull      a face as the polygon of all corners in its plane
//
// Thread: made at load; a feature from any thread. Cost of a feature: 10 to 50 ns, for a hull one product a face; no allocation.
#pragma once

#include "haptics/collision/convex_gap.h"
#include "haptics/collision/solid_shape.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace fulcrum {

class SampledShape;  // sampled_shape.h

/// A hull's faces, each flat, its corners counter-clockwise as seen from outside.
struct HullFaces {
    struct Face {
        Vector3 normal_B{Vector3::UnitY()};  ///< unit, outwards
        std::uint32_t first = 0;             ///< of its corners
        std::uint32_t count = 0;             ///< 3 to kMostCorners
    };
    std::vector<Vector3> vertices_B;
    std::vector<Face> faces;
    std::vector<std::uint32_t> corners;
};

/// A face with more corners is met as one with every so manieth of them.
inline constexpr int kMostCorners = 32;

struct ContactShape {
    enum class Kind : std::uint8_t { half_space, sphere, capsule, box, cylinder, hull, mesh };
    Kind kind = Kind::half_space;
    ConvexCore core{};
    std::shared_ptr<const HullFaces> hull{};  ///< of a hull, and round a mesh
    /// Of a mesh, and of what meets one; null where nothing is a mesh.
    std::shared_ptr<const SampledShape> sampled{};
    double bounding_radius_m = 0.0;  ///< round the origin; 0 of a half space
};

/// Of a mesh the hull round it: what a half space meets. What else it meets needs it `sampled`, which is left to the caller. Refuses what
/// `validate` of a shape does, height fields and distance functions.
[[nodiscard]] Expected<ContactShape> make_contact_shape(const SolidShape& shape);
/// All below y = 0.
[[nodiscard]] ContactShape make_half_space() noexcept;

/// What of a core is farthest along a direction.
// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): written by find_feature
struct SupportFeature {
    std::array<Vector3, kMostCorners> corners_B;
    int count = 0;      ///< 1 a point, 2 a segment, more a face
    Vector3 normal_B;   ///< outwards; of a face alone
    std::int32_t face;  ///< 0 and up; -1 where it is none of the shape's flat faces
};

/// `direction_B` unit; not for half spaces.
void find_feature(const ContactShape& shape, const Vector3& direction_B,
                  SupportFeature& feature) noexcept;

/// The normal of the flat face that looks most along a direction, and which it is: -1 and no normal where there is none.
struct AlignedFace {
    Vector3 normal_B{Vector3::Zero()};
    std::int32_t face = -1;
};
[[nodiscard]] AlignedFace find_aligned_face(const ContactShape& shape,
                                            const Vector3& direction_B) noexcept;
/// The outward normal of a face that `find_aligned_face` named; zero for another number.
[[nodiscard]] Vector3 find_face_normal(const ContactShape& shape, std::int32_t face) noexcept;

}  // namespace fulcrum
