#include "haptics/collision/wall_thickness.h"

#include "haptics/geometry/shape.h"
#include "tests/support/hard_meshes.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace fulcrum;

namespace {

double find(const TriangleMesh& mesh, double share = 0.05) {
    return find_wall_m(*CollisionMesh::create(mesh).value(),
                       make_surface_pointshell(mesh, 1000).value(), share);
}

constexpr double kSingle_m = 1.0e-5;  // places are single precision, ways begin off the surface

}  // namespace

TEST_CASE("wall thickness: a plate is as thick as it is, inside out too") {
    const TriangleMesh plate = *make_box({0.4, 0.003, 0.3});
    for (const double share : {0.0, 0.05, 0.5}) {
        CHECK(find(plate, share) == Approx(0.003).margin(kSingle_m));
        CHECK(find(*make_inverted(plate), share) == Approx(0.003).margin(kSingle_m));
    }
    // Its rims are walls of 0.3 and 0.4 m.
    CHECK(find(plate, 0.999) > 0.29);
}

TEST_CASE("wall thickness: a ball is as thick as its diameter, a hollow one as its skin") {
    CHECK(find(*make_sphere(0.1, 40), 0.0) > 0.195);
    const TriangleMesh hollow = *make_hollow(*make_sphere(0.1, 40), *make_sphere(0.095, 40));
    CHECK(find(hollow, 0.05) > 0.0045);
    CHECK(find(hollow, 0.95) < 0.0065);
}

TEST_CASE("wall thickness: the cleft between two plates is no wall, and an open sheet has none") {
    // Two plates of 20 mm, 1 mm apart.
    const TriangleMesh plate = *make_box({0.4, 0.02, 0.3});
    std::vector<Vector3> vertices = plate.vertices_B();
    std::vector<TriangleCorners> triangles = plate.triangles();
    const auto n = static_cast<std::int32_t>(vertices.size());
    for (std::int32_t i = 0; i < n; ++i) {
        vertices.emplace_back(vertices[static_cast<std::size_t>(i)] + Vector3(0.0, 0.021, 0.0));
    }
    for (const TriangleCorners& t : plate.triangles()) {
        triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
    }
    const TriangleMesh both = *TriangleMesh::build(vertices, triangles);
    CHECK(find(both) == Approx(0.02).margin(kSingle_m));
    CHECK(std::isinf(find(*make_plate(0.4, 0.3, 4), 0.99)));
}

TEST_CASE("wall thickness: sheets that lie upon each other are a wall of none") {
    CHECK(find(*make_box({0.4, 1.0e-5, 0.3})) < 2.0e-5);
}
