// The world's laws in closed form, one step at a time, and those of what it is made of: rigid_body.h, catcher.h and its plan.
#include "haptics/dynamics/catcher.h"
#include "haptics/dynamics/rigid_body.h"
#include "haptics/dynamics/world.h"
#include "haptics/math/rotation.h"
#include "tests/support/refused.h"
#include "tests/unit/haptics/dynamics/world_fixture.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <vector>

using namespace fulcrum;

namespace {

using Kind = WorldCommand::Kind;

constexpr double kExact = 1.0e-12;  // metres: what rounding leaves of positions of a few metres
constexpr double kGravity_m_per_s2 = 9.81;
const HapticState kFarTool = tool_at({0.0, 50.0, 0.0});

double turned_rad(const Quaternion& from, const Quaternion& to) {
    return compute_log(to * from.conjugate()).norm();
}

}  // namespace

TEST_CASE("world: a drop turns by 1.5 radians a second, each drop about another axis") {
    ToldWorld world(make_weightless_plan());
    Vector3 axes[2];
    for (Vector3& axis : axes) {
        world.drop(1, {3.0, 10.0, 0.0});
        world.run(kFarTool, 100);
        axis = compute_log(world.body().pose_W.orientation);
        CHECK(axis.norm() == Approx(1.5 * 100 * kDt_s));
    }
    CHECK(axes[0].normalized().dot(axes[1].normalized()) < 0.9);
}

TEST_CASE("world: landing aslant, the speed told is the whole, a quarter and a half of it remain") {
    ToldWorld world;
    world.drop(1, {2.0, 0.54, 0.0}, {2.0, 0.0, -1.0});
    Quaternion before = Quaternion::Identity();
    double flight_rad = 0.0;
    int n = 0;
    while (world.events().empty() && n < 1000) {
        flight_rad = turned_rad(before, world.body().pose_W.orientation);
        before = world.body().pose_W.orientation;
        world.run(kFarTool);
        ++n;
    }
    // Semi-implicit Euler without drag: v_y = -g n dt; the step that reaches the ground is flown to its end.
    const double down_m_per_s = kGravity_m_per_s2 * n * kDt_s;
    REQUIRE(world.events().size() == 1);
    CHECK(world.events()[0].speed_m_per_s == Approx(Vector3(2.0, down_m_per_s, -1.0).norm()));
    CHECK((world.body().velocity_W - Vector3(1.0, 0.25 * down_m_per_s, -0.5)).norm() < kExact);
    CHECK(world.at_W().y() == 0.04);
    // The spin is halved as well.
    const Quaternion landed = world.body().pose_W.orientation;
    world.run(kFarTool);
    CHECK(flight_rad == Approx(1.5 * kDt_s));
    CHECK(turned_rad(landed, world.body().pose_W.orientation) == Approx(0.75 * kDt_s));
}

TEST_CASE("world: a bounce below 0.2 m/s is none, and the bucket is where the proxy is") {
    for (const double down_m_per_s : {0.79, 0.81}) {
        ToldWorld world(make_weightless_plan());
        world.drop(1, {2.0, 0.0401, 0.0}, {0.3, -down_m_per_s, 0.0});
        world.run(kFarTool);
        REQUIRE(world.body().where == BodyWhere::landed);
        CHECK(world.is_at_rest() == (down_m_per_s < 0.8));
        CHECK(world.body().velocity_W.y() ==
              Approx(down_m_per_s < 0.8 ? 0.0 : 0.25 * down_m_per_s));
    }
    ToldWorld world(make_weightless_plan());
    HapticState tool = tool_at({0.0, 1.0, 0.0});
    tool.tool_pose_W.position = Vector3(0.0, 0.4, 0.0);  // pressed deep into a table
    world.run(tool);
    world.hold(1);
    CHECK((world.at_W() - Vector3(0.036, 0.92, 0.0)).norm() < kExact);
}

