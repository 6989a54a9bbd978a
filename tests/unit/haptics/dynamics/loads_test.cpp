#include "haptics/dynamics/loads.h"

#include "tests/support/adding_load.h"
#include "tests/support/differentiated_loads.h"
#include "tests/unit/haptics/dynamics/integrator_fixture.h"

#include <catch2/catch.hpp>

#include <array>
#include <initializer_list>
#include <rapidcheck.h>
#include <vector>

using namespace fulcrum;
using namespace fulcrum::test;

namespace {

constexpr double kRounding = 1.0e-12;

// Central differences of 1e-6 on laws whose third derivatives are some 1e4 of the first: 1e-8 and rounding.
constexpr double kDifferences = 1.0e-6;

RigidState random_state() {
    const auto number = [](double size) { return size * 1.0e-3 * *rc::gen::inRange(-1000, 1001); };
    const auto vector = [&](double size) {
        return Vector3(number(size), number(size), number(size));
    };
    RigidState state;
    state.pose_W.position = vector(0.02);
    state.pose_W.orientation = compute_exp(vector(1.0));
    state.velocity_W = {vector(0.5), vector(10.0)};
    return state;
}

const PlaneContact kContact{.point_B = {0.01, -0.02, 0.03},
                            .plane_point_W = {0.0, 0.05, 0.0},
                            .normal_W = Vector3(0.6, 0.8, 0.0),
                            .stiffness_N_per_m = 2000.0,
                            .damping_Ns_per_m = 5.0,
                            .damping_ramp_m = 0.0};

const MovingFrame kHandle{{{0.03, 0.01, -0.04}, compute_exp({0.3, 0.8, -0.5})},
                          {{0.1, -0.2, 0.3}, {1.0, 2.0, -1.0}}};

// What no load may do: it sets one derivative.
class SettingLoad final : public Load {
  public:
    void add_wrench(const RigidState& /*state*/, double /*time_s*/,
                    Wrench& /*wrench*/) const noexcept override {}
    void add_linearised_wrench(const RigidState& /*state*/, double /*time_s*/, Wrench& /*wrench*/,
                               WrenchJacobian& jacobian) const noexcept override {
        jacobian.velocity(5, 5) = 1.0;
    }
};

// A body whose contact point lies `depth_m` behind the plane and sinks at `sinking_m_per_s`.
RigidState touching(double depth_m, double sinking_m_per_s) {
    RigidState state;
    state.pose_W.position = kContact.plane_point_W - kContact.point_B - depth_m * kContact.normal_W;
    state.velocity_W.linear = -sinking_m_per_s * kContact.normal_W;
    return state;
}

}  // namespace

TEST_CASE("loads: constant ones; contacts never pull, with a ramp they begin without a jump") {
    const ConstantLoad load({{1.0, -2.0, 3.0}, {0.1, 0.2, -0.3}});
    Vector6 expected;
    expected << 1.0, -2.0, 3.0, 0.1, 0.2, -0.3;
    CHECK((find_wrench(load, any_state()) - expected).norm() == 0.0);
    CHECK(compute_push_N(kContact, touching(-0.001, 1.0)) == 0.0);
    CHECK(compute_push_N(kContact, touching(0.0, 1.0)) == 0.0);
    CHECK(compute_push_N(kContact, touching(0.001, -1.0)) == 0.0);
    CHECK(compute_push_N(kContact, touching(0.001, -0.399)) == Approx(0.005).epsilon(1e-9));
    PlaneContact ramped = kContact;
    ramped.damping_ramp_m = 1.0e-4;
    // Without a ramp the push jumps by b u = 1 N.
    CHECK(compute_push_N(kContact, touching(1.0e-9, 0.2)) == Approx(1.0).epsilon(1e-4));
    CHECK(compute_push_N(ramped, touching(1.0e-9, 0.2)) < 2.0e-5);
    CHECK(compute_push_N(ramped, touching(0.5e-4, 0.2)) == Approx(0.1 + 0.5).epsilon(1e-9));
    CHECK(compute_push_N(ramped, touching(2.0e-4, 0.2)) ==
          Approx(compute_push_N(kContact, touching(2.0e-4, 0.2))).epsilon(kRounding));
}

TEST_CASE("loads: a point spring pulls to its anchor, damps its point, and turns by its arm") {
    const PointSpringLoad load({.point_B = {0.0, 0.1, 0.0},
                                .anchor_W = {0.3, 0.1, 0.0},
                                .stiffness_N_per_m = 100.0,
                                .damping_Ns_per_m = 2.0});
    RigidState state;
    state.velocity_W.angular = {0.0, 0.0, 4.0};  // the point moves at -0.4 along x
    const Vector6 wrench = find_wrench(load, state);
    CHECK(wrench[0] == Approx(30.0 + 0.8).epsilon(kRounding));
    CHECK(wrench[5] == Approx(-0.1 * 30.8).epsilon(kRounding));
    CHECK(wrench.block<4, 1>(1, 0).norm() < kRounding);
}

