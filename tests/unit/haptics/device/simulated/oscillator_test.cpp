#include "haptics/device/simulated/oscillator.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <rapidcheck.h>

using namespace fulcrum;

namespace {

constexpr double kRounding = 1e-9;

// Kinetic energy, that of the spring, and that of a constant force that pushes all the while.
double energy_J(const AxisPlant& plant, const AxisState& state, double force_N) {
    return 0.5 * plant.mass_kg * state.velocity_m_per_s * state.velocity_m_per_s +
           0.5 * plant.stiffness_N_per_m * state.position_m * state.position_m -
           force_N * state.position_m;
}

}  // namespace

TEST_CASE("oscillator step: underdamped, critical and overdamped in closed form") {
    // Underdamped: y = e^(-at) (cos wt + a/w sin wt) from y0 = 1, v0 = 0.
    const double a = 10.0;
    const double w = std::sqrt(300.0 - 100.0);
    const OscillatorStep under = compute_oscillator_step(1.0, 300.0, 20.0, 0.03);
    CHECK(under.yy ==
          Approx(std::exp(-a * 0.03) * (std::cos(w * 0.03) + a / w * std::sin(w * 0.03))));
    CHECK(under.yv == Approx(std::exp(-a * 0.03) * std::sin(w * 0.03) / w));
    // Critical: y = e^(-at) (1 + at).
    const OscillatorStep critical = compute_oscillator_step(1.0, 100.0, 20.0, 0.05);
    CHECK(critical.yy == Approx(std::exp(-0.5) * 1.5));
    CHECK(critical.vv == Approx(std::exp(-0.5) * 0.5));
    // Overdamped, roots -5 and -20: y = (20 e^(-5t) - 5 e^(-20t)) / 15.
    const OscillatorStep over = compute_oscillator_step(1.0, 100.0, 25.0, 0.1);
    CHECK(over.yy == Approx((20.0 * std::exp(-0.5) - 5.0 * std::exp(-2.0)) / 15.0));
    // No time, no change.
    const OscillatorStep none = compute_oscillator_step(1.0, 300.0, 20.0, 0.0);
    CHECK(none.yy == 1.0);
    CHECK(none.yv == 0.0);
    CHECK(none.vy == 0.0);
    CHECK(none.vv == 1.0);
}

TEST_CASE("oscillator step: two halves make a whole, near critical damping too") {
    CHECK(rc::check([] {
        const double mass = 0.1 * *rc::gen::inRange(1, 50);
        const double stiffness = 1.0 * *rc::gen::inRange(1, 3000);
        const double ratio = 0.01 * *rc::gen::inRange(0, 300);
        const double damping = 2.0 * ratio * std::sqrt(mass * stiffness);
        const double dt_s = 0.0001 * *rc::gen::inRange(1, 200);
        const OscillatorStep one = compute_oscillator_step(mass, stiffness, damping, dt_s);
        const OscillatorStep half = compute_oscillator_step(mass, stiffness, damping, 0.5 * dt_s);
        RC_ASSERT(std::abs(half.yy * half.yy + half.yv * half.vy - one.yy) < 1e-9);
        RC_ASSERT(std::abs(half.yy * half.yv + half.yv * half.vv - one.yv) < 1e-9);
        RC_ASSERT(std::abs(half.vy * half.yy + half.vv * half.vy - one.vy) <
                  1e-9 * (1.0 + std::abs(one.vy)));
        RC_ASSERT(std::abs(half.vy * half.yv + half.vv * half.vv - one.vv) < 1e-9);
        // Energy k y^2 / 2 + m v^2 / 2 never grows: from any start on the unit circle of (sqrt k y, sqrt m v).
        for (int i = 0; i < 8; ++i) {
            const double angle = i * std::numbers::pi / 8.0;
            const double y = std::cos(angle) / std::sqrt(stiffness);
            const double v = std::sin(angle) / std::sqrt(mass);
            const double y1 = one.yy * y + one.yv * v;
            const double v1 = one.vy * y + one.vv * v;
            RC_ASSERT(stiffness * y1 * y1 + mass * v1 * v1 <= 1.0 + 1e-9);
        }
    }));
}

