#include "tests/support/hands_in_world.h"
#include "tests/support/tool_scene.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace fulcrum;
using fulcrum::test::BoxScene;
using fulcrum::test::HandsInWorld;

namespace {

constexpr double kBoxGravity = 9.81;
constexpr double kCursor_m = 0.006;
constexpr double kHalfBox_m = 0.03;

double ease(double share) {
    const double s = std::clamp(share, 0.0, 1.0);
    return s * s * (3.0 - 2.0 * s);
}

// Two fingers left and right of a box of 0.2 kg, as stiff as those that press with some newtons.
BoxScene make_grasp_scene(double friction) {
    BoxScene scene;
    scene.friction = friction;
    scene.coupling = {.stiffness_N_per_m = 1000.0, .damping_Ns_per_m = 9.5};
    scene.human = {0.05, 15.0, 3000.0};
    return scene;
}

// Both fingers `squeeze_m` beyond where they touch the box's faces (below 0: beside them), about `middle_W`, turned about the vertical.
void aim_fingers(HandsInWorld& hands, const Vector3& middle_W, double squeeze_m,
                 double turn_rad = 0.0) {
    const double reach_m = kHalfBox_m + kCursor_m - squeeze_m;
    const Vector3 along(std::cos(turn_rad), 0.0, -std::sin(turn_rad));
    hands.aim(0, middle_W - reach_m * along);
    hands.aim(1, middle_W + reach_m * along);
}

HandsInWorld begin_grasp(const BoxScene& scene, const Vector3& middle_W) {
    const Vector3 side(kHalfBox_m + kCursor_m + 0.02, 0.0, 0.0);
    return HandsInWorld(scene, {middle_W - side, middle_W + side});
}

// How far the box has sunk in a second, after its fingers held it in the air and then pressed with `share` of what holds it.
double hold_with(double share, double friction) {
    BoxScene scene = make_grasp_scene(friction);
    HandsInWorld hands = begin_grasp(scene, {0.0, 0.03, 0.0});
    const Vector3 grasp_W(0.0, 0.03, 0.0);
    // The coupling and the finger in series, of both hands: N = k s, and 2 mu N = m g at the edge.
    const double series_N_per_m = 1.0 / (1.0 / 1000.0 + 1.0 / scene.human.stiffness_N_per_m);
    const double edge_m = 0.2 * kBoxGravity / (2.0 * friction) / series_N_per_m;
    for (int i = 0; i < 1800; ++i) {
        const double t = 1.0e-3 * i;
        const Vector3 lift(0.0, 0.08 * ease((t - 0.7) / 0.8), 0.0);
        aim_fingers(hands, grasp_W + lift, -0.02 + (0.02 + 2.0 * edge_m) * ease(t / 0.6));
        hands.step();
    }
    const double before_m = hands.box_W(0).position.y();
    CHECK(before_m > 0.1);
    for (int i = 0; i < 2000; ++i) {
        const double squeeze = 2.0 + (share - 2.0) * ease(i / 1000.0);
        aim_fingers(hands, grasp_W + Vector3(0.0, 0.08, 0.0), squeeze * edge_m);
        hands.step();
    }
    return before_m - hands.box_W(0).position.y();
}

// How a world keeps up: its step, and when it is told after it began.
struct Pace {
    double period_s = 0.001;
    double late_s = 0.0;
};

// An arm pushes a box 6 cm along the floor. How far do its force and hand go to and fro in half a second, 2.5 s later?
struct Pushed {
    double wobble_N = 0.0;
    double moved_m = 0.0;
    double peak_J = 0.0;
    double box_m = 0.0;
    Fault faults = Fault::none;

    [[nodiscard]] bool is_calm(double most_J) const {
        return wobble_N < 0.02 && moved_m < 1.0e-4 && peak_J < most_J && box_m > 0.08 &&
               faults == Fault::none;
    }
};

Pushed push_box(const Pace& pace, double mass_kg) {
    BoxScene scene;
    scene.world_rate_hz = 1.0 / pace.period_s;
    scene.world_late_s = pace.late_s;
    scene.boxes[0].mass_kg = mass_kg;
    scene.human = kArm;
    HandsInWorld hands(scene, {{-0.06, 0.03, 0.0}});
    hands.run(0.3);
    Pushed pushed;
    double least_N = 0.0;
    double most_N = 0.0;
    double held_m = 0.0;
    for (int i = 0; i < 4000; ++i) {
        hands.aim(0, {-0.06 + 1.2e-4 * std::min(i, 1000), 0.03, 0.0});
        hands.step();
        pushed.faults |= hands.state(0).faults;
        if (i == 3500) {
            least_N = most_N = hands.state(0).applied_W.force.x();
            held_m = hands.arm(0).position_D().x();
        } else if (i > 3500) {
            least_N = std::min(least_N, hands.state(0).applied_W.force.x());
            most_N = std::max(most_N, hands.state(0).applied_W.force.x());
            pushed.moved_m =
                std::max(pushed.moved_m, std::abs(hands.arm(0).position_D().x() - held_m));
        }
    }
    pushed.wobble_N = most_N - least_N;
    pushed.peak_J = hands.state(0).force_energy.peak_J;
    pushed.box_m = hands.box_W(0).position.x();
    return pushed;
}

}  // namespace