TEST_CASE("loads: a contact pushes along its normal with k d - b u_n, and makes torque") {
    const std::array<PlaneContact, 1> contacts{kContact};
    const PlaneContactsLoad load(contacts);
    const Vector6 wrench = find_wrench(load, touching(0.001, 0.1));
    const double push_N = 2000.0 * 0.001 + 5.0 * 0.1;
    CHECK((wrench.head<3>() - push_N * kContact.normal_W).norm() < 1.0e-10);
    CHECK((wrench.tail<3>() - kContact.point_B.cross(push_N * kContact.normal_W)).norm() < 1.0e-10);
    CHECK(compute_push_N(kContact, touching(0.001, 0.1)) == Approx(push_N).epsilon(1e-10));
    CHECK(compute_depth_m(kContact, touching(0.001, 0.0).pose_W) == Approx(0.001).epsilon(1e-10));
}

// x(t) of a critically damped spring that is let go at x0: x0 (1 + w t) e^(-w t), w^2 = k / m.
TEST_CASE("loads: let go, a tool turns back about each axis as what is critically damped does") {
    const Inertia inertia = make_box_inertia(0.05, {0.12, 0.04, 0.01});
    const Vector3& moments = inertia.moments_kg_m2;
    REQUIRE(moments.maxCoeff() > 8.0 * moments.minCoeff());
    const ToolCouplingSettings settings = make_critically_damped({}, inertia.mass_kg, moments);
    constexpr double kStart_rad = 0.3;
    constexpr double kStep_s = 1.0e-4;
    // RK4's fifth order in w h = 0.04.
    constexpr double kAccuracy = 1.0e-6;
    const Quaternion q_WH = compute_exp({0.5, -0.8, 1.1});
    for (const int axis : {0, 1, 2}) {
        ToolCouplingLoad coupling(settings);
        coupling.set_handle({{Vector3::Zero(), q_WH}, {}}, 0.0);
        RigidState state;
        state.pose_W.orientation = q_WH * compute_exp(kStart_rad * Vector3::Unit(axis));
        const double w = std::sqrt(settings.turn.stiffness_Nm_per_rad / moments[axis]);
        for (int i = 1; i * kStep_s * w < 12.0; ++i) {
            REQUIRE(step_rigid_body({.integrator = Integrator::runge_kutta_4}, inertia, coupling,
                                    (i - 1) * kStep_s, kStep_s, state)
                        .moved());
            const Vector3 left = compute_log(q_WH.conjugate() * state.pose_W.orientation);
            const double wt = w * i * kStep_s;
            REQUIRE(left[axis] ==
                    Approx(kStart_rad * (1.0 + wt) * std::exp(-wt)).margin(kAccuracy * kStart_rad));
            REQUIRE(left[axis] > 0.0);  // it never swings past
        }
    }
}

