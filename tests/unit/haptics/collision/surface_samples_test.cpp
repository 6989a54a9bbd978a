#include "haptics/collision/surface_samples.h"

#include "haptics/geometry/shape.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace fulcrum {
namespace {

int count_kind(const SurfaceSamples& samples, SampleKind kind) {
    return static_cast<int>(std::ranges::count_if(
        samples.all(), [&](const SurfaceSample& s) { return s.kind == kind; }));
}

TEST_CASE(
    "surface samples: a box has its corners, its edges no farther apart than the spacing, and its "
    "faces") {
    const auto samples = SurfaceSamples::make(*make_box({0.4, 0.2, 0.1}), 200);
    REQUIRE(samples);
    CHECK(samples->spacing_m() == Approx(std::sqrt(2.0 * (0.08 + 0.04 + 0.02) / 200.0)));
    CHECK(count_kind(*samples, SampleKind::corner) == 8);
    CHECK(count_kind(*samples, SampleKind::face) == 200);
    // Four of each length, the middles of pieces no longer than the spacing; diagonals of faces are not sharp.
    const auto inner = [&](double length_m) {
        return 4 * static_cast<int>(std::ceil(length_m / samples->spacing_m()));
    };
    CHECK(count_kind(*samples, SampleKind::edge) == inner(0.4) + inner(0.2) + inner(0.1));
    for (const SurfaceSample& sample : samples->all()) {
        const Vector3 beyond = sample.place_B.cwiseAbs() - Vector3(0.2, 0.1, 0.05);
        const auto on =
            std::ranges::count_if(beyond, [](double x) { return std::abs(x) < 1.0e-7; });
        CHECK(beyond.maxCoeff() == Approx(0.0).margin(1.0e-7));
        CHECK(on >= (sample.kind == SampleKind::corner ? 3
                     : sample.kind == SampleKind::edge ? 2
                                                       : 1));
        CHECK(sample.along_B.norm() == Approx(sample.kind == SampleKind::edge ? 1.0 : 0.0));
    }
}

TEST_CASE("surface samples: what is round has faces alone, and what looks inwards has no edges") {
    const auto ball = SurfaceSamples::make(*make_sphere(0.1, 8), 64);
    REQUIRE(ball);
    CHECK(ball->all().size() == 64);
    // A box turned inside out: all of its edges are grooves.
    const auto room = SurfaceSamples::make(*make_inverted(*make_box({1.0, 1.0, 1.0})), 64);
    REQUIRE(room);
    CHECK(room->all().size() == 64);
    // A plate's rim has one triangle alone.
    const auto plate = SurfaceSamples::make(*make_plate(1.0, 1.0, 2), 64);
    REQUIRE(plate);
    CHECK(count_kind(*plate, SampleKind::corner) == 8);
}

TEST_CASE("surface samples: groups hold each sample once, within their balls") {
    const auto samples = SurfaceSamples::make(*make_cylinder(0.05, 0.2, 64), 512);
    REQUIRE(samples);
    std::uint32_t next = 0;
    for (const SurfaceSamples::Group& group : samples->groups()) {
        CHECK(group.first == next);
        CHECK(group.count <= 16);
        next += group.count;
        for (const SurfaceSample& sample : samples->of(group)) {
            CHECK((sample.place_B - group.centre_B).norm() <= group.radius_m);
        }
    }
    CHECK(next == samples->all().size());
    CHECK(samples->memory_bytes() >= next * sizeof(SurfaceSample));
}

TEST_CASE("surface samples: too few, too many, and a mesh of nothing but edges are refused") {
    CHECK_FALSE(SurfaceSamples::make(*make_box({1.0, 1.0, 1.0}), 15));
    CHECK_FALSE(SurfaceSamples::make(*make_box({1.0, 1.0, 1.0}), 100'001));
    std::vector<Vector3> corners;
    std::vector<TriangleCorners> triangles;
    for (int i = 0; i < 40'000; ++i) {
        for (const Vector3& corner : {Vector3(i, 0, 0), Vector3(i, 0.5, 0), Vector3(i, 0, 0.5)}) {
            corners.push_back(corner);
        }
        triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    const auto loose = SurfaceSamples::make(*TriangleMesh::build(corners, triangles), 64);
    REQUIRE_FALSE(loose);
    CHECK(to_sentence(loose.error()).find("100000") != std::string::npos);
}

}  // namespace
}  // namespace fulcrum
