// Who waits while something loads: told how far it has come, and heard when it should end.
//
// What takes long asks a LoadPulse as often as it likes; that asks the one who waits every 50 ms, so that an end is heard soon and
// asking costs nothing.
//
// Thread: the one that loads. Cost: a look at the clock, 30 ns.
#pragma once

#include <chrono>
#include <functional>

namespace fulcrum {

/// Told the share done, 0 to 1; false stops the work. May be empty.
using LoadProgress = std::function<bool(double)>;

class LoadPulse {
  public:
    /// Refers to `progress`.
    explicit LoadPulse(const LoadProgress& progress) : progress_(progress) {}

    /// Whether to go on, with that share done.
    [[nodiscard]] bool goes_on(double share) {
        if (!progress_ || is_stopped_) {
            return !is_stopped_;
        }
        const auto now = std::chrono::steady_clock::now();
        return now - asked_ < kBetween || ask(share, now);
    }
    /// The same, asked at once.
    [[nodiscard]] bool goes_on_now(double share) {
        return !is_stopped_ && (!progress_ || ask(share, std::chrono::steady_clock::now()));
    }

  private:
    static constexpr std::chrono::milliseconds kBetween{50};

    bool ask(double share, std::chrono::steady_clock::time_point now) {
        asked_ = now;
        is_stopped_ = !progress_(share);
        return !is_stopped_;
    }

    const LoadProgress& progress_;
    std::chrono::steady_clock::time_point asked_ = std::chrono::steady_clock::now();
    bool is_stopped_ = false;
};

}  // namespace fulcrum
