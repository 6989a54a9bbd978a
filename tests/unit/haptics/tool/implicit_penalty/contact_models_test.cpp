#include "haptics/math/rotation.h"
#include "haptics/tool/contact_age.h"
#include "haptics/tool/implicit_penalty/contact_taylor.h"
#include "haptics/tool/implicit_penalty/implicit_penalty.h"
#include "tests/support/adding_load.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/differentiated_loads.h"
#include "tests/support/field_parts.h"
#include "tests/support/refused.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>

using namespace fulcrum;
using namespace fulcrum::test;

namespace {

constexpr double kDt_s = 0.001;

// Steps from `from_s` to `to_s` after which nothing newer than `told_s` has come.
void wait(ContactAge& age, double from_s, double to_s, double told_s) {
    const int n = static_cast<int>(std::lround((to_s - from_s) / kDt_s));
    for (int i = 0; i < n; ++i) {
        age.step(from_s + i * kDt_s, told_s, kDt_s);
    }
}

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

TEST_CASE("contact age: told in time it is felt whole, then it fades and comes back evenly") {
    ContactAge age({.hold_s = 0.1, .fade_s = 0.05});
    for (int i = 0; i < 1000; ++i) {
        age.step(i * kDt_s, i * kDt_s - 0.004, kDt_s);
        REQUIRE(age.share() == 1.0);
        REQUIRE_FALSE(age.is_late());
    }
    CHECK(age.age_s() == Approx(0.004));
    // Silent from 0.995 s on: nothing changes for a tenth of a second.
    wait(age, 1.0, 1.095, 0.995);
    CHECK(age.share() == 1.0);
    CHECK(age.age_s() == Approx(0.099));
    age = ContactAge({.hold_s = 0.1, .fade_s = 0.05});
    age.step(0.0, 0.0, kDt_s);
    double before = 1.0;
    for (int i = 1; i <= 400; ++i) {
        const double t_s = i * kDt_s;
        const double told_s = t_s < 0.2 ? 0.0 : t_s - 0.001;
        age.step(t_s, told_s, kDt_s);
        // In closed form, but for the step in which it was noticed.
        const double expected = t_s < 0.2 ? std::clamp(1.0 - (t_s - 0.1) / 0.05, 0.0, 1.0)
                                          : std::clamp((t_s - 0.199) / 0.05, 0.0, 1.0);
        REQUIRE(std::abs(age.share() - expected) < 1.001 * kDt_s / 0.05);
        REQUIRE(std::abs(age.share() - before) < 1.001 * kDt_s / 0.05);
        REQUIRE(age.is_late() == (t_s > 0.1 + 1e-12 && t_s < 0.2));
        if (t_s > 0.151 && t_s < 0.2) {
            REQUIRE(age.is_lost());
        }
        before = age.share();
    }
    CHECK(age.share() == 1.0);
}

TEST_CASE("contact age: no answer, one from the future, no number and bad settings") {
    ContactAge age({.hold_s = 0.1, .fade_s = 0.1});
    wait(age, 7.0, 7.05, -1.0);
    CHECK(age.age_s() == Approx(0.049));
    CHECK(age.share() == 1.0);
    wait(age, 7.05, 7.25, -1.0);
    CHECK(age.is_lost());
    age.restart();
    CHECK(age.share() == 1.0);
    CHECK(age.age_s() == 0.0);
    age.step(9.0, -1.0, kDt_s);
    CHECK(age.age_s() == 0.0);
    age = ContactAge({});
    age.step(1.0, 2.0, kDt_s);
    CHECK(age.age_s() == 0.0);
    age.step(1.0, kNan, kDt_s);
    CHECK(age.is_late());
    CHECK(age.share() < 1.0);
    check_ranges(ContactAgeSettings{},
                 {{"hold_s", [](auto& s) -> double& { return s.hold_s; }, 0.001, 10.0},
                  {"fade_s", [](auto& s) -> double& { return s.fade_s; }, 0.001, 10.0}});
}

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

TEST_CASE("contact taylor: right to the second order beside its place, with its derivatives") {
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
    for (const PenaltyModel kind : {PenaltyModel::linearised, PenaltyModel::held}) {
        ContactTaylor taylor(settings_of(kind));
        taylor.learn(model);
        taylor.begin_step(objects);
        const RigidState state =
            place_tool(model, objects[0], {2e-4, -1e-4, 3e-4}, {0.05, -0.08, 0.03});
        CHECK(find_jacobian_error(taylor, state) < 1.0e-6);
        CHECK(find_adding_error(taylor, state) < 1.0e-12);
    }
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

// An implicit tool among more contacts than are told of at a time.

TEST_CASE("implicit penalty: among six walls the last one holds as the first one does") {
    const Vector3 size(0.2, 0.1, 0.2);
    constexpr double kBlock_m = 0.3;
    constexpr double kPress_m = 0.02;
    const auto field = test::make_field(make_box(Vector3::Constant(kBlock_m)).value(), 96);
    const auto shell = test::make_shell(make_box(size).value(), 6000);
    const std::array<Vector3, 6> directions{-Vector3::UnitY(), -Vector3::UnitX(), Vector3::UnitX(),
                                            -Vector3::UnitZ(), Vector3::UnitY(),  Vector3::UnitZ()};
    std::vector<MovingFrame> objects(directions.size());
    ImplicitPenaltyPlan plan;
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const Vector3& d = directions[i];
        objects[i].pose_W =
            Pose::at(d * (0.5 * kBlock_m + 0.5 * size.cwiseProduct(d.cwiseAbs()).sum() + 4.0e-4));
        plan.objects.push_back({field, shell});
    }
    plan.settings.inertia = make_box_inertia(0.05, size);
    plan.settings.coupling.shift.stiffness_N_per_m = 500.0;
    plan.settings.coupling.turn.stiffness_Nm_per_rad = 2.0;
    for (const std::size_t against : {std::size_t{0}, directions.size() - 1}) {
        CAPTURE(against);
        ImplicitPenaltyTool tool = ImplicitPenaltyTool::build(plan).value();
        tool.place(Pose{});
        ToolFelt felt;
        for (int i = 1; i <= 400; ++i) {
            const double share = std::min(1.0, i / 200.0);
            felt = tool.move({Pose::at(share * kPress_m * directions[against]), {}}, objects,
                             1.0e-3 * i, 1.0e-3);
        }
        // There are more clusters than are told of, which is said, and none is without.
        CHECK(tool.model().n == kMostClusters);
        CHECK_FALSE(felt.effort.in_time);
        std::array<int, 6> n_of{};
        for (const ToldContact& told : tool.model().all()) {
            ++n_of.at(static_cast<std::size_t>(told.object));
        }
        CHECK(std::ranges::all_of(n_of, [](int n) { return n > 0; }));
        CHECK(tool.centre_W().norm() < 1.0e-3);
        CHECK(felt.felt_W.force.dot(-directions[against]) == Approx(500.0 * kPress_m).epsilon(0.1));
    }
}
