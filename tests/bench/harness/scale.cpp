#include "tests/bench/harness/scale.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fulcrum::bench {
namespace {

constexpr double kMargin = 0.04;     // of the extent, on either side
constexpr double kMostTicks = 7.0;   // on a linear axis
constexpr double kFewDecades = 2.5;  // below it the 2 and 5 between decades are shown too
constexpr double kMostDecades = 9.0;

// The smallest of 1, 2, 5 times a power of ten that is at least `value`.
double round_up(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= value * (1.0 - 1e-9)) {
            return factor * power;
        }
    }
    return 10.0 * power;
}

}  // namespace

void Extent::add(double value, bool logarithmic) {
    if (std::isfinite(value) && (!logarithmic || value > 0.0)) {
        low_ = std::min(low_, value);
        high_ = std::max(high_, value);
    }
}

Scale::Scale(const Extent& extent, bool logarithmic, double from, double to)
    : logarithmic_(logarithmic), low_(0.0), high_(1.0), from_(from), to_(to) {
    if (!extent.empty()) {
        low_ = logarithmic ? std::log10(extent.low()) : extent.low();
        high_ = logarithmic ? std::log10(extent.high()) : extent.high();
    }
    const double least = logarithmic ? 0.3 : std::max(1e-12, 1e-6 * std::abs(high_));
    const double margin = std::max(kMargin * (high_ - low_), high_ - low_ < least ? least : 0.0);
    // A scale that begins at zero goes on beginning there.
    low_ -= !logarithmic && low_ == 0.0 ? 0.0 : margin;
    high_ += margin;
}

double Scale::place(double value) const {
    const double v = logarithmic_ ? (value > 0.0 ? std::log10(value) : low_) : value;
    const double share = std::clamp((v - low_) / (high_ - low_), 0.0, 1.0);
    return from_ + share * (to_ - from_);
}

std::vector<double> Scale::ticks() const {
    std::vector<double> list;
    if (!logarithmic_) {
        const double step = round_up((high_ - low_) / kMostTicks);
        for (double k = std::ceil(low_ / step); k * step <= high_ + 1e-9 * step; k += 1.0) {
            list.push_back(k * step);
        }
        return list;
    }
    const double every = std::ceil((high_ - low_) / kMostDecades);
    for (double decade = std::floor(low_); decade <= high_; decade += every) {
        for (const double factor : {1.0, 2.0, 5.0}) {
            const double exponent = decade + std::log10(factor);
            const bool shown = factor == 1.0 || high_ - low_ < kFewDecades;
            if (shown && exponent >= low_ && exponent <= high_) {
                list.push_back(std::pow(10.0, decade) * factor);
            }
        }
    }
    return list;
}

}  // namespace fulcrum::bench