TEST_CASE(
    "oscillator step: every arm that settings allow stays finite, and loses energy, at any step") {
    struct Range {
        double low, high;
    };
    // Mass, stiffness, damping; then inertia, turn stiffness, turn damping.
    const Range ranges[2][3] = {{{0.05, 20.0}, {1.0, 5000.0}, {0.0, 500.0}},
                                {{1e-5, 1.0}, {0.01, 100.0}, {0.0, 10.0}}};
    for (const auto& range : ranges) {
        for (int corner = 0; corner < 8; ++corner) {
            const double mass = corner & 1 ? range[0].high : range[0].low;
            const double stiffness = corner & 2 ? range[1].high : range[1].low;
            const double damping = corner & 4 ? range[2].high : range[2].low;
            for (double dt_s = 1e-5; dt_s <= 10.0; dt_s *= 1.3) {
                const OscillatorStep a = compute_oscillator_step(mass, stiffness, damping, dt_s);
                const OscillatorStep half =
                    compute_oscillator_step(mass, stiffness, damping, 0.5 * dt_s);
                // In units in which energy is a length: A = [yy, yv r; vy / r, vv], r = sqrt(k / m).
                const double r = std::sqrt(stiffness / mass);
                const double size = std::max(
                    {std::abs(a.yy), std::abs(a.yv * r), std::abs(a.vy / r), std::abs(a.vv)});
                REQUIRE(size <= 1.0 + kRounding);
                // Two halves make a whole: y from y, y from v, v from v.
                REQUIRE(std::abs(half.yy * half.yy + half.yv * half.vy - a.yy) < kRounding);
                REQUIRE(r * std::abs(half.yv * (half.yy + half.vv) - a.yv) < kRounding);
                REQUIRE(std::abs(half.vv * half.vv + half.yv * half.vy - a.vv) < kRounding);
            }
        }
    }
}

TEST_CASE("oscillator step: a force moves the axis as in closed form, with and without a spring") {
    // Spring: towards f/k; y(t) = f/k (1 - cos wt).
    const double w = std::sqrt(400.0 / 2.0);
    const OscillatorStep spring = compute_oscillator_step(2.0, 400.0, 0.0, 0.05);
    CHECK(spring.yf == Approx((1.0 - std::cos(w * 0.05)) / 400.0));
    CHECK(spring.vf == Approx(std::sin(w * 0.05) / (2.0 * w)));
    // Nothing but mass: y = f t^2 / 2m.
    const OscillatorStep free = compute_oscillator_step(2.0, 0.0, 0.0, 0.05);
    CHECK(free.yy == 1.0);
    CHECK(free.yv == Approx(0.05));
    CHECK(free.vv == 1.0);
    CHECK(free.yf == Approx(0.05 * 0.05 / 4.0));
    CHECK(free.vf == Approx(0.05 / 2.0));
    // Mass and damper, r = b / m: v = f/b (1 - e^-rt), y = f/b (t - (1 - e^-rt) / r).
    for (const double damping : {1e-6, 1e-3, 0.039, 0.041, 10.0, 3000.0}) {
        const double r = damping / 2.0;
        const OscillatorStep drag = compute_oscillator_step(2.0, 0.0, damping, 0.05);
        CHECK(drag.vv == Approx(std::exp(-r * 0.05)).epsilon(1e-12).margin(1e-14));
        CHECK(drag.vf == Approx(-std::expm1(-r * 0.05) / damping).epsilon(1e-9));
        const double way = damping < 0.01 ? 0.05 * 0.05 / 4.0 * (1.0 - r * 0.05 / 3.0)
                                          : (0.05 + std::expm1(-r * 0.05) / r) / damping;
        CHECK(drag.yf == Approx(way).epsilon(1e-8));
    }
}

TEST_CASE("axis: dry friction alone stops a sliding mass after m v^2 / 2 f_c, at rest for good") {
    const AxisPlant plant{.mass_kg = 0.3, .dry_friction_N = 0.25};
    for (const double dt_s : {0.0007, 0.01, 5.0}) {
        AxisMotion motion(plant);
        AxisState state{0.02, -0.4};
        for (double t_s = 0.0; t_s < 1.0; t_s += dt_s) {
            motion.step(state, 0.0, dt_s);
        }
        CHECK(state.velocity_m_per_s == 0.0);
        CHECK(state.position_m == Approx(0.02 - 0.3 * 0.4 * 0.4 / (2.0 * 0.25)).epsilon(1e-10));
    }
    // On the way: v = v0 - (f_c / m) t.
    AxisMotion motion(plant);
    AxisState state{0.0, 0.4};
    motion.step(state, 0.0, 0.1);
    CHECK(state.velocity_m_per_s == Approx(0.4 - 0.25 / 0.3 * 0.1));
}

