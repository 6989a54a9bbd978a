#include "haptics/tool/god_object/god_motion.h"

#include "haptics/math/rotation.h"
#include "tests/support/edited_meshes.h"
#include "tests/support/god_scene.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

using namespace fulcrum;

namespace {

constexpr double kDt_s = 0.001;
const Vector3 kCube_m(0.04, 0.04, 0.04);
const MovingFrame kBlock{Pose::at({0.0, -0.02, 0.0}), {}};  // its top is y = 0

const GodObjectSettings kSettings = test::make_god_settings(make_box_inertia(0.02, kCube_m));
const double kGap_m = kSettings.gap_m;

GodObjectPlan make_block_plan(const TriangleMesh& tool = make_box(kCube_m).value()) {
    return {GodSurface::create(make_box({0.2, 0.04, 0.2}).value()), GodSurface::create(tool)};
}

GodMotion make_motion(GodChannels* channels = nullptr, double friction = 0.0) {
    GodObjectPlan plan = make_block_plan();
    plan.friction = {.static_coefficient = friction, .dynamic_coefficient = friction};
    return GodMotion({plan}, kSettings, channels);
}

std::unique_ptr<GodContactSet> tell(const GodMotion& motion) {
    auto set = std::make_unique<GodContactSet>();
    motion.tell(*set);
    return set;
}

Pose at_height(double height_m) {
    return Pose::at({0.01, 0.5 * kCube_m.y() + height_m, 0.0});
}

}  // namespace

TEST_CASE("god motion: what it tells of a cube on a block are its four corners, at rest there") {
    GodMotion motion = make_motion(nullptr, 0.3);
    motion.place(at_height(0.01));
    CHECK(tell(motion)->n == 0);
    CHECK_FALSE(tell(motion)->is_near);
    for (int i = 0; i < 60; ++i) {
        REQUIRE(motion.move(at_height(-0.002), {&kBlock, 1}, false));
    }
    const auto set = tell(motion);
    CHECK(set->n_objects == 1);
    CHECK(set->objects[0].object_W.position == kBlock.pose_W.position);
    CHECK(set->tool_W.position.y() - 0.5 * kCube_m.y() == Approx(kGap_m).epsilon(0.05));
    CHECK(set->is_near);
    CHECK(set->step.settled);
    CHECK(set->step.contacts == set->n);
    REQUIRE(set->n == 4);
    for (const GodPress& press : set->all()) {
        CHECK(press.object == 0);
        CHECK((press.normal_W - Vector3::UnitY()).norm() < 1e-9);
        CHECK((press.arm_W.cwiseAbs() - 0.5 * kCube_m).norm() < 1e-9);
        CHECK(press.arm_W.y() < 0.0);
        // On top of the block, below the corner.
        const Vector3 on_object_W = set->objects[0].object_W * press.on_object_O;
        CHECK((on_object_W - (set->tool_W.position + press.arm_W)).norm() < 2.0 * kGap_m);
        CHECK(press.least_m <= 0.0);
        CHECK(press.least_m > -0.1 * kGap_m);
        CHECK(press.share > 0.9);
        CHECK(press.friction == 0.3);
    }
    // Over it, by what it was before the step and is after it.
    CHECK((set->objects[0].to_OT.position.y() - 0.5 * kCube_m.y() - 0.02) ==
          Approx(kGap_m).epsilon(0.05));
}

