// Meshes on their way: mesh_sweep.h against every triangle with every other, and the boxes that spare it (swept_boxes.h, swept_mesh.h).
#include "haptics/continuous/mesh_sweep.h"

#include "haptics/continuous/swept_boxes.h"
#include "haptics/continuous/swept_mesh.h"
#include "haptics/continuous/triangle_sweep.h"
#include "haptics/geometry/shape.h"
#include "haptics/math/rotation.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace fulcrum {
namespace {

constexpr SweepSettings kSettings{};

std::shared_ptr<const SweptMesh> make_swept(const Expected<TriangleMesh>& mesh) {
    return SweptMesh::create(mesh.value());
}

// Without trees: every triangle against every other, over the whole way.
double find_first_of_all(const SweptMesh& fixed, const SweptMesh& moving,
                         const InBetweenMotion& motion) {
    double first = 2.0;
    for (std::int32_t j = 0; j < moving.n_triangles(); ++j) {
        const MovingTriangle triangle = MovingTriangle::of(motion, moving.triangle(j));
        for (std::int32_t i = 0; i < fixed.n_triangles(); ++i) {
            const TriangleSweep told =
                sweep_triangles(motion, fixed.triangle(i), triangle, kSettings);
            first = told.outcome == SweepOutcome::free ? first : std::min(first, told.contact.time);
        }
    }
    return first;
}
struct Closeness {
    double distance_m = std::numeric_limits<double>::infinity();
    bool crossing = false;
};
Closeness find_closeness(const SweptMesh& fixed, const SweptMesh& moving,
                         const InBetweenMotion& motion, double t) {
    Closeness closeness;
    for (std::int32_t j = 0; j < moving.n_triangles(); ++j) {
        const Triangle place =
            MovingTriangle::of(motion, moving.triangle(j)).find_place(motion, t, motion.turn_at(t));
        for (std::int32_t i = 0; i < fixed.n_triangles(); ++i) {
            closeness.distance_m = std::min(
                closeness.distance_m, find_nearest_features(fixed.triangle(i), place).distance_m);
            closeness.crossing = closeness.crossing || do_cross(fixed.triangle(i), place);
        }
    }
    return closeness;
}
TEST_CASE("mesh sweep: it finds what every triangle against every other finds") {
    const auto fixed = make_swept(make_bumpy_sphere(0.5, 2, 0.2, 5.0));
    const auto moving = make_swept(make_bumpy_sphere(0.4, 2, 0.3, 7.0));
    const auto heap = make_swept(make_heap(60, 3));
    Random random(1);
    int n_touching = 0;
    for (int i = 0; i < 90; ++i) {
        const SweptMesh& held = i % 5 == 0 ? *heap : *fixed;
        // Throws, spins, and steps of a hand.
        const double step = i % 3 == 0 ? 4.0 : (i % 3 == 1 ? 0.4 : 0.02);
        const Vector3 beside = random.direction();
        const Pose start{(1.0 + (i % 3 == 0 ? 1.0 : 0.1 * random.uniform())) * beside,
                         random.turn(M_PI)};
        const Pose end{start.position - step * (beside + 0.3 * random.in_cube()),
                       compute_exp(std::min(M_PI, step) * random.in_cube()) * start.orientation};
        const InBetweenMotion motion(start, end, 0.2 * random.in_cube());
        const MeshSweep told = sweep_meshes(held, *moving, motion, kSettings);
        const double first = find_first_of_all(held, *moving, motion);
        CAPTURE(i, first, told.contact.time, told.contact.features.distance_m);
        REQUIRE((told.outcome == SweepOutcome::free) == (first > 1.0));
        if (told.outcome != SweepOutcome::touching) {
            continue;
        }
        ++n_touching;
        REQUIRE(told.contact.time == Approx(first).margin(1.0e-4));
        const Closeness then = find_closeness(held, *moving, motion, told.contact.time);
        REQUIRE_FALSE(then.crossing);
        REQUIRE(then.distance_m > 0.0);
        REQUIRE(then.distance_m <= kSettings.tolerance_m * (1.0 + 1.0e-9));
        // The normal leads from the held one to the moving one.
        const NearFeatures& near = told.contact.features;
        REQUIRE(told.contact.normal_A.dot(near.on_moving - near.on_fixed) ==
                Approx(near.distance_m).margin(1.0e-12));
        REQUIRE(told.contact.normal_A.norm() == Approx(1.0));
        // The same question has the same answer, to the last bit.
        const MeshSweep again = sweep_meshes(held, *moving, motion, kSettings);
        REQUIRE(again.contact.time == told.contact.time);
        REQUIRE(again.fixed_triangle == told.fixed_triangle);
        REQUIRE(again.moving_triangle == told.moving_triangle);
    }
    CHECK(n_touching > 30);
}
TEST_CASE("mesh sweep: a bullet passes no thin sheet, and a spinning bar sweeps what it sweeps") {
    const auto sheet = make_swept(make_box({2.0, 1.0e-4, 2.0}));
    const auto bullet = make_swept(make_box({0.01, 0.01, 0.01}));
    for (const double speed : {1.0, 100.0, 1.0e4}) {
        const InBetweenMotion shot(Pose::at({0.1, 0.5 * speed, 0.2}),
                                   Pose::at({0.3, -0.5 * speed, 0.1}));
        const MeshSweep told = sweep_meshes(*sheet, *bullet, shot, kSettings);
        REQUIRE(told.outcome == SweepOutcome::touching);
        // From half the speed down to half of both thicknesses.
        CHECK(told.contact.time * speed == Approx(0.5 * speed - 0.00505).margin(2.0e-6));
        CHECK((told.contact.normal_A - Vector3::UnitY()).norm() < 1.0e-9);
    }
    // A bar of 2 m, 2 cm thick, turns about its middle; a cube stands 0.8 m out, 90 degrees round.
    const auto bar = make_swept(make_box({2.0, 0.02, 0.02}));
    const auto cube = make_swept(make_box({0.2, 0.2, 0.2}));
    const Pose start = Pose::at({0.0, 0.0, -0.8});
    const Pose end{start.position, compute_exp({0.0, 3.0, 0.0})};
    const MeshSweep met = sweep_meshes(*cube, *bar, {start, end}, kSettings);
    REQUIRE(met.outcome == SweepOutcome::touching);
    // Its flank, 1 cm from the line through the pivot, comes to the cube's corner at (0.1, 0.7 from the pivot) or its far one.
    const double near_corner = std::atan2(0.7, 0.1) - std::asin(0.01 / std::hypot(0.1, 0.7));
    const double far_corner = std::atan2(0.9, 0.1) - std::asin(0.01 / std::hypot(0.1, 0.9));
    CHECK(met.contact.time * 3.0 <= std::max(near_corner, far_corner));
    CHECK(met.contact.time * 3.0 == Approx(std::min(near_corner, far_corner)).margin(0.02));
    CHECK(sweep_meshes(*cube, *bar, {start, {start.position, compute_exp({0.0, 1.0, 0.0})}},
                       kSettings)
              .outcome == SweepOutcome::free);
}

TEST_CASE("mesh sweep: what overlaps at first is told at once; what is no motion tells nothing") {
    const auto ball = make_swept(make_bumpy_sphere(0.5, 4, 0.1, 5.0));
    const double none = std::numeric_limits<double>::quiet_NaN();
    const auto find = [&](double from, double to, const SweepSettings& settings = kSettings) {
        return sweep_meshes(*ball, *ball, {Pose::at({from, 0.0, 0.0}), Pose::at({to, 0.0, 0.0})},
                            settings)
            .outcome;
    };
    CHECK(find(0.6, 3.0) == SweepOutcome::overlapping);
    CHECK(find(0.0, 0.0) == SweepOutcome::overlapping);
    CHECK(find(2.0, 2.0) == SweepOutcome::free);
    CHECK(find(none, 0.0) == SweepOutcome::invalid);
    CHECK(find(0.0, 0.0, {0.0, none}) == SweepOutcome::invalid);
    const auto fine = make_swept(make_sphere(0.1, 24));
    const MeshSweep found = sweep_meshes(
        *fine, *fine,
        InBetweenMotion(Pose::at({0.01, 0.005, 0.002}), Pose::at({0.02, 0.005, 0.002})), kSettings);
    CHECK(found.outcome == SweepOutcome::overlapping);
    CHECK(found.contact.time == 0.0);
    // One pair of leaves that cross is enough, of thousands.
    CHECK(found.n_triangle_pairs < 200);
}

TEST_CASE("mesh sweep: what is near at a time is what every triangle says") {
    const auto fixed = make_swept(make_bumpy_sphere(0.5, 4, 0.2, 5.0));
    const auto moving = make_swept(make_box({0.3, 0.3, 0.3}));
    const InBetweenMotion motion(Pose::at({0.9, 0.1, 0.0}),
                                 {Vector3(0.5, 0.0, 0.0), compute_exp({0.1, 0.4, 0.2})});
    const MeshSweep told = sweep_meshes(*fixed, *moving, motion, kSettings);
    REQUIRE(told.outcome == SweepOutcome::touching);
    BoundedList<NearTriangles> near(4000);
    for (const double within_m : {1.0e-6, 1.0e-3, 0.1}) {
        REQUIRE(collect_near(*fixed, *moving, motion, told.contact.time, within_m, near));
        std::size_t expected = 0;
        const SineCosine turn = motion.turn_at(told.contact.time);
        for (std::int32_t i = 0; i < fixed->n_triangles(); ++i) {
            for (std::int32_t j = 0; j < moving->n_triangles(); ++j) {
                const Triangle place = MovingTriangle::of(motion, moving->triangle(j))
                                           .find_place(motion, told.contact.time, turn);
                expected +=
                    find_nearest_features(fixed->triangle(i), place).distance_m <= within_m ? 1 : 0;
            }
        }
        CHECK(near.count() == expected);
        CHECK(near.count() >= 1);
    }
    BoundedList<NearTriangles> few(3);
    CHECK_FALSE(collect_near(*fixed, *moving, motion, told.contact.time, 0.1, few));
    CHECK(few.count() == 3);
    CHECK_FALSE(collect_near(*fixed, *moving, motion, 1.5, 0.1, near));
}
TEST_CASE("mesh sweep: of what is near at first and what crosses there the latter is told") {
    // Two triangles far from each other, met by two: one half a micrometre above, one across.
    const auto make_two = [](const Triangle& first, const Triangle& second) {
        return SweptMesh::create(
            TriangleMesh::build({first[0], first[1], first[2], second[0], second[1], second[2]},
                                {{0, 1, 2}, {3, 4, 5}})
                .value());
    };
    const auto flat_at = [](double x, double y) {
        return Triangle{Vector3(x, y, 0.0), Vector3(x + 0.1, y, 0.0), Vector3(x, y, 0.1)};
    };
    const auto across_at = [](double x) {
        return Triangle{Vector3(x + 0.02, -0.1, 0.02), Vector3(x + 0.03, 0.1, 0.02),
                        Vector3(x + 0.02, 0.1, 0.03)};
    };
    const InBetweenMotion away(Pose{}, Pose::at({0.0, 1.0, 0.0}));
    const SweepSettings settings{.touch_m = 1.0e-6, .tolerance_m = 1.0e-6};
    for (const double side : {-1.0, 1.0}) {
        const auto held = make_two(flat_at(-side, 0.0), flat_at(side, 0.0));
        const auto moving = make_two(flat_at(-side, 5.0e-7), across_at(side));
        const MeshSweep told = sweep_meshes(*held, *moving, away, settings);
        CHECK(told.outcome == SweepOutcome::overlapping);
        CHECK(told.contact.time == 0.0);
        // Without it: apart, and nearer than touching.
        const auto above = make_two(flat_at(-side, 5.0e-7), flat_at(side, 0.5));
        const MeshSweep touching = sweep_meshes(*held, *above, away, settings);
        CHECK(touching.outcome == SweepOutcome::touching);
        CHECK(touching.contact.time == 0.0);
    }
}
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
TEST_CASE("swept mesh: every triangle lies in one leaf, and in all boxes above it") {
    const TriangleMesh mesh = make_bumpy_sphere(0.3, 6, 0.1, 6.0).value();
    const auto swept = SweptMesh::create(mesh);
    REQUIRE(swept->n_triangles() == static_cast<std::int32_t>(mesh.triangles().size()));
    std::vector<int> seen(mesh.triangles().size());
    std::vector<std::vector<std::int32_t>> paths{{swept->root()}};
    while (!paths.empty()) {
        const std::vector<std::int32_t> path = paths.back();
        paths.pop_back();
        const std::int32_t child = swept->boxes().first_child(path.back());
        if (child >= 0) {
            for (const std::int32_t next : {child, child + 1}) {
                paths.push_back(path);
                paths.back().push_back(next);
            }
            continue;
        }
        for (const std::int32_t triangle : swept->boxes().triangles_of(path.back())) {
            ++seen[static_cast<std::size_t>(triangle)];
            for (const Vector3& corner : swept->triangle(triangle)) {
                CHECK(corner.norm() <= swept->reach_m());
                for (const std::int32_t node : path) {
                    const OrientedBox& box = swept->boxes().box(node);
                    const Vector3 place = box.to_frame(corner);
                    for (std::size_t i = 0; i < 3; ++i) {
                        REQUIRE(std::abs(place[static_cast<Index>(i)]) <=
                                static_cast<double>(box.half_size[i]));
                    }
                }
            }
        }
    }
    for (const int count : seen) {
        REQUIRE(count == 1);
    }
    CHECK(swept->memory_bytes() > sizeof(Vector3) * mesh.vertices_B().size());
}

}  // namespace
}  // namespace fulcrum
