#include "haptics/math/rotation.h"
#include "haptics/tool/field_sampling/field_sampler.h"
#include "tests/support/edited_meshes.h"
#include "tests/support/field_parts.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace fulcrum;
using test::make_field;
using test::make_shell;
using test::make_unit_box_field;

namespace {

constexpr SamplingMode kModes[] = {SamplingMode::brute_force, SamplingMode::tree,
                                   SamplingMode::coherent};

// One bumpy ball on another.
FieldSampler make(SamplingMode mode, ForceAlong along = ForceAlong::normals) {
    static const auto kField = std::make_shared<const DistanceField>(test::build_bumpy_field(128));
    static const FieldSampler::Shell kBall =
        make_shell(*make_bumpy_sphere(1.0, 16, 0.03, 9.0), 20000);
    return FieldSampler::build(kField, kBall, {.along = along, .mode = mode}).value();
}

// A tool that wanders over the object, now faster, now slower, lifts off, jumps and is turned.
std::vector<Pose> make_way(int n, unsigned seed) {
    Random random(seed);
    Wanderer wanderer(seed);
    std::vector<Pose> way;
    Quaternion turn = Quaternion::Identity();
    for (int i = 0; i < n; ++i) {
        const int phase = i / 50 % 4;
        const Vector3 direction =
            phase == 3 && way.size() > 1 ? way.back().position.normalized() : wanderer.next();
        turn = (random.turn(phase == 1 ? 0.02 : 0.001) * turn).normalized();
        const double height = phase == 2 ? 2.0 + 0.1 * std::abs(random.uniform()) : 1.97;
        way.push_back({height * direction, turn});
        if (i % 170 == 169) {
            way.back() = {1.9 * random.direction(), random.turn(3.0)};
        }
    }
    return way;
}

bool is_same(const FieldTouch& a, const FieldTouch& b) {
    return a.wrench_W.force == b.wrench_W.force && a.wrench_W.torque == b.wrench_W.torque &&
           a.n_touching == b.n_touching && a.deepest_m == b.deepest_m;
}

}  // namespace

TEST_CASE(
    "field sampling: all modes give brute force's contacts and forces to the bit, each frame") {
    for (const ForceAlong along : {ForceAlong::normals, ForceAlong::slopes}) {
        FieldSampler brute = make(SamplingMode::brute_force, along);
        FieldSampler tree = make(SamplingMode::tree, along);
        FieldSampler coherent = make(SamplingMode::coherent, along);
        std::int64_t most = 0;
        std::int64_t brute_leaves = 0;
        std::int64_t tree_leaves = 0;
        std::int64_t coherent_groups = 0;
        std::int64_t tree_groups = 0;
        for (const Pose& X_WT : make_way(1500, 3)) {
            const FieldTouch exact = brute.step({}, X_WT);
            const FieldTouch by_tree = tree.step({}, X_WT);
            const FieldTouch by_memory = coherent.step({}, X_WT);
            REQUIRE(is_same(exact, by_tree));
            REQUIRE(is_same(exact, by_memory));
            CHECK(exact.weight == 1);
            CHECK(exact.error_N == 0.0);
            most = std::max(most, exact.n_touching);
            brute_leaves += exact.n_leaves;
            tree_leaves += by_tree.n_leaves;
            tree_groups += by_tree.n_groups;
            coherent_groups += by_memory.n_groups;
        }
        CHECK(most > 100);
        CHECK(15 * tree_leaves < brute_leaves);
        CHECK(coherent_groups < tree_groups);
    }
}

TEST_CASE(
    "field sampling: a plane of points over a face feels k d n, and the torque about its origin") {
    // The lower face of a plate lies d deep in the upper face of a box.
    const FieldSampler::Field box = make_unit_box_field(64);
    const Pointshell plate = test::make_point_rows(10, 0.2, [](int, int) { return -0.05; });
    const auto shell = make_shell(make_moved(plate, Pose::at({0.2, 0.0, 0.1})));
    for (const ForceAlong along : {ForceAlong::normals, ForceAlong::slopes}) {
        FieldSampler sampler =
            FieldSampler::build(box, shell, {.stiffness_N_per_m = 50.0, .along = along}).value();
        const double d = 0.01;
        const Pose X_WO{{3.0, 1.0, -2.0},
                        Quaternion(AngleAxis(0.7, Vector3(1, 2, 3).normalized()))};
        const FieldTouch touch = sampler.step(X_WO, X_WO * Pose::at({0.0, 0.55 - d, 0.0}));
        const Vector3 force_O = 50.0 * d * 100.0 * Vector3::UnitY();
        const Vector3 middle_O(0.19, -0.05, 0.09);
        CHECK(touch.n_touching == 100);
        CHECK(touch.deepest_m == Approx(d).margin(1.0e-5));
        CHECK((touch.wrench_W.force - X_WO.orientation * force_O).norm() < 1.0e-3 * force_O.norm());
        CHECK((touch.wrench_W.torque - X_WO.orientation * middle_O.cross(force_O)).norm() <
              1.0e-3 * force_O.norm());
    }
}

