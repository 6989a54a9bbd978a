// How old what a thread beside told of contact was, step by step, and how often that was too old.
//
// Thread: the haptic loop adds; any thread reads, without a lock. Cost: 5 ns.
#pragma once

#include "haptics/loop/latency_histogram.h"
#include "haptics/tool/contact_age.h"

#include <atomic>
#include <cstdint>

namespace fulcrum {

class ContactLateness {
  public:
    /// A step that went by what is so old.
    void add(const ContactAge& contact) noexcept {
        age_.add(contact.age_s());
        if (contact.is_late()) {
            n_late_.store(n_late_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
        }
    }
    [[nodiscard]] const LatencyHistogram& age() const noexcept { return age_; }
    /// Steps that gave less force for it.
    [[nodiscard]] std::uint64_t n_late() const noexcept {
        return n_late_.load(std::memory_order_relaxed);
    }

  private:
    LatencyHistogram age_;
    std::atomic<std::uint64_t> n_late_{0};
};

}  // namespace fulcrum
