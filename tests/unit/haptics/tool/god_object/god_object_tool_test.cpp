#include "haptics/tool/god_object/god_object_tool.h"

#include "haptics/math/rotation.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/god_scene.h"
#include "tests/support/refused.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace fulcrum {
namespace {

using test::kGodDt_s;
using test::make_ground;
using test::move_to;

constexpr double kGap_m = 1.0e-6;
constexpr double kStiffness = 500.0;
constexpr double kExact_N = 1.0e-6;
constexpr double kHalf_m = 0.02;  // of the tool, a cube
constexpr int kBlended = 1200;    // steps in which any set of contacts is blended in, to 1e-9 N

const Inertia kCube = make_box_inertia(0.05, Vector3::Constant(2.0 * kHalf_m));

TriangleMesh make_cube() {
    return test::make_cube(2.0 * kHalf_m);
}

GodObjectTool make_tool(const TriangleMesh& object,
                        const GodObjectSettings& settings = test::make_god_settings(kCube)) {
    return test::make_god_tool(make_cube(), {object}, settings);
}

TEST_CASE("god-object tool: in free space it follows the handle, and nothing is felt") {
    GodObjectTool tool = make_tool(make_ground());
    Random random(1);
    Pose handle = Pose::at({0.0, 0.1, 0.0});
    tool.place(handle);
    for (int i = 0; i < 500; ++i) {
        handle.position += 0.002 * random.in_cube();
        handle.position.y() = std::max(handle.position.y(), 0.05);
        handle.orientation = compute_exp(0.02 * random.in_cube()) * handle.orientation;
        const Pose before = tool.pose_W();
        const ToolFelt felt = move_to(tool, handle);
        REQUIRE(felt.moved);
        REQUIRE(felt.felt_W.force == Vector3::Zero());
        REQUIRE(felt.felt_W.torque == Vector3::Zero());
        // Half of the way that is left, by shift and turn.
        const Vector6 left = find_way(before, handle);
        REQUIRE((find_way(before, tool.pose_W()) - 0.5 * left).norm() < 1.0e-12);
    }
}

TEST_CASE("god-object tool: a cube pressed or dragged on a floor feels stiffness times depth") {
    const bool fine = GENERATE(false, true);
    const TriangleMesh floor = fine ? make_plate(0.3, 0.3, 24).value() : make_ground();
    const TriangleMesh cube = make_cube();
    GodObjectTool tool = make_tool(floor);
    tool.place(Pose::at({0.0, 0.05, 0.0}));
    const double rest_m = kHalf_m + kGap_m;
    (void)move_to(tool, Pose::at({0.0, rest_m - 0.003, 0.0}), kBlended);
    for (int i = 0; i < 300; ++i) {
        const double depth_m = 0.003 + 0.002 * std::sin(0.05 * i);
        const Pose handle =
            Pose::at({0.05 * std::sin(0.02 * i), rest_m - depth_m, 0.03 * std::sin(0.013 * i)});
        const Vector3 before = tool.centre_W();
        const ToolFelt felt = move_to(tool, handle);
        CAPTURE(fine, i, tool.last_step().rounds, tool.last_step().contacts);
        CHECK((felt.felt_W.force - Vector3(0.0, kStiffness * depth_m, 0.0)).norm() < kExact_N);
        CHECK(felt.felt_W.torque.norm() < kExact_N);
        // Against a floor that is met at its surface it is off by what it says.
        const double at_surface_N = kStiffness * (depth_m - kGap_m);
        CHECK(std::abs(felt.felt_W.force.y() - at_surface_N) <=
              find_wall_error_N(test::make_god_settings(kCube)) * (1.0 + 1.0e-6));
        // Along the floor as in free space.
        const Vector3 gone = tool.centre_W() - before;
        const Vector3 free = 0.5 * (handle.position - before);
        CHECK(std::abs(gone.x() - free.x()) + std::abs(gone.z() - free.z()) < 1.0e-9);
        CHECK(std::abs(tool.centre_W().y() - rest_m) < 1.0e-10);
        REQUIRE_FALSE(test::do_enter(floor, {}, cube, tool.pose_W()));
    }
}

TEST_CASE("god-object tool: pressed while it is turned, it feels the turn by its inertia") {
    GodObjectTool tool = make_tool(make_ground());
    const double rest_m = kHalf_m + kGap_m;
    tool.place(Pose::at({0.0, rest_m + 0.001, 0.0}));
    constexpr double kTurn_rad = 0.05;
    const Pose handle{Vector3(0.0, rest_m - 0.004, 0.0), compute_exp(Vector3(kTurn_rad, 0.3, 0.0))};
    const ToolFelt felt = move_to(tool, handle, kBlended);
    const double turn_stiffness = kStiffness * kCube.moments_kg_m2.x() / kCube.mass_kg;
    // About the floor's normal it turns freely; what is left is the turn to the handle from there.
    const Vector6 left = find_way(tool.pose_W(), handle);
    CHECK(std::abs(left[4]) < 1.0e-6);
    CHECK((felt.felt_W.force - Vector3(0.0, kStiffness * 0.004, 0.0)).norm() < 1.0e-5);
    CHECK((felt.felt_W.torque + turn_stiffness * left.tail<3>()).norm() < 1.0e-6);
    CHECK(felt.felt_W.torque.norm() > 0.9 * turn_stiffness * kTurn_rad);
}

TEST_CASE(
    "god-object tool: along a hollow corner both walls are felt by their depth, and nothing "
    "along it") {
    const std::array<PlacedBox, 2> boxes{{{{0.0, -0.05, 0.0}, {0.5, 0.1, 0.5}},
                                          {{-0.1, 0.1, 0.0}, {0.1, 0.3, 0.5}}}};  // wall: x = -0.05
    const TriangleMesh corner = make_boxes(boxes).value();
    const TriangleMesh cube = make_cube();
    GodObjectTool tool = make_tool(corner);
    const Vector3 rest(-0.05 + kHalf_m + kGap_m, kHalf_m + kGap_m, 0.0);
    tool.place(Pose::at(rest + Vector3(0.01, 0.01, 0.0)));
    (void)move_to(tool, Pose::at(rest - Vector3(0.002, 0.002, 0.0)), kBlended);
    for (int i = 0; i < 200; ++i) {
        const Vector3 depth(0.002 + 0.001 * std::sin(0.1 * i), 0.003 + 0.001 * std::cos(0.07 * i),
                            -0.08 * std::sin(0.02 * i));
        const ToolFelt felt = move_to(tool, Pose::at(rest - depth));
        CAPTURE(i, tool.last_step().rounds, tool.last_step().contacts);
        CHECK((felt.felt_W.force - kStiffness * Vector3(depth.x(), depth.y(), 0.0)).norm() <
              kExact_N);
        // Off by what one wall is over the sine of half of a right angle.
        const Vector3 at_surface(depth.x() - kGap_m, depth.y() - kGap_m, 0.0);
        CHECK((felt.felt_W.force - kStiffness * at_surface).norm() <=
              find_wall_error_N(test::make_god_settings(kCube)) / std::sqrt(0.5) * (1.0 + 1.0e-6));
        CHECK(felt.felt_W.torque.norm() < kExact_N);
        REQUIRE_FALSE(test::do_enter(corner, {}, cube, tool.pose_W()));
    }
}

TEST_CASE(
    "god-object tool: in a slot 10 micrometres wider it slides freely, and is held across it") {
    constexpr double kPlay_m = 1.0e-5;
    const double wall_m = kHalf_m + 0.5 * kPlay_m;
    const std::array<PlacedBox, 2> walls{{{{-wall_m - 0.05, 0.0, 0.0}, {0.1, 0.2, 0.5}},
                                          {{wall_m + 0.05, 0.0, 0.0}, {0.1, 0.2, 0.5}}}};
    const TriangleMesh slot = make_boxes(walls).value();
    const TriangleMesh cube = make_cube();
    GodObjectTool tool = make_tool(slot);
    tool.place(Pose::at({0.0, 0.2, 0.0}));
    // In from above: half the play less the gap is how far it may go to either side.
    const double side_m = 0.5 * kPlay_m - kGap_m;
    const double kept = std::exp(-kGodDt_s / test::make_god_settings(kCube).fade_s);
    double blended_N = 0.0;  // what of the wall that it came to last may not be felt yet
    double last_N = 0.0;
    for (int i = 0; i < 400; ++i) {
        const double pull_m = 0.002 * std::sin(0.05 * i);
        const Pose handle = Pose::at({i < 60 ? 0.0 : pull_m, std::max(0.2 - 0.003 * i, 0.0),
                                      i < 100 ? 0.0 : 0.1 * std::sin(0.02 * (i - 100))});
        const Vector3 before = tool.centre_W();
        const ToolFelt felt = move_to(tool, handle);
        const double wanted_m = std::abs(handle.position.x());
        const double force_N =
            kStiffness * std::copysign(std::max(wanted_m - side_m, 0.0), -handle.position.x());
        CAPTURE(i, tool.last_step().rounds, tool.last_step().contacts, tool.centre_W());
        blended_N = kept * (blended_N + (force_N * last_N > 0.0 ? 0.0 : std::abs(force_N)));
        last_N = force_N;
        if (i > 100) {
            CHECK(std::abs(felt.felt_W.force.x() - force_N) < blended_N + kExact_N);
            CHECK(felt.felt_W.force.tail<2>().norm() < kExact_N);
            CHECK(felt.felt_W.torque.norm() < kExact_N);
            const Vector3 free = 0.5 * (handle.position - before);
            CHECK((tool.centre_W() - before - free).tail<2>().norm() < 1.0e-9);
        }
        REQUIRE_FALSE(test::do_enter(slot, {}, cube, tool.pose_W()));
    }
    // Held on one side, until that is blended in, and drawn along: its force alone.
    (void)move_to(tool, Pose::at({0.003, 0.0, 0.05}), kBlended);
    for (int i = 0; i < 100; ++i) {
        const double pull_m = 0.003 + 0.001 * std::sin(0.1 * i);
        const ToolFelt felt = move_to(tool, Pose::at({pull_m, 0.0, 0.05 - 0.001 * i}));
        CHECK((felt.felt_W.force + kStiffness * Vector3(pull_m - side_m, 0.0, 0.0)).norm() <
              kExact_N);
        CHECK(felt.felt_W.torque.norm() < kExact_N);
    }
    // Turned about y by a hand, it is held at what the play lets it.
    const ToolFelt turned =
        move_to(tool, {Vector3::Zero(), compute_exp(Vector3(0.0, 0.2, 0.0))}, kBlended);
    const double turn_stiffness = kStiffness * kCube.moments_kg_m2.y() / kCube.mass_kg;
    CHECK(turned.felt_W.torque.y() == Approx(-turn_stiffness * 0.2).epsilon(0.01));
    CHECK(turned.felt_W.force.norm() < 1.0e-3);
}

TEST_CASE("god-object tool: at a round a step it says so, enters nothing and rests as ever") {
    const TriangleMesh cube = make_cube();
    const TriangleMesh floor = make_ground();
    GodObjectSettings hurried = test::make_god_settings(kCube);
    hurried.most_rounds = 1;
    GodObjectTool slow = make_tool(floor);
    GodObjectTool fast = make_tool(floor, hurried);
    Random random(4);
    Pose handle;
    int n_unsettled = 0;
    for (GodObjectTool* const tool : {&slow, &fast}) {
        tool->place(Pose::at({0.0, 0.05, 0.0}));
    }
    for (int i = 0; i < 200 + kBlended; ++i) {
        // Thrown at the floor, then held still.
        if (i < 200 && i % 5 == 0) {
            handle = {Vector3(0.0, 0.01, 0.0) + 0.03 * random.in_cube(),
                      compute_exp(0.6 * random.in_cube())};
        }
        (void)move_to(slow, handle);
        const ToolFelt felt = move_to(fast, handle);
        REQUIRE(felt.moved);
        REQUIRE(fast.last_step().rounds <= 1);
        n_unsettled += felt.effort.lacks[static_cast<std::size_t>(ToolLack::unsettled)] ? 1 : 0;
        REQUIRE_FALSE(test::do_enter(floor, {}, cube, fast.pose_W()));
    }
    CHECK(n_unsettled > 20);
    CHECK((fast.centre_W() - slow.centre_W()).norm() < 1.0e-6);
    CHECK((move_to(fast, handle).felt_W.force - move_to(slow, handle).felt_W.force).norm() <
          1.0e-3);
}

TEST_CASE("god-object tool: a handle that is no number feels nothing; bad settings are refused") {
    GodObjectTool tool = make_tool(make_ground());
    tool.place(Pose::at({0.0, 0.03, 0.0}));
    (void)move_to(tool, Pose::at({0.0, 0.01, 0.0}), kBlended);
    const Pose nowhere = Pose::at({kNan, 0.0, 0.0});
    CHECK_FALSE(move_to(tool, nowhere).moved);
    CHECK(tool.force(nowhere).force == Vector3::Zero());
    // It goes on afterwards as if nothing had been.
    CHECK(move_to(tool, Pose::at({0.0, 0.01, 0.0})).felt_W.force.y() ==
          Approx(kStiffness * 0.010001));
    const GodObjectSettings good = test::make_god_settings(kCube);
    check_refused(good,
                  {[](auto& s) { s.gap_m = 0.0; }, [](auto& s) { s.gap_m = std::nan(""); },
                   [](auto& s) { s.gap_m = 0.99e-8; }, [](auto& s) { s.step_share = 0.0; },
                   [](auto& s) { s.step_share = 1.1; }, [](auto& s) { s.fade_s = -1.0; },
                   [](auto& s) { s.most_rounds = 0; }, [](auto& s) { s.most_contacts = 0; },
                   [](auto& s) { s.grip_T.x() = 11.0; }, [](auto& s) { s.handle_turn.w() = 2.0; },
                   [](auto& s) { s.inertia.mass_kg = 0.0; },
                   [](auto& s) { s.coupling.shift.stiffness_N_per_m = -1.0; }});
    CHECK_FALSE(GodObjectTool::build({}, good).has_value());
    CHECK_FALSE(GodObjectTool::build({{}}, good).has_value());
}

TEST_CASE("god-object tool: as far out as places are nothing crosses; beyond, nothing moves") {
    const TriangleMesh floor = make_ground();
    const TriangleMesh cube = make_cube();
    GodObjectSettings settings = test::make_god_settings(kCube);
    settings.gap_m = GENERATE(1.0e-8, 1.0e-6);
    GodObjectTool tool = make_tool(floor, settings);
    // Whatever its turn, the tool stays within the last place.
    constexpr double kFarthest_m = 2.0e4;
    const Vector3 origin = Vector3::Constant(kFarthest_m - 1.0);
    Random random(29);
    const Pose object{origin, random.turn(M_PI)};
    const auto at = [&](const Vector3& above, const Vector3& turn) {
        return object * Pose{above, compute_exp(turn)};
    };
    tool.place(at({0.0, 0.05, 0.0}, Vector3::Zero()));
    Vector3 turn = Vector3::Zero();
    int n_touching = 0;
    for (int i = 0; i < 400; ++i) {
        turn = 0.95 * turn + 0.05 * random.in_cube();
        const Vector3 above(0.05 * std::sin(0.02 * i), 0.02 + 0.01 * std::sin(0.05 * i), 0.0);
        const ToolFelt felt = move_to(tool, at(above, turn), 1, object);
        REQUIRE(felt.moved);
        n_touching += tool.touches()[0].touches ? 1 : 0;
        REQUIRE_FALSE(test::do_cross(floor, tool.object_W(0), cube, tool.pose_W()));
    }
    CHECK(n_touching > 100);
    const Pose beyond = Pose::at(Vector3(1.001 * kFarthest_m, 0.0, 0.0));
    CHECK_FALSE(move_to(tool, beyond, 1, object).moved);
    CHECK_FALSE(move_to(tool, object, 1, beyond).moved);
    CHECK(is_place(Pose::at({-kFarthest_m, 0.0, 0.0})));
}

TEST_CASE("god-object tool: it is free beside a block, not on it, in it or around it") {
    GodObjectTool tool = make_tool(test::make_cube(0.1));
    const MovingFrame object{};
    const auto is_free = [&](const Vector3& at) {
        tool.place(Pose::at(at));
        return tool.is_free({&object, 1});
    };
    CHECK(is_free({0.0, 0.05 + kHalf_m + 3.0 * kGap_m, 0.0}));
    CHECK_FALSE(is_free({0.0, 0.05 + kHalf_m + kGap_m, 0.0}));
    CHECK_FALSE(is_free({0.0, 0.05, 0.0}));
    CHECK_FALSE(is_free(Vector3::Zero()));
    GodObjectTool large =
        test::make_god_tool(make_box({0.5, 0.5, 0.5}).value(), {make_box({0.1, 0.1, 0.1}).value()},
                            test::make_god_settings(kCube));
    large.place(Pose{});
    CHECK_FALSE(large.is_free({&object, 1}));
    CHECK_FALSE(large.is_free({}));
}

}  // namespace
}  // namespace fulcrum
