// The step path of kite_swap.h.
#include "haptics/flight/kite_swap.h"

namespace fulcrum {

KiteFlight* KiteSwap::take(KiteFlight* flown) noexcept {
    if (next_.load(std::memory_order_acquire) == nullptr ||
        spent_.load(std::memory_order_acquire) != nullptr) {
        return nullptr;
    }
    KiteFlight* next = next_.exchange(nullptr, std::memory_order_acq_rel);
    if (next != nullptr) {
        spent_.store(flown, std::memory_order_release);
    }
    return next;
}

}  // namespace fulcrum
