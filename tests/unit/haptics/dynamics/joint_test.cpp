// What an island of a world is solved of: its bodies (islands.h), joints (joint.h) and hands (hand_rows.h).
#include "haptics/dynamics/joint.h"

#include "haptics/dynamics/hand_rows.h"
#include "haptics/dynamics/islands.h"
#include "haptics/math/rotation.h"
#include "tests/support/refused.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace fulcrum {
namespace {

constexpr JointKind kKinds[] = {JointKind::ball, JointKind::hinge, JointKind::slider,
                                JointKind::fixed, JointKind::distance};

JointPlan make_plan(JointKind kind, Random& random) {
    return {.kind = kind,
            .body_a = 0,
            .body_b = 1,
            .anchor_W = random.in_cube(),
            .other_anchor_W = random.in_cube(),
            .axis_W = random.direction()};
}

Pose moved(const Pose& pose, const Vector6& velocity, double dt_s) {
    return {pose.position + dt_s * velocity.head<3>(),
            compute_exp(dt_s * velocity.tail<3>()) * pose.orientation};
}

Vector6 velocity_by_chance(Random& random) {
    Vector6 velocity;
    velocity << random.in_cube(), random.in_cube();
    return velocity;
}

// Two bodies on the way, each at any velocity for a microsecond, and what the joint's rows tell before and after.
struct Moved {
    static constexpr double kStep_s = 1.0e-6;
    Vector6 v_a, v_b;
    Pose later_a, later_b;
    JointRows before, after;