TEST_CASE("haptic loop: a body that is lifted by its grip weighs in the hand what it weighs") {
    BoxScene scene;
    scene.grip_buttons = 1U;
    HandsInWorld hands(scene, {{0.0, 0.09, 0.0}});
    hands.run(0.3);
    hands.aim(0, {0.0, 0.062, 0.0});
    hands.run(0.5);
    for (int i = 0; i < 1000; ++i) {
        hands.aim(0, {0.0, 0.062 + 0.2 * ease(i / 1000.0), 0.0}, 1U);
        hands.step();
    }
    hands.run(1.5);
    CHECK(hands.state(0).applied_W.force.y() == Approx(-0.2 * kBoxGravity).epsilon(1.0e-3));
    CHECK(hands.state(0).applied_W.force.head<1>().norm() < 1.0e-3);
    CHECK(hands.state(0).touched_body == 0);
    CHECK((hands.box_W(0).orientation * Vector3::UnitY()).y() > 0.9999);
    // Let go it falls and lies.
    hands.aim(0, {0.0, 0.262, 0.0});
    hands.run(1.0);
    CHECK(hands.box_W(0).position.y() == Approx(0.03).margin(1.0e-4));
    CHECK(hands.state(0).applied_W.force.norm() < 1.0e-6);
}

TEST_CASE("haptic loop: a box is pushed along a floor against its friction, and lies still after") {
    BoxScene scene;
    HandsInWorld hands(scene, {{-0.06, 0.03, 0.0}});
    hands.run(0.3);
    double felt_N = 0.0;
    for (int i = 0; i < 1500; ++i) {
        hands.aim(0, {-0.06 + 1.2e-4 * i, 0.03, 0.0});
        hands.step();
        if (i > 1000) {
            felt_N += -hands.state(0).applied_W.force.x() / 499.0;
        }
    }
    // It slides on at the hand's own speed: mu m g.
    CHECK(felt_N == Approx(0.6 * 0.2 * kBoxGravity).epsilon(0.1));
    hands.run(1.0);
    CHECK(hands.box_velocity_W(0).linear.norm() < 1.0e-6);
}

TEST_CASE(
    "haptic loop: two hands squeeze, lift and turn a box, which slips where 2 mu N is too little") {
    for (const double turn_rad : {0.0, 0.5}) {
        HandsInWorld hands = begin_grasp(make_grasp_scene(0.6), {0.0, 0.035, 0.0});
        for (int i = 0; i < 4500; ++i) {
            const double t = 1.0e-3 * i;
            aim_fingers(hands, {0.0, 0.035 + 0.15 * ease((t - 0.8) / 1.5), 0.0},
                        -0.02 + 0.026 * ease(t / 0.6), turn_rad * ease((t - 2.5) / 1.0));
            hands.step();
        }
        const Pose box_W = hands.box_W(0);
        CHECK(box_W.position.y() == Approx(0.18).margin(2.0e-3));
        CHECK(std::hypot(box_W.position.x(), box_W.position.z()) < 1.0e-3);
        CHECK(2.0 * std::asin(box_W.orientation.y()) == Approx(turn_rad).margin(0.02));
        CHECK((box_W.orientation * Vector3::UnitY()).y() > 0.999);
        // Each hand carries half the weight.
        for (const std::size_t hand : {0U, 1U}) {
            CHECK(hands.state(hand).applied_W.force.y() ==
                  Approx(-0.5 * 0.2 * kBoxGravity).epsilon(0.01));
        }
    }
    for (const double friction : {0.3, 0.6}) {
        INFO("friction " << friction);
        CHECK(hold_with(1.04, friction) < 3.0e-3);
        CHECK(hold_with(0.96, friction) > 0.05);
    }
}

