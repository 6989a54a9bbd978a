#include "haptics/continuous/nearest_features.h"

#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>

namespace fulcrum {
namespace {

const Triangle kFlat{Vector3(0.0, 0.0, 0.0), Vector3(1.0, 0.0, 0.0), Vector3(0.0, 1.0, 0.0)};

Triangle draw_triangle(Random& random) {
    return {random.in_cube(), random.in_cube(), random.in_cube()};
}

TEST_CASE("nearest features: a corner over a face, a face over a corner, edges that cross") {
    const Triangle above{Vector3(0.2, 0.3, 0.5), Vector3(0.2, 0.3, 1.5), Vector3(0.4, 0.3, 1.5)};
    const NearFeatures corner = find_nearest_features(kFlat, above);
    CHECK(corner.pair == FeaturePair::face_vertex);
    CHECK(corner.moving_feature == 0);
    CHECK(corner.distance_m == Approx(0.5));
    CHECK((corner.on_fixed - Vector3(0.2, 0.3, 0.0)).norm() < 1.0e-15);
    const NearFeatures face = find_nearest_features(above, kFlat);
    CHECK(face.pair == FeaturePair::vertex_face);
    CHECK(face.fixed_feature == 0);
    CHECK(face.distance_m == Approx(0.5));
    // An edge across the middle of the first one, 0.25 below.
    const Triangle below{Vector3(0.5, -1.0, -0.25), Vector3(0.5, 0.4, -0.25),
                         Vector3(0.5, -1.0, -2.0)};
    const NearFeatures edges = find_nearest_of(FeaturePair::edge_edge, 0, 0, kFlat, below);
    CHECK(edges.distance_m == Approx(0.25));
    CHECK((edges.on_fixed - Vector3(0.5, 0.0, 0.0)).norm() < 1.0e-15);
    CHECK((edges.on_moving - Vector3(0.5, 0.0, -0.25)).norm() < 1.0e-15);
    CHECK(find_nearest_features(kFlat, below).distance_m == Approx(0.25));
}

TEST_CASE(
    "nearest features: no two places of the triangles are nearer than told, and the told ones are "
    "theirs") {
    Random random(1);
    for (int i = 0; i < 2000; ++i) {
        Triangle first = draw_triangle(random);
        Triangle second = draw_triangle(random);
        if (i % 5 == 0) {  // without area
            first[2] = 0.25 * first[0] + 0.75 * first[1];
        }
        if (i % 10 == 0) {  // a point, parallel edges
            second[1] = second[0];
            second[2] = i % 20 == 0 ? second[0] : Vector3(second[0] + first[1] - first[0]);
        }
        const NearFeatures near = find_nearest_features(first, second);
        const bool crossing = do_cross(first, second);
        double sampled = 1.0e9;
        for (int k = 0; k < 60; ++k) {
            const auto place = [&random](const Triangle& t) {
                double v = 0.5 + 0.5 * random.uniform();
                double w = 0.5 + 0.5 * random.uniform();
                if (v + w > 1.0) {
                    v = 1.0 - v;
                    w = 1.0 - w;
                }
                return Vector3(t[0] + v * (t[1] - t[0]) + w * (t[2] - t[0]));
            };
            sampled = std::min(sampled, (place(first) - place(second)).norm());
        }
        REQUIRE((crossing || near.distance_m <= sampled + 1.0e-12));
        // The direction between them keeps all corners apart by as much.
        if (!crossing) {
            const Vector3 k = (near.on_moving - near.on_fixed) / near.distance_m;
            for (const Vector3& a : first) {
                for (const Vector3& p : second) {
                    REQUIRE(k.dot(p - a) >= near.distance_m - 1.0e-9);
                }
            }
        }
    }
}

TEST_CASE(
    "nearest features: what goes through crosses, what touches or lies in the plane does not") {
    const auto through = [](double from, double to) {
        return Triangle{Vector3(0.2, 0.2, from), Vector3(0.2, 0.2, to), Vector3(9.0, 9.0, to)};
    };
    CHECK(do_cross(kFlat, through(-1.0, 1.0)));
    CHECK(do_cross(through(-1.0, 1.0), kFlat));
    CHECK(do_cross(kFlat, through(-1.0e-300, 1.0)));
    CHECK_FALSE(do_cross(kFlat, through(0.0, 1.0)));
    CHECK_FALSE(do_cross(kFlat, through(1.0e-300, 1.0)));
    CHECK_FALSE(do_cross(kFlat, kFlat));
    const Triangle point{Vector3(0.2, 0.2, 0.0), Vector3(0.2, 0.2, 0.0), Vector3(0.2, 0.2, 0.0)};
    CHECK_FALSE(do_cross(kFlat, point));
    CHECK(find_nearest_features(kFlat, point).distance_m == 0.0);
    CHECK(find_nearest_features(point, point).distance_m == 0.0);
}

}  // namespace
}  // namespace fulcrum
