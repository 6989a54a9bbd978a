// Where a body is on its way (in_between_motion.h), and what of two triangles is nearest there (nearest_features.h).
#include "haptics/continuous/in_between_motion.h"

#include "haptics/continuous/nearest_features.h"
#include "haptics/math/rotation.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fulcrum {
namespace {

Pose draw_pose(Random& random, double size_m, double angle_rad) {
    return {size_m * random.in_cube(), random.turn(angle_rad)};
}
TEST_CASE("in-between motion: it begins and ends where it was told, to the last bit") {
    Random random(1);
    for (int i = 0; i < 2000; ++i) {
        const Pose start = draw_pose(random, 2.0, M_PI);
        const Pose end = draw_pose(random, 2.0, M_PI);
        const InBetweenMotion motion(start, end, random.in_cube());
        REQUIRE(motion.is_valid());
        REQUIRE(motion.pose(0.0).position == start.position);
        REQUIRE(motion.pose(1.0).position == end.position);
        REQUIRE(motion.pose(1.0).orientation.angularDistance(end.orientation) < 1.0e-7);
        REQUIRE(motion.angle_rad() <= M_PI + 1.0e-15);
        // The shorter way round.
        REQUIRE(motion.angle_rad() ==
                Approx(start.orientation.angularDistance(end.orientation)).margin(1.0e-7));
    }
}
TEST_CASE("in-between motion: paths meet both ends and the poses on the way within the slack") {
    Random random(2);
    for (int i = 0; i < 20000; ++i) {
        const double size_m = std::pow(10.0, 3.0 * random.uniform());
        const Pose start = draw_pose(random, size_m, M_PI);
        Pose end = draw_pose(random, size_m, M_PI);
        if (i % 4 == 0) {  // small turns
            end.orientation =
                compute_exp(std::pow(10.0, -9.0 + 8.0 * random.uniform()) * random.direction()) *
                start.orientation;
        } else if (i % 4 == 1) {  // half a turn
            end.orientation = compute_exp(M_PI * random.direction()) * start.orientation;
        }
        const Vector3 point = size_m * random.in_cube();
        const InBetweenMotion motion(start, end, 0.3 * size_m * random.in_cube());
        const PointPath path = motion.find_path(point);
        const double slack_m = motion.find_slack_m(motion.distance_to_pivot_m(point));
        REQUIRE(slack_m < 1.0e-12 * size_m);
        for (const double t : {0.0, 1.0, 0.5 + 0.5 * random.uniform()}) {
            const Vector3 place = motion.find_place(path, t, motion.turn_at(t));
            REQUIRE((place - motion.pose(t) * point).norm() <= slack_m);
            const Vector3 turned = motion.find_rotation(motion.turn_at(t)) * (point);
            REQUIRE((turned - motion.pose(t).orientation * point).norm() <= slack_m);
        }
        REQUIRE(path.b.norm() == Approx(path.c.norm()).margin(slack_m));
        REQUIRE(std::abs(path.b.dot(motion.axis_A())) <= slack_m);
    }
}
TEST_CASE("in-between motion: a turn about the pivot leaves it, straight ways are straight") {
    const Pose start = Pose::at({0.1, 0.2, 0.3});
    const Vector3 pivot(0.05, 0.0, -0.02);
    Pose end{Vector3::Zero(), compute_exp({0.0, 0.0, 2.0})};
    end.position = start * pivot - end.orientation * pivot;
    const InBetweenMotion turn(start, end, pivot);
    CHECK(turn.travel_A().norm() < 1.0e-16);
    CHECK(turn.angle_rad() == Approx(2.0));
    CHECK((turn.axis_A() - Vector3::UnitZ()).norm() < 1.0e-15);
    for (const double t : {0.2, 0.7}) {
        CHECK((turn.pose(t) * pivot - start * pivot).norm() < 1.0e-15);
    }
    const InBetweenMotion straight(start, Pose::at({1.1, 0.2, 0.3}), pivot);
    CHECK(straight.angle_rad() == 0.0);
    const PointPath path = straight.find_path({0.0, 0.5, 0.0});
    CHECK(
        (straight.find_place(path, 0.25, straight.turn_at(0.25)) - Vector3(0.35, 0.7, 0.3)).norm() <
        1.0e-15);
    CHECK((straight.find_rate(path, straight.turn_at(0.25)) - Vector3::UnitX()).norm() < 1.0e-15);
    const InBetweenMotion none(start, start, pivot);
    CHECK(none.find_longest_way_m(10.0) < 1.0e-14);
}
TEST_CASE("in-between motion: every place over a time lies in the box of that time") {
    Random random(3);
    for (int i = 0; i < 20000; ++i) {
        const InBetweenMotion motion(draw_pose(random, 1.0, M_PI), draw_pose(random, 1.0, M_PI),
                                     random.in_cube());
        const PointPath path = motion.find_path(random.in_cube());
        const double width = std::pow(10.0, -3.0 + 3.0 * random.uniform());
        const double first = 0.5 + 0.5 * random.uniform();
        const Interval times = Interval::between(first, std::min(1.0, first + width));
        const double share = 0.5 + 0.5 * random.uniform();
        const double t =
            std::clamp(times.lower + share * (times.upper - times.lower), times.lower, times.upper);
        const IntervalVector box = motion.enclose(path, times);
        for (std::size_t k = 0; k < 3; ++k) {
            const auto row = static_cast<Index>(k);
            // By the C library and in more digits.
            const long double angle = static_cast<long double>(motion.angle_rad()) * t;
            const long double exact = static_cast<long double>(path.a[row]) +
                                      static_cast<long double>(motion.travel_A()[row]) * t +
                                      path.b[row] * std::cos(angle) + path.c[row] * std::sin(angle);
            REQUIRE(static_cast<long double>(box[k].lower) <= exact);
            REQUIRE(static_cast<long double>(box[k].upper) >= exact);
        }
        // Its rate is that of a difference.
        constexpr double kStep = 1.0e-6;
        if (t > kStep && t < 1.0 - kStep) {
            const Vector3 before = motion.find_place(path, t - kStep, motion.turn_at(t - kStep));
            const Vector3 after = motion.find_place(path, t + kStep, motion.turn_at(t + kStep));
            const Vector3 rate = motion.find_rate(path, motion.turn_at(t));
            REQUIRE(((after - before) / (2.0 * kStep) - rate).norm() < 1.0e-8);
            REQUIRE(rate.norm() <= motion.find_longest_way_m(path.b.norm()));
        }
    }
}

TEST_CASE("in-between motion: what is no pose makes none") {
    const double none = std::numeric_limits<double>::quiet_NaN();
    CHECK(InBetweenMotion().is_valid());
    for (const Pose& bad :
         {Pose::at({none, 0.0, 0.0}), Pose::at({0.0, std::numeric_limits<double>::infinity(), 0.0}),
          Pose::at({0.0, 1.0e31, 0.0}), Pose{Vector3::Zero(), Quaternion(0.0, 0.0, 0.0, 0.0)},
          Pose{Vector3::Zero(), Quaternion(none, 0.0, 0.0, 1.0)}}) {
        CAPTURE(bad.position, bad.orientation.w());
        CHECK_FALSE(InBetweenMotion(Pose{}, bad).is_valid());
        CHECK_FALSE(InBetweenMotion(bad, Pose{}).is_valid());
    }
    CHECK_FALSE(InBetweenMotion(Pose{}, Pose{}, {none, 0.0, 0.0}).is_valid());
}

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
TEST_CASE("nearest features: no two places are nearer than those told") {
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
TEST_CASE("nearest features: what goes through crosses, what touches or is in the plane not") {
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
