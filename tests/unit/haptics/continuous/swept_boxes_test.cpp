#include "haptics/continuous/swept_boxes.h"

#include "haptics/math/rotation.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace fulcrum {
namespace {

OrientedBox make_oriented(const Vector3& centre, const Quaternion& turn, const Vector3& half) {
    OrientedBox box;
    const Matrix3 axes = turn.toRotationMatrix().transpose();
    for (std::size_t i = 0; i < 3; ++i) {
        const auto row = static_cast<Index>(i);
        box.centre[i] = static_cast<float>(centre[row]);
        box.half_size[i] = static_cast<float>(half[row]);
        for (std::size_t k = 0; k < 3; ++k) {
            box.axes[i][k] = static_cast<float>(axes(row, static_cast<Index>(k)));
        }
    }
    return box;
}

Vector3 draw_half(Random& random) {
    return {std::pow(10.0, -2.0 + 1.5 * random.uniform()),
            std::pow(10.0, -2.0 + 1.5 * random.uniform()),
            std::pow(10.0, -2.0 + 1.5 * random.uniform())};
}

TEST_CASE("swept boxes: what meets at any time of the piece is never told apart") {
    Random random(1);
    for (int i = 0; i < 40000; ++i) {
        const Vector3 pivot = random.in_cube();
        const InBetweenMotion motion({random.in_cube(), random.turn(M_PI)},
                                     {random.in_cube(), random.turn(M_PI)}, pivot);
        const Vector3 half = draw_half(random);
        const Quaternion turn = random.turn(M_PI);
        const Vector3 centre = random.in_cube();
        const OrientedBox moving = make_oriented(centre, turn, half);
        // A place on the moving box's border, and a held box with the same place on its own.
        const auto on_border = [&random](const Vector3& size) {
            Vector3 place = size.cwiseProduct(random.in_cube());
            place[static_cast<Index>(random.integer() % 3)] *= 0.0;
            const auto k = static_cast<Index>(random.integer() % 3);
            place[k] = random.uniform() < 0.0 ? -size[k] : size[k];
            return place;
        };
        const double width = std::pow(10.0, -2.0 + 2.0 * random.uniform());
        const double begin = (0.5 + 0.5 * random.uniform()) * (1.0 - std::min(1.0, width));
        const double end = std::min(1.0, begin + width);
        // Often at the ends of the piece, where the way is longest.
        const auto which = random.integer() % 3;
        const double t = which == 0 ? begin : (which == 1 ? end : 0.5 * begin + 0.5 * end);
        const Vector3 met = motion.pose(t) * Vector3(centre + turn * on_border(half));
        const Vector3 held_half = draw_half(random);
        const Quaternion held_turn = random.turn(M_PI);
        const OrientedBox held =
            make_oriented(met - held_turn * on_border(held_half), held_turn, held_half);
        CAPTURE(i, begin, end, t);
        REQUIRE(
            look_at_boxes(held, moving, pivot, TimePiece::of(motion, begin, end), 0.0).may_touch);
    }
}

TEST_CASE("swept boxes: boxes that stay apart are told so, by faces and by edges") {
    const OrientedBox held =
        make_oriented(Vector3::Zero(), Quaternion::Identity(), {0.1, 0.1, 0.1});
    const OrientedBox moving =
        make_oriented(Vector3::Zero(), Quaternion::Identity(), {0.1, 0.1, 0.1});
    const auto may_touch = [&](const Pose& start, const Pose& end, double near_m) {
        const InBetweenMotion motion(start, end);
        return look_at_boxes(held, moving, Vector3::Zero(), TimePiece::of(motion, 0.0, 1.0), near_m)
            .may_touch;
    };
    // Past each other with 1 mm between; with that much asked for they are near.
    CHECK_FALSE(may_touch(Pose::at({-0.5, 0.201, 0.0}), Pose::at({0.5, 0.201, 0.0}), 0.0));
    CHECK(may_touch(Pose::at({-0.5, 0.201, 0.0}), Pose::at({0.5, 0.201, 0.0}), 2.0e-3));
    CHECK(may_touch(Pose::at({-0.5, 0.199, 0.0}), Pose::at({0.5, 0.199, 0.0}), 0.0));
    // Edge over edge, crossed at right angles, each box turned by an eighth: no face tells.
    const Quaternion roll(AngleAxis(0.25 * M_PI, Vector3::UnitZ()));
    const Quaternion pitch(AngleAxis(0.25 * M_PI, Vector3::UnitX()));
    const OrientedBox ridge = make_oriented(Vector3::Zero(), roll, {0.1, 0.1, 0.1});
    for (const double gap : {1.0e-3, -1.0e-3}) {
        const Vector3 above(0.0, 2.0 * std::sqrt(2.0) * 0.1 + gap, 0.0);
        const InBetweenMotion still({above, pitch}, {above, pitch});
        CHECK(look_at_boxes(ridge, moving, Vector3::Zero(), TimePiece::of(still, 0.0, 1.0), 0.0)
                  .may_touch == (gap < 0.0));
    }
    // A short piece of a long way is small, the whole is mostly motion.
    const InBetweenMotion way(Pose::at({-5.0, 1.0, 0.0}), Pose::at({5.0, 1.0, 0.0}));
    CHECK(look_at_boxes(held, moving, Vector3::Zero(), TimePiece::of(way, 0.0, 1.0), 0.0)
              .is_mostly_motion);
    CHECK_FALSE(look_at_boxes(held, moving, Vector3::Zero(), TimePiece::of(way, 0.5, 0.501), 0.0)
                    .is_mostly_motion);
}

// What lies within a box's half sizes in its frame as that is kept.
Vector3 place_in(const OrientedBox& box, const Vector3& at) {
    Matrix3 rows;
    rows << box.axis(0).transpose(), box.axis(1).transpose(), box.axis(2).transpose();
    return -box.from_centre(Vector3::Zero()) + rows.inverse() * at;
}

Vector3 half_of(const OrientedBox& box) {
    return {static_cast<double>(box.half_size[0]), static_cast<double>(box.half_size[1]),
            static_cast<double>(box.half_size[2])};
}

TEST_CASE("swept boxes: boxes of one corner in common may touch, in the frames as they are kept") {
    Random random(2);
    for (int i = 0; i < 20000; ++i) {
        const OrientedBox held =
            make_oriented(random.in_cube(), random.turn(M_PI), draw_half(random));
        OrientedBox moving = make_oriented(Vector3::Zero(), random.turn(M_PI), draw_half(random));
        // The moving one's lowest corner, as seen along an axis of the held one, on that one's face.
        const auto k = static_cast<Index>(i % 3);
        const Vector3 out = held.axis(static_cast<std::size_t>(k)).normalized();
        Vector3 lowest = half_of(moving);
        for (Index j = 0; j < 3; ++j) {
            lowest[j] *= moving.axis(static_cast<std::size_t>(j)).dot(out) > 0.0 ? -1.0 : 1.0;
        }
        Vector3 on_face = half_of(held).cwiseProduct(random.in_cube());
        on_face[k] = half_of(held)[k];
        const Pose at = Pose::at(place_in(held, on_face) - place_in(moving, lowest));
        CAPTURE(i);
        REQUIRE(look_at_boxes(held, moving, Vector3::Zero(),
                              TimePiece::of(InBetweenMotion(at, at), 0.0, 1.0), 0.0)
                    .may_touch);
    }
}

}  // namespace
}  // namespace fulcrum
