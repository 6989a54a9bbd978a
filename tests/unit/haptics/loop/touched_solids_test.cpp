#include "haptics/coupling/virtual_coupling.h"
#include "haptics/geometry/shape.h"
#include "haptics/loop/contact_stage.h"
#include "haptics/loop/solid_push.h"
#include "tests/support/touchable.h"
#include "tests/unit/haptics/loop/rounds.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace fulcrum;

namespace {

constexpr CouplingSettings kSoft{.stiffness_N_per_m = 200.0, .damping_Ns_per_m = 1.0};
constexpr CouplingSettings kHard{.stiffness_N_per_m = 900.0, .damping_Ns_per_m = 5.0};

// Two solids of their own stiffness, and a third that has the plan's.
HapticPlan make_plan() {
    HapticPlan plan;
    plan.coupling = {.stiffness_N_per_m = 500.0, .damping_Ns_per_m = 3.0};
    plan.solids.resize(3);
    plan.solids[0].coupling = kSoft;
    plan.solids[1].coupling = kHard;
    return plan;
}

// A hand `a` deep in a floor of solid 0 and `b` deep in a wall of solid 1; the proxy at the origin.
ProxyContact make_corner(double a, double b) {
    ProxyContact contact;
    contact.solid = a > b ? 0 : 1;
    contact.n_constraints = 2;
    contact.touches[0] = {.solid = 0, .feature = -1, .normal_W = Vector3::UnitY(), .push_m = a};
    contact.touches[1] = {.solid = 1, .feature = -1, .normal_W = Vector3::UnitX(), .push_m = b};
    contact.normal_W = Vector3(b, a, 0.0).normalized();
    return contact;
}

// A proxy at a place, held by one plane of solid 0 and dragged along it.
ProxyContact make_touched(const Vector3& at_W, const Vector3& normal_W, std::int32_t solid = 0,
                          std::int32_t feature = -1, const Vector3& drag_W = Vector3::Zero()) {
    ProxyContact contact;
    contact.position_W = at_W;
    contact.solid = solid;
    contact.n_constraints = 1;
    contact.normal_W = normal_W;
    contact.touches[0] = {.solid = solid,
                          .feature = feature,
                          .normal_W = normal_W,
                          .push_m = 0.002,
                          .drag_W = drag_W,
                          .friction_coefficient = drag_W.isZero(0.0) ? 0.0 : 0.8};
    return contact;
}

// What is felt at that velocity against all that is touched.
ContactForce feel(ContactStage& stage, const ProxyContact& contact, const Vector3& hand_W,
                  const Vector3& velocity_W = Vector3::Zero(), std::span<const Pose> poses_W = {}) {
    const std::array<Vector3, kMaxTouches> velocities_W{velocity_W, velocity_W, velocity_W};
    return stage.step(contact, hand_W, velocities_W, poses_W);
}

// A mesh that is shaded up to a crease, on a spring of 500 N/m alone.
HapticPlan make_shaded(const MeshShape& mesh, double crease_deg) {
    HapticPlan plan;
    plan.coupling = {.stiffness_N_per_m = 500.0, .damping_Ns_per_m = 0.0};
    plan.solids = only_solid(mesh);
    plan.solids[0].surface.shading = {crease_deg > 0.0, std::max(crease_deg, 1.0)};
    return plan;
}

ProxyContact make_two_touches() {
    ProxyContact contact;
    contact.position_W = {0.1, 0.2, 0.3};
    contact.solid = 0;
    contact.n_constraints = 2;
    contact.normal_W = Vector3::UnitY();
    contact.touches[0] = {0, -1, Vector3::UnitY(), 0.003};
    contact.touches[1] = {1, -1, Vector3::UnitX(), 0.004};
    return contact;
}

}  // namespace

