// Why the hand feels its force, for the panel that says so: each effect's share as the loop tells it, calmed so that it can be read.
//
//   w <- w + (w_told - w) (1 - exp(-dt / kCalm_s))      every share alike, so that the sum stays the sum
// The strongest come first; what a hand does not notice (kShownShare_N) is left out.
//
// All words are the catalogue's (hud.why…), but for the names that a lesson gave its own forces.
//
// Thread: lesson loop. Cost: a microsecond a frame, and nothing where the panel is not wanted.
#pragma once

#include "dialogue/catalogue.h"
#include "haptics/handover/force_shares.h"
#include "haptics/handover/messages.h"
#include "runtime/evidence/force_account.h"
#include "runtime/scene/description.h"
#include "runtime/scene/view.h"

#include <span>
#include <string>
#include <vector>

namespace fulcrum::runtime {

inline constexpr double kCalm_s = 0.15;
inline constexpr double kShownShare_N = 0.05;

class WhyShown {
  public:
    /// `effects`: the loop's, of a lesson with these forces.
    WhyShown(std::span<const EffectSlot> effects, std::span<const ForceDescription> forces,
             const MostFelt& most);

    /// What was told for a frame; a time that does not go on changes nothing.
    void look(const ForceShares& shares, const HapticState& state, double time_s);
    /// As it stands.
    [[nodiscard]] ViewWhy show(const dialogue::Catalogue& catalogue) const;

  private:
    MostFelt most_;
    std::vector<const char*> keys_;  // of the effects' words, as many as calm_ has effects
    ForceAccount calm_{};
    bool has_looked_ = false;
    double looked_s_ = 0.0;
};

}  // namespace fulcrum::runtime