TEST_CASE("world: the catch is continuous in place, turn and velocity, and the glide is its law") {
    ToldWorld world(make_weightless_plan());
    // The bucket is turned about its own axis, so that a turn in its frame is another than in the world's.
    HapticState tool = tool_at({0.3, 1.0, -0.2});
    tool.tool_pose_W.orientation = compute_exp(Vector3(0.0, 0.7, 0.0));
    const Pose tool_WT{tool.proxy_position_W, tool.tool_pose_W.orientation};
    world.run(tool);
    const Vector3 start_T(0.02, 0.0015, 0.01);
    const Vector3 start_W = tool_WT * start_T;
    world.drop(1, start_W, Vector3(0.0, -1.0, 0.0));
    world.run(tool);
    REQUIRE(world.events().size() == 1);
    CHECK(world.events()[0].kind == WorldEvent::Kind::caught);
    // 1.5 mm of the step's 2 mm above the rim, a quarter of the step left to glide.
    const Vector3 rest_T(0.6 * (0.1 - 0.04), -0.12 + 0.04, 0.0);
    const Vector3 rim_T(start_T.x(), 0.0, start_T.z());
    const auto glided_W = [&](double glide_s) {
        return Vector3(tool_WT * (rest_T + std::exp(-glide_s / 0.08) * (rim_T - rest_T)));
    };
    const Vector3 caught_W = world.at_W();
    CHECK((caught_W - glided_W(0.25 * kDt_s)).norm() < kExact);
    CHECK((world.body().velocity_W - (caught_W - start_W) / kDt_s).norm() < 1e-9);
    CHECK(turned_rad(Quaternion::Identity(), world.body().pose_W.orientation) ==
          Approx(1.5 * kDt_s));
    for (int k = 1; k <= 100; ++k) {
        world.run(tool);
        REQUIRE((world.at_W() - glided_W((k + 0.25) * kDt_s)).norm() < kExact);
    }
}

TEST_CASE("world: what is told as velocity is the way of the step, through fall, catch and ride") {
    for (const double share : {0.001, 0.3, 0.999}) {
        ToldWorld world;
        const auto tool_after = [](int k) {
            return tool_at(Vector3(0.1 * std::sin(0.004 * k), 0.5 + 0.05 * std::sin(0.01 * k), 0));
        };
        world.run(tool_after(0));
        world.drop(1, {0.0, 0.6 + share * 5.0 * kDt_s, 0.0}, {0.0, -5.0, 0.0});
        Vector3 before_W = world.at_W();
        for (int k = 1; k < 500; ++k) {
            world.run(tool_after(k));
            const Vector3 mean = (world.at_W() - before_W) / kDt_s;
            REQUIRE((world.body().velocity_W - mean).norm() < 1e-9);
            before_W = world.at_W();
        }
        CHECK(world.n_held() == 1);
    }
    // A body that the lesson puts into the tool rests there.
    ToldWorld world;
    world.run(kFarTool);
    world.drop(1, {0.0, 9.0, 0.0}, {0.0, -5.0, 0.0});
    world.hold(1);
    CHECK(world.body().velocity_W == Vector3::Zero());
    CHECK((world.at_W() - Vector3(0.036, 50.0 - 0.08, 0.0)).norm() < kExact);
}

TEST_CASE("world: the first tool pose is no sweep, a pose that is no rotation no pose") {
    ToldWorld world(make_weightless_plan());
    // Seen from the origin the body is above the rim, seen from the first pose below it.
    world.drop(1, {0.0, 0.5, 0.0});
    world.run(tool_at({0.0, 1.0, 0.0}));
    CHECK(world.body().where == BodyWhere::falling);
    world.hold(1);
    const Vector3 held_W = world.at_W();
    for (const double length : {0.0, 0.998, 1.002, 2.0}) {
        HapticState garbled = tool_at({0.0, 2.0, 0.0});
        garbled.tool_pose_W.orientation.coeffs() *= length;
        world.run(garbled);
        CHECK((world.at_W() - held_W).norm() < kExact);
    }
    HapticState rounded = tool_at({0.0, 2.0, 0.0});
    rounded.tool_pose_W.orientation.coeffs() *= 1.0 + 1.0e-6;
    world.run(rounded);
    CHECK(world.at_W().y() == Approx(held_W.y() + 1.0));
}

TEST_CASE("world: commands up to 10 km and 1 km/s are done, farther and faster ones ignored") {
    ToldWorld world;
    world.drop(1, {0.0, 1.0e4, 0.0}, {0, 1.0e3, 0});
    CHECK(world.ignored_commands() == 0);
    world.drop(1, {0.0, -1.001e4, 0.0});
    CHECK(world.ignored_commands() == 1);
    world.drop(1, Vector3::Zero(), Vector3(-1.001e3, 0.0, 0.0));
    CHECK(world.ignored_commands() == 2);
}

namespace {

const Vector3 kGravity_W(0.0, -9.81, 0.0);

RigidBody make_body(double drag_area_m2) {
    return make_rigid_body({0.2, 0.2, 0.05, drag_area_m2});
}
// Height after falling from rest for `time_s` in steps of `dt_s`.
double fall_m(double dt_s, double time_s, double drag_area_m2) {
    RigidBody body = make_body(drag_area_m2);
    const int n = static_cast<int>(std::lround(time_s / dt_s));
    for (int k = 0; k < n; ++k) {
        step_flight(body, kGravity_W, dt_s);
    }
    return body.pose_W.position.y();
}

}  // namespace

