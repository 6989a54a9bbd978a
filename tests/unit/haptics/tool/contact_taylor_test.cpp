#include "haptics/tool/contact_taylor.h"

#include "haptics/math/rotation.h"
#include "tests/support/adding_load.h"
#include "tests/support/differentiated_loads.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>

using namespace fulcrum;
using namespace fulcrum::test;

namespace {

ContactPlanesSettings settings_of(PenaltyModel kind) {
    return {.model = kind, .stiffness_N_per_m = 5000.0, .damping_Ns_per_m = 8.0, .within_m = 0.001};
}

// Two clusters of an object, found with the tool at some place and on its way.
ContactModel make_model() {
    ContactModel model;
    model.n = 2;
    for (std::size_t i = 0; i < 2; ++i) {
        ToldContact& told = model.contacts[i];
        told.X_OT = {{0.01, 0.02, -0.01}, compute_exp(Vector3(0.2, -0.1, 0.3))};
        told.velocity_O = {{0.05, -0.1, 0.02}, {1.0, -2.0, 0.5}};
        told.cluster.id = static_cast<std::uint32_t>(i + 1);
        told.cluster.point_T = {0.01 - 0.03 * static_cast<double>(i), -0.01, 0.005};
        told.cluster.normal_O = Vector3(0.2, 1.0, -0.4 + 0.5 * static_cast<double>(i)).normalized();
        told.cluster.depth_m = 0.0004;
        told.cluster.place_O = told.X_OT * told.cluster.point_T + 0.0004 * told.cluster.normal_O;
    }
    return model;
}

// The object turns and goes.
std::array<MovingFrame, 1> make_objects() {
    std::array<MovingFrame, 1> objects{};
    objects[0].pose_W = {{0.1, -0.2, 0.3}, compute_exp(Vector3(-0.5, 0.4, 0.9))};
    objects[0].velocity_W = {{0.3, 0.1, -0.2}, {0.7, -0.4, 1.1}};
    return objects;
}

// The tool as the object saw it when it was found, moved on by as much as given.
RigidState place_tool(const ContactModel& model, const MovingFrame& object,
                      const Vector3& shift = Vector3::Zero(),
                      const Vector3& turn = Vector3::Zero()) {
    const Pose X_WT = object.pose_W * model.contacts[0].X_OT;
    const Twist& seen_O = model.contacts[0].velocity_O;
    RigidState state;
    state.pose_W = {X_WT.position + shift, compute_exp(turn) * X_WT.orientation};
    state.velocity_W.linear = compute_velocity_at(object, state.pose_W.position) +
                              object.pose_W.orientation * seen_O.linear;
    state.velocity_W.angular =
        object.velocity_W.angular + object.pose_W.orientation * seen_O.angular;
    return state;
}

// The contact's own law, at the very clusters.
Wrench find_exact(const ContactModel& model, const MovingFrame& object, const RigidState& state) {
    Wrench sum;
    for (const ToldContact& told : std::span(model.contacts).first(2)) {
        PlaneContact plane;
        plane.point_B = told.cluster.point_T;
        plane.normal_W = object.pose_W.orientation * told.cluster.normal_O;
        plane.plane_point_W =
            object.pose_W * Vector3(told.cluster.place_O + 0.001 * told.cluster.normal_O);
        plane.plane_velocity_W = compute_velocity_at(object, state.pose_W * told.cluster.point_T);
        plane.stiffness_N_per_m = 5000.0;
        plane.damping_Ns_per_m = 8.0;
        PlaneContactsLoad({&plane, 1}).add_wrench(state, 0.0, sum);
    }
    return sum;
}

}  // namespace

TEST_CASE("contact taylor: where it was found it is the force of all clusters, to rounding") {
    const ContactModel model = make_model();
    const auto objects = make_objects();
    const RigidState state = place_tool(model, objects[0]);
    const Wrench exact = find_exact(model, objects[0], state);
    CHECK(exact.force.norm() > 5.0);
    for (const PenaltyModel kind : {PenaltyModel::linearised, PenaltyModel::held}) {
        ContactTaylor taylor(settings_of(kind));
        taylor.learn(model);
        taylor.begin_step(objects);
        Wrench wrench;
        taylor.add_wrench(state, 0.0, wrench);
        CHECK((wrench.force - exact.force).norm() < 1.0e-9);
        CHECK((wrench.torque - exact.torque).norm() < 1.0e-10);
        CHECK((taylor.compute_wrench_of(0, state).force - wrench.force).norm() < 1.0e-12);
        CHECK(taylor.compute_wrench_of(1, state).force.norm() == 0.0);
    }
}

TEST_CASE(
    "contact taylor: beside it the series is right to the second order, and what is held stays") {
    const ContactModel model = make_model();
    const auto objects = make_objects();
    ContactTaylor series(settings_of(PenaltyModel::linearised));
    ContactTaylor held(settings_of(PenaltyModel::held));
    series.learn(model);
    held.learn(model);
    series.begin_step(objects);
    held.begin_step(objects);
    const auto error_at = [&](const Load& load, double share) {
        const RigidState state = place_tool(model, objects[0], share * Vector3(1e-4, -2e-4, 1e-4),
                                            share * Vector3(0.01, 0.005, -0.01));
        Wrench wrench;
        load.add_wrench(state, 0.0, wrench);
        return (wrench.force - find_exact(model, objects[0], state).force).norm();
    };
    CHECK(error_at(series, 1.0) / error_at(series, 0.5) == Approx(4.0).epsilon(0.1));
    CHECK(error_at(held, 1.0) / error_at(held, 0.5) == Approx(2.0).epsilon(0.1));
    CHECK(error_at(held, 1.0) > 20.0 * error_at(series, 1.0));
}

TEST_CASE("contact taylor: its derivatives are those of its wrench") {
    const ContactModel model = make_model();
    const auto objects = make_objects();
    for (const PenaltyModel kind : {PenaltyModel::linearised, PenaltyModel::held}) {
        ContactTaylor taylor(settings_of(kind));
        taylor.learn(model);
        taylor.begin_step(objects);
        const RigidState state =
            place_tool(model, objects[0], {2e-4, -1e-4, 3e-4}, {0.05, -0.08, 0.03});
        CHECK(find_jacobian_error(taylor, state) < 1.0e-6);
        CHECK(find_adding_error(taylor, state) < 1.0e-12);
    }
}

TEST_CASE("contact taylor: forgotten, or of an object that is not there, it is nothing") {
    ContactTaylor taylor(settings_of(PenaltyModel::linearised));
    taylor.learn(make_model());
    CHECK(taylor.is_near());
    taylor.begin_step({});
    Wrench wrench;
    taylor.add_wrench({}, 0.0, wrench);
    CHECK(wrench.force.norm() == 0.0);
    taylor.clear();
    CHECK_FALSE(taylor.is_near());
}
