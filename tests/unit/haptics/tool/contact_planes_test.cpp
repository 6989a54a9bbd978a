#include "haptics/tool/contact_planes.h"

#include "haptics/math/rotation.h"
#include "haptics/tool/contact_taylor.h"
#include "tests/support/refused.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace fulcrum;

namespace {

constexpr double kDt_s = 0.001;
constexpr double kRounding = 1.0e-12;
const ContactPlanesSettings kPlain{.stiffness_N_per_m = 5000.0,
                                   .damping_Ns_per_m = 0.0,
                                   .within_m = 0.001,
                                   .rise_m_per_s = 0.1,
                                   .turn_rad_per_s = 50.0,
                                   .shift_m_per_s = 1.0};

// A cluster of a floor at y = 0, met by the tool's point at a depth.
ToldContact tell(std::uint32_t id, double depth_m, const Vector3& point_T = Vector3::Zero(),
                 const Vector3& normal_O = Vector3::UnitY()) {
    ToldContact told;
    told.X_OT = Pose::at(-depth_m * normal_O - point_T);
    told.cluster = {id, point_T, normal_O, Vector3::Zero(), depth_m, 1.0};
    return told;
}

ContactModel model_of(const std::vector<ToldContact>& all) {
    ContactModel model;
    model.stamp_s = 0.0;
    for (const ToldContact& one : all) {
        model.contacts[static_cast<std::size_t>(model.n++)] = one;
    }
    return model;
}

Wrench find_push(const ContactPlanes& planes, const Pose& tool_W) {
    Wrench wrench;
    PlaneContactsLoad(planes.planes()).add_wrench({tool_W, {}}, 0.0, wrench);
    return wrench;
}

const std::array<MovingFrame, 1> kStanding{};

}  // namespace

TEST_CASE("contact planes: what stays is pushed by k times how far it is in the layer") {
    ContactPlanes planes(kPlain);
    const ToldContact told = tell(1, 0.0004, {0.01, 0.0, 0.0});
    for (int i = 0; i < 100; ++i) {
        planes.learn(model_of({told}));
        planes.begin_step(told.X_OT, kStanding, kDt_s);
    }
    const Wrench push = find_push(planes, told.X_OT);
    CHECK(push.force.y() == Approx(5000.0 * 0.0014).epsilon(1e-9));
    CHECK(push.torque.z() == Approx(0.01 * 5000.0 * 0.0014).epsilon(1e-9));
    // And where the tool goes without being told anew, the plane goes on pushing as it lies.
    const Pose deeper = Pose::at(told.X_OT.position - 0.0006 * Vector3::UnitY());
    planes.begin_step(deeper, kStanding, kDt_s);
    CHECK(find_push(planes, deeper).force.y() == Approx(5000.0 * 0.002).epsilon(1e-9));
    const Pose away = Pose::at(Vector3(-0.01, 0.0011, 0.0));
    planes.begin_step(away, kStanding, kDt_s);
    CHECK(find_push(planes, away).force.norm() == 0.0);
}

TEST_CASE("contact planes: one that is told deep pushes nothing at first and comes at its rate") {
    ContactPlanes planes(kPlain);
    const ToldContact told = tell(1, 0.003);
    planes.learn(model_of({told}));
    for (int i = 1; i <= 60; ++i) {
        planes.begin_step(told.X_OT, kStanding, kDt_s);
        const double reach_m = std::min(0.004, 0.1 * kDt_s * i);
        REQUIRE(find_push(planes, told.X_OT).force.y() == Approx(5000.0 * reach_m).epsilon(1e-9));
    }
}

TEST_CASE("contact planes: one that is no longer told goes back at its rate and is gone") {
    ContactPlanes planes(kPlain);
    const ToldContact told = tell(1, 0.001);
    for (int i = 0; i < 100; ++i) {
        planes.learn(model_of({told}));
        planes.begin_step(told.X_OT, kStanding, kDt_s);
    }
    planes.learn(model_of({}));
    double last_N = find_push(planes, told.X_OT).force.y();
    CHECK(last_N == Approx(10.0).epsilon(1e-9));
    int n_steps = 0;
    while (planes.is_near() && n_steps < 100) {
        planes.begin_step(told.X_OT, kStanding, kDt_s);
        const double now_N = find_push(planes, told.X_OT).force.y();
        CHECK(last_N - now_N <= 0.5 * (1.0 + 1e-9));
        last_N = now_N;
        ++n_steps;
    }
    CHECK(n_steps == 20);
    CHECK(last_N == 0.0);
}

