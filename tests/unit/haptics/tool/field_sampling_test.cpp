#include "haptics/tool/field_sampling.h"

#include "haptics/geometry/shape.h"
#include "haptics/math/rotation.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <limits>

using namespace fulcrum;

namespace {

FieldSampler::Field make_field(const TriangleMesh& mesh, int n_along) {
    return std::make_shared<const DistanceField>(
        DistanceField::build(mesh, DistanceField::make_frame(mesh, n_along).value()).value());
}

FieldSampler::Field bumpy() {
    static const FieldSampler::Field kField =
        make_field(*make_bumpy_sphere(1.0, 16, 0.05, 12.0), 128);
    return kField;
}

FieldSampler::Shell make_shell(const TriangleMesh& mesh, int n_points) {
    return std::make_shared<const ShellTree>(
        ShellTree::build(make_surface_pointshell(mesh, n_points).value()).value());
}

FieldSampler::Shell ball() {
    static const FieldSampler::Shell kShell =
        make_shell(*make_bumpy_sphere(1.0, 16, 0.03, 9.0), 20000);
    return kShell;
}

FieldSampler make(SamplingMode mode, ForceAlong along = ForceAlong::normals) {
    return FieldSampler::build(bumpy(), ball(), {.along = along, .mode = mode}).value();
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
    const FieldSampler::Field box = make_field(*make_box({1.0, 1.0, 1.0}), 64);
    Pointshell points;
    constexpr int kSide = 10;
    for (int i = 0; i < kSide * kSide; ++i) {
        points.add({0.02 * (i % kSide) + 0.1, -0.05, 0.02 * (i / kSide)}, Vector3::UnitY());
    }
    const auto shell = std::make_shared<const ShellTree>(ShellTree::build(points).value());
    for (const ForceAlong along : {ForceAlong::normals, ForceAlong::slopes}) {
        FieldSampler sampler =
            FieldSampler::build(box, shell, {.stiffness_N_per_m = 50.0, .along = along}).value();
        const double d = 0.01;
        const Pose X_WO{{3.0, 1.0, -2.0},
                        Quaternion(Eigen::AngleAxisd(0.7, Vector3(1, 2, 3).normalized()))};
        const FieldTouch touch = sampler.step(X_WO, X_WO * Pose::at({0.0, 0.55 - d, 0.0}));
        const double n = kSide * kSide;
        const Vector3 force_O = 50.0 * d * n * Vector3::UnitY();
        const Vector3 middle_O(0.19, -0.05, 0.09);
        CHECK(touch.n_touching == kSide * kSide);
        CHECK(touch.deepest_m == Approx(d).margin(1.0e-5));
        CHECK((touch.wrench_W.force - X_WO.orientation * force_O).norm() < 1.0e-3 * force_O.norm());
        CHECK((touch.wrench_W.torque - X_WO.orientation * middle_O.cross(force_O)).norm() <
              1.0e-3 * force_O.norm());
    }
}

TEST_CASE("field sampling: only where the tool is to the object counts") {
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
}

TEST_CASE("field sampling: long ways do not make the memory forget or remember too much") {
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

TEST_CASE("field sampling: a pose beyond all reach gives no force, and the next is as ever") {
    FieldSampler coherent = make(SamplingMode::coherent);
    const Pose touching = Pose::at({1.95, 0.0, 0.0});
    const FieldTouch before = coherent.step({}, touching);
    REQUIRE(before.n_touching > 0);
    for (const double far_m : {1.0e8, 1.0e19, 1.0e300}) {
        CHECK(coherent.step({}, Pose::at({far_m, 0.0, 0.0})).n_touching == 0);
        CHECK(is_same(coherent.step({}, touching), before));
    }
}

TEST_CASE("field sampling: a pose that is no number gives no force, and the next is as ever") {
    FieldSampler coherent = make(SamplingMode::coherent);
    const Pose touching = Pose::at({1.95, 0.0, 0.0});
    const FieldTouch before = coherent.step({}, touching);
    REQUIRE(before.n_touching > 0);
    const Pose broken = Pose::at(Vector3::Constant(std::numeric_limits<double>::quiet_NaN()));
    CHECK(coherent.step({}, broken).wrench_W.force == Vector3::Zero());
    CHECK(coherent.step(broken, touching).n_touching == 0);
    CHECK(is_same(coherent.step({}, touching), before));
}

TEST_CASE("field sampling: a thin wall stops a tool at 2 m/s, which steps of a millisecond pass") {
    const double thickness_m = 5.0e-4;
    const FieldSampler::Field wall = make_field(*make_box({0.1, thickness_m, 0.1}), 512);
    const FieldSampler::Shell tool = make_shell(*make_sphere(2.0e-4, 6), 500);
    FieldSampler sampler = FieldSampler::build(wall, tool, {}).value();
    const double step_m = 2.0e-3;  // 2 m/s at 1 kHz
    const Pose above = Pose::at({0.01, 0.5 * step_m, 0.01});
    const Pose below = Pose::at({0.01, -0.5 * step_m, 0.01});
    CHECK(sampler.step({}, above).n_touching == 0);
    CHECK(sampler.step({}, below).n_touching == 0);
    const double share = sampler.find_first_touch(above, below);
    const double height_m = 0.5 * step_m - share * step_m;
    const double touch_m = 0.5 * thickness_m + 2.0e-4;
    CHECK(height_m >= touch_m - 1.0e-6);
    CHECK(height_m < touch_m + 0.6 * wall->frame().voxel_m);
    CHECK(sampler.find_first_touch(above, Pose::at({0.02, 0.5 * step_m, 0.03})) == 1.0);
    CHECK(sampler.find_first_touch(Pose::at({0.01, 0.0, 0.01}), above) == 0.0);
}

TEST_CASE("field sampling: no motion passes through what it first touches, turning ones too") {
    FieldSampler sampler = make(SamplingMode::tree);
    Random random(9);
    int n_hits = 0;
    for (int k = 0; k < 60; ++k) {
        const Pose from{2.4 * random.direction(), random.turn(3.0)};
        const Pose to{2.4 * random.direction(), random.turn(3.0)};
        const double share = sampler.find_first_touch(from, to);
        for (int i = 0; i <= 40; ++i) {
            const double t = share * i / 40.0;
            const Pose at{from.position + t * (to.position - from.position),
                          from.orientation.slerp(t, to.orientation)};
            CHECK(sampler.step({}, at).n_touching == 0);
        }
        if (share < 1.0) {
            ++n_hits;
        }
    }
    CHECK(n_hits > 20);
    CHECK(n_hits < 60);
}
