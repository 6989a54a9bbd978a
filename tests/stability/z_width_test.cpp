// What a sampled wall may be: theory's region of passivity, the exact boundary of stability, and the same in time by the
// code that renders it.
//
// In what sense they agree. Passivity (K T/2 + |B| < b, Colgate and Schenkel) promises stability with every passive hand:
// no hand of a wide set is unstable inside it. The boundary is also needed, by the worst hand: for B <= 0 a heavy free
// mass comes as near to it as it is heavy, and with any delay; for B > 0 a hand that resonates at the Nyquist frequency
// and its odd multiples, as near as it has resonances. One given hand is stable beyond it.
#include "haptics/math/plain_eigen.h"
#include "tests/support/linear_wall.h"
#include "tests/support/wall_trial.h"

#include <catch2/catch.hpp>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace fulcrum::z_width {
namespace {

// The fastest growth, in 1/s, of two modes with the device's damping and a continuous spring across both:
//   P1 P2 + (b s + K) (P1 + P2) = 0,   Pi = mi s^2 + ci s + ki
double find_continuous_growth(const Mode& one, const Mode& two, double damping, double stiffness) {
    const double mass = one.mass_kg * two.mass_kg;
    const double m = one.mass_kg + two.mass_kg;
    const double c = one.damping_Ns_per_m + two.damping_Ns_per_m;
    const double k = one.stiffness_N_per_m + two.stiffness_N_per_m;
    // Coefficients of s^0 to s^3, over that of s^4.
    const Eigen::Vector4d a =
        Eigen::Vector4d(
            one.stiffness_N_per_m * two.stiffness_N_per_m + stiffness * k,
            one.stiffness_N_per_m * two.damping_Ns_per_m +
                one.damping_Ns_per_m * two.stiffness_N_per_m + damping * k + stiffness * c,
            one.stiffness_N_per_m * two.mass_kg + one.mass_kg * two.stiffness_N_per_m +
                one.damping_Ns_per_m * two.damping_Ns_per_m + damping * c + stiffness * m,
            one.mass_kg * two.damping_Ns_per_m + one.damping_Ns_per_m * two.mass_kg + damping * m) /
        mass;
    Eigen::Matrix4d companion = Eigen::Matrix4d::Zero();
    companion.diagonal(-1).setOnes();
    companion.col(3) = -a;
    return companion.eigenvalues().real().maxCoeff();
}

TEST_CASE("z-width: two unequal modes share the device's damping and the wall's force") {
    // Sampled so fast that the hold takes away next to nothing: K T/2 of 0.02 Ns/m.
    constexpr double kPeriod_s = 1.0e-5;
    constexpr double kWithin = 0.01;
    const Mode light{0.1, 0.3, 50.0};
    const Mode heavy{0.7, 0.2, 2000.0};
    for (const double stiffness : {0.0, 300.0, 4000.0}) {
        for (const double damping : {0.0, 3.0, 20.0}) {
            LinearWall wall;
            wall.period_s = kPeriod_s;
            wall.device_damping_Ns_per_m = damping;
            wall.stiffness_N_per_m = stiffness;
            const double growth = find_continuous_growth(light, heavy, damping, stiffness);
            REQUIRE(growth < -0.01);
            for (const auto& modes : {std::vector{light, heavy}, std::vector{heavy, light}}) {
                wall.modes = modes;
                INFO("K " << stiffness << ", b " << damping);
                CHECK(std::log(compute_spectral_radius(wall)) / kPeriod_s ==
                      Approx(growth).epsilon(kWithin).margin(0.03));
            }
        }
    }
}

// Hands to try: free masses, springs with and without dampers, resonances around the Nyquist frequency, chains of them.
std::vector<std::vector<Mode>> make_hands(double period_s) {
    std::vector<std::vector<Mode>> hands;
    for (const double mass_kg : {0.01, 0.045, 0.3, 1.0, 10.0, 100.0}) {
        for (const double w : {0.0, 0.05, 0.3, 0.8, 0.95, 1.0, 1.05, 1.7, 2.0, 3.0, 3.9}) {
            const double w_per_s = w * std::numbers::pi / period_s;
            for (const double ratio : {0.0, 0.001, 0.1, 1.0}) {
                hands.push_back(
                    {{mass_kg, 2.0 * ratio * mass_kg * w_per_s, mass_kg * w_per_s * w_per_s}});
            }
        }
        for (const int n : {2, 5, 9}) {
            hands.push_back(make_nyquist_hand(n, mass_kg, period_s));
        }
    }
    for (const HumanImpedance& human : {kFingertip, kArm, kPosture}) {
        hands.push_back({{0.045 + human.mass_kg, human.damping_Ns_per_m, human.stiffness_N_per_m}});
    }
    return hands;
}

TEST_CASE("z-width: inside the region of passivity every wall is stable with every hand") {
    constexpr double kInside = 0.999;
    constexpr double kRounding = 1e-9;  // of an eigenvalue of a hand without any damping
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    int n_tried = 0;
    for (const double rate_Hz : {500.0, 1000.0, 4000.0}) {
        for (int i = 0; i < 12; ++i) {
            LinearWall wall;
            wall.period_s = 1.0 / rate_Hz;
            wall.device_damping_Ns_per_m = 0.1 + 9.9 * uniform(random);
            wall.delay_s = i % 3 == 0 ? 0.0 : 3.0 * wall.period_s * uniform(random);
            // A part of the damping goes to |B|, the rest to K.
            const double to_damping = i % 4 == 0 ? 0.0 : uniform(random);
            const double budget = kInside * wall.device_damping_Ns_per_m;
            wall.damping_Ns_per_m = (i % 2 == 0 ? 1.0 : -1.0) * to_damping * budget;
            wall.stiffness_N_per_m =
                (1.0 - to_damping) * budget / (0.5 * wall.period_s + wall.delay_s);
            REQUIRE(compute_passive_damping(wall) < wall.device_damping_Ns_per_m);
            for (const std::vector<Mode>& hand : make_hands(wall.period_s)) {
                wall.modes = hand;
                REQUIRE(compute_spectral_radius(wall) < 1.0 + kRounding);
                ++n_tried;
            }
        }
    }
    CHECK(n_tried > 10000);
}

TEST_CASE(
    "z-width: for B <= 0 a heavy hand's boundary is the formula's within 1 %, delayed or not") {
    constexpr double kHeavy_kg = 30.0;
    constexpr double kWithin = 0.01;
    for (const double rate_Hz : {500.0, 1000.0, 2000.0, 4000.0}) {
        for (const double damping : {0.0, -0.3, -0.9}) {
            for (const double late : {0.0, 0.4, 1.0, 2.5}) {
                LinearWall wall;
                wall.period_s = 1.0 / rate_Hz;
                wall.modes = {{kHeavy_kg, 0.0, 0.0}};
                wall.device_damping_Ns_per_m = 1.0;
                wall.damping_Ns_per_m = damping;
                wall.delay_s = late * wall.period_s;
                const double formula =
                    (1.0 - std::abs(damping)) / (0.5 * wall.period_s + wall.delay_s);
                CHECK(find_linear_boundary(wall) == Approx(formula).epsilon(kWithin));
            }
        }
    }
}

TEST_CASE(
    "z-width: for B > 0 the hand that rings at Nyquist reaches the formula as it gets modes") {
    constexpr double kHeavy_kg = 30.0;
    constexpr double kWithin = 0.01;
    for (const double rate_Hz : {500.0, 1000.0, 4000.0}) {
        for (const double damping : {0.2, 0.6, 0.9}) {
            for (const int n : {1, 3, 10}) {
                LinearWall wall;
                wall.period_s = 1.0 / rate_Hz;
                wall.modes = make_nyquist_hand(n, kHeavy_kg, wall.period_s);
                wall.device_damping_Ns_per_m = 1.0;
                wall.damping_Ns_per_m = damping;
                // The hold lets through a share of the loop: b = share (K T/2 + B).
                const double formula =
                    2.0 / wall.period_s * (1.0 / compute_nyquist_share(n) - damping);
                CHECK(find_linear_boundary(wall) == Approx(formula).epsilon(kWithin));
            }
        }
    }
    // Ten resonances are within 2.1 % of all of them.
    CHECK(compute_nyquist_share(10) > 0.979);
    CHECK(compute_nyquist_share(100000) == Approx(1.0).epsilon(1e-5));
}

TEST_CASE(
    "z-width: the exact condition of passivity is K T/2 + |B|, and never above it when delayed") {
    LinearWall wall;
    for (const double damping : {-2.0, 0.0, 2.0}) {
        wall.stiffness_N_per_m = 1500.0;
        wall.damping_Ns_per_m = damping;
        wall.delay_s = 0.0;
        CHECK(compute_exact_passive_damping(wall) ==
              Approx(compute_passive_damping(wall)).epsilon(1e-6));
        for (const double late : {1.0, 2.0, 4.0}) {
            wall.delay_s = late * wall.period_s;
            const double exact = compute_exact_passive_damping(wall);
            CHECK(exact <= compute_passive_damping(wall) * (1.0 + 1e-6));
            if (damping <= 0.0) {
                CHECK(exact == Approx(compute_passive_damping(wall)).epsilon(1e-6));
            }
        }
    }
    // A low pass asks for less at Nyquist and for more below it, where it lags.
    wall.delay_s = 0.0;
    wall.stiffness_N_per_m = 0.0;
    wall.damping_Ns_per_m = 2.0;
    wall.velocity = {.method = VelocityMethod::filtered_difference, .cutoff_Hz = 80.0};
    CHECK(compute_exact_passive_damping(wall) < 1.0);
}

TEST_CASE(
    "z-width: one given hand is stable beyond the region of passivity, a lighter one farther") {
    LinearWall wall;
    wall.device_damping_Ns_per_m = 0.5;
    const double formula = 2.0 * 0.5 / wall.period_s;
    for (const HumanImpedance& human : {kFingertip, kArm, kPosture}) {
        wall.modes = {{0.045 + human.mass_kg, human.damping_Ns_per_m, human.stiffness_N_per_m}};
        CHECK(find_linear_boundary(wall) > formula);
    }
}

// The largest stable stiffness in time, by the code that renders.
double find_rendered_boundary(WallTrial trial, double low, double tolerance) {
    return find_largest(
        [&](double stiffness) {
            trial.stiffness_N_per_m = stiffness;
            return run_wall_trial(trial).is_stable();
        },
        low, kStiffestLinear_N_per_m, tolerance);
}

TEST_CASE(
    "z-width: without steps and dry friction the rendering code's boundary is the eigenvalues'") {
    constexpr double kWithin = 0.005;
    struct Hand {
        HumanImpedance human;
        double device_damping;
    };
    const Hand hands[] = {{kFingertip, 0.5}, {kArm, 0.5}, {kNobody, 1.0}};
    const VelocitySettings estimators[] = {
        {.method = VelocityMethod::finite_difference},
        {.method = VelocityMethod::filtered_difference, .cutoff_Hz = 80.0},
        {.method = VelocityMethod::kalman, .noise_bound_m = 5.5e-5}};
    for (const Hand& hand : hands) {
        for (const VelocitySettings& velocity : estimators) {
            for (const double late : {0.0, 0.6, 2.0}) {
                for (const double damping : {-0.3, 0.0, 0.4, 2.0}) {
                    WallTrial trial;
                    trial.rate_Hz = 1000.0;
                    trial.arm.human = hand.human;
                    trial.arm.damping_Ns_per_m = hand.device_damping;
                    trial.arm.delay_s = late / trial.rate_Hz;
                    trial.arm.max_force_N = 100.0;
                    trial.both_ways = true;
                    trial.start_m = -1.0e-5;  // far from the largest force
                    trial.velocity = velocity;
                    trial.damping_Ns_per_m = damping;
                    LinearWall wall;
                    wall.modes = {{trial.arm.mass_kg + hand.human.mass_kg,
                                   hand.human.damping_Ns_per_m, hand.human.stiffness_N_per_m}};
                    wall.device_damping_Ns_per_m = hand.device_damping;
                    wall.damping_Ns_per_m = damping;
                    wall.delay_s = trial.arm.delay_s;
                    wall.velocity = velocity;
                    const double exact = find_linear_boundary(wall);
                    INFO(hand.human.mass_kg << " kg, method " << int(velocity.method) << ", late "
                                            << late << ", B " << damping);
                    REQUIRE(exact > 10.0);
                    CHECK(find_rendered_boundary(trial, 0.5 * exact, 0.002) ==
                          Approx(exact).epsilon(kWithin));
                }
            }
        }
    }
}

TEST_CASE("z-width: inside Abbott and Okamura's bound all is calm; no boundary is told as none") {
    // K <= min(2 b / T, 2 f_c / d): dry friction swallows what rounding the position adds.
    for (const double friction_N : {0.05, 0.26}) {
        for (const double resolution_m : {1.0e-5, 5.5e-5}) {
            for (const HumanImpedance& human : {kFingertip, kArm, kPosture}) {
                WallTrial trial;
                trial.arm = make_desktop_arm();
                trial.arm.dry_friction_N = friction_N;
                trial.arm.position_resolution_m = resolution_m;
                trial.arm.human = human;
                trial.press_m = 0.004;
                trial.stiffness_N_per_m =
                    0.99 * std::min(2.0 * trial.arm.damping_Ns_per_m * trial.rate_Hz,
                                    2.0 * friction_N / resolution_m);
                const WallCourse course = run_wall_trial(trial);
                CHECK(course.is_stable());
                CHECK(course.last.swing_m <= kCalmSteps * resolution_m);
                CHECK(course.last.force_N > 0.1);
            }
        }
    }
    const auto below = [](double limit) { return [limit](double x) { return x < limit; }; };
    CHECK(find_largest(below(123.4), 1.0, 1e6, 1e-6) == Approx(123.4).epsilon(2e-6));
    CHECK(find_largest(below(0.5), 1.0, 1e6, 1e-6) < 1.0);
    CHECK(find_largest(below(1e9), 1.0, 1e6, 1e-6) == 1e6);
}

}  // namespace
}  // namespace fulcrum::z_width
