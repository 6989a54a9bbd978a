#include "haptics/loop/latency_histogram.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>

namespace fulcrum {
namespace {

constexpr std::uint64_t kLongest_ns = std::uint64_t{1} << 62;

std::size_t compute_bin(std::uint64_t time_ns) noexcept {
    // Below eight nanoseconds there are no three bits after the leading one: a bin each.
    if (time_ns < 8) {
        return static_cast<std::size_t>(time_ns);
    }
    const int octave = static_cast<int>(std::bit_width(time_ns)) - 1;
    return static_cast<std::size_t>(8 * (octave - 2)) +
           static_cast<std::size_t>((time_ns >> (octave - 3)) & 7U);
}

// The largest time that falls into `bin`.
std::uint64_t compute_upper_ns(std::size_t bin) noexcept {
    if (bin < 8) {
        return bin;
    }
    const auto octave = static_cast<int>(bin / 8) + 2;
    return ((std::uint64_t{8} + bin % 8 + 1) << (octave - 3)) - 1;
}

}  // namespace

void LatencyHistogram::add(double time_s) noexcept {
    const double time_ns = time_s * 1e9;
    const std::uint64_t ns =
        time_ns > 0.0
            ? static_cast<std::uint64_t>(std::min(time_ns, static_cast<double>(kLongest_ns)))
            : 0;
    // The one writer needs no read-modify-write.
    std::atomic<std::uint64_t>& bin = bins_[compute_bin(ns)];
    bin.store(bin.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
    if (ns > max_ns_.load(std::memory_order_relaxed)) {
        max_ns_.store(ns, std::memory_order_relaxed);
    }
}

std::uint64_t LatencyHistogram::count() const noexcept {
    std::uint64_t sum = 0;
    for (const auto& bin : bins_) {
        sum += bin.load(std::memory_order_relaxed);
    }
    return sum;
}

double LatencyHistogram::compute_quantile_s(double share) const noexcept {
    const auto total = static_cast<double>(count());
    double seen = 0.0;
    for (std::size_t i = 0; i < kBins; ++i) {
        seen += static_cast<double>(bins_[i].load(std::memory_order_relaxed));
        if (seen > 0.0 && seen >= share * total) {
            return std::min(static_cast<double>(compute_upper_ns(i)) * 1e-9, max_s());
        }
    }
    return max_s();
}

}  // namespace fulcrum
