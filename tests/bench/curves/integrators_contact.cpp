// 100 g pressed on a plane of 2 kN/m at each of three points, off its rest: a stiff contact that is not left.
#include "haptics/dynamics/loads.h"
#include "tests/bench/curves/integrators.h"

#include <array>
#include <cmath>

namespace fulcrum::bench {
namespace {

PlaneContact make_foot(double x_m, double z_m) {
    return {.point_B = {x_m, -0.01, z_m},
            .plane_point_W = Vector3::Zero(),
            .normal_W = Vector3::UnitY(),
            .stiffness_N_per_m = 2000.0,
            .damping_Ns_per_m = 3.0,
            .damping_ramp_m = 0.0};
}

const std::array<PlaneContact, 3> kFeet{make_foot(0.03, 0.0), make_foot(-0.02, 0.025),
                                        make_foot(-0.02, -0.025)};
const PlaneContactsLoad kContacts(kFeet);
const ConstantLoad kPress({.force = {0.0, -3.0, 0.0}});
const Loads kLoad(kContacts, kPress);

double compute_push_N(const RigidState& state) {
    double sum_N = 0.0;
    for (const PlaneContact& foot : kFeet) {
        sum_N += fulcrum::compute_push_N(foot, state);
    }
    return sum_N;
}

}  // namespace

IntegratorProblem make_contact_problem() {
    IntegratorProblem problem;
    problem.name = "integrators-contact";
    problem.title = "Integrators on a stiff contact";
    problem.work =
        "100 g pressed by 3 N on a plane, 2 kN/m and 3 Ns/m at each of three points, let go 0.3 mm "
        "too deep, for 0.4 s; the worst error of the contact force at any of 20 instants";
    problem.advice =
        "On stiff contacts explicit methods end where h sqrt(k/m) passes about 2, explicit Euler "
        "already where h passes b/k; below that RK4 is the most exact. Backward Euler goes on at "
        "any rate, so it is the default of the library's step.";
    problem.error = {"error of contact force", "N", true};
    problem.inertia = make_box_inertia(0.1, {0.05, 0.02, 0.05});
    problem.start.pose_W.position = {0.0, 0.0092, 0.0};
    problem.load = &kLoad;
    problem.compute_error = [](const RigidState& state, const RigidState& expected) {
        return std::abs(compute_push_N(state) - compute_push_N(expected));
    };
    problem.unstable_above = 6.0;  // twice the pressing force
    problem.rounding = 1.0e-9;
    take_converged_course(problem, 20);
    return problem;
}

}  // namespace fulcrum::bench
