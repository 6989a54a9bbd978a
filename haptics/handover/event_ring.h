// Single-producer, single-consumer ring for events: wait-free, bounded; a full ring drops the newest and counts it.
//
// Thread: one producer calls `push`, one consumer calls `pop`. Cost: one copy and one release store.
// Each side keeps its own copy of the other's index and looks at the shared one only when its copy says full or empty
// (after Rigtorp's SPSCQueue and moodycamel's readerwriterqueue, who publish the reason: fewer shared cache lines).
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace fulcrum {

template <class T, std::size_t kCapacity>
class EventRing {
    static_assert(std::is_trivially_destructible_v<T>);
    static_assert(kCapacity > 0 && (kCapacity & (kCapacity - 1)) == 0,
                  "the capacity is a power of two");

  public:
    /// Producer: false when the ring is full; the event is dropped and counted.
    bool push(const T& event) noexcept {
        return push_by([&event](T& slot) { slot = event; });
    }

    /// The same for an event of which a part may be left as it is: `fill(T&)` sets it where it lies, and may not read what it finds.
    template <class Fill>
    bool push_by(Fill fill) noexcept {
        const std::uint64_t head = head_.load(std::memory_order_relaxed);
        if (head - tail_seen_ == kCapacity) {
            tail_seen_ = tail_.load(std::memory_order_acquire);
            if (head - tail_seen_ == kCapacity) {
                dropped_.fetch_add(1, std::memory_order_relaxed);
                return false;
            }
        }
        fill(slots_[head & (kCapacity - 1)]);
        head_.store(head + 1, std::memory_order_release);
        return true;
    }

    /// Consumer: false when there is nothing.
    bool pop(T& event) noexcept {
        const std::uint64_t tail = tail_.load(std::memory_order_relaxed);
        if (tail == head_seen_) {
            head_seen_ = head_.load(std::memory_order_acquire);
            if (tail == head_seen_) {
                return false;
            }
        }
        event = slots_[tail & (kCapacity - 1)];
        tail_.store(tail + 1, std::memory_order_release);
        return true;
    }

    /// Any thread: how many events were dropped so far.
    [[nodiscard]] std::uint64_t dropped() const noexcept {
        return dropped_.load(std::memory_order_relaxed);
    }

  private:
    std::array<T, kCapacity> slots_{};
    alignas(64) std::atomic<std::uint64_t> head_{0};  // next to write; stored by the producer
    std::uint64_t tail_seen_ = 0;                     // producer's copy of tail_
    alignas(64) std::atomic<std::uint64_t> tail_{0};  // next to read; stored by the consumer
    std::uint64_t head_seen_ = 0;                     // consumer's copy of head_
    alignas(64) std::atomic<std::uint64_t> dropped_{0};
};

}  // namespace fulcrum