TEST_CASE("contact stage: each solid has its own coupling, one without has the plan's") {
    ContactStage stage(make_plan());
    for (const auto& [solid, coupling] :
         {std::pair{0, kSoft}, {1, kHard}, {2, make_plan().coupling}, {7, make_plan().coupling}}) {
        const ProxyContact contact = make_touched(Vector3::Zero(), Vector3::UnitY(), solid);
        const Vector3 velocity(0.0, -0.1, 0.0);
        const ContactForce felt = feel(stage, contact, Vector3(0.0, -0.002, 0.0), velocity);
        CHECK(felt.spring.force.y() == Approx(0.002 * coupling.stiffness_N_per_m));
        CHECK(felt.force_W.y() ==
              Approx(0.002 * coupling.stiffness_N_per_m + 0.1 * coupling.damping_Ns_per_m));
        CHECK(felt.spring.push == Approx(felt.force_W.y()));
        CHECK(felt.spring.energy_J == Approx(0.5 * coupling.stiffness_N_per_m * 4.0e-6));
        REQUIRE(stage.touches().size() == 1);
        CHECK(stage.touches()[0].stiffness_N_per_m == Approx(coupling.stiffness_N_per_m));
        CHECK(stage.touches()[0].depth_m == 0.002);
    }
    stage.leave();
    CHECK(stage.touches().empty());
}

TEST_CASE("contact stage: between two solids the stiffness is weighed by how much each pushes") {
    ContactStage stage(make_plan());
    const auto felt = [&stage](double a, double b) {
        return feel(stage, make_corner(a, b), Vector3(-b, -a, 0.0));
    };
    const double k = (0.003 * 200.0 + 0.001 * 900.0) / 0.004;
    CHECK((felt(0.003, 0.001).force_W - k * Vector3(0.001, 0.003, 0.0)).norm() < 1.0e-12);
    // From one solid to the other without a step, at either end the force of one alone.
    Vector3 before = felt(0.003, 0.0).force_W;
    CHECK(before.y() == Approx(0.003 * 200.0));
    for (int i = 1; i <= 1000; ++i) {
        const double s = 1.0e-3 * i;
        const Vector3 now = felt(0.003 * (1.0 - s), 0.003 * s).force_W;
        CHECK((now - before).norm() < 0.01);
        before = now;
    }
    CHECK(before.x() == Approx(0.003 * 900.0));
}

TEST_CASE("contact stage: a wall never pulls, and a proxy without planes has one") {
    ContactStage stage(make_plan());
    ProxyContact contact;
    contact.solid = 1;
    contact.normal_W = Vector3::UnitY();
    const ContactForce felt = feel(stage, contact, Vector3(0.0, -1.0e-4, 0.0), Vector3(0, 1, 0));
    CHECK(felt.force_W == Vector3::Zero());
    REQUIRE(stage.touches().size() == 1);
    CHECK(stage.touches()[0].depth_m == Approx(1.0e-4));
    CHECK(stage.touches()[0].solid == 1);
}

TEST_CASE("contact stage: shading turns the force and keeps its size; else it is the spring's") {
    const auto mesh = touchable(make_sphere(0.05, 3));
    ContactStage flat(make_shaded(mesh, 0.0));
    ContactStage shaded(make_shaded(mesh, 60.0));
    CHECK(shaded.memory_bytes() > flat.memory_bytes());
    // A place beside the middle of a triangle, the solid moved and turned.
    const Pose pose_W{Vector3(0.3, 0.2, 0.1),
                      Quaternion(AngleAxis(0.7, Vector3(1, 2, 3).normalized()))};
    const auto& corners = mesh->corners(5);
    const Vector3 p0 = mesh->vertex_B(corners[0]);
    const Vector3 p1 = mesh->vertex_B(corners[1]);
    const Vector3 p2 = mesh->vertex_B(corners[2]);
    const Vector3 place_B = 0.7 * p0 + 0.2 * p1 + 0.1 * p2;
    const Vector3 normal_W = pose_W.orientation * (p1 - p0).cross(p2 - p0).normalized();
    ProxyContact contact = make_touched(pose_W * place_B, normal_W, 0, 5);
    const Vector3 hand_W = contact.position_W - 0.002 * normal_W;
    const std::array<Pose, 1> poses{pose_W};
    const ContactForce plain = feel(flat, contact, hand_W, Vector3::Zero(), poses);
    CHECK((plain.force_W - normal_W).norm() < 1.0e-9);
    const ContactForce turned = feel(shaded, contact, hand_W, Vector3::Zero(), poses);
    CHECK(turned.force_W.norm() == Approx(1.0));
    const Vector3 smooth_W = pose_W.orientation * place_B.normalized();
    CHECK(turned.force_W.dot(smooth_W) > plain.force_W.dot(smooth_W));
    CHECK((turned.force_W - smooth_W).norm() < 0.02);
    CHECK((turned.spring.normal - turned.force_W).norm() < 1.0e-12);
    CHECK((shaded.touches()[0].normal_W - turned.force_W).norm() < 1.0e-12);
    // From the inside it is turned as well, and still away from the surface.
    contact.touches[0].normal_W = contact.normal_W = -normal_W;
    const ContactForce inside =
        feel(shaded, contact, contact.position_W + 0.002 * normal_W, Vector3::Zero(), poses);
    CHECK((inside.force_W + turned.force_W).norm() < 1.0e-9);
}

