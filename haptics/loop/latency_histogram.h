// Counts of times in bins of equal ratio: eight bins an octave, from a nanosecond up, without a lock.
//
//   bin = 8 (floor(log2 t) - 2) + the three bits after t's leading one,  t in nanoseconds, t >= 8
// A bin is at most 12.5 % wide; below 8 ns each nanosecond has one.
//
// Thread: one thread calls `add`; any thread reads, and sees each count before or after an `add`.
// Cost: about 3 ns.
// Source: the logarithm's integer part and top mantissa bits, as in G. Tene's HdrHistogram.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace fulcrum {

class LatencyHistogram {
  public:
    /// Counts one time; negative and NaN count as zero.
    void add(double time_s) noexcept;
    /// How many were counted.
    [[nodiscard]] std::uint64_t count() const noexcept;
    /// The time that `share` (0 to 1) of the counts do not exceed, seconds, rounded up to its bin's upper end and never above
    /// the maximum; 0 when nothing was counted.
    [[nodiscard]] double compute_quantile_s(double share) const noexcept;
    /// The largest time counted, seconds.
    [[nodiscard]] double max_s() const noexcept {
        return static_cast<double>(max_ns_.load(std::memory_order_relaxed)) * 1e-9;
    }

  private:
    static constexpr int kBinsAnOctave = 8;
    static constexpr std::size_t kBins = std::size_t{64} * kBinsAnOctave;
    std::array<std::atomic<std::uint64_t>, kBins> bins_{};
    std::atomic<std::uint64_t> max_ns_{0};
};

}  // namespace fulcrum