TEST_CASE("field sampling: only where the tool is counts, and long ways harm no memory") {
    FieldSampler still = make(SamplingMode::coherent);
    FieldSampler moving = make(SamplingMode::coherent);
    Random random(5);
    for (const Pose& X_OT : make_way(200, 6)) {
        const Pose X_WO{3.0 * random.in_cube(), random.turn(3.0)};
        const FieldTouch a = still.step({}, X_OT);
        const FieldTouch b = moving.step(X_WO, X_WO * X_OT);
        CHECK(std::abs(a.n_touching - b.n_touching) <= 2);
        CHECK((X_WO.orientation * a.wrench_W.force - b.wrench_W.force).norm() <
              1.0e-3 * (a.wrench_W.force.norm() + 1.0e-3));
    }
    FieldSampler tree = make(SamplingMode::tree);
    FieldSampler coherent = make(SamplingMode::coherent);
    // Many times round: the clock of motion starts anew several times.
    for (int i = 0; i < 3000; ++i) {
        const double angle = 0.15 * i;
        const Pose X_WT = Pose::at(1.97 * Vector3(std::cos(angle), std::sin(angle), 0.0));
        REQUIRE(is_same(tree.step({}, X_WT), coherent.step({}, X_WT)));
    }
}

TEST_CASE("field sampling: free space gives no force, and at rest almost nothing is asked") {
    FieldSampler coherent = make(SamplingMode::coherent);
    const Pose away = Pose::at({2.3, 0.0, 0.0});
    [[maybe_unused]] const FieldTouch first = coherent.step({}, away);
    const FieldTouch touch = coherent.step({}, away);
    CHECK(touch.wrench_W.force == Vector3::Zero());
    CHECK(touch.n_touching == 0);
    CHECK(touch.n_leaves == 0);
    CHECK(touch.n_groups == 0);
}

TEST_CASE("field sampling: beyond all reach, or nowhere, is no force, and the next is as ever") {
    FieldSampler coherent = make(SamplingMode::coherent);
    const Pose touching = Pose::at({1.95, 0.0, 0.0});
    const FieldTouch before = coherent.step({}, touching);
    REQUIRE(before.n_touching > 0);
    const Pose nowhere = Pose::at(Vector3::Constant(std::numeric_limits<double>::quiet_NaN()));
    for (const Pose& pose : {Pose::at({1.0e8, 0.0, 0.0}), Pose::at({1.0e19, 0.0, 0.0}),
                             Pose::at({1.0e300, 0.0, 0.0}), nowhere}) {
        const FieldTouch touch = coherent.step({}, pose);
        CHECK(touch.n_touching == 0);
        CHECK(touch.wrench_W.force == Vector3::Zero());
        CHECK(is_same(coherent.step({}, touching), before));
    }
    CHECK(coherent.step(nowhere, touching).n_touching == 0);
    CHECK(is_same(coherent.step({}, touching), before));
}

TEST_CASE("field sampling: by itself it takes the law by which no closed way gains energy") {
    CHECK(FieldSamplingSettings{}.along == ForceAlong::slopes);
    // A closed way of a tilted sole over an edge of a box: by normals it gains, by slopes it does not.
    const FieldSampler::Field box = make_unit_box_field(64);
    const FieldSampler::Shell plate = make_shell(*make_inverted(*make_plate(0.3, 0.3, 4)), 3000);
    const auto gain = [&](ForceAlong along) {
        FieldSampler sampler = FieldSampler::build(box, plate, {.along = along}).value();
        const Quaternion tilt(AngleAxis(0.2, Vector3::UnitZ()));
        constexpr int kSteps = 2000;
        double gained_J = 0.0;
        double done_J = 0.0;
        for (int i = 0; i < kSteps; ++i) {
            const auto place = [&](double at) {
                const double angle = 2.0 * 3.14159265358979 * at / kSteps;
                return Vector3(0.45 + 0.1 * std::cos(angle), 0.5 + 0.03 * std::sin(angle), 0.05);
            };
            const FieldTouch touch = sampler.step({}, {place(i + 0.5), tilt});
            const double work_J = touch.wrench_W.force.dot(place(i + 1.0) - place(i));
            gained_J += work_J;
            done_J += std::abs(work_J);
        }
        return std::abs(gained_J) / done_J;
    };
    CHECK(gain(ForceAlong::slopes) < 1.0e-4);
    CHECK(gain(ForceAlong::normals) > 1.0e-2);
}

