// A kite that is made on one thread and flown on another: it crosses as a whole, and what it replaces goes back to be freed.
//
//   lesson loop --put--> next --take--> kite loop --spent--> freed at the next put, or at the end
// Nothing is made or freed on the kite loop's thread.
//
// Thread: `put` and the destructor on the one that makes them; `take` on the one that flies them. Cost: `take` is an atomic
// exchange where there is something new, else a load; wait-free.
#pragma once

#include "haptics/flight/kite_flight.h"

#include <atomic>
#include <memory>

namespace fulcrum {

class KiteSwap {
  public:
    KiteSwap() = default;
    KiteSwap(const KiteSwap&) = delete;
    KiteSwap& operator=(const KiteSwap&) = delete;
    ~KiteSwap();

    /// The kite to be flown next, instead of one that has not been taken yet.
    void put(std::unique_ptr<KiteFlight> next);
    /// The kite to be flown from now on, which is the caller's to fly and this one's to free no more; `flown` comes back in its
    /// place. Null where there is none, or while what came back last has not been freed: then `flown` stays the caller's.
    [[nodiscard]] KiteFlight* take(KiteFlight* flown) noexcept;

  private:
    std::atomic<KiteFlight*> next_{nullptr};   // writer: put; taker: take
    std::atomic<KiteFlight*> spent_{nullptr};  // writer: take; freed by put
};

}  // namespace fulcrum
