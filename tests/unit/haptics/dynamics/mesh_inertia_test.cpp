#include "haptics/dynamics/mesh_inertia.h"

#include "haptics/dynamics/integrator.h"
#include "haptics/geometry/shape.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

namespace fulcrum {
namespace {

constexpr double kSteel_kg_per_m3 = 7850.0;
// Of samples: one in each of 64^3 cubes, of which some thousands are cut by the surface.
constexpr double kSampledMass = 0.003;
constexpr double kSampledMoment = 0.005;

// Both surfaces in one mesh, the second moved.
TriangleMesh join(const TriangleMesh& first, const TriangleMesh& second, const Vector3& way) {
    std::vector<Vector3> vertices = first.vertices_B();
    std::vector<TriangleCorners> triangles = first.triangles();
    const auto n = static_cast<std::int32_t>(vertices.size());
    for (const Vector3& vertex : second.vertices_B()) {
        vertices.emplace_back(vertex + way);
    }
    for (const TriangleCorners& t : second.triangles()) {
        triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
    }
    return *TriangleMesh::build(std::move(vertices), std::move(triangles), {.weld_relative = 0.0});
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
        std::vector<Vector3> vertices = mesh.vertices_B();
        for (Vector3& vertex : vertices) {
            vertex = X_WB * vertex;
        }
        const auto found =
            fill_with_mass(*measure_solid(*TriangleMesh::build(vertices, mesh.triangles())), 2.0);
        REQUIRE(found);
        CHECK(found->inertia.moments_kg_m2.isApprox(box.moments_kg_m2, 1.0e-10));
        CHECK(found->X_BP.position.isApprox(X_WB.position, 1.0e-12));
        CHECK(compute_inertia_W(found->inertia, found->X_BP.orientation)
                  .isApprox(compute_inertia_W(box, X_WB.orientation), 1.0e-9));
        CHECK(found->inertia_B.isApprox(compute_inertia_W(box, X_WB.orientation), 1.0e-9));
    }
}

TEST_CASE(
    "mesh inertia: inside out it is the same; with a hollow it lacks what the hollow would have") {
    const TriangleMesh outer = *make_box(Vector3(0.4, 0.4, 0.4));
    const auto inverted = compute_inertia(*make_inverted(outer), 1000.0);
    REQUIRE(inverted);
    CHECK(inverted->rule == InertiaRule::integrals);
    CHECK(inverted->inertia.mass_kg == Approx(64.0).epsilon(1.0e-12));
    CHECK(inverted->inertia.moments_kg_m2.isApprox(
        make_box_inertia(64.0, Vector3::Constant(0.4)).moments_kg_m2, 1.0e-12));
    const auto hollow = compute_inertia(
        join(outer, *make_inverted(*make_box(Vector3::Constant(0.2))), Vector3::Zero()), 1000.0);
    REQUIRE(hollow);
    CHECK(hollow->rule == InertiaRule::integrals);
    CHECK(hollow->inertia.mass_kg == Approx(64.0 - 8.0).epsilon(1.0e-12));
    const Vector3 lacking = make_box_inertia(8.0, Vector3::Constant(0.2)).moments_kg_m2;
    CHECK(hollow->inertia.moments_kg_m2.isApprox(
        make_box_inertia(64.0, Vector3::Constant(0.4)).moments_kg_m2 - lacking, 1.0e-12));
}

TEST_CASE("mesh inertia: open, overlapping, nested and partly inverted meshes are sampled") {
    const TriangleMesh box = *make_box(Vector3(0.4, 0.4, 0.4));
    const Vector3 cube = make_box_inertia(64.0, Vector3::Constant(0.4)).moments_kg_m2;
    const auto check = [](const TriangleMesh& mesh, double mass_kg, const Vector3& moments) {
        const auto found = compute_inertia(mesh, 1000.0);
        REQUIRE(found);
        CHECK(found->rule == InertiaRule::samples);
        CHECK(found->inertia.mass_kg == Approx(mass_kg).epsilon(kSampledMass));
        CHECK((found->inertia.moments_kg_m2 - moments).norm() < kSampledMoment * moments.norm());
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
        check(join(box, box, Vector3(0.2, 0.0, 0.0)), 96.0,
              make_box_inertia(96.0, edges).moments_kg_m2);
    }
    SECTION("a cube in a cube weighs nothing more") {
        check(join(box, *make_box(Vector3::Constant(0.2)), Vector3::Zero()), 64.0, cube);
    }
    SECTION("two cubes apart, one inside out") {
        const double apart_m = 0.8;
        const Vector3 both = 2.0 * cube + 2.0 * 64.0 * 0.25 * apart_m * apart_m * Vector3(0, 1, 1);
        check(join(box, *make_inverted(box), Vector3(apart_m, 0.0, 0.0)), 128.0, both);
    }
    SECTION("a ball with its seam open") {
        const double mass = 1000.0 * 4.0 / 3.0 * 3.14159265358979 * 0.001;
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
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double bad : {0.0, -1.0, nan, infinity}) {
        CHECK_FALSE(compute_inertia(box, bad));
        CHECK_FALSE(fill_with_mass(*measure_solid(box), bad));
    }
    const auto sheet = compute_inertia(*make_plate(0.1, 0.1, 4), 1000.0, "sheet.obj");
    REQUIRE_FALSE(sheet);
    CHECK(to_sentence(sheet.error()) ==
          "sheet.obj: the mesh encloses nothing, so it has no mass; close its holes, or give mass "
          "and "
          "moments of inertia as numbers.");
    const TriangleMesh plate = *make_plate(0.1, 0.1, 4);
    CHECK_FALSE(compute_inertia(join(plate, *make_inverted(plate), Vector3::Zero()), 1000.0));
    // Too light for any integrator: 1e-9 kg.
    const auto speck = compute_inertia(*make_box(Vector3::Constant(1.0e-4)), 1.0, "speck.obj");
    REQUIRE_FALSE(speck);
    CHECK(to_sentence(speck.error()).find("speck.obj: the body's mass_kg is 1e-12") == 0);
    CHECK_FALSE(compute_inertia(*make_box(Vector3::Constant(1.0e14)), 1.0));
}

}  // namespace
}  // namespace fulcrum
