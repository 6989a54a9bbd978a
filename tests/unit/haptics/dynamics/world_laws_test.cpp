// The world's laws in closed form, one step at a time.
#include "haptics/dynamics/world.h"
#include "haptics/math/rotation.h"
#include "tests/unit/haptics/dynamics/world_fixture.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace fulcrum;

namespace {

using Kind = WorldCommand::Kind;

constexpr double kExact = 1.0e-12;  // metres: what rounding leaves of positions of a few metres
constexpr double kGravity_m_per_s2 = 9.81;
const HapticState kFarTool = tool_at(Vector3(0.0, 50.0, 0.0));

WorldPlan make_weightless_plan() {
    WorldPlan plan = make_world_plan();
    plan.gravity_W.setZero();
    return plan;
}

const BodyState& body_of(const World& world, std::size_t index = 1) {
    return world.snapshot().bodies[index];
}

double turned_rad(const Quaternion& from, const Quaternion& to) {
    return compute_log(to * from.conjugate()).norm();
}

}  // namespace

TEST_CASE("world: a drop turns by 1.5 radians a second, each drop about another axis") {
    World world(make_weightless_plan());
    Vector3 axes[2];
    for (Vector3& axis : axes) {
        world.apply(make_command(Kind::drop, 1, Vector3(3.0, 10.0, 0.0)));
        for (int k = 0; k < 100; ++k) {
            world.step(kDt_s, kFarTool);
        }
        axis = compute_log(body_of(world).pose_W.orientation);
        CHECK(axis.norm() == Approx(1.5 * 100 * kDt_s));
    }
    CHECK(axes[0].normalized().dot(axes[1].normalized()) < 0.9);
}

TEST_CASE("world: landing aslant, the speed told is the whole, a quarter and a half of it remain") {
    World world(make_world_plan());
    world.apply(make_command(Kind::drop, 1, Vector3(2.0, 0.54, 0.0), Vector3(2.0, 0.0, -1.0)));
    Quaternion before = Quaternion::Identity();
    double flight_rad = 0.0;
    int n = 0;
    while (world.events().empty() && n < 1000) {
        flight_rad = turned_rad(before, body_of(world).pose_W.orientation);
        before = body_of(world).pose_W.orientation;
        world.step(kDt_s, kFarTool);
        ++n;
    }
    // Semi-implicit Euler without drag: v_y = -g n dt; the step that reaches the ground is flown to its end.
    const double down_m_per_s = kGravity_m_per_s2 * n * kDt_s;
    REQUIRE(world.events().size() == 1);
    CHECK(world.events()[0].speed_m_per_s == Approx(Vector3(2.0, down_m_per_s, -1.0).norm()));
    CHECK((body_of(world).velocity_W - Vector3(1.0, 0.25 * down_m_per_s, -0.5)).norm() < kExact);
    CHECK(body_of(world).pose_W.position.y() == 0.04);
    // The spin is halved as well.
    const Quaternion landed = body_of(world).pose_W.orientation;
    world.step(kDt_s, kFarTool);
    CHECK(flight_rad == Approx(1.5 * kDt_s));
    CHECK(turned_rad(landed, body_of(world).pose_W.orientation) == Approx(0.75 * kDt_s));
}

TEST_CASE("world: a bounce slower than 0.2 m/s is none") {
    for (const double down_m_per_s : {0.79, 0.81}) {
        World world(make_weightless_plan());
        world.apply(make_command(Kind::drop, 1, Vector3(2.0, 0.0401, 0.0),
                                 Vector3(0.3, -down_m_per_s, 0.0)));
        world.step(kDt_s, kFarTool);
        REQUIRE(body_of(world).where == BodyWhere::landed);
        CHECK(world.is_at_rest() == (down_m_per_s < 0.8));
        CHECK(body_of(world).velocity_W.y() ==
              Approx(down_m_per_s < 0.8 ? 0.0 : 0.25 * down_m_per_s));
    }
}

TEST_CASE("world: the catch is continuous in place, turn and velocity, and the glide is its law") {
    World world(make_weightless_plan());
    // The bucket is turned about its own axis, so that a turn in its frame is another than in the world's.
    HapticState tool = tool_at(Vector3(0.3, 1.0, -0.2));
    tool.tool_pose_W.orientation = compute_exp(Vector3(0.0, 0.7, 0.0));
    const Pose tool_WT{tool.proxy_position_W, tool.tool_pose_W.orientation};
    world.step(kDt_s, tool);
    const Vector3 start_T(0.02, 0.0015, 0.01);
    const Vector3 start_W = tool_WT * start_T;
    world.apply(make_command(Kind::drop, 1, start_W, Vector3(0.0, -1.0, 0.0)));
    world.step(kDt_s, tool);
    REQUIRE(world.events().size() == 1);
    CHECK(world.events()[0].kind == WorldEvent::Kind::caught);
    // 1.5 mm of the step's 2 mm above the rim, a quarter of the step left to glide.
    const Vector3 rest_T(0.6 * (0.1 - 0.04), -0.12 + 0.04, 0.0);
    const Vector3 rim_T(start_T.x(), 0.0, start_T.z());
    const auto glided_W = [&](double glide_s) {
        return Vector3(tool_WT * (rest_T + std::exp(-glide_s / 0.08) * (rim_T - rest_T)));
    };
    const Vector3 caught_W = body_of(world).pose_W.position;
    CHECK((caught_W - glided_W(0.25 * kDt_s)).norm() < kExact);
    CHECK((body_of(world).velocity_W - (caught_W - start_W) / kDt_s).norm() < 1e-9);
    CHECK(turned_rad(Quaternion::Identity(), body_of(world).pose_W.orientation) ==
          Approx(1.5 * kDt_s));
    for (int k = 1; k <= 100; ++k) {
        world.step(kDt_s, tool);
        REQUIRE((body_of(world).pose_W.position - glided_W((k + 0.25) * kDt_s)).norm() < kExact);
    }
}

