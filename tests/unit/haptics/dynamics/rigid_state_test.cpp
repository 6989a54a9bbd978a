#include "haptics/dynamics/rigid_state.h"

#include "haptics/math/rotation.h"

#include <catch2/catch.hpp>

using namespace fulcrum;

TEST_CASE("rigid state: spin and angular momentum belong together, in a body that is turned") {
    const Inertia inertia{0.2, {2.0e-5, 3.0e-5, 4.0e-5}};
    RigidState state;
    state.pose_W.orientation = compute_exp({0.4, -1.0, 0.7});
    state.velocity_W = {{1.0, 2.0, 2.0}, {3.0, -5.0, 2.0}};
    const Vector3 momentum = compute_angular_momentum_W(inertia, state);
    CHECK(
        (compute_inertia_W(inertia, state.pose_W.orientation) * state.velocity_W.angular - momentum)
            .norm() < 1.0e-18);
    CHECK((compute_spin_W(inertia, state.pose_W.orientation, momentum) - state.velocity_W.angular)
              .norm() < 1.0e-13);
    CHECK(compute_kinetic_energy_J(inertia, state) ==
          Approx(0.5 * (0.2 * 9.0 + state.velocity_W.angular.dot(momentum))).epsilon(1e-12));
}

TEST_CASE(
    "rigid state: the momentum of a spin about a principal axis is its moment times the spin") {
    const Inertia inertia{0.2, {2.0e-5, 3.0e-5, 4.0e-5}};
    RigidState state;
    state.pose_W.orientation = compute_exp({0.3, 0.2, -0.9});
    for (int axis = 0; axis < 3; ++axis) {
        state.velocity_W.angular = state.pose_W.orientation * Vector3(7.0 * Vector3::Unit(axis));
        CHECK((compute_angular_momentum_W(inertia, state) -
               inertia.moments_kg_m2[axis] * state.velocity_W.angular)
                  .norm() < 1.0e-18);
    }
}

TEST_CASE("rigid state: moments of a ball and of a box") {
    CHECK((make_ball_inertia(2.0, 0.1).moments_kg_m2 - Vector3::Constant(0.008)).norm() < 1.0e-15);
    const Inertia box = make_box_inertia(1.2, {0.1, 0.2, 0.3});
    CHECK((box.moments_kg_m2 - Vector3(0.013, 0.010, 0.005)).norm() < 1.0e-15);
    CHECK(box.mass_kg == 1.2);
}
