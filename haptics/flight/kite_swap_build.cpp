// The load path of kite_swap.h.
#include "haptics/flight/kite_swap.h"

namespace fulcrum {

KiteSwap::~KiteSwap() {
    put(nullptr);
}

void KiteSwap::put(std::unique_ptr<KiteFlight> next) {
    const std::unique_ptr<KiteFlight> spent(spent_.exchange(nullptr, std::memory_order_acq_rel));
    const std::unique_ptr<KiteFlight> untaken(
        next_.exchange(next.release(), std::memory_order_acq_rel));
}

}  // namespace fulcrum