TEST_CASE("god motion: between floor and ceiling it glides, and they push no more than they must") {
    constexpr double kSide_m = 0.04;
    // Plates that lie askew a few metres from their origins: so far do their normals' differences round.
    const Quaternion turn(compute_exp({0.3, -0.7, 0.4}));
    const auto make_plate_at = [&](double y) {
        return test::move_corners(make_box({0.5, 0.1, 0.4}).value(), [&](const Vector3& v) {
            return Vector3(turn * (v + Vector3(3.1, y, -2.7)));
        });
    };
    const auto at = [&](double x, double y, double z, const Vector3& turned = Vector3::Zero()) {
        return Pose{turn * Vector3(3.1 + x, y, -2.7 + z), turn * compute_exp(turned)};
    };
    test::GodScene scene(test::make_cube(kSide_m), {make_plate_at(-0.05), make_plate_at(0.05)},
                         test::make_sudden_settings(make_box_inertia(0.05, kCube_m)));
    const double rest_m = 0.5 * kSide_m + kGap_m;
    const auto lower_ceiling = [&](double room_m) {
        scene.frames[1].pose_W =
            Pose::at(turn * Vector3(0.0, kSide_m + 2.0 * kGap_m + room_m, 0.0));
    };
    lower_ceiling(1.0e-3);
    scene.god.place(at(0.0, rest_m + 5.0e-4, 0.0));
    for (int i = 0; i < 100; ++i) {
        (void)scene.step(at(0.0, rest_m - 0.002, 0.0));
    }
    for (int i = 0; i < 100; ++i) {
        lower_ceiling(std::max(1.0e-3 * (1.0 - i / 50.0), 0.0));
        (void)scene.step(at(0.0, rest_m - 0.002, 0.0));
    }
    Random random(23);
    int n_between = 0;
    for (int i = 0; i < 400; ++i) {
        const Pose before = scene.god.pose_W();
        const Pose handle = at(0.05 * std::sin(0.05 * i), rest_m + 0.002 * random.uniform(),
                               0.04 * std::sin(0.037 * i), 0.02 * random.in_cube());
        const ToolFelt felt = scene.step(handle);
        CAPTURE(i, scene.god.last_step().rounds, scene.god.last_step().contacts);
        REQUIRE_FALSE(scene.is_inside());
        const Vector3 gone = turn.conjugate() * (scene.god.pose_W().position - before.position);
        const Vector3 free = 0.5 * (turn.conjugate() * (handle.position - before.position));
        REQUIRE(std::abs(gone.x() - free.x()) + std::abs(gone.z() - free.z()) < 1.0e-7);
        const Wrench& floor = scene.god.touches()[0].wrench_W;
        const Wrench& ceiling = scene.god.touches()[1].wrench_W;
        REQUIRE((floor.force + ceiling.force - felt.felt_W.force).norm() <
                1.0e-6 * (1.0 + felt.felt_W.force.norm()));
        // A turn of 0.02 rad is held by a couple over the cube's side.
        REQUIRE(floor.force.norm() + ceiling.force.norm() < 20.0);
        n_between += scene.god.touches()[0].touches && scene.god.touches()[1].touches ? 1 : 0;
    }
    CHECK(n_between > 100);
}

TEST_CASE("god motion: near is within sixteen gaps; on its way nothing is told to press") {
    const auto is_near = [](double height_m, bool asks) {
        GodMotion motion = make_motion();
        motion.place(at_height(height_m));
        REQUIRE(motion.move(at_height(height_m), {&kBlock, 1}, asks));
        CHECK(tell(motion)->n == 0);
        return tell(motion)->is_near;
    };
    CHECK(is_near(10.0 * kGap_m, true));
    CHECK_FALSE(is_near(10.0 * kGap_m, false));
    CHECK_FALSE(is_near(30.0 * kGap_m, true));
    GodObjectSettings settings = kSettings;
    settings.most_rounds = 1;
    GodMotion motion({make_block_plan()}, settings, nullptr);
    motion.place(at_height(0.01));
    REQUIRE(motion.move(at_height(-0.05), {&kBlock, 1}, false));
    // Stopped on its way it is not where it would be held: nothing is told to press but what did before.
    const auto set = std::make_unique<GodContactSet>();
    CHECK_FALSE(motion.tell(*set));
    CHECK(set->n == 0);
    CHECK_FALSE(set->step.settled);
    CHECK(set->step.contacts == 4);
    CHECK(set->step.least_gap_m < 0.6 * kGap_m);
}

