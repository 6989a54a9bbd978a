// Numbers by chance that are the same in every run: SplitMix64.
//
//   s_n = seed + n gamma (mod 2^64),   output n = mix(s_n)
// so that any of them can be had without those before it.
//
// Thread: any; an object by one. Cost: a nanosecond.
// Source: G. Steele, D. Lea, C. Flood 2014, Fast splittable pseudorandom number generators, OOPSLA, figure 17.
#pragma once

#include <cstdint>

namespace fulcrum {

inline constexpr std::uint64_t kSplitMixGamma = 0x9E3779B97F4A7C15U;

/// What is drawn in the state `s`.
[[nodiscard]] constexpr std::uint64_t compute_split_mix(std::uint64_t s) noexcept {
    s = (s ^ (s >> 30U)) * 0xBF58476D1CE4E5B9U;
    s = (s ^ (s >> 27U)) * 0x94D049BB133111EBU;
    return s ^ (s >> 31U);
}

/// The upper 53 bits as a number in [0, 1).
[[nodiscard]] constexpr double to_chance(std::uint64_t bits) noexcept {
    return static_cast<double>(bits >> 11U) * 0x1.0p-53;
}

/// One after another.
class SplitMix {
  public:
    explicit constexpr SplitMix(std::uint64_t seed) noexcept : state_(seed) {}
    [[nodiscard]] constexpr std::uint64_t draw() noexcept {
        state_ += kSplitMixGamma;
        return compute_split_mix(state_);
    }
    /// In [0, 1).
    [[nodiscard]] constexpr double draw_chance() noexcept { return to_chance(draw()); }

  private:
    std::uint64_t state_;
};

}  // namespace fulcrum
