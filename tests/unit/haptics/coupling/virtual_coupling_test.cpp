#include "haptics/coupling/virtual_coupling.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

namespace fulcrum {
namespace {

const CouplingSettings kLinear{.stiffness_N_per_m = 800.0, .damping_Ns_per_m = 2.0};
// k s1 = 2 N; the blend ends at 5 N.
const CouplingSettings kSaturating{.stiffness_N_per_m = 800.0,
                                   .damping_Ns_per_m = 2.0,
                                   .linear_range_m = 0.0025,
                                   .saturation_range_m = 0.012,
                                   .saturation_force_N = 5.0};

double slope(const CouplingSettings& settings, double stretch_m) {
    const double step_m = 1.0e-8;
    return (compute_spring_force_N(settings, stretch_m + step_m) -
            compute_spring_force_N(settings, stretch_m - step_m)) /
           (2.0 * step_m);
}

// What a hand feels whose proxy a surface of that normal holds.
Vector3 feel(const CouplingSettings& settings, const Vector3& proxy, const Vector3& hand,
             const Vector3& relative_velocity, const Vector3& normal = Vector3::UnitY()) {
    return compute_contact_force(settings, compute_coupling_spring(settings, proxy, hand),
                                 relative_velocity, normal);
}

TEST_CASE(
    "virtual coupling: F = k (proxy - hand) - b v, towards the proxy and against the motion") {
    const Vector3 proxy(0.0, 0.01, 0.0);
    const Vector3 hand(0.003, 0.006, 0.0);
    const Vector3 velocity(0.1, 0.0, -0.2);
    const Vector3 force = feel(kLinear, proxy, hand, velocity);
    CHECK(force.x() == Approx(800.0 * -0.003 - 2.0 * 0.1).epsilon(1e-12));
    CHECK(force.y() == Approx(800.0 * 0.004).epsilon(1e-12));
    CHECK(force.z() == Approx(2.0 * 0.2).epsilon(1e-12));
}

TEST_CASE("virtual coupling: no drag in free space, where the proxy moves with the hand") {
    const Vector3 hand(0.3, -0.2, 0.1);
    const Vector3 hand_velocity(3.0, 1.0, -2.0);
    const Vector3 proxy_velocity = hand_velocity;
    const Vector3 force = feel(kLinear, hand, hand, hand_velocity - proxy_velocity);
    CHECK(force.norm() == 0.0);
}

TEST_CASE("virtual coupling: linear, then a cubic, then constant, with a continuous slope") {
    CHECK(compute_spring_force_N(kSaturating, 0.0) == 0.0);
    CHECK(compute_spring_force_N(kSaturating, 0.001) == Approx(0.8).epsilon(1e-12));
    CHECK(compute_spring_force_N(kSaturating, 0.0025) == Approx(2.0).epsilon(1e-12));
    CHECK(compute_spring_force_N(kSaturating, 0.012) == Approx(5.0).epsilon(1e-12));
    CHECK(compute_spring_force_N(kSaturating, 1.0e6) == 5.0);
    // Continuity from both sides of each seam; a difference of 1e-9 m is at most k 1e-9 = 1e-6 N.
    for (const double seam_m : {0.0025, 0.012}) {
        CHECK(std::abs(compute_spring_force_N(kSaturating, seam_m + 1e-9) -
                       compute_spring_force_N(kSaturating, seam_m - 1e-9)) < 2.0e-6);
        CHECK(std::abs(slope(kSaturating, seam_m + 2e-8) - slope(kSaturating, seam_m - 2e-8)) <
              0.02);
    }
    CHECK(slope(kSaturating, 0.0025 + 2e-8) == Approx(800.0).epsilon(1e-4));
    CHECK(std::abs(slope(kSaturating, 0.012 - 2e-8)) < 0.02);
    // The middle of a Hermite cubic: mean of the ends plus an eighth of width times slope
    // difference.
    CHECK(compute_spring_force_N(kSaturating, 0.00725) ==
          Approx(0.5 * (2.0 + 5.0) + 0.125 * 0.0095 * (800.0 - 0.0)).epsilon(1e-12));
}

TEST_CASE(
    "virtual coupling: the slope is the derivative of the force, on every piece and at the seams") {
    for (const double stretch_m : {0.0005, 0.002, 0.004, 0.007, 0.011, 0.02}) {
        CHECK(compute_spring_slope_N_per_m(kSaturating, stretch_m) ==
              Approx(slope(kSaturating, stretch_m)).epsilon(1e-6).margin(1e-6));
        CHECK(compute_spring_slope_N_per_m(kLinear, stretch_m) == 800.0);
    }
    CHECK(compute_spring_slope_N_per_m(kSaturating, 0.0025 + 1e-12) == Approx(800.0).epsilon(1e-6));
    CHECK(std::abs(compute_spring_slope_N_per_m(kSaturating, 0.012 - 1e-12)) < 1e-5);
}

TEST_CASE(
    "virtual coupling: the force never falls with the stretch, at the steepest blend allowed") {
    CouplingSettings steepest = kSaturating;
    steepest.saturation_force_N = 2.0 + 800.0 * 0.0095 / 3.0;
    steepest.saturation_force_N *= 1.0 + 1e-12;
    REQUIRE(validate(steepest));
    CouplingSettings steeper = steepest;
    steeper.saturation_force_N = 2.0 + 800.0 * 0.0095 / 3.0 * (1.0 - 1e-9);
    CHECK_FALSE(validate(steeper));
    double before_N = 0.0;
    for (int i = 1; i <= 20000; ++i) {
        const double force_N = compute_spring_force_N(steepest, 0.02 * i / 20000.0);
        REQUIRE(force_N >= before_N - 1e-12);
        before_N = force_N;
    }
}

TEST_CASE("virtual coupling: the direction is the stretch's and survives extreme lengths") {
    const Vector3 direction = Vector3(1.0, -2.0, 2.0) / 3.0;
    for (const double stretch_m : {1e-300, 1e-12, 1e-3, 1.0, 1e200}) {
        const Vector3 force =
            compute_coupling_spring(kSaturating, direction * stretch_m, Vector3::Zero());
        REQUIRE(is_finite(force));
        const double expected_N = compute_spring_force_N(kSaturating, stretch_m);
        CHECK((force - direction * expected_N).norm() <= 1e-12 * expected_N + 1e-300);
    }
}

TEST_CASE("virtual coupling: by default the bare handle is critically damped") {
    const CouplingSettings settings;
    CHECK(settings.stiffness_N_per_m == 500.0);
    // m x'' + b x' + k x = 0 has a double root exactly when b^2 = 4 m k.
    CHECK(settings.damping_Ns_per_m * settings.damping_Ns_per_m ==
          Approx(4.0 * kHandleMass_kg * settings.stiffness_N_per_m).epsilon(0.01));
}

TEST_CASE("virtual coupling: a surface pushes and never holds fast, and the rest is the coupling") {
    const Vector3 up = Vector3::UnitY();
    const Vector3 proxy(0.0, 0.001, 0.0);
    const auto moving = [&](const Vector3& velocity) {
        return feel(kLinear, proxy, Vector3::Zero(), velocity, up);
    };
    // 0.8 N of spring; leaving at 0.3 m/s takes 0.6 N of it, at 0.5 m/s it would pull back by 0.2 N.
    const Vector3 slow = moving({0.1, 0.3, 0.0});
    CHECK(slow.x() == Approx(-0.2));
    CHECK(slow.y() == Approx(0.2));
    const Vector3 fast = moving({0.1, 0.5, 0.0});
    CHECK(fast.x() == Approx(-0.2));
    CHECK(fast.y() == 0.0);
    CHECK(moving({0.0, -0.5, 0.0}).y() == Approx(1.8));
}

TEST_CASE("virtual coupling: the energy is the integral of the force, at every stretch") {
    for (const CouplingSettings& settings : {kLinear, kSaturating}) {
        constexpr double kStep_m = 1e-7;
        double energy_J = 0.0;
        for (int i = 0; i < 200000; ++i) {
            energy_J += kStep_m * compute_spring_force_N(settings, (i + 0.5) * kStep_m);
            if (i % 1000 == 999) {
                REQUIRE(compute_spring_energy_J(settings, (i + 1) * kStep_m) ==
                        Approx(energy_J).epsilon(1e-6));
            }
        }
        CHECK(compute_spring_energy_J(settings, 0.0) == 0.0);
    }
}

}  // namespace
}  // namespace fulcrum
