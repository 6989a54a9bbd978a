#include "haptics/coupling/kalman_velocity.h"
#include "haptics/coupling/velocity_estimator.h"
#include "haptics/math/rotation.h"
#include "tests/support/bad_numbers.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
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

constexpr double kDt_s = 0.001;
constexpr double kEncoder_m = 5.5e-5;  // a Touch's nominal position resolution
constexpr double kRounding = 1e-9;

VelocitySettings with(VelocityMethod method) {
    VelocitySettings settings;
    settings.method = method;
    settings.noise_bound_m = kEncoder_m;
    return settings;
}

double counted(double position_m) {
    return std::round(position_m / kEncoder_m) * kEncoder_m;
}

constexpr int kLongestWindow = 8;  // intervals of kDt_s: 8 ms

// Root mean square of (estimate - truth) over a hand that swings, read by an encoder.
double measure_error(VelocityMethod method, double amplitude_m, double frequency_Hz,
                     double rate_Hz) {
    VelocityEstimator estimator(with(method));
    const double w = 2.0 * std::numbers::pi * frequency_Hz;
    double sum = 0.0;
    int n = 0;
    for (int k = 0; k < static_cast<int>(4.0 * rate_Hz); ++k) {
        const double t_s = k / rate_Hz;
        const Vector3 y(counted(amplitude_m * std::sin(w * t_s)), 0, 0);
        const double error = estimator.step(y, t_s).x() - amplitude_m * w * std::cos(w * t_s);
        if (t_s > 0.1) {
            sum += error * error;
            ++n;
        }
    }
    return std::sqrt(sum / n);
}

}  // namespace

