#include "haptics/loop/solid_push.h"

#include "tests/unit/haptics/loop/rounds.h"

#include <catch2/catch.hpp>

using namespace fulcrum;

namespace {

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

TEST_CASE("solid push: a damper drags only where friction holds") {
    ProxyContact contact = make_two_touches();
    contact.n_constraints = 1;
    const Vector3 spring_W(0.0, 2.0, 0.0);
    const Vector3 force_W(3.0, 3.0, 0.0);
    CHECK((compute_held_force(contact, force_W, spring_W) - Vector3(0.0, 3.0, 0.0)).norm() <
          kRounding);
    contact.touches[0].drag_W = {0.001, 0.0, 0.0};
    CHECK(compute_held_force(contact, force_W, spring_W) == force_W);
}

TEST_CASE("solid push: no more than the hand may feel is passed on, its couple in proportion") {
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
