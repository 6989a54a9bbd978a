#include "haptics/math/rotation.h"
#include "haptics/tool/god_object/god_object_tool.h"
#include "tests/support/god_scene.h"
#include "tests/support/refused.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace fulcrum {
namespace {

using test::make_ground;
using test::move_to;

constexpr double kGap_m = 1.0e-6;
constexpr double kStiffness = 500.0;
constexpr double kExact_N = 1.0e-6;
constexpr double kHalf_m = 0.02;  // of the tool, a cube
constexpr double kRest_m = kHalf_m + kGap_m;
constexpr FrictionSettings kWood{.static_coefficient = 0.5, .dynamic_coefficient = 0.5};

const Inertia kCube = make_box_inertia(0.05, Vector3::Constant(2.0 * kHalf_m));

TriangleMesh make_cube() {
    return test::make_cube(2.0 * kHalf_m);
}

GodObjectTool make_tool(const TriangleMesh& tool, const TriangleMesh& object,
                        const FrictionSettings& friction) {
    return GodObjectTool::build({{GodSurface::create(object), GodSurface::create(tool), friction}},
                                test::make_sudden_settings(kCube))
        .value();
}

// What the coupling holds, but for its stiffness.
double compute_stretch(const GodObjectTool& tool, const Pose& handle_W) {
    const Vector6 way = find_way(tool.pose_W(), handle_W);
    return 0.5 * (kCube.mass_kg * way.head<3>().squaredNorm() +
                  kCube.moments_kg_m2.x() * way.tail<3>().squaredNorm());
}

TEST_CASE(
    "god-object friction: a dragged cube sticks below mu N, and slides held back by just that") {
    const int squares = GENERATE(0, 1, 24);
    const TriangleMesh floor = squares > 0 ? make_plate(0.3, 0.3, squares).value() : make_ground();
    const TriangleMesh cube = make_cube();
    GodObjectTool tool = make_tool(cube, floor, kWood);
    tool.place(Pose::at({0.0, 0.05, 0.0}));
    constexpr double kDepth_m = 0.003;
    const double most_m = 0.5 * kDepth_m;  // that the handle may be aside of a tool that sticks
    const Vector3 along = Vector3(0.8, 0.0, 0.6);
    (void)move_to(tool, Pose::at({0.0, kRest_m - kDepth_m, 0.0}), 60);
    const Vector3 start = tool.centre_W();
    for (int i = 0; i <= 40; ++i) {
        const Vector3 aside = 0.999 * most_m * std::sin(0.2 * i) * along;
        const ToolFelt felt = move_to(tool, Pose::at(start + aside - Vector3(0.0, kDepth_m, 0.0)));
        CAPTURE(squares, i, tool.last_step().contacts);
        CHECK((tool.centre_W() - start).norm() < 1.0e-10);
        CHECK((felt.felt_W.force - kStiffness * (Vector3(0.0, kDepth_m, 0.0) - aside)).norm() <
              kExact_N);
        CHECK(felt.felt_W.torque.norm() < kExact_N);
    }
    const double drag_N = kStiffness * most_m;
    for (int i = 0; i < 200; ++i) {
        const Vector3 aside = (2.0 * most_m + 0.0002 * i) * along;
        const ToolFelt felt = move_to(tool, Pose::at(start + aside - Vector3(0.0, kDepth_m, 0.0)));
        CAPTURE(squares, i, tool.last_step().contacts);
        CHECK(
            (felt.felt_W.force - Vector3(0.0, kStiffness * kDepth_m, 0.0) + drag_N * along).norm() <
            kExact_N);
        CHECK(felt.felt_W.torque.norm() < kExact_N);
        CHECK((tool.touches()[0].wrench_W.force - felt.felt_W.force).norm() < kExact_N);
        REQUIRE_FALSE(test::do_enter(floor, {}, cube, tool.pose_W()));
    }
    // It comes to rest as far behind as friction holds, and lifted nothing is left of it.
    const Vector3 end = start + 0.05 * along;
    (void)move_to(tool, Pose::at(end - Vector3(0.0, kDepth_m, 0.0)), 100);
    CHECK((tool.centre_W() - (end - most_m * along)).norm() < 1.0e-8);
    CHECK(move_to(tool, Pose::at(end + Vector3(0.0, 0.001, 0.0))).felt_W.force == Vector3::Zero());
}

TEST_CASE("god-object friction: on a slope it stays where the slope is less than mu") {
    const double slope = GENERATE(0.49, 0.51, 1.0);
    const double angle = std::atan(slope);
    const Pose plane_W{Vector3::Zero(), compute_exp(Vector3(0.0, 0.0, angle))};
    const TriangleMesh floor = make_ground();
    const TriangleMesh cube = make_cube();
    GodObjectTool tool = make_tool(cube, floor, kWood);
    const Vector3 up = plane_W.orientation * Vector3::UnitY();
    const Vector3 along = plane_W.orientation * Vector3::UnitX();
    Pose handle{kRest_m * up, plane_W.orientation};
    tool.place({handle.position + 0.001 * up, handle.orientation});
    (void)move_to(tool, handle, 40, plane_W);
    const Vector3 start = tool.centre_W();
    constexpr double kWeight_N = 1.0;
    handle.position = start - Vector3(0.0, kWeight_N / kStiffness, 0.0);
    const ToolFelt felt = move_to(tool, handle, 100, plane_W);
    const double press_N = kWeight_N * std::cos(angle);
    const double pull_N = kWeight_N * std::sin(angle);
    const double drag_N = std::min(pull_N, 0.5 * press_N);
    CHECK((felt.felt_W.force - press_N * up - drag_N * along).norm() < kExact_N);
    const double slid_m = (pull_N - drag_N) / kStiffness;
    CHECK((tool.centre_W() - start + slid_m * along).norm() < 1.0e-8);
    CHECK(felt.felt_W.torque.norm() < kExact_N);
}

TEST_CASE(
    "god-object friction: along a hollow corner and in a slot it is that of the walls that press") {
    const bool slot = GENERATE(false, true);
    const double wall_m = kHalf_m + 0.5e-5;
    const std::array<PlacedBox, 2> walls{{{{-wall_m - 0.05, 0.0, 0.0}, {0.1, 0.2, 0.5}},
                                          {{wall_m + 0.05, 0.0, 0.0}, {0.1, 0.2, 0.5}}}};
    const std::array<PlacedBox, 2> corner{{{{0.0, -kHalf_m - 0.05, 0.0}, {0.5, 0.1, 0.5}},
                                           {{-wall_m - 0.05, 0.1, 0.0}, {0.1, 0.3, 0.5}}}};
    const TriangleMesh object = make_boxes(slot ? walls : corner).value();
    const TriangleMesh cube = make_cube();
    GodObjectTool tool = make_tool(cube, object, kWood);
    const Vector3 rest(-(wall_m - kRest_m), slot ? 0.0 : kGap_m, 0.0);
    const Vector3 pressed = slot ? Vector3(0.002, 0.0, 0.0) : Vector3(0.002, 0.003, 0.0);
    tool.place(Pose::at(Vector3(0.0, 0.00002, 0.0)));
    (void)move_to(tool, Pose::at(rest - pressed), 60);
    const Vector3 start = tool.centre_W();
    const double most_m = 0.5 * (pressed.x() + pressed.y());
    for (int i = 0; i < 200; ++i) {
        const double aside_m = 0.0001 * i;
        const ToolFelt felt = move_to(
            tool,
            Pose::at(rest - pressed + Vector3(0.0, start.y() - rest.y(), start.z() + aside_m)));
        CAPTURE(slot, i, tool.last_step().contacts);
        const Vector3 expected(kStiffness * pressed.x(), kStiffness * pressed.y(),
                               -kStiffness * std::min(aside_m, most_m));
        // Each wall's friction holds it where it came to rest, a hundredth of the gap from the other.
        CHECK((felt.felt_W.force - expected).norm() < (aside_m > most_m ? kExact_N : 1.0e-5));
        CHECK(felt.felt_W.torque.norm() < kExact_N);
        REQUIRE_FALSE(test::do_enter(object, {}, cube, tool.pose_W()));
    }
}

TEST_CASE("god-object friction: what sticks does not creep under a hand that trembles") {
    GodObjectTool tool = make_tool(make_cube(), make_ground(), kWood);
    tool.place(Pose::at({0.0, 0.03, 0.0}));
    const Vector3 pressed(0.0, kRest_m - 0.003, 0.0);
    (void)move_to(tool, Pose::at(pressed), 60);
    const Pose start = tool.pose_W();
    Random random(1);
    for (int i = 0; i < 100000; ++i) {
        const Vector3 tremble = 0.0005 * random.in_cube();
        (void)move_to(tool, {pressed + tremble + Vector3(0.0003, 0.0, 0.0),
                             compute_exp(0.001 * random.in_cube())});
    }
    CHECK((tool.centre_W() - start.position).norm() < 1.0e-9);
    CHECK(find_way(start, tool.pose_W()).tail<3>().norm() < 1.0e-9);
}

TEST_CASE("god-object friction: static until it slips, then dynamic, and static again at rest") {
    GodObjectTool tool = make_tool(make_cube(), make_ground(), {0.6, 0.4, 0.0});
    tool.place(Pose::at({0.0, 0.03, 0.0}));
    constexpr double kDepth_m = 0.004;
    const auto drag = [&](double aside_m, int n_steps) {
        return -move_to(tool, Pose::at({aside_m, kRest_m - kDepth_m, 0.0}), n_steps)
                    .felt_W.force.x();
    };
    (void)drag(0.0, 60);
    const double static_m = 0.6 * kDepth_m;
    const double dynamic_m = 0.4 * kDepth_m;
    CHECK(drag(0.999 * static_m, 50) == Approx(0.999 * kStiffness * static_m).margin(kExact_N));
    CHECK(std::abs(tool.centre_W().x()) < 1.0e-10);
    // It breaks away, and goes on until the dynamic one holds it.
    (void)drag(1.001 * static_m, 1);
    CHECK(drag(1.001 * static_m, 1) == Approx(kStiffness * dynamic_m).margin(kExact_N));
    (void)drag(1.001 * static_m, 60);
    CHECK(tool.centre_W().x() == Approx(1.001 * static_m - dynamic_m).margin(1.0e-8));
    // Which stick again: it breaks away once more, and then slides on.
    for (int i = 0; i < 50; ++i) {
        CHECK(drag(1.001 * static_m + 0.0001 * (i + 1), 1) ==
              Approx(kStiffness * dynamic_m)
                  .margin(i < 10 ? kStiffness * (static_m - dynamic_m) + kExact_N : kExact_N));
    }
    const double end_m = 1.001 * static_m + 0.005;
    (void)drag(end_m, 60);
    const double rest_m = tool.centre_W().x();
    CHECK(drag(rest_m + 0.999 * static_m, 50) ==
          Approx(0.999 * kStiffness * static_m).margin(kExact_N));
    CHECK(tool.centre_W().x() == Approx(rest_m).margin(1.0e-10));
}

TEST_CASE("god-object friction: a floor that moves carries what is pressed on it") {
    const TriangleMesh floor = make_ground();
    const TriangleMesh cube = make_cube();
    GodObjectTool tool = make_tool(cube, floor, kWood);
    tool.place(Pose::at({0.0, 0.03, 0.0}));
    constexpr double kDepth_m = 0.004;
    const Pose handle = Pose::at({0.0, kRest_m - kDepth_m, 0.0});
    (void)move_to(tool, handle, 60);
    for (int i = 0; i < 200; ++i) {
        const double gone_m = 0.00002 * (i + 1);
        const Pose floor_W = Pose::at({gone_m, 0.0, 0.0});
        const ToolFelt felt = move_to(tool, handle, 1, floor_W);
        const double carried_m = std::min(gone_m, 0.5 * kDepth_m);
        // It slips where the way of a step and a step's share of the stretch are more than friction holds.
        const bool breaks_away = i >= 95 && i < 120;
        CAPTURE(i);
        CHECK(felt.felt_W.force.x() ==
              Approx(kStiffness * carried_m).margin(breaks_away ? 0.01 : 2.0e-6));
        CHECK(tool.centre_W().x() == Approx(carried_m).margin(breaks_away ? 2.0e-5 : 1.0e-8));
        REQUIRE_FALSE(test::do_enter(floor, floor_W, cube, tool.pose_W()));
    }
}

TEST_CASE(
    "god-object by chance: nothing enters, gaps stay, no step gains energy, at any friction") {
    const double mu = GENERATE(0.0, 0.2, 1.0);
    const TriangleMesh cube = make_cube();
    const TriangleMesh block = make_box({0.06, 0.05, 0.07}).value();
    // Without friction as it ships.
    GodObjectTool tool = mu > 0.0
                             ? make_tool(cube, block, {mu, mu, 0.0})
                             : test::make_god_tool(cube, {block}, test::make_god_settings(kCube));
    const Pose object_W{Vector3(0.01, 0.0, 0.0), compute_exp(Vector3(0.3, 0.2, 0.1))};
    Random random(3);
    Pose handle = Pose::at({0.0, 0.09, 0.0});
    tool.place(handle);
    int n_touching = 0;
    for (int i = 0; i < 3000; ++i) {
        const double speed = i % 500 < 100 ? 0.05 : 0.002;
        handle.position = 0.99 * handle.position + speed * random.in_cube();
        handle.orientation = compute_exp(20.0 * speed * random.in_cube()) * handle.orientation;
        handle.orientation.normalize();
        const double before = compute_stretch(tool, handle);
        const ToolFelt felt = move_to(tool, handle, 1, object_W);
        REQUIRE(felt.moved);
        n_touching += tool.touches()[0].touches ? 1 : 0;
        CAPTURE(mu, i, tool.last_step().rounds, tool.last_step().contacts);
        // But for contacts that it was stopped nearer to than it rests.
        CHECK(compute_stretch(tool, handle) <= before * (1.0 + 1.0e-3) + 1.0e-9);
        REQUIRE_FALSE(test::do_enter(block, object_W, cube, tool.pose_W()));
        REQUIRE(tool.last_step().least_gap_m > kGap_m / 300.0);
    }
    CHECK(n_touching > 500);
}

TEST_CASE("god-object friction: of next to nothing it is what it is without") {
    const TriangleMesh cube = make_cube();
    const TriangleMesh block = make_box({0.06, 0.05, 0.07}).value();
    GodObjectTool with = make_tool(cube, block, {1.0e-12, 1.0e-12, 0.0});
    GodObjectTool without = make_tool(cube, block, {});
    Pose handle = Pose::at({0.0, 0.06, 0.0});
    with.place(handle);
    without.place(handle);
    int n_touching = 0;
    for (int i = 0; i < 800; ++i) {
        handle.position = {0.03 * std::sin(0.01 * i), 0.06 - 0.02 * std::sin(0.004 * i), 0.0};
        handle.orientation = compute_exp(Vector3(0.1 * std::sin(0.013 * i), 0.2, 0.0));
        const ToolFelt a = move_to(with, handle);
        const ToolFelt b = move_to(without, handle);
        CAPTURE(i);
        n_touching += without.touches()[0].touches ? 1 : 0;
        CHECK(find_way(with.pose_W(), without.pose_W()).norm() < 1.0e-7);
        CHECK((a.felt_W.force - b.felt_W.force).norm() < 1.0e-4);
    }
    CHECK(n_touching > 200);
}

TEST_CASE("god-object friction: what is out of range, and a viscous part, are refused") {
    const auto takes = [](const FrictionSettings& friction) {
        const GodObjectPlan plan{GodSurface::create(make_ground()), GodSurface::create(make_cube()),
                                 friction};
        return GodObjectTool::build({plan}, test::make_god_settings(kCube)).has_value();
    };
    check_refused(kWood, takes,
                  {[](auto& friction) {
                       friction = {0.5, 0.6, 0.0};
                   },
                   [](auto& friction) {
                       friction = {std::nan(""), 0.0, 0.0};
                   },
                   [](auto& friction) {
                       friction = {0.5, 0.4, 1.0};
                   }});
}

}  // namespace
}  // namespace fulcrum
