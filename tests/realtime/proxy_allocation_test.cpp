// No step of any proxy allocates: every cursor on every kind of body, two of them, moving.
#include "haptics/geometry/height_field.h"
#include "haptics/geometry/shape.h"
#include "haptics/point/god_object.h"
#include "haptics/point/make_proxy.h"
#include "tests/realtime/allocation_trap.h"
#include "tests/support/distance_bodies.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

namespace fulcrum {
namespace {

// A body of each kind that the cursor can touch, some 0.1 m in size.
std::vector<SolidShape> make_shapes(bool with_function) {
    std::vector<SolidShape> shapes{
        touchable(make_bumpy_sphere(0.1, 20, 0.003, 20.0)),
        SphereShape{0.1},
        BoxShape{{0.1, 0.08, 0.09}},
        CapsuleShape{0.05, 0.05},
        CylinderShape{0.08, 0.07},
        make_hull_shape({{-0.1, 0, 0}, {0.1, 0, 0}, {0, 0, 0.1}, {0, 0, -0.1}, {0, 0.1, 0}})
            .value(),
        make_height_field_shape({.width_m = 0.2,
                                 .depth_m = 0.2,
                                 .n_x = 9,
                                 .n_z = 9,
                                 .heights_m = std::vector<double>(81, 0.08)})
            .value()};
    if (with_function) {
        shapes.emplace_back(DistanceShape{std::make_shared<BallFunction>(0.1)});
    }
    return shapes;
}

// Steps a hand about two bodies of one shape that move, one from each side; counts what it allocates, and the touches.
std::uint64_t count_in_proxy(const ProxySettings& settings, const SolidShape& shape,
                             int& n_touching, int& n_between) {
    SolidPlan solid{.shape = shape, .friction = {0.4, 0.3, 0.5}};
    const auto proxy = make_proxy(settings, {solid, solid}, {{.stiffness_N_per_m = 500.0}, 0.001});
    proxy->reset({0.0, 0.3, 0.0});
    std::array<Pose, 2> poses;
    return count_allocations([&] {
        for (int k = 0; k < 2000; ++k) {
            const Quaternion turn(AngleAxis(0.001 * k, Vector3(0.6, 0.0, 0.8)));
            poses[0] = {Vector3(-0.09, 0.01 * std::sin(0.01 * k), 0.0), turn};
            poses[1] = {Vector3(0.09, 0.0, 0.01 * std::sin(0.007 * k)), Quaternion::Identity()};
            const Vector3 hand(0.12 * std::sin(0.011 * k), 0.14 + 0.16 * std::cos(0.005 * k),
                               0.05 * std::sin(0.017 * k));
            const ProxyContact& contact = proxy->step(hand, poses);
            n_touching += contact.n_constraints > 0 ? 1 : 0;
            n_between += contact.n_constraints > 1 ? 1 : 0;
        }
    });
}

TEST_CASE("no allocation: point, ball and convex cursors, with friction, on bodies of every kind") {
    const HullShape hull =
        make_hull_shape({{-0.02, 0, 0}, {0.02, 0, 0}, {0, 0, 0.02}, {0, -0.03, 0}, {0, 0.01, 0}})
            .value();
    const std::vector<CursorShape> cursors{
        std::monostate{},         SphereShape{0.01},         BoxShape{{0.01, 0.02, 0.015}},
        CapsuleShape{0.01, 0.02}, CylinderShape{0.01, 0.02}, hull};
    for (const CursorShape& cursor : cursors) {
        int n_between = 0;
        for (const SolidShape& shape : make_shapes(cursor.index() <= 1)) {
            INFO("cursor " << cursor.index() << ", body " << shape.index());
            int n_touching = 0;
            const ProxySettings settings{.kind = ProxyKind::friction_cone, .cursor = cursor};
            CHECK(count_in_proxy(settings, shape, n_touching, n_between) == 0);
            CHECK(n_touching > 100);
        }
        CHECK(n_between > 20);
    }
    for (const SegmentStructureKind structure :
         {SegmentStructureKind::h_collide, SegmentStructureKind::brute_force}) {
        int n_touching = 0;
        int n_between = 0;
        CHECK(count_in_proxy({.structure = structure}, make_shapes(false).front(), n_touching,
                             n_between) == 0);
        CHECK(n_touching > 100);
    }
}

TEST_CASE("no allocation: god object in free space, sliding, in corners, on moving bodies") {
    const auto mesh = touchable(make_bumpy_sphere(1.0, 40, 0.03, 20.0));
    const auto box = touchable(make_box(Vector3::Ones()));
    GodObject proxy({SolidPlan{.body = 0, .shape = mesh, .initial_pose_W = {}},
                     SolidPlan{.body = 1, .shape = box, .initial_pose_W = {}}});
    Random random(15);
    std::array<Pose, 2> poses;
    proxy.reset({0.0, 2.0, 0.0});
    int n_touching = 0;
    CHECK(count_allocations([&] {
              for (int i = 0; i < 20000; ++i) {
                  const Vector3 hand =
                      Vector3(0.0, 2.0 * std::cos(0.003 * i), 0.0) + 0.02 * random.vector();
                  poses[0] = {0.01 * random.vector(), random.turn(0.01) * poses[0].orientation};
                  poses[1] = {Vector3(1.1, 0.2 * std::sin(0.01 * i), 0.0),
                              random.turn(0.01) * poses[1].orientation};
                  n_touching += proxy.step(hand, poses).solid != kNoBody ? 1 : 0;
              }
          }) == 0);
    CHECK(n_touching > 1000);
    CHECK(n_touching < 20000);
}

}  // namespace
}  // namespace fulcrum