    Moved(const Joint& joint, const Pose& a, const Pose& b, Random& random)
        : v_a(velocity_by_chance(random)),
          v_b(velocity_by_chance(random)),
          later_a(moved(a, v_a, kStep_s)),
          later_b(moved(b, v_b, kStep_s)) {
        make_joint_rows(joint, a, b, 0.001, before);
        make_joint_rows(joint, later_a, later_b, 0.001, after);
    }
    // As the row tells.
    [[nodiscard]] double find_rate(std::size_t row) const {
        return before.rows[row].jacobian_a.dot(v_a) + before.rows[row].jacobian_b.dot(v_b);
    }
};

TEST_CASE("joint: errors grow as the rows say, on the joint's place and a little off it") {
    Random random(1);
    for (const JointKind kind : kKinds) {
        for (int i = 0; i < 40; ++i) {
            const Pose a{random.in_cube(), random.turn(3.0)};
            const Pose b{random.in_cube(), random.turn(3.0)};
            const Joint joint = make_joint(make_plan(kind, random), a, b);
            const Moved way(joint, a, b, random);
            REQUIRE(way.before.count == joint.n_rows);
            for (std::size_t row = 0; row < static_cast<std::size_t>(joint.n_rows); ++row) {
                CAPTURE(static_cast<int>(kind), row);
                REQUIRE(std::abs(way.before.errors[row]) < 1.0e-12);
                REQUIRE(way.after.errors[row] / Moved::kStep_s ==
                        Approx(way.find_rate(row)).margin(2.0e-5));
            }
        }
    }
}

TEST_CASE("joint: a slider far out turns with its rail; as many rows as degrees of freedom") {
    Random random(5);
    for (int i = 0; i < 40; ++i) {
        const Pose a{random.in_cube(), random.turn(3.0)};
        const Pose start{random.in_cube(), random.turn(3.0)};
        JointPlan plan = make_plan(JointKind::slider, random);
        plan.drive.motor_force = 1.0;
        const Joint joint = make_joint(plan, a, start);
        const Pose b{start.position + 0.8 * plan.axis_W.normalized(), start.orientation};
        CHECK(compute_joint_travel(joint, a, b) == Approx(0.8));
        const Moved way(joint, a, b, random);
        REQUIRE(way.before.count == 6);
        for (std::size_t row = 0; row < 6; ++row) {
            const double grown = row == 5
                                     ? compute_joint_travel(joint, way.later_a, way.later_b) - 0.8
                                     : way.after.errors[row] - way.before.errors[row];
            REQUIRE(grown / Moved::kStep_s == Approx(way.find_rate(row)).margin(2.0e-5));
        }
    }
    random = Random(2);
    const int taken[] = {3, 5, 5, 6, 1};
    for (std::size_t i = 0; i < 5; ++i) {
        CHECK(make_joint(make_plan(kKinds[i], random), Pose{}, Pose{}).n_rows == taken[i]);
    }
}

TEST_CASE("joint: travel is the angle of a hinge and the way of a slider, from where they were") {
    JointPlan plan{
        .body_a = -1, .body_b = 0, .anchor_W = {1.0, 0.0, 0.0}, .axis_W = {0.0, 0.0, 2.0}};
    plan.kind = JointKind::hinge;
    const Pose start{{0.5, 0.2, 0.0}, Quaternion(AngleAxis(0.4, Vector3::UnitX()))};
    const Joint hinge = make_joint(plan, Pose{}, start);
    CHECK(compute_joint_travel(hinge, Pose{}, start) == Approx(0.0).margin(1.0e-14));
    for (const double angle_rad : {0.3, -1.0, 3.0, -3.0}) {
        const Quaternion turn(AngleAxis(angle_rad, Vector3::UnitZ()));
        const Pose turned{plan.anchor_W + turn * (start.position - plan.anchor_W),
                          turn * start.orientation};
        CHECK(compute_joint_travel(hinge, Pose{}, turned) == Approx(angle_rad));
    }
    plan.kind = JointKind::slider;
    const Joint slider = make_joint(plan, Pose{}, start);
    CHECK(compute_joint_travel(slider, Pose{},
                               {start.position + Vector3(0.0, 0.0, 0.25), start.orientation}) ==
          Approx(0.25));
    plan.kind = JointKind::ball;
    CHECK(compute_joint_travel(make_joint(plan, Pose{}, start), Pose{}, start) == 0.0);
}

TEST_CASE("joint: a limit asks for the way that is left, a motor for its speed with its force") {
    JointPlan plan{.kind = JointKind::slider, .body_a = -1, .body_b = 0, .axis_W = {1.0, 0.0, 0.0}};
    plan.drive = {
        .lower = -0.1, .upper = 0.3, .motor_speed = 2.0, .motor_force = 5.0, .friction = 1.0};
    const Joint slider = make_joint(plan, Pose{}, Pose{});
    REQUIRE(slider.n_rows == 8);
    JointRows rows;
    make_joint_rows(slider, Pose{}, Pose::at({0.05, 0.0, 0.0}), 0.01, rows);
    CHECK(rows.rows[5].target == 2.0);
    CHECK(rows.rows[5].most == Approx(0.05));
    CHECK(rows.rows[6].target == Approx(-15.0));
    CHECK(rows.rows[6].least == 0.0);
    CHECK(rows.rows[7].target == Approx(25.0));
    CHECK(rows.rows[7].most == 0.0);
    make_joint_rows(slider, Pose{}, Pose::at({0.32, 0.0, 0.0}), 0.01, rows);
    CHECK(rows.rows[7].target == 0.0);
    CHECK(rows.errors[7] == Approx(0.02));
    CHECK(rows.errors[6] == 0.0);
    make_joint_rows(slider, Pose{}, Pose::at({-0.12, 0.0, 0.0}), 0.01, rows);
    CHECK(rows.errors[6] == Approx(-0.02));
}

TEST_CASE("joint: what joins nothing, has no axis, no length or drives that are none is refused") {
    Random random(3);
    using P = JointPlan;
    check_refused(
        make_plan(JointKind::hinge, random),
        [](const P& plan) { return validate(plan, 2, "joint 0").has_value(); },
        {[](P& p) { p.body_b = 2; }, [](P& p) { p.body_b = 0; }, [](P& p) { p.axis_W.setZero(); },
         [](P& p) { p.anchor_W.x() = std::nan(""); }, [](P& p) { p.drive.lower = 0.1; },
         [](P& p) { p.drive.motor_force = -1.0; }, [](P& p) { p.drive.friction = std::nan(""); },
         [](P& p) {
             p.kind = JointKind::ball;
             p.drive.friction = 1.0;
         },
         [](P& p) {
             p.kind = JointKind::distance;
             p.other_anchor_W = p.anchor_W;
         }});
}

using Links = std::vector<std::pair<std::int32_t, std::int32_t>>;

// Numbers spread along links until nothing changes: the least body of each island.
std::vector<std::int32_t> spread(const std::vector<std::uint8_t>& moves, const Links& links) {
    std::vector<std::int32_t> least(moves.size());
    for (std::size_t i = 0; i < least.size(); ++i) {
        least[i] = moves[i] != 0 ? static_cast<std::int32_t>(i) : -1;
    }
    for (bool changes = true; changes;) {
        changes = false;
        for (const auto& [a, b] : links) {
            auto& at_a = least[static_cast<std::size_t>(a)];
            auto& at_b = least[static_cast<std::size_t>(b)];
            if (at_a >= 0 && at_b >= 0 && at_a != at_b) {
                at_a = at_b = std::min(at_a, at_b);
                changes = true;
            }
        }
    }
    return least;
}

TEST_CASE("islands: what links reach, in any order, and nothing through what stands still") {
    Random random(1);
    Islands islands(30);
    for (int trial = 0; trial < 200; ++trial) {
        std::vector<std::uint8_t> moves;
        for (int i = 0; i < 30; ++i) {
            moves.push_back(random.uniform() > -0.7 ? 1 : 0);
        }
        Links links;
        for (int i = 0; i < trial % 40; ++i) {
            links.emplace_back(random.integer() % 30, random.integer() % 30);
        }
        const auto least = spread(moves, links);
        std::vector<std::int32_t> first;
        for (int order = 0; order < 2; ++order) {
            islands.begin(moves);
            for (const auto& [a, b] : links) {
                islands.link(a, b);
                islands.link(-1, b);
            }
            islands.finish();
            std::vector<std::int32_t> told;
            int n_bodies = 0;
            for (int i = 0; i < islands.count(); ++i) {
                const auto bodies = islands.bodies(i);
                REQUIRE(std::ranges::is_sorted(bodies));
                for (const std::int32_t body : bodies) {
                    REQUIRE(least[static_cast<std::size_t>(body)] == bodies.front());
                    REQUIRE(islands.island_of(body) == i);
                    told.push_back(body);
                    ++n_bodies;
                }
            }
            REQUIRE(n_bodies == std::ranges::count_if(moves, [](auto m) { return m != 0; }));
            REQUIRE((order == 0 || told == first));
            first = told;
            std::ranges::reverse(links);
        }
    }
    CHECK(islands.island_of(-1) == -1);
}

TEST_CASE("islands: groups keep numbers ascending, leave out what is in none, and may be empty") {
    Groups groups(6, 3);
    groups.sort(std::vector<std::int32_t>{2, 0, -1, 2, 0, 2}, 3);
    CHECK(std::ranges::equal(groups.group(0), std::vector<std::int32_t>{1, 4}));
    CHECK(groups.group(1).empty());
    CHECK(std::ranges::equal(groups.group(2), std::vector<std::int32_t>{0, 3, 5}));
    groups.sort({}, 0);
    groups.sort(std::vector<std::int32_t>{0}, 1);
    CHECK(groups.group(0).size() == 1);
}

constexpr double kRowStep_s = 0.01;
const Inertia kRowInertia{0.2, {1.0e-4, 2.0e-4, 3.0e-4}};

BodyHold make_row_hold() {
    BodyHold hold{.at_W = {0.03, 0.0, 0.0}, .push_W = {{2.0, 1.0, 0.0}, {0.0, 0.0, 0.05}}};
    hold.slopes = {600.0, 5.0, 0.5, 0.01, 0.04};
    hold.bounds = {.along_W = Vector3::UnitX(), .friction_N = 0.7, .most_N = 3.0, .most_Nm = 0.2};
    return hold;
}

HandRows make_rows(const BodyHold& hold, const RigidState& state = {}) {
    return make_hand_rows(hold, kRowInertia, state, kRowStep_s);
}

TEST_CASE("hand rows: a push answers with its spring and its damper, each with its share") {
    RigidState state;
    state.velocity_W.linear = {-0.1, 0.0, 0.0};
    const HandRows rows = make_rows(make_row_hold(), state);
    REQUIRE(rows.count == 7);
    const double spring_kg = kRowStep_s * kRowStep_s * 600.0;
    const double damper_kg = kRowStep_s * 5.0 + 0.04;
    const double share = spring_kg / (spring_kg + damper_kg);
    // The body comes on: the spring is shorter by h u at the end of the step.
    const double force_N = 2.0 + kRowStep_s * 600.0 * 0.1;
    const RowConstraint& spring = rows.rows[0];
    CHECK(spring.softness == Approx(1.0 / spring_kg));
    CHECK(spring.target == Approx(-0.1 + kRowStep_s * share * force_N / spring_kg));
    CHECK(spring.least == 0.0);
    CHECK(spring.most == Approx(kRowStep_s * share * 3.0));
    const RowConstraint& damper = rows.rows[1];
    CHECK(damper.softness == Approx(1.0 / damper_kg));
    CHECK(damper.target == Approx(-0.1 + kRowStep_s * (1.0 - share) * force_N / damper_kg));
    CHECK(damper.most == Approx(kRowStep_s * (1.0 - share) * 3.0));
    CHECK(rows.balls[1].n_along == 2);
    CHECK(rows.balls[1].most == Approx(kRowStep_s * 3.0));
}

TEST_CASE("hand rows: a push without force has its spring alone") {
    BodyHold hold = make_row_hold();
    hold.push_W.force.setZero();
    hold.bounds.friction_N = 0.0;
    const HandRows rows = make_rows(hold);
    REQUIRE(rows.count == 4);
    CHECK(rows.rows[0].softness == Approx(1.0 / (kRowStep_s * kRowStep_s * 600.0)));
    CHECK(rows.rows[0].target == 0.0);
    // One that goes away before it is none either.
    RigidState state;
    state.velocity_W.linear.x() = 0.5;
    const HandRows left = make_rows(hold, state);
    CHECK(left.rows[0].target == Approx(0.5));
}

TEST_CASE("hand rows: across it holds what friction bears, and turns no more than it may") {
    const HandRows rows = make_rows(make_row_hold());
    CHECK(rows.rows[2].most == Approx(kRowStep_s * 0.7));
    CHECK(rows.rows[2].least == Approx(-kRowStep_s * 0.7));
    CHECK(rows.balls[0].first == 2);
    CHECK(rows.balls[0].count == 2);
    CHECK(rows.balls[0].most == Approx(kRowStep_s * 0.7));
    CHECK(rows.rows[6].most == Approx(kRowStep_s * 0.2));
    CHECK(rows.rows[6].softness == Approx(1.0 / (kRowStep_s * (kRowStep_s * 0.5 + 0.01))));
    CHECK(rows.rows[6].impulse == Approx(kRowStep_s * 0.05));
}

TEST_CASE("hand rows: what pulls beyond its bounds counts as the nearest within, by its length") {
    BodyHold hold = make_row_hold();
    hold.bounds.along_W.setZero();
    hold.push_W.force = {20.0, -40.0, 40.0};
    hold.push_W.torque = {3.0, 4.0, 0.0};
    const HandRows rows = make_rows(hold);
    CHECK(rows.rows[0].impulse == Approx(kRowStep_s * 1.0));
    CHECK(rows.rows[1].impulse == Approx(-kRowStep_s * 2.0));
    CHECK(rows.rows[2].impulse == Approx(kRowStep_s * 2.0));
    CHECK(rows.rows[3].impulse == Approx(kRowStep_s * 0.12));
    CHECK(rows.rows[4].impulse == Approx(kRowStep_s * 0.16));
}

TEST_CASE("hand rows: a standing hand gives less as its body goes on; a grip holds every way") {
    BodyHold hold = make_row_hold();
    RigidState after;
    after.pose_W = {{0.001, 0.0, 0.0}, Quaternion(AngleAxis(0.5 * M_PI, Vector3::UnitZ()))};
    after.velocity_W = {{0.0, 0.2, 0.0}, {0.0, 0.0, 3.0}};
    carry_hold(RigidState{}, after, hold);
    CHECK((hold.at_W - Vector3(0.001, 0.03, 0.0)).norm() < 1.0e-15);
    // k (-0.029, 0.03) and b (0, 0.2) + b w x (0, 0.03) = b (-0.09, 0.2).
    CHECK(hold.push_W.force.x() == Approx(2.0 + 600.0 * 0.029 + 5.0 * 0.09));
    CHECK(hold.push_W.force.y() == Approx(1.0 - 600.0 * 0.03 - 5.0 * 0.2));
    CHECK(hold.push_W.torque.z() == Approx(0.05 - 0.5 * 0.5 * M_PI - 0.01 * 3.0));
    hold = make_row_hold();
    hold.bounds.along_W.setZero();
    HandRows rows = make_rows(hold);
    REQUIRE(rows.count == 6);
    CHECK(rows.rows[0].least == Approx(-kRowStep_s * 3.0));
    CHECK(rows.rows[2].least == Approx(-kRowStep_s * 3.0));
    CHECK(rows.rows[3].most == Approx(kRowStep_s * 0.2));
    hold.bounds.most_N = 0.0;
    hold.bounds.most_Nm = 0.0;
    CHECK(make_rows(hold).count == 0);
}

TEST_CASE("hand rows: without slopes a force is given as it is, no further than its bound") {
    BodyHold hold = make_row_hold();
    hold.slopes = {};
    hold.push_W.force.x() = 5.0;
    const HandRows rows = make_rows(hold);
    REQUIRE(rows.count == 6);
    // 5 N along and 0.7 N across, cut to 3 N together.
    const double length_N = std::hypot(5.0, 0.7);
    CHECK(rows.rows[0].least == Approx(kRowStep_s * 3.0 * 5.0 / length_N));
    CHECK(rows.rows[0].most == rows.rows[0].least);
    CHECK(rows.rows[0].softness == 0.0);
    CHECK(std::hypot(rows.rows[1].impulse, rows.rows[2].impulse) ==
          Approx(kRowStep_s * 3.0 * 0.7 / length_N));
}

}  // namespace
}  // namespace fulcrum