TEST_CASE("field sampling: a tool deeper than the band is pushed out, harder the deeper it is") {
    const FieldSampler::Field box = make_unit_box_field(128);
    const FieldSampler::Shell ball = make_shell(*make_sphere(0.03, 8), 300);
    FieldSampler sampler = FieldSampler::build(box, ball, {.stiffness_N_per_m = 10.0}).value();
    double before_N = 0.0;
    for (int i = 1; i < 30; ++i) {
        // From the face to 37 voxels below it; the ball is 7 voxels thick.
        const double depth_m = 0.01 * i;
        const FieldTouch touch = sampler.step({}, Pose::at({0.02, 0.53 - depth_m, -0.05}));
        INFO(depth_m);
        CHECK(touch.deepest_m == Approx(depth_m).margin(1.0e-3));
        CHECK(touch.wrench_W.force.y() > before_N);
        CHECK(touch.wrench_W.force.x() == Approx(0.0).margin(0.02 * touch.wrench_W.force.y()));
        before_N = touch.wrench_W.force.y();
        if (depth_m > 0.06) {
            // All of it is inside: k n times the depth of its middle, which its points have on the mean.
            const double all_N = 10.0 * 300.0 * (depth_m - 0.03);
            CHECK(touch.wrench_W.force.y() == Approx(all_N).epsilon(0.02));
        }
    }
}

TEST_CASE(
    "field sampling: with or without holes, below the band too, all modes sum D in double "
    "precision") {
    const TriangleMesh ball = *make_bumpy_sphere(1.0, 16, 0.05, 9.0);
    const Pointshell points = make_surface_pointshell(*make_sphere(0.15, 12), 3000).value();
    const auto shell = make_shell(points);
    for (const bool open : {false, true}) {
        const FieldSampler::Field field = make_field(
            open ? test::take_first(ball, -std::ssize(ball.triangles()) / 20) : ball, 128);
        REQUIRE((field->counts().n_open_edges > 0) == open);
        Random random(6);
        double clamped = 0.0;
        for (int pose = 0; pose < 12; ++pose) {
            const Pose X_OT{(1.15 - 0.02 * pose) * random.direction(), random.turn(3.0)};
            Vector3 sum = Vector3::Zero();
            Vector3 sum_in_band = Vector3::Zero();
            for (std::size_t i = 0; i < points.size(); ++i) {
                const Vector3 p_O = X_OT * points.position_T(i);
                const Vector3 normal_O = X_OT.orientation * points.normal_T(i);
                sum += field->sample_depth(p_O).depth_m * normal_O;
                sum_in_band += std::max(-field->sample(p_O).value_m, 0.0) * normal_O;
            }
            clamped = std::max(clamped, (sum - sum_in_band).norm() / std::max(sum.norm(), 1e-3));
            for (const SamplingMode mode : kModes) {
                FieldSampler sampler =
                    FieldSampler::build(
                        field, shell,
                        {.stiffness_N_per_m = 1.0, .along = ForceAlong::normals, .mode = mode})
                        .value();
                const Vector3 force = sampler.step({}, X_OT).wrench_W.force;
                CHECK((force - sum).norm() <= 1.0e-4 * sum.norm() + 1.0e-6);
            }
        }
        // What ends at the band is another law: by this much it is less there.
        CHECK(clamped > 0.05);
    }
}

