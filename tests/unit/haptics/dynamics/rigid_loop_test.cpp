#include "haptics/dynamics/rigid_loop.h"

#include "tests/support/bad_numbers.h"
#include "tests/support/refused.h"
#include "tests/unit/haptics/dynamics/rigid_loop_fixture.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <memory>
#include <vector>

namespace fulcrum {
namespace {

TEST_CASE("rigid loop: tells the lesson and the hands of each body by their own numbers") {
    CubesLoop cubes;
    cubes.run(1.0);
    CHECK(cubes.seen(5).pose_W.position.x() == Approx(0.5));
    CHECK(cubes.seen(5).where == BodyWhere::landed);
    CHECK(cubes.lesson->snapshot.value().n_bodies == 6);
    CHECK(cubes.lesson->snapshot.value().time_s == Approx(1.0));
    CHECK(cubes.felt(2).pose_W.position.x() == Approx(0.5));
    CHECK(cubes.felt(2).is_present);
    CHECK_FALSE(cubes.felt(1).is_present);
    CHECK(cubes.hand->frame.value().stamp_s == Approx(1.0));
}

TEST_CASE("rigid loop: what is dropped falls, lands with its speed, and comes to rest") {
    CubesLoop cubes;
    cubes.run(0.1);
    cubes.order(WorldCommand::Kind::drop, 3, {0.0, 0.55, 0.0}, {0.0, -1.0, 0.0});
    cubes.run(0.1);
    CHECK(cubes.seen(3).where == BodyWhere::falling);
    CHECK(cubes.seen(3).velocity_W.y() == Approx(-1.0 - 9.81 * 0.1).epsilon(1.0e-3));
    CHECK(cubes.felt(0).n_placements == 1);
    CHECK(cubes.events().empty());
    cubes.run(1.9);
    const auto landed = cubes.events();
    REQUIRE(landed.size() == 1);
    CHECK(landed[0].kind == WorldEvent::Kind::landed);
    CHECK(landed[0].body == 3);
    // v^2 = 1 + 2 g 0.5.
    CHECK(landed[0].speed_m_per_s == Approx(std::sqrt(1.0 + 9.81)).epsilon(0.01));
    CHECK(cubes.seen(3).where == BodyWhere::landed);
    CHECK(cubes.seen(3).pose_W.position.y() == Approx(0.05).margin(1.0e-4));
}

TEST_CASE("rigid loop: what is placed stands where it was put, what is hidden is nowhere") {
    CubesLoop cubes;
    cubes.run(0.1);
    cubes.order(WorldCommand::Kind::place, 3, {0.5, 0.15, 0.0}, {9.0, 9.0, 9.0});
    cubes.run(1.0);
    CHECK((cubes.seen(3).pose_W.position - Vector3(0.5, 0.15, 0.0)).norm() < 1.0e-4);
    CHECK(cubes.events().empty());
    RigidLoopPlan plan = make_two_cubes();
    plan.hidden = {1};
    cubes = CubesLoop(plan);
    cubes.order(WorldCommand::Kind::hide, 5, Vector3::Zero());
    cubes.run(0.1);
    CHECK(cubes.seen(3).where == BodyWhere::hidden);
    CHECK(cubes.seen(5).where == BodyWhere::hidden);
    CHECK_FALSE(cubes.felt(0).is_present);
    cubes.order(WorldCommand::Kind::place, 3, {0.0, 0.05, 0.0});
    cubes.run(0.1);
    CHECK(cubes.seen(3).where == BodyWhere::placed);
    CHECK(cubes.felt(0).is_present);
}

TEST_CASE("rigid loop: orders that name no rigid body or no place are passed over") {
    CubesLoop cubes;
    for (const std::int32_t body : {-1, 0, 4, 64, 1000}) {
        cubes.order(WorldCommand::Kind::place, body, {0.0, 3.0, 0.0});
    }
    cubes.order(WorldCommand::Kind::place, 3, Vector3::Constant(kNan));
    cubes.order(WorldCommand::Kind::drop, 3, Vector3::Zero(), Vector3::Constant(kNan));
    cubes.order(WorldCommand::Kind::hold, 3, Vector3::Zero());
    cubes.run(0.1);
    CHECK((cubes.seen(3).pose_W.position - Vector3(0.0, 0.05, 0.0)).norm() < 1.0e-4);
    CHECK(cubes.felt(0).n_placements == 0);
}

TEST_CASE("rigid loop: a hand pushes until it has been silent for too long") {
    CubesLoop cubes;
    cubes.run(0.01);
    // 8 N against 0.6 m g = 2.9 N of friction; the second push is on what is no rigid body.
    const RigidPush push = make_push({0.5, 0.05, 0.0}, {0.45, 0.05, 0.0}, {8.0, 0.0, 0.0});
    RigidPush nowhere = push;
    nowhere.solid = 1;
    cubes.push({push, nowhere});
    cubes.run(0.05);
    const double speed = cubes.seen(5).velocity_W.x();
    CHECK(speed == Approx(0.05 * (8.0 / 0.5 - 0.6 * 9.81)).epsilon(0.02));
    CHECK(cubes.seen(5).where == BodyWhere::held);
    cubes.run(0.1);
    CHECK(cubes.seen(5).where != BodyWhere::held);
    CHECK(cubes.seen(5).velocity_W.x() < 2.1 * speed);
    cubes.run(0.3);
    CHECK(cubes.seen(5).velocity_W.norm() < 1.0e-3);
}

// Without weight; the second cube is pushed by a hand that says nothing more.
CubesLoop make_pushed_once(const RigidPush& push) {
    RigidLoopPlan plan = make_two_cubes();
    plan.world.settings.gravity_W = Vector3::Zero();
    plan.world.bodies[2].pose_W.position.y() = 1.0;
    CubesLoop cubes(plan);
    cubes.run(0.01);
    cubes.push({push});
    return cubes;
}

const Vector3 kHigh_W(0.5, 1.0, 0.0);

// Along x, as a touch does; and a couple about y.
RigidPush make_touch(double force_N, double couple_Nm, const PushSlopes& slopes) {
    RigidPush push = make_push(kHigh_W, kHigh_W, {force_N, 0.0, 0.0});
    push.hold.push_W.torque = {0.0, couple_Nm, 0.0};
    push.hold.slopes = slopes;
    push.hold.bounds.along_W = Vector3::UnitX();
    return push;
}

TEST_CASE("rigid loop: a hand that stalls gives no more than its spring held") {
    CubesLoop cubes = make_pushed_once(make_touch(9.0, 0.05, {600.0, 0.0, 0.5, 0.0, 0.0}));
    cubes.run(0.2);
    const Twist& velocity_W = cubes.state().velocity_W;
    const double moved_share = 0.25 * velocity_W.linear.squaredNorm() / (81.0 / 600.0 / 2.0);
    const double turned_share =
        0.5 * (0.5 * 0.01 / 6.0) * velocity_W.angular.squaredNorm() / (0.0025 / 0.5 / 2.0);
    CHECK(moved_share < 1.0);
    CHECK(moved_share > 0.8);
    CHECK(turned_share < 1.0);
    CHECK(turned_share > 0.8);
    // Its damper takes it as well: m v = (F - b v) t comes to F / b at most.
    CubesLoop damped = make_pushed_once(make_touch(9.0, 0.05, {0.0, 30.0, 0.0, 0.1, 0.0}));
    damped.run(0.2);
    const Twist& slow_W = damped.state().velocity_W;
    CHECK(slow_W.linear.x() <= 9.0 / 30.0);
    CHECK(slow_W.angular.y() <= 0.05 / 0.1);
    CHECK(slow_W.angular.y() > 0.0);
}

// A spring without a damper, that is told of the body as each step begins: in closed form v' = (v - h k x / m) / (1 + h^2 k / m).
TEST_CASE("rigid loop: a push as old as the step takes energy and gives none") {
    for (const double step_s : {0.001, 0.01, 0.05}) {
        for (const double k : {100.0, 1000.0, 4000.0}) {
            CAPTURE(step_s, k);
            CubesLoop cubes = make_pushed_once(make_push(kHigh_W, kHigh_W, Vector3::Zero()));
            const auto energy_J = [&](double x, double v) {
                return 0.5 * (0.5 * v * v + k * x * x);
            };
            double x = 0.0;
            double v = 0.0;
            double most_J = energy_J(0.01, 0.0);
            for (int i = 0; i < 400; ++i) {
                const RigidState& state = cubes.state();
                const Vector3& at_W = state.pose_W.position;
                const Vector3 pulled = Vector3(0.51, 1.0, 0.0) - at_W;
                RigidPush push = make_push(at_W, at_W, k * pulled);
                push.velocity_W = state.velocity_W;
                push.hold.slopes.stiffness_N_per_m = k;
                push.hold.bounds.most_N = 1.0e3;
                cubes.push({push});
                const double foretold =
                    (state.velocity_W.linear.x() + step_s * k / 0.5 * pulled.x()) /
                    (1.0 + step_s * step_s * k / 0.5);
                cubes.run(step_s, step_s);
                x = 0.51 - state.pose_W.position.x();
                v = state.velocity_W.linear.x();
                REQUIRE(v == Approx(foretold).margin(1.0e-8));
                REQUIRE(energy_J(x, v) <= most_J * (1.0 + 1.0e-6) + 1.0e-12);
                most_J = energy_J(x, v);
            }
        }
    }
}

// m v = h (F + k * 2 mm + b * 0.1 m/s), and what an implicit step takes of it.
TEST_CASE("rigid loop: a push is taken as the hand would have given it where the body is") {
    const PushSlopes slopes{600.0, 5.0, 0.0, 0.0, 0.0};
    const double mass_kg = 0.5 + 1.0e-6 * 600.0 + 1.0e-3 * 5.0;
    RigidPush push = make_touch(2.0, 0.0, slopes);
    // The hand took it to be 2 mm further along x, and at 0.1 m/s.
    push.pose_W.position.x() += 0.002;
    push.hold.at_W.x() += 0.002;
    push.velocity_W.linear.x() = 0.1;
    CubesLoop cubes = make_pushed_once(push);
    cubes.run(0.001);
    const double asked_N = 2.0 + 600.0 * 0.002 + 5.0 * 0.1;
    CHECK(cubes.seen(5).velocity_W.x() == Approx(1.0e-3 * asked_N / mass_kg).epsilon(1.0e-6));
    // No more than it may feel, nor the other way, nor across.
    push.hold.bounds.most_N = 2.5;
    CubesLoop bounded = make_pushed_once(push);
    bounded.run(0.001);
    CHECK(bounded.seen(5).velocity_W.x() == Approx(1.0e-3 * 2.5 / mass_kg).epsilon(1.0e-6));
    push.pose_W.position.x() -= 0.02;
    push.hold.at_W.x() -= 0.02;
    push.pose_W.position.y() -= 0.02;
    push.hold.at_W.y() -= 0.02;
    CubesLoop parted = make_pushed_once(push);
    parted.run(0.001);
    CHECK(parted.seen(5).velocity_W.norm() == 0.0);
}

TEST_CASE("rigid loop: a grip that knew the body turned otherwise turns it less") {
    RigidPush push = make_push(kHigh_W, kHigh_W, Vector3::Zero());
    push.hold.push_W.torque = {0.0, 0.02, 0.0};
    push.hold.slopes.turn_stiffness_Nm_per_rad = 0.4;
    push.pose_W.orientation = Quaternion(AngleAxis(-0.03, Vector3::UnitY()));
    CubesLoop cubes = make_pushed_once(push);
    cubes.run(0.001);
    CHECK(cubes.state().velocity_W.angular.y() ==
          Approx(1.0e-3 * (0.02 - 0.4 * 0.03) / (0.5 * 0.01 / 6.0 + 1.0e-6 * 0.4)).epsilon(1.0e-6));
}

TEST_CASE("rigid loop: a push of a time to come, or from before the last placing, is none") {
    CubesLoop early;
    early.run(0.01);
    early.push({make_push({0.5, 0.05, 0.0}, {0.45, 0.05, 0.0}, {8.0, 0.0, 0.0})}, 5.0);
    early.run(0.05);
    CHECK(early.seen(5).velocity_W.norm() < 1.0e-6);
    CHECK(early.seen(5).where != BodyWhere::held);
    for (const bool has_moved : {true, false}) {
        CAPTURE(has_moved);
        CubesLoop cubes = make_pushed_once(make_push(kHigh_W, kHigh_W, {9.0, 0.0, 0.0}));
        if (has_moved) {
            cubes.run(0.01);
            REQUIRE(cubes.seen(5).velocity_W.x() > 0.1);
        }
        cubes.order(WorldCommand::Kind::place, 5, {0.5, 2.0, 0.0});
        cubes.run(has_moved ? 0.01 : 0.001);
        CHECK(cubes.seen(5).velocity_W.norm() == 0.0);
        // One that knows of it is.
        RigidPush push = make_push({0.5, 2.0, 0.0}, {0.5, 2.0, 0.0}, {9.0, 0.0, 0.0});
        push.n_placements = 1;
        cubes.push({push});
        cubes.run(0.001);
        CHECK(cubes.seen(5).velocity_W.x() == Approx(1.0e-3 * 9.0 / 0.5));
    }
}

TEST_CASE("rigid loop: rounds close together push once; a bad clock moves nothing too far") {
    CubesLoop cubes = make_pushed_once(make_push(kHigh_W, kHigh_W, {9.0, 0.0, 0.0}));
    for (int i = 0; i < 5; ++i) {
        cubes.loop->step(cubes.now_s);
    }
    CHECK(cubes.seen(5).velocity_W.norm() == 0.0);
    cubes.run(0.0009, 3.0e-5);
    // Of the last rounds less than the shortest step may wait, and is told as such.
    const double moved_s = 0.0009 - cubes.felt(2).behind_s;
    CHECK(cubes.felt(2).behind_s < kShortestRigidStep_s);
    CHECK(cubes.seen(5).velocity_W.x() == Approx(9.0 / 0.5 * moved_s));
    RigidLoopPlan plan = make_two_cubes();
    plan.world.bodies[1].pose_W.position.y() = 50.0;
    cubes = CubesLoop(plan);
    cubes.run(0.01);
    const double height_m = cubes.seen(3).pose_W.position.y();
    cubes.loop->step(cubes.now_s);
    cubes.loop->step(cubes.now_s - 1.0);
    cubes.loop->step(kNan);
    CHECK(cubes.seen(3).pose_W.position.y() == height_m);
    cubes.loop->step(cubes.now_s + 1000.0);
    CHECK(cubes.seen(3).pose_W.position.y() > height_m - 9.81 * 0.06 * 0.06);
}

TEST_CASE("rigid loop: a slow step tells how much of the time it kept; bad plans are refused") {
    CubesLoop cubes;
    const auto told_rate = [&](double dt_s) {
        cubes.now_s += dt_s;
        cubes.loop->step(cubes.now_s);
        cubes.hand->frame.take();
        return cubes.hand->frame.value().rate;
    };
    (void)told_rate(0.001);
    CHECK(told_rate(0.05) == Approx(1.0));
    CHECK(told_rate(0.2) == Approx(0.25));
    CHECK(told_rate(0.001) == Approx(1.0));
    using P = RigidLoopPlan;
    check_refused(make_two_cubes(), {{&P::rate_hz, 10.0},
                                     [](P& plan) { plan.scene_bodies.pop_back(); },
                                     [](P& plan) { plan.scene_bodies[1] = 5; },
                                     [](P& plan) { plan.scene_bodies[1] = kMaxBodies; },
                                     [](P& plan) { plan.solids[0] = 3; },
                                     [](P& plan) { plan.solids.resize(kMaxSolids + 1, kNoBody); },
                                     [](P& plan) { plan.hidden = {-1}; },
                                     [](P& plan) { plan.world.bodies[1].mass_kg = -1.0; }});
}

TEST_CASE("rigid loop: steps that the solver left outside its tolerance are told to the lesson") {
    RigidLoopPlan plan = make_two_cubes();
    plan.world.settings.solver.method = ContactMethod::iterative;
    plan.world.settings.solver.max_iterations = 1;
    CubesLoop cubes(plan);
    std::uint64_t n_unconverged = 0;
    constexpr std::uint64_t kSteps = 200;
    cubes.order(WorldCommand::Kind::drop, 3, {0.48, 0.3, 0.01}, {0.0, -3.0, 0.5});
    for (std::uint64_t i = 0; i < kSteps; ++i) {
        cubes.run(1.0e-3);
        n_unconverged += cubes.loop->world().report().n_unconverged > 0 ? 1 : 0;
    }
    cubes.lesson->snapshot.take();
    const WorldEffort& told = cubes.lesson->snapshot.value().effort;
    CHECK(n_unconverged > 0);
    CHECK(told.n_unconverged == n_unconverged);
    CHECK(told.n_steps == kSteps);
}

}  // namespace
}  // namespace fulcrum
