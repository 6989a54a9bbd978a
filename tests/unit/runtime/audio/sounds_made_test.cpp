#include "runtime/audio/force_sound.h"
#include "runtime/audio/synthesis.h"
#include "runtime/audio/waveform.h"
#include "tests/unit/runtime/audio/heard.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

/// Sum of f |X(f)|^2 over sum of |X(f)|^2, from 20 Hz to 12 kHz in steps of 20 Hz, by a plain
/// Fourier sum.
double spectral_centroid_Hz(Sound x) {
    double weighted = 0.0;
    double power = 0.0;
    for (double f_Hz = 20.0; f_Hz < 12'000.0; f_Hz += 20.0) {
        // Goertzel's recurrence gives the magnitude at one frequency.
        const double turn = 2.0 * std::numbers::pi * f_Hz / kSampleRate_Hz;
        const double c = 2.0 * std::cos(turn);
        double s1 = 0.0;
        double s2 = 0.0;
        for (const float sample : x) {
            const double s0 = static_cast<double>(sample) + c * s1 - s2;
            s2 = s1;
            s1 = s0;
        }
        const double magnitude2 = s1 * s1 + s2 * s2 - c * s1 * s2;
        weighted += f_Hz * magnitude2;
        power += magnitude2;
    }
    return weighted / power;
}

std::vector<float> sound(std::string_view name) {
    auto made = synthesise(name);
    REQUIRE(made.has_value());
    return *made;
}

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

TEST_CASE("synthesis: each sound is finite, loud enough, 3 dB below full scale, without a click") {
    const std::string name(
        GENERATE(from_range(std::vector<std::string>(sound_names().begin(), sound_names().end()))));
    CAPTURE(name);
    const auto x = sound(name);
    CHECK(std::ranges::all_of(x, [](float sample) { return std::isfinite(sample); }));
    const float highest = loudest(x);
    // -3 dBFS is 10^(-3/20).
    CHECK(static_cast<double>(highest) <= std::pow(10.0, -3.0 / 20.0));
    CHECK(highest > 0.2F);
    CHECK(x.size() >= kSampleRate_Hz / 20);  // 50 ms
    CHECK(x.size() <= 3U * kSampleRate_Hz);  // 3 s
    // Nor does it begin or end with a click.
    CHECK(x.front() == 0.0F);
    CHECK(x.back() == 0.0F);
    // The last millisecond stays below -60 dBFS.
    CHECK(loudest(Sound(x).last(kSampleRate_Hz / 1000)) < 1e-3F);
}

TEST_CASE("synthesis: the same name gives the same samples, different names do not") {
    std::set<std::vector<float>> all;
    for (const std::string_view name : sound_names()) {
        CHECK(sound(name) == sound(name));
        all.insert(sound(name));
    }
    CHECK(all.size() == sound_names().size());
}

TEST_CASE("synthesis: a caught melon sounds low, an egg bright, an apple and a banana between") {
    const double melon_Hz = spectral_centroid_Hz(sound("catch_watermelon"));
    const double apple_Hz = spectral_centroid_Hz(sound("catch_apple"));
    const double banana_Hz = spectral_centroid_Hz(sound("catch_banana"));
    const double egg_Hz = spectral_centroid_Hz(sound("catch_egg"));
    CAPTURE(melon_Hz, apple_Hz, banana_Hz, egg_Hz);
    CHECK(melon_Hz < 250.0);
    CHECK(egg_Hz > 2000.0);
    CHECK(egg_Hz > 8.0 * melon_Hz);
    CHECK(apple_Hz > 1.5 * melon_Hz);
    CHECK(banana_Hz > 1.5 * melon_Hz);
    CHECK(egg_Hz > 2.0 * apple_Hz);
    CHECK(egg_Hz > 2.0 * banana_Hz);
}

TEST_CASE("synthesis: the melon rings on in its hollow, the egg is over at once") {
    const auto melon = sound("catch_watermelon");
    const auto egg = sound("catch_egg");
    CHECK(energy(piece(melon, 0.15, 0.8)) > 0.1 * energy(piece(melon, 0.0, 0.8)));
    CHECK(energy(piece(egg, 0.15, 0.8)) < 0.01 * energy(piece(egg, 0.0, 0.8)));
}

TEST_CASE("synthesis: right rises, try again falls and is the softer one") {
    const auto first_and_second = [](Sound x, double second_s, const auto& measure_Hz) {
        constexpr double kLong_s = 0.12;
        return std::pair{measure_Hz(piece(x, 0.0, kLong_s)),
                         measure_Hz(piece(x, second_s, second_s + kLong_s))};
    };
    // As bright, and by the pitch alone: what dies away grows less bright by itself.
    const auto find_pitch_Hz = [](Sound x) { return strongest_Hz(x, 200.0, 1200.0); };
    const auto check = [&](const auto& measure_Hz) {
        const auto right = first_and_second(sound("right"), 0.2, measure_Hz);
        const auto again = first_and_second(sound("try_again"), 0.35, measure_Hz);
        CHECK(right.second > 1.1 * right.first);
        CHECK(again.second < 0.95 * again.first);
    };
    check(spectral_centroid_Hz);
    check(find_pitch_Hz);
    const auto peak = [](const std::vector<float>& x) {
        return *std::max_element(x.begin(), x.end());
    };
    CHECK(peak(sound("try_again")) < peak(sound("right")));
}

TEST_CASE("synthesis: an unknown name is an error that lists the names") {
    const auto made = synthesise("moo");
    REQUIRE_FALSE(made.has_value());
    CHECK(made.error().message.find("moo") != std::string::npos);
    CHECK(made.error().what_to_do.find("catch_egg") != std::string::npos);
}

TEST_CASE("force sound: its loop has no seam and no louder peak than other sounds") {
    const auto loop = synthesise_force_loop();
    REQUIRE(loop.size() == kSampleRate_Hz);
    CHECK(std::abs(loop.front() - loop.back()) <= largest_step(loop, 1));
    CHECK(static_cast<double>(loudest(loop)) <= kPeak);
}

TEST_CASE("force sound: louder and higher with every newton, silent at none, bounded") {
    CHECK(force_gain(0.0) == 0.0);
    CHECK(force_gain(kForceHalf_N) == Approx(0.5));
    CHECK(force_pitch(0.0) == 1.0);
    CHECK(force_pitch(kForceOctave_N) == Approx(2.0));
    CHECK(force_pitch(1000.0) == Approx(4.0));
    for (double F = 0.0; F < 10.0; F += 0.5) {
        CHECK(force_gain(F + 0.5) > force_gain(F));
        CHECK(force_pitch(F + 0.5) > force_pitch(F));
        CHECK(force_gain(F) < 1.0);
    }
    CHECK(force_gain(-3.0) == 0.0);
    CHECK(force_gain(std::nan("")) == 0.0);
    CHECK(force_pitch(std::numeric_limits<double>::infinity()) == 1.0);
}

TEST_CASE("force sound: following is exact for a held target, whatever the step") {
    const double once = follow(1.0, 5.0, 0.1);
    double stepped = 1.0;
    for (int i = 0; i < 10; ++i) {
        stepped = follow(stepped, 5.0, 0.01);
    }
    CHECK(stepped == Approx(once).epsilon(1e-12));
    CHECK(once == Approx(5.0 - 4.0 * std::exp(-0.1 / kForceFollow_s)));
    CHECK(follow(1.0, 5.0, 0.0) == 1.0);
    CHECK(follow(1.0, 5.0, -1.0) == 1.0);
    CHECK(follow(1.0, 5.0, std::nan("")) == 1.0);
}

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
