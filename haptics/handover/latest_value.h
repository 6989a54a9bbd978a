// Newest-value hand-over from one writing thread to one reading thread: wait-free on both sides, never torn.
//
// Three slots: the writer owns one, the reader owns one, the third lies between them. `publish` and `take` exchange
// their own slot for the middle one with one atomic exchange; a flag in the same word says that the middle is new.
// Thread: one writer calls `publish`, one reader calls `take`/`value`. Cost: one copy and one atomic exchange;
// by a ThriftyWriter the exchange alone while nothing changes.
// Source: the triple buffer of real-time audio practice; ownership of indices stated as in PipeWire's ring buffers.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <type_traits>

namespace fulcrum {

template <class T>
class ThriftyWriter;

template <class T>
class LatestValue {
    // No heap may hide in a value that crosses a thread; fixed-size Eigen members pass, std::vector does not.
    static_assert(std::is_trivially_destructible_v<T>);

  public:
    /// Writer: makes `value` the newest. Never waits; an untaken older value is overwritten.
    void publish(const T& value) noexcept {
        slots_[writer_slot_] = value;
        hand_over();
    }

    /// Reader: fetches the newest value if there is one; true when it is newer than the last.
    bool take() noexcept {
        if ((middle_.load(std::memory_order_relaxed) & kNew) == 0) {
            return false;
        }
        reader_slot_ = middle_.exchange(reader_slot_, std::memory_order_acq_rel) & kIndexMask;
        ++n_taken_;
        return true;
    }

    /// Reader: how often there was a newer one.
    [[nodiscard]] std::uint64_t n_taken() const noexcept { return n_taken_; }

    /// Reader: the value last taken (default-constructed before the first).
    [[nodiscard]] const T& value() const noexcept { return slots_[reader_slot_]; }

  private:
    friend class ThriftyWriter<T>;

    // Writer: what lies in its own slot becomes the newest; the slot that it gets holds an older value.
    void hand_over() noexcept {
        const std::uint8_t before = middle_.exchange(static_cast<std::uint8_t>(writer_slot_ | kNew),
                                                     std::memory_order_acq_rel);
        writer_slot_ = before & kIndexMask;
    }

    static constexpr std::uint8_t kIndexMask = 3;
    static constexpr std::uint8_t kNew = 4;

    std::array<T, 3> slots_{};
    alignas(64) std::atomic<std::uint8_t> middle_{1};
    alignas(64) std::uint8_t writer_slot_ = 0;  // touched by the writer only
    alignas(64) std::uint8_t reader_slot_ = 2;  // touched by the reader only, like the next
    std::uint64_t n_taken_ = 0;
};

/// Writes a value of which little changes from one time to the next: it is filled only where the slot holds an older
/// revision, so that a value that stays costs what is refreshed in it and no copy.
/// Thread: the writer's. As long as it lives it is the channel's only writer: it knows what each slot holds.
template <class T>
class ThriftyWriter {
  public:
    static constexpr std::uint64_t kNoRevision = 0;  ///< of what is filled anew each time

    /// The channel outlives it; what a former writer left there counts for nothing.
    explicit ThriftyWriter(LatestValue<T>& to) noexcept : to_(to) {}

    /// Makes a value the newest: `fill(T&)` sets all of it but for what `refresh(T&)` sets, and is called only where
    /// the slot was not filled under this `revision`. Neither may read what they find.
    template <class Fill, class Refresh>
    void publish(std::uint64_t revision, Fill fill, Refresh refresh) noexcept {
        const std::uint8_t slot = to_.writer_slot_;
        if (revisions_[slot] != revision || revision == kNoRevision) {
            fill(to_.slots_[slot]);
            revisions_[slot] = revision;
        }
        refresh(to_.slots_[slot]);
        to_.hand_over();
    }

  private:
    LatestValue<T>& to_;
    std::array<std::uint64_t, 3> revisions_{};  // under which each slot was filled
};

}  // namespace fulcrum
