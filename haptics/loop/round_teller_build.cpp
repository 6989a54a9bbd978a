// The load path of round_teller.h.
#include "haptics/loop/round_teller.h"

#include <utility>

namespace fulcrum {

RoundTeller::RoundTeller(HapticChannels& channels, std::vector<EffectSlot> effects)
    : channels_(&channels), effects_(std::move(effects)) {
    for (std::size_t i = effects_.size(); i > 0; --i) {
        slot_of_[static_cast<std::size_t>(effects_[i - 1].effect)] =
            static_cast<std::int8_t>(i - 1);
    }
    shares_.n = static_cast<std::int32_t>(effects_.size());
}

}  // namespace fulcrum