TEST_CASE("axis: it sticks up to the friction and slides beyond, by the excess") {
    const AxisPlant plant{.mass_kg = 0.5, .dry_friction_N = 1.0};
    for (const double force_N : {0.0, 0.999, 1.0, -1.0}) {
        AxisMotion motion(plant);
        AxisState state{0.1, 0.0};
        motion.step(state, force_N, 10.0);
        CHECK(state.position_m == 0.1);
        CHECK(state.velocity_m_per_s == 0.0);
    }
    for (const double force_N : {1.2, -1.2}) {
        AxisMotion motion(plant);
        AxisState state{0.1, 0.0};
        motion.step(state, force_N, 0.5);
        const double a = std::copysign(0.2 / 0.5, force_N);
        CHECK(state.velocity_m_per_s == Approx(a * 0.5));
        CHECK(state.position_m == Approx(0.1 + 0.5 * a * 0.25));
    }
}

TEST_CASE("axis: on a spring each swing is 2 f_c / k shorter, until it sticks within f_c / k") {
    const AxisPlant plant{.mass_kg = 0.2, .stiffness_N_per_m = 50.0, .dry_friction_N = 0.1};
    const double half_s = std::numbers::pi / std::sqrt(50.0 / 0.2);
    const double shorter_m = 2.0 * 0.1 / 50.0;
    AxisMotion motion(plant);
    AxisState state{0.0218, 0.0};
    double expected_m = 0.0218;
    while (std::abs(expected_m) > 0.5 * shorter_m) {
        motion.step(state, 0.0, half_s);
        expected_m = -std::copysign(std::abs(expected_m) - shorter_m, expected_m);
        REQUIRE(state.position_m == Approx(expected_m).margin(1e-12));
    }
    motion.step(state, 0.0, 100.0);
    CHECK(state.position_m == Approx(expected_m).margin(1e-12));
    CHECK(state.velocity_m_per_s == 0.0);
    // In one stroke over all its turns, too.
    AxisMotion other(plant);
    AxisState at_once{0.0218, 0.0};
    other.step(at_once, 0.0, 50.0);
    CHECK(at_once.position_m == Approx(expected_m).margin(1e-12));
}

TEST_CASE("axis: where it stops is where its velocity first is zero, in every regime of damping") {
    for (const double damping : {0.0, 0.4, 2.0, 7.0, 200.0}) {
        for (const double stiffness : {0.0, 1.0, 100.0}) {
            for (const double acceleration : {-30.0, -2.0, -0.1, 0.0, 3.0}) {
                const AxisPlant plant{
                    .mass_kg = 0.1, .damping_Ns_per_m = damping, .stiffness_N_per_m = stiffness};
                const double speed = 0.5;
                // At the origin with that velocity, the force that gives that acceleration.
                const double force_N = 0.1 * acceleration + damping * speed;
                const double stop_s = find_stop_s(plant, speed, acceleration);
                const double end_s = std::min(stop_s, 20.0);
                for (int i = 1; i < 200; ++i) {
                    const OscillatorStep a =
                        compute_oscillator_step(0.1, stiffness, damping, end_s * i / 200.0);
                    REQUIRE(a.vv * speed + a.vf * force_N > -1e-12);
                }
                if (stop_s < 20.0) {
                    const OscillatorStep a =
                        compute_oscillator_step(0.1, stiffness, damping, stop_s);
                    CHECK(a.vv * speed + a.vf * force_N == Approx(0.0).margin(1e-9));
                }
            }
        }
    }
}

TEST_CASE("axis: energy never grows, and a halved step comes to the same place") {
    CHECK(rc::check([] {
        const auto number = [](double low, double high) {
            return low + (high - low) * 1e-4 * *rc::gen::inRange(0, 10001);
        };
        const AxisPlant plant{number(0.01, 2.0), number(0.0, 30.0),
                              *rc::gen::inRange(0, 3) == 0 ? 0.0 : number(1.0, 3000.0),
                              number(0.0, 1.0)};
        AxisMotion motion(plant);
        AxisMotion halves(plant);
        AxisState state{number(-0.1, 0.1), number(-1.0, 1.0)};
        AxisState other = state;
        for (int k = 0; k < 20; ++k) {
            const double force_N = number(-3.0, 3.0);
            const double dt_s = number(1e-5, 0.05);
            const double before_J = energy_J(plant, state, force_N);
            const double from_m = state.position_m;
            motion.step(state, force_N, dt_s);
            RC_ASSERT(energy_J(plant, state, force_N) <= before_J + 1e-9);
            // Friction takes at least f_c times the way between the ends.
            RC_ASSERT(energy_J(plant, state, force_N) <=
                      before_J - plant.dry_friction_N * std::abs(state.position_m - from_m) + 1e-9);
            halves.step(other, force_N, 0.4 * dt_s);
            halves.step(other, force_N, 0.6 * dt_s);
            RC_ASSERT(std::abs(other.position_m - state.position_m) < 1e-8);
            RC_ASSERT(std::abs(other.velocity_m_per_s - state.velocity_m_per_s) < 1e-5);
        }
    }));
}
