// What of a texture reaches the hand at which loop rate: the spectrum of the felt force against the one that the relief itself
// would give.
//
// A relief of waves from 0.4 to 2 mm is stroked at 0.1 and 0.5 m/s, so that it has waves of up to 250 and 1250 Hz. The error is that
// of the waves below 0.3 of the loop's rate, which must be right, and, apart, of all that there are: what a loop cannot give is
// missing there, at best.
#include "haptics/surface/stroke_filter.h"
#include "haptics/surface/texture.h"
#include "tests/bench/harness/curve.h"

#include <complex>

namespace fulcrum::bench {
namespace {

constexpr double kShortest_m = 0.0004;
constexpr double kLongest_m = 0.002;
constexpr double kDepth_m = 0.004;
constexpr double kReference_Hz = 40000.0;
constexpr double kFastest_Hz = 1500.0;

TextureSettings make_relief() {
    TextureSettings settings;
    settings.source = NoiseTexture{kShortest_m, kLongest_m, 1};
    settings.law = TextureLaw::lateral;
    settings.height_m = 1.0e-4;
    return settings;
}

// The force along a straight stroke, for each newton a metre of the coupling.
std::vector<double> stroke(const Texture& texture, double speed, double rate_Hz, double seconds,
                           bool averaged) {
    std::vector<double> force;
    const double way_m = speed / rate_Hz;
    const auto n = static_cast<int>(std::lround(seconds * rate_Hz));
    for (int k = 0; k < n; ++k) {
        const SurfaceVector place{way_m * k, 0.0031};
        const SurfaceVector step = averaged ? SurfaceVector{way_m, 0.0} : SurfaceVector{};
        force.push_back(texture.feel(place, step, kDepth_m).along.u_m);
    }
    return force;
}

// Complex amplitude of one wave, through a Hann window.
std::complex<double> amplitude(const std::vector<double>& record, double rate_Hz, double hertz) {
    std::complex<double> sum = 0.0;
    const std::complex<double> turn = std::polar(1.0, -2.0 * std::numbers::pi * hertz / rate_Hz);
    std::complex<double> phase = 1.0;
    const double n = static_cast<double>(record.size());
    for (std::size_t k = 0; k < record.size(); ++k) {
        const double window =
            0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * static_cast<double>(k) / n);
        sum += window * record[k] * phase;
        phase *= turn;
    }
    return sum * (4.0 / n);
}

struct Errors {
    double passed = 0.0;  // of the waves that the filter passes in full
    double all = 0.0;
};

Errors compare(const std::vector<double>& felt, double rate_Hz, const std::vector<double>& truth,
               double seconds) {
    const double bin_Hz = 1.0 / seconds;
    double wrong = 0.0;
    double false_passed = 0.0;
    double lost = 0.0;
    double below = 0.0;
    double total = 0.0;
    for (double f = bin_Hz; f < kFastest_Hz; f += bin_Hz) {
        const std::complex<double> reference = amplitude(truth, kReference_Hz, f);
        total += std::norm(reference);
        if (f >= 0.5 * rate_Hz) {
            lost += std::norm(reference);
            continue;
        }
        const double error = std::norm(amplitude(felt, rate_Hz, f) - reference);
        wrong += error;
        if (f < kStrokePass * rate_Hz) {
            below += std::norm(reference);
            false_passed += error;
        }
    }
    return {std::sqrt(false_passed / below), std::sqrt((wrong + lost) / total)};
}

Sheet list_costs(const Texture& texture) {
    Sheet sheet{
        "texture-cost",
        "What a texture costs a round",
        "One touch on a relief of 128 x 128 heights, in a loop of 1 kHz, by the speed of the "
        "stroke.",
        "At rest a texture is nearly free; a fast stroke needs more of the relief, and never more "
        "than this.",
        {"speed of the stroke, m/s", "median µs", "99 % µs"}};
    for (const double speed : {0.0, 0.02, 0.1, 0.5, 2.0}) {
        double u_m = 0.0;
        const Cost cost = measure_cost([&] {
            u_m += 0.001 * speed + 1.0e-6;
            keep(texture.feel({u_m, 0.0031}, {0.001 * speed, 0.0}, kDepth_m).along.u_m);
        });
        sheet.add({speed, cost.median_us, cost.p99_us});
    }
    return sheet;
}

Report run_texture_rate(Run& run) {
    const Texture texture(make_relief());
    const double seconds = run.pick(0.5, 0.2);
    LineChart chart;
    chart.name = "texture-rate";
    chart.title = "A texture's spectrum against the loop's rate";
    chart.work =
        "Bumps of 0.4 to 2 mm are stroked at an even speed; the felt force is compared wave by "
        "wave with what the relief gives at 40 kHz: the rms of the difference over the rms of all, "
        "of the waves below 0.3 of the loop's rate and of all waves.";
    chart.reference =
        "beside it the relief taken place by place, where short waves are folded into long ones";
    chart.advice =
        "Average along the stroke: it costs three microseconds at most. Raise the rate where bumps "
        "below a millimetre are stroked fast; at 1 kHz waves up to 300 Hz are right.";
    chart.x = {"rate of the loop", "Hz", false};
    chart.y = {"error of the spectrum", "", true};
    const std::vector<double> rates = run.pick<std::vector<double>>(
        {1000, 1250, 1500, 2000, 2500, 3000, 4000, 5000}, {1000, 2000, 5000});
    double done = 0.0;
    for (const double speed : {0.1, 0.5}) {
        const auto truth = stroke(texture, speed, kReference_Hz, seconds, false);
        for (const bool averaged : {true, false}) {
            const std::string name = std::string(averaged ? "averaged" : "place by place") +
                                     (speed < 0.2 ? ", 0.1 m/s" : ", 0.5 m/s");
            Line given{name};
            Line all{name + ", all waves"};
            for (const double rate_Hz : rates) {
                const Errors errors = compare(stroke(texture, speed, rate_Hz, seconds, averaged),
                                              rate_Hz, truth, seconds);
                given.add(rate_Hz, errors.passed);
                all.add(rate_Hz, errors.all);
                done += 1.0;
                run.progress(done / (4.0 * static_cast<double>(rates.size())));
            }
            chart.lines.push_back(std::move(given));
            chart.lines.push_back(std::move(all));
        }
    }
    return {chart, list_costs(texture)};
}

const Registration kTextureRate{
    {"texture-rate", "a texture's spectrum against the loop's rate", run_texture_rate}};

}  // namespace
}  // namespace fulcrum::bench
