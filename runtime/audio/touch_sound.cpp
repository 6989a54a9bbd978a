#include "runtime/audio/touch_sound.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fulcrum::runtime {
namespace {

constexpr double kSample_s = 1.0 / kSampleRate_Hz;
/// Heights that change by 0.03 m/s, 0.1 mm deep at 100 Hz, are heard at a quarter of what there is.
constexpr double kStrokeGain_s_per_m = 8.0;
constexpr double kHalfLoud_N = 0.5;
constexpr double kFullTap_m_per_s = 0.25;
constexpr double kSilentTap = 1e-4;
constexpr double kLoudestTap = 0.9;
/// Rounds further apart than so many periods are not joined by a curve.
constexpr double kGap = 2.5;
/// Sound that lags further behind touch begins anew.
constexpr double kMostLag_s = 0.04;
/// So many rounds have to be there beyond what is heard.
constexpr double kLeastLead = 2.0;

double soft_limit(double x) noexcept {
    return x / std::sqrt(1.0 + x * x);
}

/// d/dx of the Catmull-Rom cubic through four heights one apart, at `x` 0 to 1 between the middle two.
double cubic_slope(double a, double b, double c, double d, double x) noexcept {
    const double linear = 0.5 * (c - a);
    const double square = a - 2.5 * b + 2.0 * c - 0.5 * d;
    const double cube = 0.5 * (d - a) + 1.5 * (b - c);
    return linear + x * (2.0 * square + x * 3.0 * cube);
}

}  // namespace

TapTone tone_of(const TransientSettings& transient) noexcept {
    switch (transient.kind) {
        case TransientKind::none:
            return {};
        case TransientKind::fixed_pulse:
            return {0.5 / transient.pulse_s, 2.0 / transient.pulse_s};
        case TransientKind::decaying_sinusoid:
        case TransientKind::acceleration_matching:
            return {transient.frequency_Hz, transient.decay_per_s};
    }
    return {};
}

TouchSound::TouchSound(TouchRing& touches, std::vector<TapTone> tones, double round_s)
    : touches_(touches), tones_(std::move(tones)), round_s_(round_s) {}

const TouchSound::Moment& TouchSound::moment(std::size_t i) const noexcept {
    return moments_[(first_ + i) % moments_.size()];
}

void TouchSound::take_in(std::size_t n_samples) noexcept {
    const double before_s = newest_s_;
    for (TouchSample sample; touches_.pop(sample);) {
        keep(sample);
    }
    // While nothing is felt time runs on; what is felt must neither lag nor be overtaken.
    const double lag_s = newest_s_ - now_s_;
    const bool in_step =
        lag_s >= static_cast<double>(n_samples) * kSample_s + kLeastLead * round_s_ &&
        lag_s <= kMostLag_s;
    if (n_moments_ > 0 && (!runs_ || (newest_s_ > before_s && !in_step))) {
        now_s_ = newest_s_ - touch_delay_s(n_samples);
        runs_ = true;
    }
}

void TouchSound::keep(const TouchSample& sample) noexcept {
    if (!std::isfinite(sample.time_s) || (n_moments_ > 0 && sample.time_s <= newest_s_)) {
        return;
    }
    if (n_moments_ == moments_.size()) {
        first_ = (first_ + 1) % moments_.size();
        --n_moments_;
    }
    const double force_N = std::max(0.0, static_cast<double>(sample.normal_force_N));
    const bool touches = sample.solid != kNoBody;
    moments_[(first_ + n_moments_) % moments_.size()] = {
        sample.time_s, static_cast<double>(sample.texture_height_m),
        touches ? force_N / (force_N + kHalfLoud_N) : 0.0};
    ++n_moments_;
    newest_s_ = sample.time_s;
    if (touches && sample.impact_speed_m_per_s > 0.0F) {
        begin_tap(sample);
    }
}

void TouchSound::begin_tap(const TouchSample& sample) noexcept {
    const auto solid = static_cast<std::size_t>(sample.solid);
    if (solid >= tones_.size() || !(tones_[solid].frequency_Hz > 0.0)) {
        return;
    }
    const double speed_m_per_s = static_cast<double>(sample.impact_speed_m_per_s);
    Tap& place = *std::ranges::min_element(
        taps_, [](const Tap& a, const Tap& b) { return a.amplitude < b.amplitude; });
    place = {sample.time_s, kLoudestTap * std::min(speed_m_per_s / kFullTap_m_per_s, 1.0),
             tones_[solid].frequency_Hz, tones_[solid].decay_per_s};
}

// Between the second and the third of four rounds that follow each other.
double TouchSound::stroke_at(double time_s) noexcept {
    while (n_moments_ > 3 && moment(2).time_s <= time_s) {
        first_ = (first_ + 1) % moments_.size();
        --n_moments_;
    }
    if (n_moments_ < 4 || time_s < moment(1).time_s || time_s >= moment(2).time_s ||
        moment(3).time_s - moment(0).time_s > 3.0 * kGap * round_s_) {
        return 0.0;
    }
    const Moment& before = moment(1);
    const Moment& after = moment(2);
    const double step_s = after.time_s - before.time_s;
    const double x = (time_s - before.time_s) / step_s;
    const double slope_m_per_s =
        cubic_slope(moment(0).height_m, before.height_m, after.height_m, moment(3).height_m, x) /
        step_s;
    // A surface that is reached or left is no slope of its relief.
    const double least =
        std::min({moment(0).loudness, before.loudness, after.loudness, moment(3).loudness});
    const double loudness = before.loudness + x * (after.loudness - before.loudness);
    return least > 0.0 ? kStrokeGain_s_per_m * loudness * slope_m_per_s : 0.0;
}

double TouchSound::taps_at(double time_s) noexcept {
    double sum = 0.0;
    for (Tap& tap : taps_) {
        const double since_s = time_s - tap.begins_s;
        if (tap.amplitude == 0.0 || since_s < 0.0) {
            continue;
        }
        const double envelope = tap.amplitude * std::exp(-tap.decay_per_s * since_s);
        if (envelope < kSilentTap) {
            tap.amplitude = 0.0;
            continue;
        }
        sum += envelope * std::sin(2.0 * std::numbers::pi * tap.frequency_Hz * since_s);
    }
    return sum;
}

void TouchSound::render(std::span<float> samples) noexcept {
    take_in(samples.size());
    for (float& sample : samples) {
        sample = static_cast<float>(soft_limit(stroke_at(now_s_) + taps_at(now_s_)));
        now_s_ += kSample_s;
    }
}

}  // namespace fulcrum::runtime
