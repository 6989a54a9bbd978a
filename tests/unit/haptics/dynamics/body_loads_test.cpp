#include "haptics/dynamics/body_loads.h"

#include <catch2/catch.hpp>

#include <limits>
#include <vector>

namespace fulcrum {
namespace {

RigidWorldBody make_sleeper(const Vector3& at_W) {
    RigidWorldBody body{.moves = true, .state = {.pose_W = Pose::at(at_W)}, .asleep = true};
    body.still_s = 1.0;
    return body;
}

BodyHold make_grip(double force_N, const Vector3& at_W) {
    return {.at_W = at_W,
            .push_W = {{force_N, 0.0, 0.0}, Vector3::Zero()},
            .slopes = {.stiffness_N_per_m = 100.0},
            .bounds = {.most_N = 10.0}};
}

std::vector<double> list_pushes(const BodyLoads& loads, const RigidWorldBody& body) {
    std::vector<double> pushes;
    loads.visit(body, [&](const BodyHold& hold) { pushes.push_back(hold.push_W.force.x()); });
    return pushes;
}

TEST_CASE("body loads: pushes add up and wake; what is no number leaves a body as it was") {
    RigidWorldBody body = make_sleeper(Vector3::Zero());
    BodyLoads loads(4);
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    BodyLoads::push({{kNone, 0.0, 0.0}, Vector3::Zero()}, body);
    loads.hold(make_grip(kNone, Vector3::Zero()), body);
    BodyHold pulled_apart = make_grip(1.0, Vector3::Zero());
    pulled_apart.slopes.damping_Ns_per_m = -1.0;
    loads.hold(pulled_apart, body);
    CHECK(body.asleep);
    CHECK_FALSE(body.touched);
    CHECK(list_pushes(loads, body).empty());

    BodyLoads::push({{1.0, 0.0, 0.0}, {0.0, 0.0, 0.5}}, body);
    BodyLoads::push({{2.0, 0.0, 0.0}, {0.0, 0.0, 0.25}}, body);
    CHECK(body.load_W.force.x() == 3.0);
    CHECK(body.load_W.torque.z() == 0.75);
    CHECK_FALSE(body.asleep);
    CHECK(body.still_s == 0.0);
    CHECK(body.touched);
}

TEST_CASE("body loads: each body has its own hands, and what finds no room is counted once") {
    RigidWorldBody first = make_sleeper(Vector3::Zero());
    RigidWorldBody second = make_sleeper(Vector3::UnitX());
    BodyLoads loads(3);
    loads.hold(make_grip(1.0, Vector3::Zero()), first);
    loads.hold(make_grip(2.0, Vector3::UnitX()), second);
    loads.hold(make_grip(3.0, Vector3::Zero()), first);
    loads.hold(make_grip(4.0, Vector3::UnitX()), second);
    CHECK(list_pushes(loads, first) == std::vector<double>{3.0, 1.0});
    CHECK(list_pushes(loads, second) == std::vector<double>{2.0});
    CHECK(loads.take_refused() == 1);
    CHECK(loads.take_refused() == 0);

    // A grip of 100 N/m whose body goes on by 1 cm gives 1 N less, and holds where the body is then. The other's stays.
    const RigidState before = first.state;
    first.state.pose_W.position.x() = 0.01;
    loads.carry(before, first);
    const std::vector<double> carried = list_pushes(loads, first);
    REQUIRE(carried.size() == 2);
    CHECK(carried[0] == Approx(2.0));
    CHECK(carried[1] == Approx(0.0).margin(1.0e-12));
    CHECK(list_pushes(loads, second) == std::vector<double>{2.0});
    loads.visit(first, [](const BodyHold& hold) { CHECK(hold.at_W.x() == Approx(0.01)); });

    first.forget_loads();
    loads.clear();
    CHECK(list_pushes(loads, first).empty());
    loads.hold(make_grip(5.0, Vector3::Zero()), first);
    CHECK(list_pushes(loads, first) == std::vector<double>{5.0});
}

}  // namespace
}  // namespace fulcrum