TEST_CASE(
    "field sampling: of a box without a lid, as a sheet, all modes feel the walls and no lid") {
    const TriangleMesh closed = *make_box({1.0, 1.0, 1.0});
    const TriangleMesh open =
        test::take_away(closed, [](const Vector3& middle) { return middle.y() > 0.49; });
    REQUIRE(open.triangles().size() == closed.triangles().size() - 2);
    const auto field = make_field(open, 128, {.sheet_voxels = 2.0});
    const FieldSampler::Shell ball = make_shell(*make_sphere(0.1, 12), 4000);
    std::vector<FieldSampler> samplers;
    for (const SamplingMode mode : kModes) {
        samplers.push_back(FieldSampler::build(field, ball, {.mode = mode}).value());
    }
    // Down through the missing lid, to the floor, to the side wall from within, out again, and to it from without.
    std::vector<Pose> way;
    const auto go_to = [&](const Vector3& end) {
        const Vector3 begin = way.empty() ? Vector3(0.0, 0.8, 0.0) : way.back().position;
        for (int i = 1; i <= 60; ++i) {
            way.push_back(Pose::at(begin + i / 60.0 * (end - begin)));
        }
    };
    for (const Vector3& end :
         {Vector3(0.0, -0.39, 0.0), Vector3(0.39, 0.0, 0.0), Vector3(0.0, 0.8, 0.0),
          Vector3(0.8, 0.8, 0.0), Vector3(0.61, 0.0, 0.0)}) {
        go_to(end);
    }
    std::vector<FieldTouch> felt;
    for (const Pose& X_WT : way) {
        const FieldTouch exact = samplers[0].step({}, X_WT);
        REQUIRE(is_same(exact, samplers[1].step({}, X_WT)));
        REQUIRE(is_same(exact, samplers[2].step({}, X_WT)));
        felt.push_back(exact);
    }
    CHECK(felt[25].n_touching == 0);              // where the lid was
    CHECK(felt[59].wrench_W.force.y() > 0.0);     // the floor, up
    CHECK(felt[119].wrench_W.force.x() < 0.0);    // the wall from within, back
    CHECK(felt.back().wrench_W.force.x() > 0.0);  // and from without, out
    // And a sweep sees the wall from both sides.
    CHECK(samplers[1].find_first_touch(Pose::at(Vector3::Zero()), Pose::at({0.8, 0.0, 0.0})) < 0.5);
    CHECK(samplers[1].find_first_touch(Pose::at({0.8, 0.0, 0.0}), Pose::at(Vector3::Zero())) <
          0.25);
    CHECK(samplers[1].find_first_touch(way[0], Pose::at(Vector3::Zero())) == 1.0);
}

TEST_CASE("field sampling: what slides along a face or away from it is not looked at again") {
    const FieldSampler::Field box = make_unit_box_field(64);
    const double voxel_m = box->frame().voxel_m;
    const auto plate = make_shell(test::make_point_rows(64, 0.6, [](int, int) { return 0.0; }));
    FieldSampler sampler = FieldSampler::build(box, plate, {}).value();
    const auto step = [&](double along_voxels, double above_voxels) {
        return sampler
            .step({}, Pose::at({along_voxels * voxel_m, 0.5 + above_voxels * voxel_m, 0.0}))
            .n_leaves;
    };
    CHECK(step(0.0, 0.5) == static_cast<std::int64_t>(plate->n_leaves()));
    for (int i = 1; i <= 15; ++i) {
        CHECK(step(0.1 * i, 0.5) == 0);
    }
    for (int i = 1; i <= 4; ++i) {
        CHECK(step(1.5, 0.5 + 0.1 * i) == 0);
    }
    // Down to the face it must be.
    CHECK(step(1.5, 0.0) == static_cast<std::int64_t>(plate->n_leaves()));
}

TEST_CASE("field sampling: in a socket memory changes no contact, however it slides and turns") {
    // A ball with a bumpy hollow, and a bumpy ball a voxel smaller in it.
    const FieldSampler::Field socket = make_field(
        *make_hollow(*make_sphere(1.2, 16), *make_bumpy_sphere(1.0, 24, 0.05, 12.0)), 96);
    const double voxel_m = socket->frame().voxel_m;
    const FieldSampler::Shell plug =
        make_shell(*make_bumpy_sphere(1.0 - voxel_m, 24, 0.05, 12.0), 20000);
    FieldSampler brute =
        FieldSampler::build(socket, plug, {.mode = SamplingMode::brute_force}).value();
    for (const double step_voxels : {0.02, 0.3}) {
        FieldSampler coherent = FieldSampler::build(socket, plug, {}).value();
        Wanderer wanderer(5, step_voxels);
        std::int64_t n_leaves = 0;
        std::int64_t n_touching = 0;
        for (int i = 0; i < 600; ++i) {
            const double turn = 0.3 * voxel_m * std::sin(0.5 * step_voxels * i);
            const Pose X_WT{1.1 * voxel_m * wanderer.next(),
                            compute_exp(turn * Vector3(0.6, 0.8, 0.0))};
            const FieldTouch exact = brute.step({}, X_WT);
            const FieldTouch by_memory = coherent.step({}, X_WT);
            REQUIRE(is_same(exact, by_memory));
            n_leaves += by_memory.n_leaves;
            n_touching += exact.n_touching;
        }
        CHECK(n_touching > 600 * 100);
        CHECK(n_leaves < 600 * static_cast<std::int64_t>(plug->n_leaves()) / 2);
    }
}