TEST_CASE("world: what is told as velocity is the way of the step, through fall, catch and ride") {
    for (const double share : {0.001, 0.3, 0.999}) {
        World world(make_world_plan());
        const auto tool_after = [](int k) {
            return tool_at(Vector3(0.1 * std::sin(0.004 * k), 0.5 + 0.05 * std::sin(0.01 * k), 0));
        };
        world.step(kDt_s, tool_after(0));
        world.apply(make_command(Kind::drop, 1, Vector3(0.0, 0.6 + share * 5.0 * kDt_s, 0.0),
                                 Vector3(0.0, -5.0, 0.0)));
        Vector3 before_W = body_of(world).pose_W.position;
        for (int k = 1; k < 500; ++k) {
            world.step(kDt_s, tool_after(k));
            const Vector3 mean = (body_of(world).pose_W.position - before_W) / kDt_s;
            REQUIRE((body_of(world).velocity_W - mean).norm() < 1e-9);
            before_W = body_of(world).pose_W.position;
        }
        CHECK(world.n_held() == 1);
    }
    // A body that the lesson puts into the tool rests there.
    World world(make_world_plan());
    world.step(kDt_s, kFarTool);
    world.apply(make_command(Kind::drop, 1, Vector3(0.0, 9.0, 0.0), Vector3(0.0, -5.0, 0.0)));
    world.apply(make_command(Kind::hold, 1));
    CHECK(body_of(world).velocity_W == Vector3::Zero());
    CHECK((body_of(world).pose_W.position - Vector3(0.036, 50.0 - 0.08, 0.0)).norm() < kExact);
}

TEST_CASE("world: the first tool pose is no sweep, a pose that is no rotation no pose") {
    World world(make_weightless_plan());
    // Seen from the origin the body is above the rim, seen from the first pose below it.
    world.apply(make_command(Kind::drop, 1, Vector3(0.0, 0.5, 0.0)));
    world.step(kDt_s, tool_at(Vector3(0.0, 1.0, 0.0)));
    CHECK(body_of(world).where == BodyWhere::falling);
    world.apply(make_command(Kind::hold, 1));
    const Vector3 held_W = body_of(world).pose_W.position;
    for (const double length : {0.0, 0.998, 1.002, 2.0}) {
        HapticState garbled = tool_at(Vector3(0.0, 2.0, 0.0));
        garbled.tool_pose_W.orientation.coeffs() *= length;
        world.step(kDt_s, garbled);
        CHECK((body_of(world).pose_W.position - held_W).norm() < kExact);
    }
    HapticState rounded = tool_at(Vector3(0.0, 2.0, 0.0));
    rounded.tool_pose_W.orientation.coeffs() *= 1.0 + 1.0e-6;
    world.step(kDt_s, rounded);
    CHECK(body_of(world).pose_W.position.y() == Approx(held_W.y() + 1.0));
}

TEST_CASE("world: the bucket is where the proxy is, not where the hand is") {
    World world(make_weightless_plan());
    HapticState tool = tool_at(Vector3(0.0, 1.0, 0.0));
    tool.tool_pose_W.position = Vector3(0.0, 0.4, 0.0);  // pressed deep into a table
    world.step(kDt_s, tool);
    world.apply(make_command(Kind::hold, 1));
    CHECK((body_of(world).pose_W.position - Vector3(0.036, 0.92, 0.0)).norm() < kExact);
}

TEST_CASE("world: commands up to 10 km and 1 km/s are done, farther and faster ones ignored") {
    World world(make_world_plan());
    world.apply(make_command(Kind::drop, 1, Vector3(0.0, 1.0e4, 0.0), Vector3(0, 1.0e3, 0)));
    CHECK(world.ignored_commands() == 0);
    world.apply(make_command(Kind::drop, 1, Vector3(0.0, -1.001e4, 0.0)));
    CHECK(world.ignored_commands() == 1);
    world.apply(make_command(Kind::drop, 1, Vector3::Zero(), Vector3(-1.001e3, 0.0, 0.0)));
    CHECK(world.ignored_commands() == 2);
}
