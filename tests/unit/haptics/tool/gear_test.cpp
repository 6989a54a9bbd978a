// The bodies that tools are tried on are closed and of the size they say.
#include "tests/support/gear.h"

#include "haptics/geometry/mesh_report.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace fulcrum;

namespace {
constexpr double kPi = 3.141592653589793;
}

TEST_CASE("gear: closed, 32 triangles a tooth, its volume that of its contours") {
    const GearSettings settings;
    const auto gear = make_gear(settings).value();
    const MeshReport report = compute_mesh_report(gear);
    CHECK(report.is_sound());
    CHECK(report.n_triangles == 32 * settings.n_teeth);
    CHECK(report.size_m.z() == Approx(settings.width_m));
    // Between the rings of root and tip, less the bore.
    const auto ring_m3 = [&](double radius_m) {
        return kPi * settings.width_m * (radius_m * radius_m - settings.bore_m * settings.bore_m);
    };
    CHECK(report.volume_m3 > 0.9 * ring_m3(settings.root_m));
    CHECK(report.volume_m3 < ring_m3(settings.tip_m));
}

TEST_CASE("peg and bush: 288 and 280 triangles, closed, and the peg fits") {
    const MeshReport peg = compute_mesh_report(make_peg(0.01, 0.06, 72).value());
    const MeshReport bush = compute_mesh_report(make_bush(0.02, 0.0105, 0.03, 35).value());
    CHECK(peg.is_sound());
    CHECK(bush.is_sound());
    CHECK(peg.n_triangles == 288);
    CHECK(bush.n_triangles == 280);
    CHECK(peg.volume_m3 == Approx(kPi * 0.0001 * 0.06).epsilon(0.002));
    CHECK(bush.volume_m3 == Approx(kPi * (0.0004 - 0.0105 * 0.0105) * 0.03).epsilon(0.01));
}
