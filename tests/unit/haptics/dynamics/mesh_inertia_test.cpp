// Mass and moments: of meshes (mesh_inertia.h), of shapes (shape_inertia.h), and of a state that moves (rigid_state.h).
#include "haptics/dynamics/mesh_inertia.h"

#include "haptics/dynamics/integrator.h"
#include "haptics/dynamics/rigid_state.h"
#include "haptics/dynamics/shape_inertia.h"
#include "haptics/geometry/shape.h"
#include "haptics/math/rotation.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/distance_bodies.h"
#include "tests/support/edited_meshes.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/hollow_meshes.h"
#include "tests/support/refused.h"
#include "tests/support/told.h"
#include "tests/support/touchable.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

namespace fulcrum {
namespace {

constexpr double kSteel_kg_per_m3 = 7850.0;
// Of samples: one in each of 64^3 cubes, of which some thousands are cut by the surface.
constexpr double kSampledMass = 0.003;
constexpr double kSampledMoment = 0.005;

// By integrals exactly, by samples as nearly as they are.
void check_inertia(const TriangleMesh& mesh, InertiaRule rule, double mass_kg,
                   const Vector3& moments) {
    const auto found = compute_inertia(mesh, 1000.0);
    REQUIRE(found);
    const bool is_exact = rule == InertiaRule::integrals;
    CHECK(found->rule == rule);
    CHECK(found->inertia.mass_kg == Approx(mass_kg).epsilon(is_exact ? 1.0e-12 : kSampledMass));
    CHECK((found->inertia.moments_kg_m2 - moments).norm() <
          (is_exact ? 1.0e-12 : kSampledMoment) * moments.norm());
}

TEST_CASE("mesh inertia: a box has the inertia of a box, exactly, and its principal axes") {
    const Vector3 edges(0.3, 0.2, 0.1);
    const auto found = compute_inertia(*make_box(edges), kSteel_kg_per_m3);
    REQUIRE(found);
    const Inertia box = make_box_inertia(kSteel_kg_per_m3 * edges.prod(), edges);
    CHECK(found->rule == InertiaRule::integrals);
    CHECK(to_string(found->rule) == "integrals");
    CHECK(found->inertia.mass_kg == Approx(box.mass_kg).epsilon(1.0e-12));
    CHECK(found->inertia.moments_kg_m2.isApprox(box.moments_kg_m2, 1.0e-12));
    CHECK(found->inertia_B.isApprox(Matrix3(box.moments_kg_m2.asDiagonal()), 1.0e-12));
    CHECK(found->volume_m3 == Approx(edges.prod()).epsilon(1.0e-12));
    CHECK(found->X_BP.position.norm() < 1.0e-14);
    CHECK(found->X_BP.orientation.isApprox(Quaternion::Identity()));
    // The mass alone gives the same.
    const auto by_mass = fill_with_mass(*measure_solid(*make_box(edges)), box.mass_kg);
    REQUIRE(by_mass);
    CHECK(by_mass->inertia.mass_kg == Approx(box.mass_kg).epsilon(1.0e-12));
    CHECK(by_mass->inertia.moments_kg_m2.isApprox(box.moments_kg_m2, 1.0e-12));
}

TEST_CASE("mesh inertia: turned and moved, its principal frame turns and moves with it") {
    const TriangleMesh mesh = *make_box(Vector3(0.3, 0.2, 0.1));
    const Inertia box = make_box_inertia(2.0, Vector3(0.3, 0.2, 0.1));
    Random random(2);
    for (int i = 0; i < 10; ++i) {
        const Pose X_WB{random.vector(), random.turn(3.0)};
        const TriangleMesh placed = ::fulcrum::test::move_corners(
            mesh, [&](const Vector3& v) { return Vector3(X_WB * v); });
        const auto found = fill_with_mass(*measure_solid(placed), 2.0);
        REQUIRE(found);
        CHECK(found->inertia.moments_kg_m2.isApprox(box.moments_kg_m2, 1.0e-10));
        CHECK(found->X_BP.position.isApprox(X_WB.position, 1.0e-12));
        CHECK(compute_inertia_W(found->inertia, found->X_BP.orientation)
                  .isApprox(compute_inertia_W(box, X_WB.orientation), 1.0e-9));
        CHECK(found->inertia_B.isApprox(compute_inertia_W(box, X_WB.orientation), 1.0e-9));
    }
}

TEST_CASE("mesh inertia: inside out it is the same; a hollow takes what it would have itself") {
    const TriangleMesh outer = *make_box(Vector3::Constant(0.4));
    const Vector3 full = make_box_inertia(64.0, Vector3::Constant(0.4)).moments_kg_m2;
    const Vector3 lacking = make_box_inertia(8.0, Vector3::Constant(0.2)).moments_kg_m2;
    check_inertia(*make_inverted(outer), InertiaRule::integrals, 64.0, full);
    check_inertia(*make_hollow(outer, *make_box(Vector3::Constant(0.2))), InertiaRule::integrals,
                  64.0 - 8.0, full - lacking);
}

TEST_CASE("mesh inertia: open, overlapping, nested and partly inverted meshes are sampled") {
    const TriangleMesh box = *make_box(Vector3(0.4, 0.4, 0.4));
    const Vector3 cube = make_box_inertia(64.0, Vector3::Constant(0.4)).moments_kg_m2;
    const auto check = [](const TriangleMesh& mesh, double mass_kg, const Vector3& moments) {
        check_inertia(mesh, InertiaRule::samples, mass_kg, moments);
    };
    SECTION("a cube that lacks one triangle") {
        std::vector<TriangleCorners> triangles = box.triangles();
        triangles.pop_back();
        const auto found =
            compute_inertia(*TriangleMesh::build(box.vertices_B(), std::move(triangles)), 1000.0);
        REQUIRE(found);
        CHECK(found->rule == InertiaRule::samples);
        // Half seen through the hole counts as out: some of the corner is lost.
        CHECK(found->inertia.mass_kg == Approx(64.0).epsilon(0.05));
    }
    SECTION("a cube of loose triangles, each twice") {
        check(*make_messy(box, 0.0), 64.0, cube);
    }
    SECTION("two cubes that overlap by half are one body of three halves") {
        const Vector3 edges(0.6, 0.4, 0.4);
        check(*make_both(box, box, Vector3(0.2, 0.0, 0.0)), 96.0,
              make_box_inertia(96.0, edges).moments_kg_m2);
    }
    SECTION("a cube in a cube weighs nothing more") {
        check(*make_both(box, *make_box(Vector3::Constant(0.2)), Vector3::Zero()), 64.0, cube);
    }
    SECTION("two cubes apart, one inside out") {
        const double apart_m = 0.8;
        const Vector3 both = 2.0 * cube + 2.0 * 64.0 * 0.25 * apart_m * apart_m * Vector3(0, 1, 1);
        check(*make_both(box, *make_inverted(box), Vector3(apart_m, 0.0, 0.0)), 128.0, both);
    }
    SECTION("a ball with its seam open") {
        const double mass = 1000.0 * 4.0 / 3.0 * std::numbers::pi * 0.001;
        check(*make_cracked(*make_sphere(0.1, 24), 1.0e-4, 1, 0.0), mass,
              make_ball_inertia(mass, 0.1).moments_kg_m2);
    }
}

TEST_CASE("mesh inertia: measured once a mesh has any mass; measuring tells, and can be stopped") {
    const TriangleMesh ball = *make_sphere(0.1, 24);
    const TriangleMesh cracked = *make_cracked(ball, 1.0e-4, 1, 0.0);
    for (const bool broken : {false, true}) {
        const TriangleMesh& mesh = broken ? cracked : ball;
        const auto solid = measure_solid(mesh);
        REQUIRE(solid);
        CHECK(solid->by_samples == broken);
        for (const double mass_kg : {0.1, 3.0}) {
            const auto filled = fill_with_mass(*solid, mass_kg);
            const auto found = compute_inertia(mesh, mass_kg / solid->moments.volume_m3);
            REQUIRE(filled);
            CHECK(filled->inertia.moments_kg_m2 == found->inertia.moments_kg_m2);
            CHECK(filled->X_BP.position == found->X_BP.position);
            CHECK(filled->rule == found->rule);
        }
        int n_told = 0;
        const auto stopped = measure_solid(mesh, "ball.obj", [&](double share) {
            CHECK(share <= 1.0);
            return ++n_told < 3;
        });
        REQUIRE_FALSE(stopped);
        CHECK(n_told == 3);
        CHECK(to_sentence(stopped.error()) ==
              "ball.obj: the mass was stopped before it was found; find it again.");
    }
}

TEST_CASE("mesh inertia: what encloses nothing or weighs what no body weighs is refused") {
    const TriangleMesh box = *make_box(Vector3::Constant(0.1));
    for (const double bad : {0.0, -1.0, std::nan(""), kInfinity}) {
        CHECK_FALSE(compute_inertia(box, bad));
        CHECK_FALSE(fill_with_mass(*measure_solid(box), bad));
    }
    const TriangleMesh plate = *make_plate(0.1, 0.1, 4);
    CHECK(refusal_of(compute_inertia(plate, 1000.0, "sheet.obj")) ==
          "sheet.obj: the mesh encloses nothing, so it has no mass; close its holes, or give mass "
          "and moments of inertia as numbers.");
    CHECK_FALSE(compute_inertia(*make_hollow(plate, plate), 1000.0));
    // Too light for any integrator: 1e-9 kg.
    CHECK(refusal_of(compute_inertia(*make_box(Vector3::Constant(1.0e-4)), 1.0, "speck.obj"))
              .find("speck.obj: the body's mass_kg is 1e-12") == 0);
    CHECK_FALSE(compute_inertia(*make_box(Vector3::Constant(1.0e14)), 1.0));
}

// A round shape's mesh lies inside it: off by the square of the angle between its sides.
constexpr double kFacets = 2.0e-3;

void compare(const SolidShape& shape, const Expected<TriangleMesh>& mesh, double within) {
    const MeshInertia exact = compute_shape_inertia(shape, 700.0).value();
    const MeshInertia meshed = compute_inertia(mesh.value(), 700.0).value();
    CHECK(exact.volume_m3 == Approx(meshed.volume_m3).epsilon(within));
    CHECK(exact.inertia.mass_kg == Approx(700.0 * exact.volume_m3));
    for (int axis = 0; axis < 3; ++axis) {
        CHECK(exact.inertia_B(axis, axis) == Approx(meshed.inertia_B(axis, axis)).epsilon(within));
        CHECK(exact.inertia.moments_kg_m2[axis] == exact.inertia_B(axis, axis));
    }
    CHECK(exact.X_BP.position == Vector3::Zero());
}

TEST_CASE("shape inertia: closed forms are a fine mesh's integrals; hulls have axes of their own") {
    compare(BoxShape{{0.1, 0.2, 0.3}}, make_box({0.2, 0.4, 0.6}), 1.0e-12);
    compare(SphereShape{0.1}, make_sphere(0.1, 40), kFacets);
    compare(CylinderShape{0.1, 0.3}, make_cylinder(0.1, 0.6, 200), kFacets);
    compare(CapsuleShape{0.1, 0.2}, make_capsule(0.1, 0.4, 200, 60), kFacets);
    const auto capsule = compute_shape_inertia(CapsuleShape{0.1, 0.0}, 500.0).value();
    const auto ball = compute_shape_inertia(SphereShape{0.1}, 500.0).value();
    CHECK((capsule.inertia.moments_kg_m2 - ball.inertia.moments_kg_m2).norm() < 1.0e-15);
    const auto heavy = compute_shape_inertia_of_mass(BoxShape{{0.1, 0.2, 0.3}}, 12.0).value();
    CHECK(heavy.inertia.mass_kg == Approx(12.0));
    CHECK(heavy.inertia.moments_kg_m2.x() == Approx(12.0 / 3.0 * (0.04 + 0.09)));
    std::vector<Vector3> corners;
    for (int i = 0; i < 8; ++i) {
        corners.emplace_back(i & 1 ? 0.3 : 0.1, i & 2 ? 0.2 : -0.2, i & 4 ? 0.1 : -0.1);
    }
    const auto hull = compute_shape_inertia_of_mass(make_hull_shape(corners).value(), 3.0).value();
    CHECK((hull.X_BP.position - Vector3(0.2, 0.0, 0.0)).norm() < 1.0e-12);
    CHECK(hull.inertia.mass_kg == Approx(3.0));
    const auto box = make_box_inertia(3.0, {0.2, 0.4, 0.2});
    CHECK(hull.inertia_B(1, 1) == Approx(box.moments_kg_m2.y()));
    const auto mesh = compute_shape_inertia(touchable(make_box({0.2, 0.4, 0.6})), 100.0).value();
    CHECK(mesh.inertia.mass_kg == Approx(4.8));
}

TEST_CASE("shape inertia: what encloses nothing, has no density or is too light is refused") {
    CHECK_FALSE(compute_shape_inertia(SphereShape{0.1}, 0.0));
    CHECK_FALSE(compute_shape_inertia(SphereShape{0.1}, std::nan("")));
    CHECK_FALSE(compute_shape_inertia_of_mass(SphereShape{0.1}, -1.0));
    CHECK_FALSE(compute_shape_inertia(SphereShape{-0.1}, 100.0));
    CHECK_FALSE(compute_shape_inertia(SphereShape{1.0e-9}, 1.0));
    CHECK(is_refused(compute_shape_inertia(DistanceShape{std::make_shared<BallFunction>(0.1)}, 1.0),
                     "volume"));
}

TEST_CASE("rigid state: spin and angular momentum belong together, in a body that is turned") {
    const Inertia inertia{0.2, {2.0e-5, 3.0e-5, 4.0e-5}};
    RigidState state;
    state.pose_W.orientation = compute_exp({0.4, -1.0, 0.7});
    state.velocity_W = {{1.0, 2.0, 2.0}, {3.0, -5.0, 2.0}};
    const Vector3 momentum = compute_angular_momentum_W(inertia, state);
    CHECK(
        (compute_inertia_W(inertia, state.pose_W.orientation) * state.velocity_W.angular - momentum)
            .norm() < 1.0e-18);
    CHECK((compute_spin_W(inertia, state.pose_W.orientation, momentum) - state.velocity_W.angular)
              .norm() < 1.0e-13);
    CHECK(compute_kinetic_energy_J(inertia, state) ==
          Approx(0.5 * (0.2 * 9.0 + state.velocity_W.angular.dot(momentum))).epsilon(1e-12));
}

TEST_CASE("rigid state: momentum about a principal axis, and moments of a ball and of a box") {
    const Inertia inertia{0.2, {2.0e-5, 3.0e-5, 4.0e-5}};
    RigidState state;
    state.pose_W.orientation = compute_exp({0.3, 0.2, -0.9});
    for (int axis = 0; axis < 3; ++axis) {
        state.velocity_W.angular = state.pose_W.orientation * Vector3(7.0 * Vector3::Unit(axis));
        CHECK((compute_angular_momentum_W(inertia, state) -
               inertia.moments_kg_m2[axis] * state.velocity_W.angular)
                  .norm() < 1.0e-18);
    }
    CHECK((make_ball_inertia(2.0, 0.1).moments_kg_m2 - Vector3::Constant(0.008)).norm() < 1.0e-15);
    const Inertia box = make_box_inertia(1.2, {0.1, 0.2, 0.3});
    CHECK((box.moments_kg_m2 - Vector3(0.013, 0.010, 0.005)).norm() < 1.0e-15);
    CHECK(box.mass_kg == 1.2);
}

}  // namespace
}  // namespace fulcrum
