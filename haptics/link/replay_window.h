// Which of a sender's numbered packets were taken already: each once, in any order, as long as it is not too old.
//
// A ring of bits about the newest number. What is older than kReach is refused, for nobody knows any more. Number 0 is never
// sent. Only packets that are authentic may come here: a forged number would push the window on.
//
// Cost: a few nanoseconds; a jump forward clears at most the whole ring.
// Source: RFC 4303, IP encapsulating security payload, section 3.4.3; RFC 6479, anti-replay algorithm without bit shifting:
// one word more than the reach needs, so that a word is cleared whole as the window enters it.
#pragma once

#include <array>
#include <cstdint>

namespace fulcrum {

class ReplayWindow {
  public:
    static constexpr std::uint64_t kReach = 256;  ///< packets behind the newest that may still come

    /// True, once, for a number that was not taken before and is not too old; then it counts as taken.
    [[nodiscard]] bool take(std::uint64_t number) noexcept {
        if (number == 0) {
            return false;
        }
        if (number > newest_) {
            enter(number);
        } else if (newest_ - number >= kReach) {
            return false;
        }
        std::uint64_t& word = words_[(number / kBits) % kWords];
        const std::uint64_t bit = std::uint64_t{1} << (number % kBits);
        if ((word & bit) != 0) {
            return false;
        }
        word |= bit;
        return true;
    }

    /// The largest number that was taken; 0 before the first.
    [[nodiscard]] std::uint64_t newest() const noexcept { return newest_; }

  private:
    static constexpr std::uint64_t kBits = 64;
    static constexpr std::uint64_t kWords = kReach / kBits + 1;

    void enter(std::uint64_t number) noexcept {
        const std::uint64_t from = newest_ / kBits;
        const std::uint64_t to = number / kBits;
        const std::uint64_t cleared = to - from < kWords ? to - from : kWords;
        for (std::uint64_t i = 1; i <= cleared; ++i) {
            words_[(from + i) % kWords] = 0;
        }
        newest_ = number;
    }

    std::uint64_t newest_ = 0;
    std::array<std::uint64_t, kWords> words_{};
};

}  // namespace fulcrum
