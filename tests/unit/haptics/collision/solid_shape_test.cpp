#include "haptics/collision/solid_shape.h"

#include "haptics/collision/collision_mesh.h"
#include "haptics/geometry/shape.h"
#include "tests/support/touchable.h"

#include <catch2/catch.hpp>

#include <limits>

namespace fulcrum {
namespace {

TEST_CASE("solid shape: sizes that are not finite and above zero are refused") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(validate(SphereShape{0.1}));
    CHECK_FALSE(validate(SphereShape{0.0}));
    CHECK_FALSE(validate(SphereShape{nan}));
    CHECK(validate(BoxShape{Vector3(0.1, 0.2, 0.3)}));
    for (int axis = 0; axis < 3; ++axis) {
        BoxShape flat{Vector3(0.1, 0.2, 0.3)};
        flat.half_size_m[axis] = 0.0;
        CHECK_FALSE(validate(flat));
    }
    CHECK(validate(CapsuleShape{0.1, 0.0}));
    CHECK_FALSE(validate(CapsuleShape{0.1, -0.1}));
    CHECK_FALSE(validate(CapsuleShape{-0.1, 0.1}));
    CHECK(validate(CylinderShape{0.1, 0.1}));
    CHECK_FALSE(validate(CylinderShape{0.1, 0.0}));
    CHECK_FALSE(validate(CylinderShape{1.0e13, 0.1}));
}

TEST_CASE("solid shape: a mesh must be there, and its memory counts") {
    CHECK_FALSE(validate(MeshShape{}));
    const MeshShape mesh = touchable(make_box(Vector3::Ones()));
    CHECK(validate(mesh));
    CHECK(memory_bytes(mesh) == sizeof(SolidShape) + mesh->memory_bytes());
    CHECK(memory_bytes(SphereShape{}) == sizeof(SolidShape));
}

}  // namespace
}  // namespace fulcrum