TEST_CASE("haptic loop: two hands stack one box on another, and it stays there") {
    BoxScene scene = make_grasp_scene(0.6);
    scene.boxes.push_back({.at_W = {0.15, 0.03, 0.0}});
    HandsInWorld hands = begin_grasp(scene, {0.0, 0.03, 0.0});
    for (int i = 0; i < 5500; ++i) {
        const double t = 1.0e-3 * i;
        const Vector3 at_W(0.15 * ease((t - 1.8) / 1.2),
                           0.03 + 0.09 * ease((t - 0.8) / 0.8) - 0.0285 * ease((t - 3.2) / 0.8),
                           0.0);
        aim_fingers(hands, at_W, -0.02 + 0.026 * (ease(t / 0.6) - ease((t - 4.3) / 0.4)));
        hands.step();
    }
    CHECK((hands.box_W(0).position - Vector3(0.15, 0.09, 0.0)).norm() < 3.0e-3);
    CHECK((hands.box_W(0).orientation * Vector3::UnitY()).y() > 0.9999);
    CHECK(hands.box_velocity_W(0).linear.norm() < 1.0e-4);
    CHECK((hands.box_W(1).position - Vector3(0.15, 0.03, 0.0)).norm() < 3.0e-3);
}

TEST_CASE("haptic loop: with a world of 20 steps a second a body is inertia, and nothing shakes") {
    const Pace paces[] = {{0.001, 0.0}, {0.001, 0.001}, {0.004, 0.004},
                          {0.02, 0.02}, {0.025, 0.025}, {0.04, 0.04},
                          {0.05, 0.0},  {0.05, 0.04},   {0.05, 0.05}};
    for (const Pace& pace : paces) {
        for (const double mass_kg : {0.02, 0.1, 0.2}) {
            const Pushed pushed = push_box(pace, mass_kg);
            INFO("steps of " << pace.period_s << " s, told after " << pace.late_s << " s, "
                             << mass_kg << " kg: " << pushed.wobble_N << " N, " << pushed.moved_m
                             << " m, " << pushed.peak_J << " J, box at " << pushed.box_m);
            CHECK(pushed.is_calm(pace.late_s > 0.03 ? 3.5e-3 : 2.0e-3));
        }
    }
}

TEST_CASE("haptic loop: a world gone silent fades the force, a closed gate lets go of the grip") {
    BoxScene scene;
    scene.boxes[0].mass_kg = 3.0;
    HandsInWorld hands(scene, {{0.0, 0.08, 0.0}});
    hands.run(0.3);
    hands.aim(0, {0.0, 0.05, 0.0});
    hands.run(1.0);
    REQUIRE(hands.state(0).applied_W.force.y() > 1.0);
    hands.stop_world();
    hands.run(0.3);
    CHECK(any(hands.state(0).faults & Fault::command_stale));
    CHECK(hands.state(0).applied_W.force.norm() == 0.0);
    scene = BoxScene();
    scene.grip_buttons = 1;
    HandsInWorld other(scene, {{-0.06, 0.03, 0.0}});
    other.aim(0, {-0.034, 0.03, 0.0});
    other.run(0.5);
    other.aim(0, {-0.034, 0.03, 0.0}, 1);
    other.run(0.1);
    REQUIRE(other.state(0).touched_body == 0);
    other.stop_world();
    other.aim(0, {-0.08, 0.03, 0.0}, 1);
    other.run(0.6);
    CHECK(other.state(0).touched_body == kNoBody);
    CHECK(other.state(0).commanded_W.force.norm() == 0.0);
}

TEST_CASE("haptic loop: a tool of points pushes a body, and feels it") {
    BoxScene scene;
    test::ToolScene tool{.tool = make_cylinder(0.01, 0.04, 32).value(),
                         .inertia = {0.02, {3.0e-6, 1.0e-6, 3.0e-6}},
                         .method = ToolMethod::field_sampling,
                         .voxel_m = 0.003,
                         .n_points = 400};
    tool.settings.coupling.turn.stiffness_Nm_per_rad = 0.5;
    scene.tool = test::make_tool_of(tool, {make_box(Vector3::Constant(0.06)).value()});
    for (const double rate_hz : {1000.0, 50.0}) {
        scene.world_rate_hz = rate_hz;
        HandsInWorld hands(scene, {{-0.08, 0.03, 0.0}});
        hands.run(0.4);
        double felt_N = 0.0;
        for (int i = 0; i < 1500; ++i) {
            hands.aim(0, {-0.08 + 1.0e-4 * i, 0.03, 0.0});
            hands.step();
            felt_N = std::max(felt_N, -hands.state(0).applied_W.force.x());
        }
        hands.run(1.0);
        INFO("world " << rate_hz << " Hz");
        CHECK(felt_N > 0.5 * 0.6 * 0.2 * kBoxGravity);
        CHECK(felt_N < 8.0);
        CHECK(hands.box_W(0).position.x() > 0.05);
        CHECK(hands.box_velocity_W(0).linear.norm() < 1.0e-3);
        CHECK(hands.state(0).faults == Fault::none);
    }
}