TEST_CASE("god motion: by goals it goes as by steps, to the bit, and its answers name them") {
    GodChannels channels;
    GodMotion beside = make_motion(&channels);
    GodMotion in_line = make_motion();
    CHECK_FALSE(in_line.run_once());
    CHECK_FALSE(beside.run_once());
    GodGoal goal;
    goal.n_objects = 1;
    goal.objects[0] = kBlock;
    for (std::uint32_t placement = 1; placement <= 2; ++placement) {
        goal.n_placements = placement;
        goal.placed_W = at_height(0.005 * placement);
        in_line.place(goal.placed_W);
        for (int i = 0; i < 40; ++i) {
            goal.stamp_s = placement + kDt_s * i;
            goal.held_W = Pose::at({0.001 * i, 0.5 * kCube_m.y() - 0.001, 0.0});
            channels.goal.publish(goal);
            REQUIRE(beside.run_once());
            REQUIRE(channels.set.take());
            const GodContactSet& set = channels.set.value();
            CHECK(set.stamp_s == goal.stamp_s);
            CHECK(set.n_placements == placement);
            CHECK(set.is_apart);
            REQUIRE(in_line.move(goal.held_W, {&kBlock, 1}, true));
            const auto expected = tell(in_line);
            REQUIRE(set.tool_W.position == expected->tool_W.position);
            REQUIRE(set.n == expected->n);
            REQUIRE(set.is_near == expected->is_near);
        }
        CHECK(channels.set.value().n == 4);
    }
    // Put into the block it stands still, and says so.
    goal.n_placements = 3;
    goal.placed_W = Pose::at({0.0, 0.0, 0.0});
    channels.goal.publish(goal);
    REQUIRE(beside.run_once());
    REQUIRE(channels.set.take());
    CHECK_FALSE(channels.set.value().is_apart);
    CHECK(channels.set.value().n == 0);
    CHECK(channels.set.value().tool_W.position == Vector3::Zero());
}

TEST_CASE(
    "god motion: where more press than there is room for, all objects are told of where they are") {
    // A bed of 625 nails of four corners each.
    std::vector<PlacedBox> nails;
    for (int i = 0; i < 625; ++i) {
        nails.push_back({0.004 * Vector3(i % 25 - 12, 0.0, i / 25 - 12), Vector3::Constant(0.002)});
    }
    const GodObjectPlan plan = make_block_plan(make_boxes(nails).value());
    GodObjectSettings settings = test::make_god_settings(make_box_inertia(0.02, {0.1, 0.01, 0.1}));
    settings.most_contacts = 4096;
    GodMotion motion({plan, plan}, settings, nullptr);
    const std::vector<MovingFrame> objects{kBlock, {Pose::at({1.0, 2.0, 3.0}), {}}};
    const auto at = [](double height_m) { return Pose::at({0.0, 0.001 + height_m, 0.0}); };
    motion.place(at(1.0e-4));
    for (int i = 0; i < 30; ++i) {
        REQUIRE(motion.move(at(-1.0e-4), objects, false));
    }
    const auto set = tell(motion);
    REQUIRE(static_cast<std::size_t>(set->n) == kMostPresses);
    CHECK(set->step.too_many);
    for (std::size_t i = 0; i < objects.size(); ++i) {
        CHECK(set->objects[i].object_W.position == objects[i].pose_W.position);
    }
}

TEST_CASE("god motion: of a cube that leans by less than a gap the lowest corners press") {
    GodMotion motion = make_motion();
    const double lean_rad = 0.8 * kGap_m / kCube_m.x();
    const auto at = [&](double lowest_m) {
        Pose pose = at_height(lowest_m + 0.5 * kCube_m.x() * lean_rad);
        pose.orientation = compute_exp(Vector3(0.0, 0.0, lean_rad));
        return pose;
    };
    motion.place(at(1.0e-4));
    for (int i = 0; i < 80; ++i) {
        REQUIRE(motion.move(at(1.1 * kGap_m), {&kBlock, 1}, false));
    }
    const auto set = tell(motion);
    REQUIRE(set->n == 2);
    for (const GodPress& press : set->all()) {
        CHECK(press.arm_W.x() < 0.0);
    }
    CHECK(set->step.contacts == 4);
}

TEST_CASE("god motion: between walls less than a gap away on either side it goes along them") {
    GodMotion motion({make_block_plan(), make_block_plan()}, kSettings, nullptr);
    const auto between = [&](double room_m) {
        return std::vector<MovingFrame>{kBlock,
                                        {Pose::at({0.0, kCube_m.y() + room_m + 0.02, 0.0}), {}}};
    };
    Pose held = at_height(5.0 * kGap_m);
    motion.place(held);
    for (int i = 0; i < 100; ++i) {
        const double room_m = std::max(10.0 - 0.2 * i, 1.2) * kGap_m;
        held = at_height(0.5 * room_m);
        REQUIRE(motion.move(held, between(room_m), false));
    }
    REQUIRE_FALSE(tell(motion)->step.wedged);
    REQUIRE(tell(motion)->step.least_gap_m < kGap_m);
    held.position.x() += 0.001;
    for (int i = 0; i < 30; ++i) {
        REQUIRE(motion.move(held, between(1.2 * kGap_m), false));
    }
    CHECK(tell(motion)->tool_W.position.x() == Approx(held.position.x()).margin(1.0e-6));
}
