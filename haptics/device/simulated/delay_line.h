// Forces on their way to a simulated arm: what was written acts from its time on, each until the next one's.
//
// Thread: that of the arm. Cost: a copy each way. More than kMost on their way are not taken.
#pragma once

#include <array>
#include <cstddef>

namespace fulcrum {

/// `Force` is what acts; oldest first.
template <class Force>
class DelayLine {
  public:
    static constexpr std::size_t kMost = 200;

    /// `force` acts from `from_s` on. What acts at `now_s` already replaces `acting`. False where there is no room.
    [[nodiscard]] bool put(double from_s, const Force& force, double now_s,
                           Force& acting) noexcept {
        if (n_ == 0 && from_s <= now_s) {
            acting = force;
            return true;
        }
        if (n_ == kMost) {
            return false;
        }
        waiting_[(first_ + n_) % kMost] = {from_s, force};
        ++n_;
        return true;
    }

    /// From `at_s` to `now_s`: `advance(dt_s)` for every time in which the same force acts, changing `acting` between.
    template <class Advance>
    void run(double at_s, double now_s, Force& acting, const Advance& advance) noexcept {
        // Two times that differ by a clock's rounding are one.
        constexpr double kSameInstant_s = 1.0e-12;
        for (; n_ > 0 && waiting_[first_].from_s <= now_s + kSameInstant_s; --n_) {
            const Waiting& next = waiting_[first_];
            if (next.from_s > at_s + kSameInstant_s) {
                advance(next.from_s - at_s);
                at_s = next.from_s;
            }
            acting = next.force;
            first_ = (first_ + 1) % kMost;
        }
        if (now_s > at_s) {
            advance(now_s - at_s);
        }
    }

    /// Nothing is on its way any more.
    void clear() noexcept { n_ = 0; }

  private:
    struct Waiting {
        double from_s = 0.0;
        Force force{};
    };
    std::array<Waiting, kMost> waiting_{};
    std::size_t first_ = 0;
    std::size_t n_ = 0;
};

}  // namespace fulcrum
