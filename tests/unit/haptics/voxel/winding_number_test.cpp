#include "haptics/voxel/winding_number.h"

#include "haptics/geometry/shape.h"
#include "tests/support/edited_meshes.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <numbers>

using namespace fulcrum;

namespace {

constexpr double kExact = 1.0e9;     // an opening that no cluster reaches
constexpr double kRounding = 1e-12;  // of a few thousand arctangents
constexpr double kDipoles = 0.02;    // what the header promises of the default opening

}  // namespace

TEST_CASE(
    "winding number: an octant of the sky is pi / 2, more from its back, less from its front") {
    const TriangleAt octant{Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ()};
    CHECK(compute_solid_angle(Vector3::Zero(), octant) ==
          Approx(std::numbers::pi / 2.0).margin(kRounding));
    CHECK(compute_solid_angle(Vector3::Constant(2.0), octant) < 0.0);
}

TEST_CASE("winding number: one inside a closed mesh and zero outside, exactly and with dipoles") {
    const TriangleMesh mesh = *make_bumpy_sphere(1.0, 20, 0.05, 15.0);
    const TriangleClusters clusters(mesh);
    Random random(3);
    for (int i = 0; i < 300; ++i) {
        const bool inside = i % 2 == 0;
        const Vector3 p = random.direction() * (inside ? 0.9 : 1.1) *
                          (inside ? std::abs(random.uniform()) : 1.0 + std::abs(random.uniform()));
        CHECK(compute_winding_number(clusters, p, kExact) ==
              Approx(inside ? 1.0 : 0.0).margin(1.0e-9));
        CHECK(compute_winding_number(clusters, p) == Approx(inside ? 1.0 : 0.0).margin(kDipoles));
        CHECK(is_wound_round(clusters, p) == inside);
    }
}

TEST_CASE("winding number: a ball that lost its cap is closed by the surface of one half") {
    const TriangleMesh open = test::take_away(
        *make_sphere(1.0, 30), [](const Vector3& middle) { return middle.y() > 0.8; });
    const TriangleClusters clusters(open);
    CHECK(is_wound_round(clusters, {0.0, 0.0, 0.0}));
    CHECK(is_wound_round(clusters, {0.0, 0.6, 0.0}));
    CHECK_FALSE(is_wound_round(clusters, {0.0, 1.2, 0.0}));
    // In the middle of the hole about half the sky is surface; the disc's own half is missing.
    const double at_hole = compute_winding_number(clusters, {0.0, 0.8, 0.0}, kExact);
    CHECK(at_hole == Approx(0.5).margin(0.03));
    Random random(4);
    for (int i = 0; i < 200; ++i) {
        const Vector3 p = 1.5 * random.direction() * random.uniform();
        CHECK(compute_winding_number(clusters, p) ==
              Approx(compute_winding_number(clusters, p, kExact)).margin(kDipoles));
    }
}

TEST_CASE("winding number: doubled, loose and turned triangles leave a ball what it is") {
    const TriangleMesh ball = *make_sphere(1.0, 12);
    const TriangleMesh messy = make_messy(ball, 0.0).value();
    const TriangleClusters clusters(messy);
    Random random(5);
    for (int i = 0; i < 200; ++i) {
        const double r =
            i % 2 == 0 ? 0.8 * std::abs(random.uniform()) : 1.1 + std::abs(random.uniform());
        CHECK(is_wound_round(clusters, r * random.direction()) == (r < 1.0));
    }
}

TEST_CASE("winding number: a mesh inside out encloses the same") {
    const TriangleClusters clusters(make_inverted(*make_sphere(1.0, 8)).value());
    CHECK(compute_winding_number(clusters, Vector3::Zero(), kExact) == Approx(-1.0));
    CHECK(is_wound_round(clusters, {0.3, 0.2, 0.1}));
    CHECK_FALSE(is_wound_round(clusters, {1.3, 0.2, 0.1}));
}