TEST_CASE(
    "touched solids: what an even normal gives is lent on the way against the solid, not of one "
    "that moves on with the hand") {
    const auto mesh = touchable(make_sphere(0.1, 2));
    const auto corners = mesh->places_B(5);
    const Vector3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
    const Vector3 place = 0.7 * corners[0] + 0.2 * corners[1] + 0.1 * corners[2];
    for (const bool solid_moves : {true, false}) {
        ContactStage stage(make_shaded(mesh, 60.0));
        double recalled_J = 0.0;
        Vector3 before_W = Vector3::Zero();
        for (int k = 0; k < 2000; ++k) {
            // Along what shading turned of the force; its place on the facet stays, whoever moves.
            const Vector3 way = 2.0e-4 * k * (place - normal.dot(place) * normal).normalized();
            const std::array<Pose, 1> poses{Pose::at(solid_moves ? way : Vector3(Vector3::Zero()))};
            const Vector3 at_W = place + way;
            ProxyContact contact = make_touched(at_W, normal, 0, 5);
            const Vector3 felt_at_W = solid_moves ? at_W : place;
            contact.position_W = felt_at_W;
            const ContactForce felt =
                feel(stage, contact, at_W - 0.002 * normal, Vector3::Zero(), poses);
            const Vector3 moved_W = at_W - before_W;
            recalled_J +=
                k > 0 ? 0.5 * (felt.counted.now_W - felt.counted.held_W).dot(moved_W) : 0.0;
            before_W = at_W;
        }
        CAPTURE(solid_moves, recalled_J);
        CHECK((recalled_J > 1.0e-3) == !solid_moves);
        CHECK(recalled_J >= 0.0);
    }
}

TEST_CASE("contact stage: what friction holds stays in a shaded force") {
    const auto mesh = touchable(make_sphere(0.05, 3));
    ContactStage stage(make_shaded(mesh, 60.0));
    const Vector3 corner = mesh->vertex_B(mesh->corners(0)[0]);
    const Vector3 n = corner.normalized();
    const Vector3 t = n.unitOrthogonal();
    const std::array<Pose, 1> poses{};
    ProxyContact contact = make_touched(corner, n, 0, 0, 0.001 * t);
    const Vector3 hand = corner - 0.002 * n - 0.001 * t;
    const double size_N = std::hypot(1.0, 0.5);
    // The corner of a coarse ball: its normal is a degree off the radius.
    CHECK(
        (feel(stage, contact, hand, Vector3::Zero(), poses).force_W - (1.0 * n + 0.5 * t)).norm() <
        0.02);
    // Of a drag that the face it came from has held this one holds what its push does; what is viscous needs no push.
    for (const double viscous_m : {0.0, 0.0006}) {
        contact.touches[0].friction_coefficient = 0.2;
        contact.touches[0].viscous_m = viscous_m;
        const double drag = 0.2 + 500.0 * viscous_m;
        CHECK((feel(stage, contact, hand, Vector3::Zero(), poses).force_W -
               size_N * (n + drag * t).normalized())
                  .norm() < 0.02);
    }
}