TEST_CASE("rigid body: free fall is semi-implicit Euler's own closed form") {
    RigidBody body = make_body(0.0);
    body.velocity_W = Vector3(1.0, 2.0, 0.0);
    const double dt_s = 0.002;
    for (int n = 1; n <= 500; ++n) {
        step_flight(body, kGravity_W, dt_s);
        // v_n = v_0 + g n dt,  x_n = v_0 n dt + g dt^2 n (n + 1) / 2
        REQUIRE(body.velocity_W.y() == Approx(2.0 - 9.81 * n * dt_s).margin(1e-12));
        REQUIRE(body.pose_W.position.y() ==
                Approx(2.0 * n * dt_s - 9.81 * dt_s * dt_s * n * (n + 1) / 2.0).margin(1e-12));
        REQUIRE(body.pose_W.position.x() == Approx(n * dt_s).margin(1e-12));
    }
}

TEST_CASE("rigid body: a fall's error halves with the step, its terminal speed is met at any") {
    // x(t) = -ln cosh(sqrt(g c) t) / c from rest.
    const double c = make_body(0.02).drag_per_m;
    const double exact_m = -std::log(std::cosh(std::sqrt(9.81 * c) * 2.0)) / c;
    double before = fall_m(0.02, 2.0, 0.02) - exact_m;
    for (double dt_s = 0.01; dt_s > 0.0005; dt_s *= 0.5) {
        const double error = fall_m(dt_s, 2.0, 0.02) - exact_m;
        CHECK(before / error == Approx(2.0).epsilon(0.02));
        before = error;
    }
    CHECK(std::abs(before) < 0.01);
    for (const double dt_s : {0.001, 0.05, 10.0}) {
        for (const double start_m_per_s : {0.0, -500.0}) {
            RigidBody body = make_body(0.02);
            body.velocity_W.y() = start_m_per_s;
            for (int k = 0; k < 20000; ++k) {
                step_flight(body, kGravity_W, dt_s);
            }
            CHECK(-body.velocity_W.y() ==
                  Approx(compute_terminal_speed_m_per_s(9.81, body.drag_per_m)).epsilon(1e-9));
        }
    }
    // m g = rho C_d A v^2 / 2
    const double v = compute_terminal_speed_m_per_s(9.81, make_body(0.02).drag_per_m);
    CHECK(0.5 * kAirDensity_kg_per_m3 * 0.02 * v * v == Approx(0.2 * 9.81));
}

TEST_CASE("rigid body: drag takes energy, and without gravity it never turns the motion round") {
    RigidBody body = make_body(0.5);
    body.velocity_W = Vector3(30.0, 40.0, -20.0);
    const Vector3 way = body.velocity_W.normalized();
    double before = body.velocity_W.norm();
    for (int k = 0; k < 1000; ++k) {
        step_flight(body, Vector3::Zero(), 0.01);
        REQUIRE(body.velocity_W.norm() < before);
        REQUIRE(body.velocity_W.normalized().dot(way) == Approx(1.0));
        before = body.velocity_W.norm();
    }
    // With gravity: kinetic plus potential energy falls in every step. Semi-implicit Euler without drag changes it by
    // -m g^2 dt^2 / 2 a step, exactly.
    RigidBody free = make_body(0.0);
    const auto energy_J = [](const RigidBody& b) {
        return 0.5 * b.mass_kg * b.velocity_W.squaredNorm() +
               b.mass_kg * 9.81 * b.pose_W.position.y();
    };
    double energy = energy_J(free);
    for (int k = 0; k < 100; ++k) {
        step_flight(free, kGravity_W, 0.002);
        REQUIRE(energy_J(free) - energy ==
                Approx(-0.5 * 0.2 * 9.81 * 9.81 * 0.002 * 0.002).epsilon(1e-6));
        energy = energy_J(free);
    }
}

TEST_CASE("rigid body: a spin turns by its angle and stays a rotation, in air of 1.204 kg / m^3") {
    // c = 1.204 * 0.02 / (2 * 0.2)
    CHECK(make_body(0.02).drag_per_m == Approx(0.0602));
    // From upright in many steps; and turned about x first, where y lies along z, in one: a quarter turn about the world's z leaves it there.
    for (const int n_steps : {1000, 1}) {
        CAPTURE(n_steps);
        RigidBody body = make_body(0.0);
        if (n_steps == 1) {
            body.pose_W.orientation = AngleAxis(0.5 * std::numbers::pi, Vector3::UnitX());
        }
        const Vector3 along_y = body.pose_W.orientation * Vector3::UnitY();
        body.spin_W = Vector3(0.0, 0.0, 0.5 * std::numbers::pi);
        for (int k = 0; k < n_steps; ++k) {
            step_flight(body, Vector3::Zero(), 1.0 / n_steps);
        }
        const Quaternion& turn = body.pose_W.orientation;
        const double within = n_steps == 1 ? 1e-12 : 1e-9;
        CHECK((turn * Vector3::UnitX() - Vector3::UnitY()).norm() < within);
        CHECK((turn * Vector3::UnitY() - Vector3::UnitZ().cross(along_y) -
               along_y.z() * Vector3::UnitZ())
                  .norm() < within);
        CHECK(turn.coeffs().norm() == Approx(1.0).epsilon(1e-14));
    }
}

