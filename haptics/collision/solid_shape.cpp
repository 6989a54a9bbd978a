#include "haptics/collision/solid_shape.h"

#include "haptics/base/range.h"
#include "haptics/collision/collision_mesh.h"

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

}  // namespace

Expected<void> validate(const SolidShape& shape) {
    return std::visit([](const auto& solid) { return check(solid); }, shape);
}

std::size_t memory_bytes(const SolidShape& shape) noexcept {
    const auto* mesh = std::get_if<MeshShape>(&shape);
    return sizeof(SolidShape) + (mesh != nullptr && *mesh ? (*mesh)->memory_bytes() : 0);
}

}  // namespace fulcrum
