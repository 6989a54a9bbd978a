// Where what is made by chance takes its choices from: a seed, or the bytes of a fuzzer, whose end chooses the first of everything.
#pragma once

#include "haptics/math/split_mix.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace fulcrum::test {

class Choices {
  public:
    explicit Choices(std::uint64_t seed) : seeded_(SplitMix(seed)) {}
    explicit Choices(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

    /// One of `n`, 0 to n - 1.
    [[nodiscard]] std::size_t below(std::size_t n) {
        if (seeded_) {
            return static_cast<std::size_t>(seeded_->draw() % n);
        }
        const std::size_t low = take();
        return (n > kByte ? low + kByte * take() : low) % n;
    }
    [[nodiscard]] bool chance(std::size_t percent) {
        // The first choice is no: bytes that have ended leave out what may be left out.
        return below(100) >= 100 - percent;
    }
    /// Within [0, 1], both ends too.
    [[nodiscard]] double part() { return static_cast<double>(below(kParts)) / (kParts - 1); }

  private:
    static constexpr std::size_t kByte = 256;
    static constexpr std::size_t kParts = 65521;

    [[nodiscard]] std::size_t take() {
        if (bytes_.empty()) {
            return 0;
        }
        const std::size_t byte = bytes_.front();
        bytes_ = bytes_.subspan(1);
        return byte;
    }

    std::optional<SplitMix> seeded_;
    std::span<const std::uint8_t> bytes_;
};

}  // namespace fulcrum::test