TEST_CASE("kalman: settled gains solve Riccati's equation; for short periods Butterworth's") {
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

TEST_CASE("velocity: the low pass of a constant velocity in closed form") {
    const VelocitySettings settings = with(VelocityMethod::filtered_difference);
    VelocityEstimator estimator(settings);
    const Vector3 velocity(0.3, -0.2, 0.1);
    for (int k = 0; k < 50; ++k) {
        const Vector3 v = estimator.step(velocity * (k * kDt_s), k * kDt_s);
        // v_k = v (1 - exp(-2 pi f_c k T))
        const double share =
            1.0 - std::exp(-2.0 * std::numbers::pi * settings.cutoff_Hz * k * kDt_s);
        REQUIRE((v - share * velocity).norm() < kRounding);
    }
}

TEST_CASE("velocity: the window is exact for a straight line from the second sample on") {
    VelocityEstimator estimator(with(VelocityMethod::adaptive_window));
    const Vector3 velocity(0.3, -0.2, 0.1);
    CHECK(estimator.step(Vector3::Zero(), 0.0).norm() == 0.0);
    for (int k = 1; k < 50; ++k) {
        REQUIRE((estimator.step(velocity * (k * kDt_s), k * kDt_s) - velocity).norm() < kRounding);
    }
}

TEST_CASE("velocity: the window grows to its longest on a line and shrinks to one step at a kink") {
    // One encoder step every 8 ms: the longest window sees exactly one step.
    VelocityEstimator estimator(with(VelocityMethod::adaptive_window));
    double v = 0.0;
    for (int k = 0; k < 150; ++k) {
        const double y = kEncoder_m * (k / kLongestWindow);
        v = estimator.step(Vector3(y, 0, 0), k * kDt_s).x();
        if (k > 30) {
            REQUIRE(v == Approx(kEncoder_m / (kLongestWindow * kDt_s)));
        }
    }
    // A stop within one sample after a fast run: two samples later the estimate is zero.
    VelocityEstimator fast(with(VelocityMethod::adaptive_window));
    for (int k = 0; k < 50; ++k) {
        v = fast.step(Vector3(0.001 * k, 0, 0), k * kDt_s).x();
    }
    CHECK(v == Approx(1.0));
    v = fast.step(Vector3(0.049, 0, 0), 0.050).x();
    CHECK(v == Approx(0.0).margin(kRounding));
}

TEST_CASE(
    "velocity: the window is eight milliseconds at every rate, rounds a little late included") {
    // One encoder step every 8 ms: a window of that length sees exactly one step.
    for (const double rate_Hz : {1000.0, 2000.0, 4000.0, 5000.0}) {
        VelocityEstimator estimator(with(VelocityMethod::adaptive_window));
        const int n = static_cast<int>(0.008 * rate_Hz);
        for (int k = 0; k < 20 * n; ++k) {
            const double late_s = k % 3 == 0 ? 5.0e-5 : 0.0;
            const double y = kEncoder_m * (k / n);
            const double v = estimator.step(Vector3(0, 0, y), k / rate_Hz + late_s).z();
            if (k > 4 * n) {
                REQUIRE(v == Approx(kEncoder_m / 0.008).epsilon(0.01));
            }
        }
    }
    // After a pause the newest two samples are all there is.
    VelocityEstimator estimator(with(VelocityMethod::adaptive_window));
    for (int k = 0; k < 20; ++k) {
        (void)estimator.step(Vector3(0.0001 * k, 0, 0), k * kDt_s);
    }
    CHECK(estimator.step(Vector3(0.0219, 0, 0), 0.119).x() == Approx(0.2));
}

TEST_CASE("velocity: the window equals the rule written out, sample by sample") {
    // Janabi-Sharifi et al.: the largest n for which every inner sample lies within d of the line through the ends.
    const VelocitySettings settings = with(VelocityMethod::adaptive_window);
    VelocityEstimator estimator(settings);
    std::vector<double> y;
    for (int k = 0; k < 500; ++k) {
        const double t_s = k * kDt_s;
        y.push_back(counted(0.01 * std::sin(20.0 * t_s) + 0.003 * std::sin(170.0 * t_s)));
        const double v = estimator.step(Vector3(0, y.back(), 0), t_s).y();
        double expected = 0.0;
        for (int n = 1; n <= std::min(k, kLongestWindow); ++n) {
            const double b = (y[std::size_t(k)] - y[std::size_t(k - n)]) / (n * kDt_s);
            bool holds = true;
            for (int i = 1; i < n; ++i) {
                holds =
                    holds && std::abs(y[std::size_t(k)] - b * i * kDt_s - y[std::size_t(k - i)]) <=
                                 settings.noise_bound_m * (1.0 + 1e-6);
            }
            if (!holds) {
                break;
            }
            expected = b;
        }
        REQUIRE(v == Approx(expected).margin(1e-7));
    }
}

TEST_CASE("velocity: over encoder steps the default beats the low pass, fast swings excepted") {
    CHECK(VelocitySettings{}.method == VelocityMethod::adaptive_window);
    for (const double rate_Hz : {1000.0, 2000.0, 4000.0, 5000.0}) {
        const auto ratio = [&](double amplitude_m, double frequency_Hz) {
            return measure_error(VelocityMethod::adaptive_window, amplitude_m, frequency_Hz,
                                 rate_Hz) /
                   measure_error(VelocityMethod::filtered_difference, amplitude_m, frequency_Hz,
                                 rate_Hz);
        };
        CHECK(ratio(0.002, 0.5) < 0.5);
        CHECK(ratio(0.01, 0.5) < 0.5);
        CHECK(ratio(0.02, 1.0) < 0.5);
        CHECK(ratio(0.05, 1.0) < 1.0);
        // The header says where it does not.
        CHECK(ratio(0.05, 2.0) > 1.0);
    }
}

TEST_CASE("velocity: the plain difference is the last step over the last period") {
    VelocityEstimator estimator(with(VelocityMethod::finite_difference));
    CHECK(estimator.step(Vector3(1, 2, 3), 0.5).norm() == 0.0);
    CHECK((estimator.step(Vector3(1.001, 2, 2.99), 0.502) - Vector3(0.5, 0.0, -5.0)).norm() <
          kRounding);
    CHECK(estimator.step(Vector3(1.001, 2, 2.99), 0.503).norm() == 0.0);
    // It lags half a period behind a steady acceleration: v_k = a (t_k - T/2).
    estimator.reset();
    for (int k = 0; k < 50; ++k) {
        const double t_s = k * kDt_s;
        const double v = estimator.step(Vector3(t_s * t_s, 0, 0), t_s).x();
        if (k > 0) {
            REQUIRE(v == Approx(2.0 * (t_s - 0.5 * kDt_s)));
        }
    }
}

TEST_CASE("velocity: the filter by name is the filter") {
    VelocitySettings settings = with(VelocityMethod::kalman);
    settings.acceleration_density = 0.1;
    VelocityEstimator estimator(settings);
    KalmanVelocity filter;
    for (int k = 0; k < 300; ++k) {
        const double t_s = k * kDt_s + (k % 3) * 1.0e-4;
        const Vector3 y(counted(0.01 * std::sin(20.0 * t_s)), counted(0.1 * t_s), 0.0);
        if (k == 0 || k == 100) {
            estimator.reset();
            filter.start(y);
            CHECK(estimator.step(y, t_s).norm() == 0.0);
            continue;
        }
        const double last_s = (k - 1) * kDt_s + ((k - 1) % 3) * 1.0e-4;
        filter.step(y, t_s - last_s, 0.1, kEncoder_m);
        REQUIRE(estimator.step(y, t_s) == filter.velocity());
    }
}

TEST_CASE("velocity: a shorter longest window sees less far back") {
    // One encoder step every 8 ms: a window of 2 ms sees one step or none.
    VelocitySettings settings = with(VelocityMethod::adaptive_window);
    settings.longest_window_s = 0.002;
    VelocityEstimator estimator(settings);
    for (int k = 0; k < 100; ++k) {
        const double y = kEncoder_m * (k / kLongestWindow);
        const double v = estimator.step(Vector3(y, 0, 0), k * kDt_s).x();
        if (k > 10) {
            const bool seen = k % kLongestWindow < 2;
            REQUIRE(v == Approx(seen ? kEncoder_m / 0.002 : 0.0).margin(kRounding));
        }
    }
}

TEST_CASE("velocity: bad samples change nothing, a constant turn is found in closed form") {
    for (const VelocityMethod method :
         {VelocityMethod::filtered_difference, VelocityMethod::adaptive_window,
          VelocityMethod::finite_difference, VelocityMethod::kalman}) {
        VelocityEstimator estimator(with(method));
        for (int k = 0; k < 10; ++k) {
            (void)estimator.step(Vector3(0.001 * k, 0, 0), k * kDt_s);
        }
        const Vector3 before = estimator.velocity();
        CHECK(estimator.step(Vector3(kNan, 0, 0), 0.010) == before);
        CHECK(estimator.step(Vector3(9, 0, 0), 0.009) == before);
        CHECK(estimator.step(Vector3(9, 0, 0), kNan) == before);
        estimator.reset();
        CHECK(estimator.velocity().norm() == 0.0);
        CHECK(estimator.step(Vector3(5, 0, 0), 0.0).norm() == 0.0);
    }
    AngularVelocityEstimator estimator(80.0);
    const Vector3 omega(1.0, -2.0, 3.0);
    const double share = 1.0 - std::exp(-2.0 * std::numbers::pi * 80.0 * kDt_s);
    double left = 1.0;
    for (int k = 0; k < 2000; ++k) {
        const Vector3 v = estimator.step(compute_exp(omega * (k * kDt_s)), k * kDt_s);
        REQUIRE((v - (1.0 - left) * omega).norm() < 1e-6);
        left *= 1.0 - share;
    }
}

TEST_CASE("velocity: a turn is told in the frame it turns in, whatever it turned from") {
    // q_k = exp(omega t) q_0: omega in the outer frame, which does not commute with q_0.
    AngularVelocityEstimator estimator(80.0);
    const Vector3 omega(0.0, 3.0, 0.0);
    const Quaternion start = compute_exp(Vector3(1.2, 0.0, 0.4));
    for (int k = 0; k < 200; ++k) {
        (void)estimator.step(compute_exp(omega * (k * kDt_s)) * start, k * kDt_s);
    }
    CHECK((estimator.velocity() - omega).norm() < 1e-6);
}

TEST_CASE("velocity: of turns too, bad samples change nothing") {
    AngularVelocityEstimator estimator(80.0);
    for (int k = 0; k < 100; ++k) {
        (void)estimator.step(compute_exp(Vector3(0.002 * k, 0, 0)), k * kDt_s);
    }
    const Vector3 before = estimator.velocity();
    const Quaternion other = compute_exp(Vector3(0, 1, 0));
    CHECK(estimator.step(other, 0.099) == before);
    CHECK(estimator.step(other, 0.05) == before);
    CHECK(estimator.step(other, kNan) == before);
    CHECK(estimator.step(Quaternion(kNan, 0, 0, 0), 0.1) == before);
    // None of them was kept.
    const Vector3 after = estimator.step(compute_exp(Vector3(0.2, 0, 0)), 0.1);
    CHECK((after - Vector3(2, 0, 0)).norm() < 1e-6);
}
