// Newest-value hand-over from one writing thread to one reading thread: wait-free on both sides, never torn.
//
// Three slots: the writer owns one, the reader owns one, the third lies between them. `publish` and `take` exchange
// their own slot for the middle one with one atomic exchange; a flag in the same word says that the middle is new.
// Thread: one writer calls `publish`, one reader calls `take`/`value`. Cost: one copy and one atomic exchange.
// Source: the triple buffer of real-time audio practice; ownership of indices stated as in PipeWire's ring buffers.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <type_traits>

namespace fulcrum {

template <class T>
class LatestValue {
    // No heap may hide in a value that crosses a thread; fixed-size Eigen members pass, std::vector does not.
    static_assert(std::is_trivially_destructible_v<T>);

  public:
    /// Writer: makes `value` the newest. Never waits; an untaken older value is overwritten.
    void publish(const T& value) noexcept {
        slots_[writer_slot_] = value;
        const std::uint8_t before = middle_.exchange(static_cast<std::uint8_t>(writer_slot_ | kNew),
                                                     std::memory_order_acq_rel);
        writer_slot_ = before & kIndexMask;
    }

    /// Reader: fetches the newest value if there is one; true when it is newer than the last.
    bool take() noexcept {
        if ((middle_.load(std::memory_order_relaxed) & kNew) == 0) {
            return false;
        }
        reader_slot_ = middle_.exchange(reader_slot_, std::memory_order_acq_rel) & kIndexMask;
        return true;
    }

    /// Reader: the value last taken (default-constructed before the first).
    [[nodiscard]] const T& value() const noexcept { return slots_[reader_slot_]; }

  private:
    static constexpr std::uint8_t kIndexMask = 3;
    static constexpr std::uint8_t kNew = 4;

    std::array<T, 3> slots_{};
    alignas(64) std::atomic<std::uint8_t> middle_{1};
    alignas(64) std::uint8_t writer_slot_ = 0;  // touched by the writer only
    alignas(64) std::uint8_t reader_slot_ = 2;  // touched by the reader only
};

}  // namespace fulcrum
