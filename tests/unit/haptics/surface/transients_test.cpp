#include "haptics/surface/stroke_filter.h"
#include "haptics/surface/transient.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <vector>

using namespace fulcrum;

namespace {

// What is left of a wave of `nu` a round, averaged with m samples a round.
double response(int m, double nu) {
    const auto weights = stroke_weights(m);
    double sum = 0.0;
    for (std::size_t j = 0; j < weights.size(); ++j) {
        const double rounds = static_cast<double>(j) / m - kStrokeReach;
        sum += weights[j] * std::cos(2.0 * std::numbers::pi * nu * rounds);
    }
    return sum;
}

constexpr double kDt_s = 0.0002;
constexpr double kTwoPi = 2.0 * std::numbers::pi;

TransientSettings make_settings(TransientKind kind) {
    TransientSettings settings;
    settings.kind = kind;
    settings.force_Ns_per_m = 10.0;
    settings.acceleration_per_s = 200.0;
    settings.frequency_Hz = 100.0;
    settings.decay_per_s = 90.0;
    settings.max_force_N = 10.0;
    return settings;
}

std::vector<double> play(const TransientSettings& settings, const HandleModel& handle, double speed,
                         int n = 1000) {
    Transient transient;
    transient.start(settings, handle, speed);
    std::vector<double> force;
    for (int k = 0; k < n; ++k) {
        force.push_back(transient.step(kDt_s));
    }
    return force;
}

}  // namespace

TEST_CASE("stroke filter: what a round can follow passes, and what it cannot is removed") {
    for (int m = 1; m <= kMostPerRound; ++m) {
        for (double nu = 0.0; nu <= m - kStrokeStop; nu += 0.001) {
            const double left = response(m, nu);
            if (nu <= kStrokePass) {
                CHECK(std::abs(left - 1.0) <= kStrokeRipple);
            } else if (nu >= kStrokeStop) {
                CHECK(std::abs(left) <= kStrokeRemoved);
            } else {
                CHECK(left > -kStrokeRemoved);
                CHECK(left < 1.0 + kStrokeRipple);
            }
        }
    }
}

TEST_CASE("stroke filter: even weights that add up to one, as many samples as the content needs") {
    for (int m = 1; m <= kMostPerRound; ++m) {
        const auto weights = stroke_weights(m);
        REQUIRE(weights.size() == static_cast<std::size_t>(2 * kStrokeReach * m + 1));
        double sum = 0.0;
        for (std::size_t j = 0; j < weights.size(); ++j) {
            CHECK(weights[j] == Approx(weights[weights.size() - 1 - j]).margin(1.0e-15));
            CHECK(weights[j] <= weights[weights.size() / 2]);
            sum += weights[j];
        }
        CHECK(sum == Approx(1.0).epsilon(1.0e-14));
    }
    CHECK(stroke_weights(0).size() == stroke_weights(1).size());
    CHECK(stroke_weights(99).size() == stroke_weights(kMostPerRound).size());
    CHECK(choose_samples_per_round(0.0) == 0);
    CHECK(choose_samples_per_round(kStrokePass) == 0);
    CHECK(choose_samples_per_round(0.31) == 1);
    CHECK(choose_samples_per_round(0.5) == 1);
    CHECK(choose_samples_per_round(0.51) == 2);
    CHECK(choose_samples_per_round(3.5) == 4);
    CHECK(choose_samples_per_round(1.0e9) == kMostPerRound);
    CHECK(choose_samples_per_round(std::nan("")) == 0);
}

TEST_CASE("transient: a decaying sinusoid in closed form, taken in the middle of each period") {
    const auto force = play(make_settings(TransientKind::decaying_sinusoid), {}, 0.2);
    for (int k = 0; k < 350; ++k) {
        const double t = (k + 0.5) * kDt_s;
        CHECK(force[static_cast<std::size_t>(k)] ==
              Approx(2.0 * std::exp(-90.0 * t) * std::sin(kTwoPi * 100.0 * t)).margin(1.0e-9));
    }
    // A thousandth is left when it ends.
    CHECK(force[400] == 0.0);
    CHECK(force.back() == 0.0);
}

TEST_CASE("transient: frequency and decay are as set, read from the force alone") {
    for (const double frequency_Hz : {18.0, 30.0, 100.0, 250.0}) {
        for (const double decay_per_s : {60.0, 90.0, 300.0}) {
            TransientSettings settings = make_settings(TransientKind::decaying_sinusoid);
            settings.frequency_Hz = frequency_Hz;
            settings.decay_per_s = decay_per_s;
            const auto f = play(settings, {}, 0.1, 60);
            // Three samples of exp(s t) follow f2 = 2 Re(e^(s dt)) f1 - |e^(s dt)|^2 f0: solved by least squares over all.
            double a11 = 0, a12 = 0, a22 = 0, b1 = 0, b2 = 0;
            for (std::size_t k = 2; k < f.size(); ++k) {
                a11 += f[k - 1] * f[k - 1];
                a12 += f[k - 1] * f[k - 2];
                a22 += f[k - 2] * f[k - 2];
                b1 += f[k] * f[k - 1];
                b2 += f[k] * f[k - 2];
            }
            const double det = a11 * a22 - a12 * a12;
            const double p = (b1 * a22 - b2 * a12) / det;
            const double q = (a11 * b2 - a12 * b1) / det;
            const double found_decay = -0.5 * std::log(-q) / kDt_s;
            const double found_Hz = std::acos(0.5 * p / std::sqrt(-q)) / (kTwoPi * kDt_s);
            CHECK(found_Hz == Approx(frequency_Hz).epsilon(1.0e-4));
            CHECK(found_decay == Approx(decay_per_s).epsilon(1.0e-4));
        }
    }
}

