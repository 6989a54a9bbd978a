#include "haptics/continuous/mesh_sweep.h"

#include "haptics/continuous/triangle_sweep.h"
#include "haptics/geometry/shape.h"
#include "haptics/math/rotation.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

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

TEST_CASE(
    "mesh sweep: a bullet does not pass a sheet of a hair, and a spinning bar sweeps what it "
    "sweeps") {
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

TEST_CASE(
    "mesh sweep: what overlaps at the beginning is told so; what is no motion finds nothing out") {
    const auto ball = make_swept(make_bumpy_sphere(0.5, 4, 0.1, 5.0));
    CHECK(sweep_meshes(*ball, *ball, {Pose::at({0.6, 0.0, 0.0}), Pose::at({3.0, 0.0, 0.0})},
                       kSettings)
              .outcome == SweepOutcome::overlapping);
    CHECK(sweep_meshes(*ball, *ball, {}, kSettings).outcome == SweepOutcome::overlapping);
    CHECK(sweep_meshes(*ball, *ball, {Pose::at({2.0, 0.0, 0.0}), Pose::at({2.0, 0.0, 0.0})},
                       kSettings)
              .outcome == SweepOutcome::free);
    const double none = std::numeric_limits<double>::quiet_NaN();
    CHECK(sweep_meshes(*ball, *ball, {Pose::at({none, 0.0, 0.0}), Pose{}}, kSettings).outcome ==
          SweepOutcome::invalid);
    CHECK(sweep_meshes(*ball, *ball, {}, {0.0, none}).outcome == SweepOutcome::invalid);
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

TEST_CASE("mesh sweep: what overlaps from the beginning on is told without looking further") {
    const auto ball = make_swept(make_sphere(0.1, 24));
    const MeshSweep found = sweep_meshes(
        *ball, *ball,
        InBetweenMotion(Pose::at({0.01, 0.005, 0.002}), Pose::at({0.02, 0.005, 0.002})), kSettings);
    CHECK(found.outcome == SweepOutcome::overlapping);
    CHECK(found.contact.time == 0.0);
    // One pair of leaves that cross is enough, of thousands.
    CHECK(found.n_triangle_pairs < 200);
}

TEST_CASE(
    "mesh sweep: of what is nearer than touching at the beginning and what crosses there the "
    "latter is told") {
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

}  // namespace
}  // namespace fulcrum