TEST_CASE("contact planes: what pushes nothing is where it was told to be, at once") {
    ContactPlanes planes(kPlain);
    planes.learn(model_of({tell(1, -0.0011)}));
    planes.begin_step(tell(1, -0.0011).X_OT, kStanding, kDt_s);
    const Vector3 other = Vector3(1.0, 1.0, 0.0).normalized();
    const ToldContact moved = tell(1, -0.0015, {0.05, 0.0, 0.0}, other);
    planes.learn(model_of({moved}));
    planes.begin_step(moved.X_OT, kStanding, kDt_s);
    REQUIRE(planes.planes().size() == 1);
    CHECK((planes.planes()[0].normal_W - other).norm() < kRounding);
    CHECK(compute_depth_m(planes.planes()[0], moved.X_OT) == Approx(-0.0005).epsilon(1e-9));
}

TEST_CASE("contact planes: a wall that moves takes its plane along and brakes what it meets") {
    ContactPlanesSettings damped = kPlain;
    damped.damping_Ns_per_m = 10.0;
    damped.within_m = 1.0e-3;
    ContactPlanes planes(damped);
    const ToldContact told = tell(1, 0.001);
    // The tool goes with the wall: nothing is damped. All turned on its side, far from the origin.
    const Quaternion turn = compute_exp(Vector3(0.0, 0.0, -1.0));
    std::array<MovingFrame, 1> wall{};
    wall[0].pose_W = {{0.3, 0.2, 0.1}, turn};
    wall[0].velocity_W.linear = {0.5, -0.2, 0.3};
    RigidState tool;
    for (int i = 0; i < 50; ++i) {
        planes.learn(model_of({told}));
        tool.pose_W = move_evenly(wall[0], -kDt_s).pose_W * told.X_OT;
        planes.begin_step(tool.pose_W, wall, kDt_s);
    }
    tool.pose_W = wall[0].pose_W * told.X_OT;
    tool.velocity_W = wall[0].velocity_W;
    REQUIRE(planes.planes().size() == 1);
    const PlaneContact& plane = planes.planes()[0];
    CHECK((plane.normal_W - turn * Vector3::UnitY()).norm() < kRounding);
    CHECK(compute_push_N(plane, tool) == Approx(10.0).epsilon(1e-9));
    tool.velocity_W.linear -= 0.1 * plane.normal_W;
    CHECK(compute_push_N(plane, tool) == Approx(11.0).epsilon(1e-9));
}

TEST_CASE("contact planes: more than there is room for, other objects, none at all") {
    ContactPlanes planes(kPlain);
    std::vector<ToldContact> many;
    for (std::uint32_t id = 1; id <= kMostClusters; ++id) {
        many.push_back(tell(id, 0.0));
    }
    planes.learn(model_of(many));
    planes.begin_step({}, kStanding, kDt_s);
    CHECK(planes.planes().size() == kMostClusters);
    for (ToldContact& one : many) {
        one.cluster.id += 100;
    }
    planes.learn(model_of(many));
    planes.begin_step({}, kStanding, kDt_s);
    CHECK(planes.planes().size() <= kMostClusters);
    // An object that is not there pushes nothing.
    planes.clear();
    CHECK_FALSE(planes.is_near());
    ToldContact elsewhere = tell(1, 0.001);
    elsewhere.object = 3;
    planes.learn(model_of({elsewhere}));
    planes.begin_step({}, kStanding, kDt_s);
    CHECK_FALSE(planes.is_near());
}

TEST_CASE("contact planes: settings outside their ranges are refused") {
    test::check_refused(
        kPlain,
        {[](auto& s) { s.stiffness_N_per_m = -1.0; }, [](auto& s) { s.damping_Ns_per_m = 1.0e5; },
         [](auto& s) { s.within_m = 0.0; }, [](auto& s) { s.rise_m_per_s = 0.0; },
         [](auto& s) { s.turn_rad_per_s = std::nan(""); },
         [](auto& s) { s.shift_m_per_s = 1.0e9; }});
}