TEST_CASE("transient: a pulse lasts as long as it is set to, its last period in part") {
    TransientSettings settings = make_settings(TransientKind::fixed_pulse);
    settings.pulse_s = 0.0051;
    const auto force = play(settings, {}, 0.1);
    for (std::size_t k = 0; k < 25; ++k) {
        CHECK(force[k] == Approx(1.0));
    }
    CHECK(force[25] == Approx(0.5));
    CHECK(force[26] == 0.0);
    double impulse_Ns = 0.0;
    for (const double one : force) {
        impulse_Ns += one * kDt_s;
    }
    CHECK(impulse_Ns == Approx(0.0051));
}

TEST_CASE("transient: what is felt is in proportion to the speed of the tap, up to the limit") {
    for (const TransientKind kind : {TransientKind::fixed_pulse, TransientKind::decaying_sinusoid,
                                     TransientKind::acceleration_matching}) {
        const auto slow = play(make_settings(kind), {}, 0.05);
        const auto fast = play(make_settings(kind), {}, 0.15);
        for (std::size_t k = 0; k < slow.size(); ++k) {
            CHECK(fast[k] == Approx(3.0 * slow[k]).margin(1.0e-12));
        }
        TransientSettings bounded = make_settings(kind);
        bounded.max_force_N = 1.5;
        double largest = 0.0;
        for (const double force : play(bounded, {}, 50.0)) {
            largest = std::max(largest, std::abs(force));
        }
        CHECK(largest <= 1.5);
        CHECK(largest > 0.9);
    }
}

TEST_CASE("transient: acceleration matching gives a simulated handle the wanted acceleration") {
    // m x'' + b x' + k x = F from the state that the wanted motion has at the start, in fine steps.
    const HandleModel handle{0.05, 3.0, 400.0};
    const TransientSettings settings = make_settings(TransientKind::acceleration_matching);
    const double speed = 0.1;
    const std::complex<double> s(-settings.decay_per_s, kTwoPi * settings.frequency_Hz);
    const double a = settings.acceleration_per_s * speed;
    const auto wanted = [&](double t) { return (a * std::exp(s * t)).imag(); };
    double x = (a / (s * s)).imag();
    double v = (a / s).imag();
    constexpr double kFine_s = 1.0e-6;
    Transient transient;
    transient.start(settings, handle, speed);
    double worst = 0.0;
    for (int k = 0; k < 40000; ++k) {
        const double force = transient.step(kFine_s);
        const double acceleration =
            (force - handle.damping_Ns_per_m * v - handle.stiffness_N_per_m * x) / handle.mass_kg;
        worst = std::max(worst, std::abs(acceleration - wanted((k + 0.5) * kFine_s)));
        v += acceleration * kFine_s;
        x += (v - 0.5 * acceleration * kFine_s) * kFine_s;
    }
    CHECK(worst < 0.002 * a);
    // Without a hand it is a sinusoid of m A.
    CHECK(compute_inverse_model({0.05, 0.0, 0.0}, s) == std::complex<double>(0.05, 0.0));
    const auto bare = play(settings, {0.05, 0.0, 0.0}, speed);
    CHECK(bare[3] == Approx(0.05 * wanted(3.5 * kDt_s)).margin(1.0e-9));
}

TEST_CASE("transient: nothing starts without a tap, and a broken clock stops it") {
    const TransientSettings settings = make_settings(TransientKind::decaying_sinusoid);
    Transient transient;
    CHECK(transient.step(kDt_s) == 0.0);
    for (const double none : {0.0, -0.1, std::nan(""), HUGE_VAL}) {
        transient.start(settings, {}, none);
        CHECK_FALSE(transient.rings());
    }
    transient.start({}, {}, 0.1);
    CHECK_FALSE(transient.rings());
    for (const double bad_s : {0.0, -0.001, std::nan("")}) {
        transient.start(settings, {}, 0.1);
        REQUIRE(transient.rings());
        CHECK(transient.step(bad_s) == 0.0);
        CHECK_FALSE(transient.rings());
    }
    transient.start(settings, {}, 0.1);
    transient.stop();
    CHECK(transient.step(kDt_s) == 0.0);
}
