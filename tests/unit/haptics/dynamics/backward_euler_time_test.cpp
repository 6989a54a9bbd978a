// Backward Euler under a load that has no time (load.h).
#include "haptics/dynamics/integrator.h"
#include "haptics/dynamics/loads.h"
#include "tests/unit/haptics/dynamics/integrator_fixture.h"

#include <catch2/catch.hpp>

#include <array>

using namespace fulcrum;
using namespace fulcrum::test;

TEST_CASE(
    "backward Euler: without time it ends with its best, which has felt the load, and says so") {
    // A wall whose damper comes in with the depth, so that Newton needs several steps.
    class Hurried final : public Load {
      public:
        explicit Hurried(int n_looks) : n_left_(n_looks) {}
        void add_wrench(const RigidState& state, double time_s,
                        Wrench& wrench) const noexcept override {
            --n_left_;
            contacts_.add_wrench(state, time_s, wrench);
        }
        void add_linearised_wrench(const RigidState& state, double time_s, Wrench& wrench,
                                   WrenchJacobian& jacobian) const noexcept override {
            contacts_.add_linearised_wrench(state, time_s, wrench, jacobian);
        }
        [[nodiscard]] bool has_time() const noexcept override { return n_left_ > 0; }

      private:
        std::array<PlaneContact, 1> planes_{{{.plane_point_W = {0.0, 0.0, 0.0},
                                              .stiffness_N_per_m = 1.0e5,
                                              .damping_Ns_per_m = 50.0,
                                              .damping_ramp_m = 1.0e-3}}};
        PlaneContactsLoad contacts_{planes_};
        mutable int n_left_;
    };
    const auto step = [](int n_looks, RigidState& state) {
        state.pose_W.position = {0.0, 0.01, 0.0};
        state.velocity_W.linear = {0.1, -2.0, 0.0};
        return step_rigid_body(settings_of(Integrator::backward_euler), kBlock, Hurried(n_looks),
                               0.0, 0.01, state);
    };
    RigidState all;
    REQUIRE(step(1000, all).status == StepStatus::done);
    RigidState some;
    const StepResult result = step(1, some);
    CHECK(result.status == StepStatus::out_of_time);
    CHECK(result.moved());
    CHECK(result.n_solves == 1);
    CHECK(some.velocity_W.linear.y() > -1.0);  // it did not fall on
}
