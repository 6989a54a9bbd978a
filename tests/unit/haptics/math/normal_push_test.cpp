#include "haptics/math/wrench_jacobian.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

namespace fulcrum {
namespace {

struct Added {
    Wrench wrench{};
    WrenchJacobian slopes{};
};

double find_largest_difference(const Added& a, const Added& b) {
    return std::max(
        {(a.wrench.force - b.wrench.force).norm(), (a.wrench.torque - b.wrench.torque).norm(),
         (a.slopes.pose - b.slopes.pose).norm(), (a.slopes.velocity - b.slopes.velocity).norm()});
}

// As a force of which all three axes are told.
void add_at_length(const Vector3& arm, const Vector3& spin, const Vector3& normal,
                   const NormalPush& push, Added& added) {
    const Matrix3 along = normal * normal.transpose();
    add_point_force(
        arm, spin,
        {push.push_N * normal, -push.by_depth_N_per_m * along, -push.by_sinking_Ns_per_m * along},
        added.wrench, added.slopes);
}

TEST_CASE("normal push: it adds what a force of any direction adds there") {
    Random random(11);
    for (int i = 0; i < 200; ++i) {
        const Vector3 arm = random.vector();
        const Vector3 spin = random.vector();
        const Vector3 normal = random.vector().normalized();
        const NormalPush push{random.uniform(), random.uniform(),
                              i % 2 == 0 ? 0.0 : random.uniform()};
        // On top of what stands there already.
        Added short_way;
        short_way.slopes.pose.setConstant(0.25);
        short_way.slopes.velocity.setConstant(-0.5);
        Added long_way = short_way;
        add_normal_push(arm, spin, normal, push, short_way.wrench, short_way.slopes);
        add_at_length(arm, spin, normal, push, long_way);
        CHECK(find_largest_difference(short_way, long_way) < 1.0e-13);
    }
}

TEST_CASE("normal push: at the origin it turns nothing") {
    Added added;
    add_normal_push(Vector3::Zero(), {1.0, 2.0, 3.0}, Vector3::UnitY(), {2.0, 5.0, 0.5},
                    added.wrench, added.slopes);
    Matrix6 by_place = Matrix6::Zero();
    by_place(1, 1) = -5.0;
    CHECK(added.wrench.torque == Vector3(0.0, 0.0, 0.0));
    CHECK(added.slopes.pose == by_place);
    CHECK(added.slopes.velocity == Matrix6(0.1 * by_place));
}

}  // namespace
}  // namespace fulcrum
