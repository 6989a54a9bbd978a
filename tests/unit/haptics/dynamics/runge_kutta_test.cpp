#include "haptics/dynamics/integrator.h"
#include "tests/unit/haptics/dynamics/integrator_fixture.h"

#include <catch2/catch.hpp>

using namespace fulcrum;
using namespace fulcrum::test;

namespace {

// A torque about a fixed axis that follows time alone: t^3, which four stages integrate exactly (Simpson's rule).
class TimedTorque final : public Load {
  public:
    void add_wrench(const RigidState& /*state*/, double time_s,
                    Wrench& wrench) const noexcept override {
        wrench.force.x() += time_s * time_s * time_s;
        wrench.torque.z() += 1.0e-4 * time_s * time_s;
    }
    void add_linearised_wrench(const RigidState& state, double time_s, Wrench& wrench,
                               WrenchJacobian& /*jacobian*/) const noexcept override {
        add_wrench(state, time_s, wrench);
    }
};

}  // namespace

TEST_CASE("RK4: one step is exact for forces that are cubic in time") {
    RigidState state;
    step_rigid_body(settings_of(Integrator::runge_kutta_4), kBlock, TimedTorque(), 1.0, 0.5, state);
    // The integral of t^3 from 1 to 1.5 over the mass; the torque's turns about z alone.
    CHECK(state.velocity_W.linear.x() ==
          Approx((std::pow(1.5, 4) - 1.0) / 4.0 / kBlock.mass_kg).epsilon(1e-12));
    CHECK(
        state.velocity_W.angular.z() ==
        Approx(1.0e-4 * (std::pow(1.5, 3) - 1.0) / 3.0 / kBlock.moments_kg_m2.z()).epsilon(1e-12));
}

TEST_CASE("RK4: an even spin about a principal axis is exact at any step, past half a turn") {
    RigidState state;
    state.velocity_W.angular = {0.0, 0.0, 40.0};
    step_rigid_body(settings_of(Integrator::runge_kutta_4), kBlock, Loads<>(), 0.0, 0.1, state);
    CHECK(compute_angle_rad(state.pose_W.orientation, compute_exp({0.0, 0.0, 4.0})) < 1.0e-12);
}

TEST_CASE("RK4: matches the exact state of a body that turns freely, spin and all") {
    FreeRotation exact(kBlock.moments_kg_m2, 10.0, 0.9);
    const RigidState start = exact.compute_state(0.0);
    const RigidState end = exact.compute_state(1.0);
    const RigidState state =
        run(settings_of(Integrator::runge_kutta_4), kBlock, Loads<>(), start, 1.0, 1000);
    CHECK(compute_angle_rad(state.pose_W.orientation, end.pose_W.orientation) < 1.0e-8);
    CHECK((state.velocity_W.angular - end.velocity_W.angular).norm() < 1.0e-7);
}
