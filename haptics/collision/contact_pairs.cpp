#include "haptics/collision/contact_pairs.h"

#include <algorithm>

namespace fulcrum {

ContactPairs::ContactPairs(int max_pairs)
    : slots_(to_index(std::max(max_pairs, 0))),
      free_(max_pairs),
      used_(max_pairs),
      before_(max_pairs) {
    for (std::size_t i = slots_.size(); i-- > 0;) {
        free_.add(static_cast<std::uint32_t>(i));
    }
}

// Both lists ascend: one walk finds who stayed and who left. Slots of those who left are free before any is taken.
void ContactPairs::update(std::span<const BodyPair> pairs) noexcept {
    pairs = pairs.first(std::min(pairs.size(), slots_.size()));
    std::swap(used_, before_);
    used_.clear();
    std::size_t old = 0;
    for (const std::uint32_t slot : before_.all()) {
        while (old < pairs.size() && pairs[old] < slots_[slot].bodies) {
            ++old;
        }
        if (old == pairs.size() || pairs[old] != slots_[slot].bodies) {
            free_.add(slot);
            slots_[slot].bodies = {-1, -1};
        }
    }
    old = 0;
    for (const BodyPair& pair : pairs) {
        while (old < before_.count() && slots_[before_[old]].bodies < pair) {
            ++old;  // it left, or its slot has been given to an earlier pair
        }
        if (old < before_.count() && slots_[before_[old]].bodies == pair) {
            used_.add(before_[old++]);
            continue;
        }
        const std::uint32_t slot = free_.take_last();
        slots_[slot] = ContactPair{.bodies = pair};
        used_.add(slot);
    }
}

}  // namespace fulcrum
