#include "runtime/audio/waveform.h"

#include "tests/unit/runtime/audio/heard.h"

using namespace fulcrum::runtime;
using namespace fulcrum::runtime::test;

namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;

/// Times, in seconds, at which the signal crosses zero upwards between two moments; interpolated.
std::vector<double> upward_crossings_s(const std::vector<float>& x, double from_s, double to_s) {
    std::vector<double> times;
    const auto last = static_cast<std::size_t>(to_s * kSampleRate_Hz);
    for (auto i = static_cast<std::size_t>(from_s * kSampleRate_Hz); i + 1 < last; ++i) {
        if (x[i] < 0.0F && x[i + 1] >= 0.0F) {
            const double a = static_cast<double>(x[i]);
            const double b = static_cast<double>(x[i + 1]);
            times.push_back((static_cast<double>(i) - a / (b - a)) / kSampleRate_Hz);
        }
    }
    return times;
}

double frequency_Hz(const std::vector<float>& x, double from_s, double to_s) {
    const auto times = upward_crossings_s(x, from_s, to_s);
    REQUIRE(times.size() > 2);
    return static_cast<double>(times.size() - 1) / (times.back() - times.front());
}

/// Power at one frequency, by a plain Fourier sum.
double power_at(const std::vector<float>& x, double f_Hz) {
    double re = 0.0;
    double im = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double angle = kTwoPi * f_Hz * static_cast<double>(i) / kSampleRate_Hz;
        re += static_cast<double>(x[i]) * std::cos(angle);
        im += static_cast<double>(x[i]) * std::sin(angle);
    }
    return re * re + im * im;
}

}  // namespace

TEST_CASE("waveform: a mode is a decaying sine, in closed form") {
    const double f_Hz = 440.0;
    const double tau_s = 0.1;
    const auto x = Waveform(0.5).add(Mode{f_Hz, tau_s, 1.0}, 0.0, 0.0).finish(0.5);
    REQUIRE(x.size() == 24'000);
    // Only the scale is free: taken from the first quarter period.
    const std::size_t first = 27;
    const double t0 = static_cast<double>(first) / kSampleRate_Hz;
    const double scale =
        static_cast<double>(x[first]) / (std::exp(-t0 / tau_s) * std::sin(kTwoPi * f_Hz * t0));
    for (std::size_t i = 0; i < 20'000; i += 7) {
        const double t = static_cast<double>(i) / kSampleRate_Hz;
        const double expected = scale * std::exp(-t / tau_s) * std::sin(kTwoPi * f_Hz * t);
        REQUIRE(static_cast<double>(x[i]) == Approx(expected).margin(1e-6));
    }
}

TEST_CASE("waveform: a glide begins at its first pitch and ends at its last") {
    const auto x = Waveform(1.0).add(Glide{200.0, 800.0, 0.05, 10.0, 1.0}, 0.0, 0.0).finish(0.5);
    // f(t) = 800 - 600 e^(-t / 0.05): 235 Hz on average over the first 6 ms, 800 Hz after many time constants.
    CHECK(upward_crossings_s(x, 0.0005, 0.02).front() == Approx(1.0 / 232.0).epsilon(0.05));
    CHECK(frequency_Hz(x, 0.6, 0.9) == Approx(800.0).epsilon(1e-3));
}

TEST_CASE("waveform: noise keeps to its band, dies away, and is the same for the same seed") {
    const auto make = [](std::uint32_t seed) {
        return Waveform(0.5).add(Noise{1000.0, 4.0, 0.1, 1.0, seed}).finish(0.5);
    };
    const auto x = make(5);
    CHECK(x == make(5));
    CHECK(x != make(6));
    // Averages over bands, for noise is uneven from one frequency to the next.
    const auto band = [&x](double centre_Hz) {
        double sum = 0.0;
        for (double f = 0.9 * centre_Hz; f < 1.1 * centre_Hz; f += 10.0) {
            sum += power_at(x, f) / (0.2 * centre_Hz);
        }
        return sum;
    };
    CHECK(band(1000.0) > 10.0 * band(250.0));
    CHECK(band(1000.0) > 10.0 * band(4000.0));
    CHECK(energy(piece(x, 0.3, 0.45)) < 0.05 * energy(piece(x, 0.0, 0.15)));
}

TEST_CASE("waveform: sounds that start later leave silence before them") {
    const auto x = Waveform(0.2).add(Mode{500.0, 0.05, 1.0}, 0.1).finish(0.5);
    CHECK(energy(piece(x, 0.0, 0.1)) == 0.0);
    CHECK(energy(piece(x, 0.1, 0.2)) > 0.0);
}

TEST_CASE("waveform: a finished sound has the peak asked for, never above 3 dB below full scale") {
    for (const double peak : {0.1, 0.5, 2.0}) {
        const auto x = Waveform(0.2).add_note(500.0, 0.1, 3.0, 0.0).finish(peak);
        CHECK(static_cast<double>(loudest(x)) == Approx(std::min(peak, kPeak)));
        CHECK(x.back() == 0.0F);
    }
    CHECK(loudest(Waveform(0.1).finish(0.5)) == 0.0F);
}