TEST_CASE("loads: each has the derivatives of finite differences, and adds to what is there") {
    const ConstantLoad weight({{1.0, -2.0, 3.0}, {0.1, 0.2, -0.3}});
    const PointSpringLoad spring({.point_B = {0.01, 0.02, -0.03},
                                  .anchor_W = {0.05, 0.0, 0.02},
                                  .stiffness_N_per_m = 300.0,
                                  .damping_Ns_per_m = 2.0});
    ToolCouplingSettings saturating;
    saturating.shift = {.stiffness_N_per_m = 500.0,
                        .damping_Ns_per_m = 4.0,
                        .linear_range_m = 0.005,
                        .saturation_range_m = 0.1,
                        .saturation_force_N = 25.0};
    saturating.turn = {.stiffness_Nm_per_rad = 0.5,
                       .damping_Nms_per_rad = {2e-3, 5e-3, 1e-3},
                       .linear_range_rad = 0.2,
                       .saturation_range_rad = 3.0,
                       .saturation_torque_Nm = 0.8};
    REQUIRE(validate(saturating));
    ToolCouplingSettings clamped;
    clamped.clamp_m = 0.002;
    std::vector<ToolCouplingLoad> couplings;
    for (const ToolCouplingSettings& settings : {ToolCouplingSettings{}, saturating, clamped}) {
        couplings.emplace_back(settings, Vector3(0.01, -0.02, 0.03));
        couplings.back().set_handle(kHandle, -0.01);
    }
    PlaneContact ramped = kContact;
    ramped.damping_ramp_m = 2.0e-3;
    const std::array<PlaneContact, 2> contacts{kContact, ramped};
    const PlaneContactsLoad contact(contacts);
    const PlaneContactsLoad none({});
    const Loads all(weight, spring, couplings[0]);
    CHECK(rc::check([&] {
        RigidState state = random_state();
        for (const Load* load : std::initializer_list<const Load*>{
                 &weight, &spring, &couplings[0], &couplings[1], &couplings[2], &none, &all}) {
            RC_ASSERT(find_jacobian_error(*load, state) < kDifferences);
            RC_ASSERT(find_adding_error(*load, state) < kRounding);
        }
        // Several as one add up.
        const Vector6 sum = find_wrench(weight, state) + find_wrench(spring, state) +
                            find_wrench(couplings[0], state);
        RC_ASSERT((find_wrench(all, state) - sum).norm() < kRounding);
        // Bring the point to a depth well off the kinks at 0 and at the ramp's end.
        for (const double depth_m : {-0.001, 0.001, 0.003}) {
            state.pose_W.position -=
                (depth_m - compute_depth_m(kContact, state.pose_W)) * kContact.normal_W;
            RC_ASSERT(find_adding_error(contact, state) < kRounding);
            const double push_N = compute_push_N(kContact, state);
            const double ramped_N = compute_push_N(ramped, state);
            if ((depth_m < 0.0) || (push_N > 1e-3 && ramped_N > 1e-3)) {
                RC_ASSERT(find_jacobian_error(contact, state) < kDifferences);
            }
        }
    }));
    CHECK(find_wrench(Loads<>(), any_state()).norm() == 0.0);
    // And what sets instead of adding is found.
    CHECK(find_adding_error(SettingLoad(), any_state()) > 1.0e-3);
}

TEST_CASE("loads: contact and coupling have the derivatives that automatic differentiation finds") {
    const ToolCouplingSettings coupling{
        .shift = {.stiffness_N_per_m = 500.0, .damping_Ns_per_m = 4.0},
        .turn = {.stiffness_Nm_per_rad = 0.5, .damping_Nms_per_rad = {0.001, 0.003, 0.002}}};
    const Vector3 grip(0.01, -0.02, 0.03);
    int n_pushing = 0;
    CHECK(rc::check([&] {
        RigidState state = random_state();
        ToolCouplingLoad load(coupling, grip);
        load.set_handle(kHandle, 0.0);
        RC_ASSERT(find_slope_error(load, state, find_coupling(coupling, kHandle, grip, state)) <
                  1.0e-9);
        // A wall that moves, met a millimetre deep.
        PlaneContact contact = kContact;
        contact.plane_velocity_W = {0.1, -0.3, 0.2};
        state.pose_W.position -=
            (0.001 - compute_depth_m(contact, state.pose_W)) * contact.normal_W;
        const std::array<PlaneContact, 1> contacts{contact};
        RC_ASSERT(find_slope_error(PlaneContactsLoad(contacts), state,
                                   find_contact(contact, state)) < 1.0e-9);
        n_pushing += compute_push_N(contact, state) > 0.0 ? 1 : 0;
    }));
    CHECK(n_pushing > 20);
}

TEST_CASE(
    "loads: the hand feels the opposite at its grip, and the handle moves on along its twist") {
    ToolCouplingLoad load({}, {0.02, 0.01, -0.03});
    load.set_handle({{{0.01, 0.0, 0.0}, compute_exp({0.0, 0.3, 0.0})}, {}}, 0.0);
    const RigidState state = any_state();
    const Wrench felt = load.compute_felt_wrench(state, 0.0);
    const Vector6 on_tool = find_wrench(load, state);
    const Vector3 arm = state.pose_W.orientation * Vector3(0.02, 0.01, -0.03);
    CHECK((on_tool.head<3>() + felt.force).norm() < kRounding);
    CHECK((on_tool.tail<3>() + felt.torque + arm.cross(felt.force)).norm() < kRounding);
    ToolCouplingLoad moving{ToolCouplingSettings{}};
    ToolCouplingLoad there{ToolCouplingSettings{}};
    const Twist twist{{0.1, 0.2, -0.3}, {0.0, 2.0, 0.0}};
    moving.set_handle({Pose::at({0.0, 0.0, 0.0}), twist}, 1.0);
    there.set_handle({{{0.05, 0.1, -0.15}, compute_exp({0.0, 1.0, 0.0})}, twist}, 1.5);
    const Wrench a = moving.compute_felt_wrench(any_state(), 1.5);
    const Wrench b = there.compute_felt_wrench(any_state(), 1.5);
    CHECK((a.force - b.force).norm() < kRounding);
    CHECK((a.torque - b.torque).norm() < kRounding);
}
