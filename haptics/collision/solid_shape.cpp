#include "haptics/collision/solid_shape.h"

#include "haptics/base/range.h"
#include "haptics/collision/collision_mesh.h"
#include "haptics/collision/distance_function.h"
#include "haptics/geometry/convex_hull.h"
#include "haptics/geometry/height_field.h"

namespace fulcrum {
namespace {

constexpr double kSmallest_m = 1.0e-12;
constexpr double kLargest_m = 1.0e12;

Expected<void> check(const MeshShape& mesh) {
    return mesh ? Expected<void>{} : fail("a solid has no mesh", {}, "give it one");
}
Expected<void> check(const SphereShape& sphere) {
    const Range ranges[] = {{"radius in metres", sphere.radius_m, kSmallest_m, kLargest_m}};
    return check_ranges("the sphere's", ranges);
}
Expected<void> check(const BoxShape& box) {
    const Range ranges[] = {
        {"half width in metres", box.half_size_m.x(), kSmallest_m, kLargest_m},
        {"half height in metres", box.half_size_m.y(), kSmallest_m, kLargest_m},
        {"half depth in metres", box.half_size_m.z(), kSmallest_m, kLargest_m},
    };
    return check_ranges("the box's", ranges);
}
Expected<void> check(const CapsuleShape& capsule) {
    const Range ranges[] = {
        {"radius in metres", capsule.radius_m, kSmallest_m, kLargest_m},
        {"half length in metres", capsule.half_length_m, 0.0, kLargest_m},
    };
    return check_ranges("the capsule's", ranges);
}
Expected<void> check(const CylinderShape& cylinder) {
    const Range ranges[] = {
        {"radius in metres", cylinder.radius_m, kSmallest_m, kLargest_m},
        {"half height in metres", cylinder.half_height_m, kSmallest_m, kLargest_m},
    };
    return check_ranges("the cylinder's", ranges);
}

Expected<void> check(const HullShape& hull) {
    return check(hull.mesh);
}
Expected<void> check(const HeightFieldShape& field) {
    return check(field.mesh);
}
Expected<void> check(const DistanceShape& shape) {
    const auto& function = shape.function;
    if (!function) {
        return fail("a solid has no distance function", {}, "give it one");
    }
    if (!function->centre_B().allFinite()) {
        return fail("the distance function's centre is not finite", {}, "give it one that is");
    }
    const Range ranges[] = {
        {"radius in metres", function->radius_m(), kSmallest_m, kLargest_m},
        {"Lipschitz bound", function->lipschitz(), kSmallest_m, kLargest_m},
    };
    return check_ranges("the distance function's", ranges);
}

Expected<MeshShape> make_touchable(const Expected<TriangleMesh>& mesh) {
    return mesh ? CollisionMesh::create(*mesh) : tl::make_unexpected(mesh.error());
}

}  // namespace

Expected<HullShape> make_hull_shape(const std::vector<Vector3>& points_B) {
    return make_touchable(make_convex_hull(points_B)).map([](const MeshShape& mesh) {
        return HullShape{mesh};
    });
}

Expected<HeightFieldShape> make_height_field_shape(const HeightField& field) {
    return make_touchable(make_height_field(field)).map([](const MeshShape& mesh) {
        return HeightFieldShape{mesh};
    });
}

const MeshShape* find_mesh(const SolidShape& shape) noexcept {
    if (const auto* hull = std::get_if<HullShape>(&shape)) {
        return &hull->mesh;
    }
    if (const auto* field = std::get_if<HeightFieldShape>(&shape)) {
        return &field->mesh;
    }
    return std::get_if<MeshShape>(&shape);
}

Expected<void> validate(const SolidShape& shape) {
    return std::visit([](const auto& solid) { return check(solid); }, shape);
}

std::size_t memory_bytes(const SolidShape& shape) noexcept {
    const MeshShape* mesh = find_mesh(shape);
    return sizeof(SolidShape) + (mesh != nullptr && *mesh ? (*mesh)->memory_bytes() : 0);
}

}  // namespace fulcrum