TEST_CASE("contact stage: a shaded force stays in friction's cone, whatever the bend") {
    const auto mesh = touchable(make_sphere(0.05, 2));  // its faces meet at large angles
    ContactStage stage(make_shaded(mesh, 90.0));
    const auto corners = mesh->corners(0);
    const Vector3 corner = mesh->vertex_B(corners[0]);
    const Vector3 along = (mesh->vertex_B(corners[1]) - corner).normalized();
    const Vector3 n = (mesh->vertex_B(corners[1]) - corner)
                          .cross(mesh->vertex_B(corners[2]) - corner)
                          .normalized();
    for (const Vector3& t : {along, Vector3(-along), Vector3(n.cross(along))}) {
        const std::array<Pose, 1> poses{};
        const ContactForce felt = feel(stage, make_touched(corner, n, 0, 0, 0.0016 * t),
                                       corner - 0.002 * n - 0.0016 * t, Vector3::Zero(), poses);
        const Vector3& shaded = felt.spring.normal;
        CHECK(shaded.dot(n) < 0.98);  // bent by more than ten degrees
        const double across = felt.force_W.dot(shaded);
        const double held = (felt.force_W - across * shaded).norm();
        CHECK(held / across == Approx(0.8).epsilon(1.0e-9));
        CHECK(felt.force_W.norm() == Approx(500.0 * std::hypot(0.002, 0.0016)));
    }
}

TEST_CASE("solid push: two solids share the force as their planes hold the stretch") {
    const ProxyContact contact = make_two_touches();
    const Vector3 force_W(4.0, 3.0, 0.0);
    const SolidPush first = compute_solid_push(contact, 0, force_W, 0.02);
    const SolidPush second = compute_solid_push(contact, 1, force_W, 0.02);
    CHECK((first.force_W - Vector3(0.0, -3.0, 0.0)).norm() < kRounding);
    CHECK((second.force_W - Vector3(-4.0, 0.0, 0.0)).norm() < kRounding);
    // Each where the cursor's ball touches it.
    CHECK((first.at_W - Vector3(0.1, 0.18, 0.3)).norm() < kRounding);
    CHECK((second.at_W - Vector3(0.08, 0.2, 0.3)).norm() < kRounding);
    CHECK_FALSE(compute_solid_push(contact, 2, force_W, 0.02).touches);
}

TEST_CASE("solid push: one that is touched alone takes all of it") {
    ProxyContact contact = make_two_touches();
    contact.n_constraints = 1;
    const SolidPush push = compute_solid_push(contact, 0, {1.0, 3.0, -2.0}, 0.0);
    CHECK((push.force_W - Vector3(-1.0, -3.0, 2.0)).norm() < kRounding);
    CHECK((push.at_W - contact.position_W).norm() < kRounding);
}

TEST_CASE("solid push: no more than is felt is passed on") {
    SolidPush push{true, Vector3::Zero(), {0.0, 0.0, 10.0}, {0.5, 0.0, 0.0}};
    const PushShare left = limit_push({.force_N = 4.0, .torque_Nm = 1.0}, push);
    CHECK(left.force == Approx(0.4));
    CHECK(left.couple == Approx(0.4));
    CHECK((push.force_W - Vector3(0.0, 0.0, 4.0)).norm() < kRounding);
    CHECK((push.couple_W - Vector3(0.2, 0.0, 0.0)).norm() < kRounding);
    SolidPush gentle{true, Vector3::Zero(), {0.0, 0.0, 1.0}, {0.5, 0.0, 0.0}};
    const PushShare of_gentle = limit_push({.force_N = 4.0, .torque_Nm = 0.1}, gentle);
    CHECK(of_gentle.force == 1.0);
    CHECK(of_gentle.couple == Approx(0.2));
    CHECK((gentle.couple_W - Vector3(0.1, 0.0, 0.0)).norm() < kRounding);
}