TEST_CASE("catcher: the opening's border decides, and from below nothing is caught") {
    const Catcher catcher(make_world_plan().catcher);
    CHECK(catcher.compute_reach_m(0.04) == Approx(0.09));
    CHECK(catcher.compute_reach_m(1.0) == Approx(0.05));
    const auto inside = [&](double x, double from_y, double to_y) {
        return catcher.compute_crossing(Vector3(x, from_y, 0), Vector3(x, to_y, 0), 0.04).inside;
    };
    CHECK(inside(0.089, 0.01, -0.01));
    CHECK_FALSE(inside(0.091, 0.01, -0.01));
    CHECK_FALSE(inside(0.0, -0.01, 0.01));
    CHECK_FALSE(inside(0.0, -0.01, -0.02));
    CHECK_FALSE(inside(0.0, 0.02, 0.01));
    CHECK(inside(0.0, 0.0, -0.01));
    const Crossing slanted =
        catcher.compute_crossing(Vector3(0.2, 0.03, 0.0), Vector3(-0.2, -0.01, 0.0), 0.04);
    CHECK(slanted.share == Approx(0.75));
    CHECK(slanted.radius_m == Approx(0.1));
}

TEST_CASE("catcher: the seeds of a sunflower, each as low as the floor and its neighbours allow") {
    const Catcher catcher(make_world_plan().catcher);
    std::vector<RigidBody> bodies(2, make_rigid_body(make_world_plan().bodies[1]));
    const double aside_m = 0.6 * (0.1 - 0.04);
    const Vector3 first_T = catcher.compute_resting_place(0.04, bodies);
    CHECK((first_T - Vector3(aside_m, -0.12 + 0.04, 0.0)).norm() < 1e-15);
    bodies[0].where = BodyWhere::held;
    bodies[0].resting_place_T = first_T;
    // Turned on by the golden angle, leaning on the first: the centres are two radii apart.
    constexpr double kGoldenAngle_rad = 2.399963229728653;
    const double across_m = 2.0 * aside_m * std::sin(0.5 * kGoldenAngle_rad);
    const Vector3 second_T = catcher.compute_resting_place(0.04, bodies);
    const Vector3 expected_T(aside_m * std::cos(kGoldenAngle_rad),
                             first_T.y() + std::sqrt(0.08 * 0.08 - across_m * across_m),
                             aside_m * std::sin(kGoldenAngle_rad));
    CHECK((second_T - expected_T).norm() < 1e-12);
    // One that fills the opening lies in the middle, upon both.
    CHECK(catcher.compute_resting_place(0.1, bodies).head<1>()[0] == Approx(0.0).margin(1e-15));
}

TEST_CASE(
    "world: each range of a plan is refused just outside, by name, and accepted at its ends") {
    using P = WorldPlan;
    check_ranges(
        make_world_plan(),
        {{"rate", [](P& p) -> double& { return p.rate_hz; }, 100.0, 1000.0},
         {"ground height", [](P& p) -> double& { return p.ground_height_m; }, -1000.0, 1000.0},
         {"opening", [](P& p) -> double& { return p.catcher.opening_radius_m; }, 0.001, 10.0},
         {"depth", [](P& p) -> double& { return p.catcher.depth_m; }, 0.0, 10.0},
         {"of body 1", [](P& p) -> double& { return p.bodies[1].mass_kg; }, 1e-6, 1e4},
         {"felt mass", [](P& p) -> double& { return p.bodies[1].felt_mass_kg; }, 0.0, 1e4},
         {"radius", [](P& p) -> double& { return p.bodies[1].radius_m; }, 0.001, 10.0},
         {"drag area", [](P& p) -> double& { return p.bodies[1].drag_area_m2; }, 0.0, 10.0}});
    WorldPlan plan = make_world_plan();
    plan.gravity_W = Vector3(60.0, -80.0, 0.0);
    plan.catcher.rim_centre_T = Vector3(6.0, 0.0, 8.0);
    check_refused(
        plan, {[](P& p) { p.gravity_W *= 1.001; }, [](P& p) { p.catcher.rim_centre_T.x() = 6.01; },
               [](P& p) { p.bodies.resize(kMaxBodies + 1); }});
}
