#include "haptics/coupling/kalman_velocity.h"

#include "haptics/coupling/velocity_estimator.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>

using namespace fulcrum;

namespace {

constexpr double kStep_m = 5.5e-5;

struct Settled {
    double position_gain, velocity_gain_per_s;
};

// Runs the filter on a resting hand until its gains change no more.
Settled settle(double q, double period_s) {
    KalmanVelocity filter;
    filter.start(Vector3::Zero());
    for (int k = 0; k < 20000; ++k) {
        filter.step(Vector3::Zero(), period_s, q, kStep_m);
    }
    return {filter.position_gain(), filter.velocity_gain_per_s()};
}

}  // namespace

TEST_CASE("kalman: settled gains solve the steady Riccati equation") {
    for (const double q : {1e-4, 4e-3, 1.0, 1e3}) {
        for (const double period_s : {0.00025, 0.001, 0.002}) {
            const Settled gains = settle(q, period_s);
            // P before a correction, from the gains: g = P (1 0)' / (P_xx + r), so P_xx = r g / (1 - g).
            const double r = kStep_m * kStep_m / 12.0;
            const double xx = r * gains.position_gain / (1.0 - gains.position_gain);
            const double xv = gains.velocity_gain_per_s * (xx + r);
            // What a correction and a prediction make of the velocity's variance must be itself: the gain takes what the
            // period added, g_v P_xv = q T.
            CHECK(gains.velocity_gain_per_s * xv == Approx(q * period_s).epsilon(1e-6));
            // The covariance's row: P_xv = (1 - g) P_xv + T (P_vv - g_v P_xv) + q T^2/2 gives P_vv, and the position's
            // P_xx = (1 - g) P_xx + 2 T (1 - g) P_xv + T^2 (P_vv - g_v P_xv) + q T^3/3 closes it.
            const double left = 1.0 - gains.position_gain;
            const double vv_left = (xv - left * xv - q * period_s * period_s / 2.0) / period_s;
            CHECK(left * xx + 2.0 * period_s * left * xv + period_s * period_s * vv_left +
                      q * std::pow(period_s, 3) / 3.0 ==
                  Approx(xx).epsilon(1e-6));
        }
    }
}

TEST_CASE("kalman: for short periods the settled filter is the Butterworth differentiator") {
    // Gains tend to sqrt2 w0 T and w0^2 T.
    const double period_s = 1e-5;
    const double lag_s = 0.01;
    const double q = compute_acceleration_density(lag_s, kStep_m, period_s);
    CHECK(compute_kalman_lag_s(q, kStep_m, period_s) == Approx(lag_s));
    const double w0 = std::sqrt(2.0) / lag_s;
    const Settled gains = settle(q, period_s);
    CHECK(gains.position_gain == Approx(std::sqrt(2.0) * w0 * period_s).epsilon(0.01));
    CHECK(gains.velocity_gain_per_s == Approx(w0 * w0 * period_s).epsilon(0.01));
}

TEST_CASE("kalman: lags a steady acceleration by sqrt2 / w0, and a steady velocity not at all") {
    const double period_s = 0.00025;
    const double lag_s = 0.005;
    const double q = compute_acceleration_density(lag_s, kStep_m, period_s);
    KalmanVelocity filter;
    filter.start(Vector3::Zero());
    const double a = 2.0;
    for (int k = 1; k < 4000; ++k) {
        const double t_s = k * period_s;
        filter.step(Vector3(0.5 * a * t_s * t_s, 0.2 * t_s, 0.0), period_s, q, kStep_m);
        if (k > 1000) {
            REQUIRE(filter.velocity().x() == Approx(a * (t_s - lag_s)).epsilon(0.005));
            REQUIRE(filter.velocity().y() == Approx(0.2).epsilon(1e-6));
        }
    }
}

TEST_CASE("kalman: the second sample gives the difference, the first a hand at rest") {
    KalmanVelocity filter;
    filter.start(Vector3(7.0, 0.0, 0.0));
    CHECK(filter.velocity().norm() == 0.0);
    filter.step(Vector3(7.0003, -0.0001, 0.0), 0.001, 0.004, kStep_m);
    CHECK(filter.velocity().x() == Approx(0.3).epsilon(1e-4));
    CHECK(filter.velocity().y() == Approx(-0.1).epsilon(1e-4));
}

TEST_CASE("kalman: of random walks in velocity it errs as little as its own covariance says") {
    // The model itself, simulated: the mean square error of v is q T^... as the steady P_vv after the correction.
    const double period_s = 0.001;
    const double q = 0.02;
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform(-0.5, 0.5);
    KalmanVelocity filter;
    double x = 0.0;
    double v = 0.0;
    double sum = 0.0;
    int n = 0;
    filter.start(Vector3::Zero());
    for (int k = 0; k < 400000; ++k) {
        // cov [T^3/3 T^2/2; T^2/2 T] q by its Cholesky factor.
        const double a = normal(random);
        const double b = normal(random);
        const double dv = std::sqrt(q * period_s) * a;
        x += period_s * v + 0.5 * period_s * dv + std::sqrt(q * std::pow(period_s, 3) / 12.0) * b;
        v += dv;
        filter.step(Vector3(x + kStep_m * uniform(random), 0, 0), period_s, q, kStep_m);
        if (k > 1000) {
            sum += (filter.velocity().x() - v) * (filter.velocity().x() - v);
            ++n;
        }
    }
    const double r = kStep_m * kStep_m / 12.0;
    const double g = filter.position_gain();
    const double xv = filter.velocity_gain_per_s() * r / (1.0 - g);
    const double vv_left = (g * xv - q * period_s * period_s / 2.0) / period_s;
    CHECK(sum / n == Approx(vv_left).epsilon(0.05));
}

TEST_CASE("kalman: stays finite and true after pauses and over steps of any length") {
    KalmanVelocity filter;
    filter.start(Vector3::Zero());
    double t_s = 0.0;
    std::mt19937_64 random(6);
    std::uniform_real_distribution<double> exponent(-5.0, 5.0);
    for (int k = 0; k < 20000; ++k) {
        const double dt_s = std::pow(10.0, exponent(random));
        t_s += dt_s;
        filter.step(Vector3(0.3 * t_s, 0.0, 0.0), dt_s, 0.004, kStep_m);
        REQUIRE(std::isfinite(filter.velocity().x()));
        REQUIRE(filter.position_gain() > 0.0);
        REQUIRE(filter.position_gain() < 1.0 + 1e-12);
    }
    CHECK(filter.velocity().x() == Approx(0.3).epsilon(1e-3));
}
