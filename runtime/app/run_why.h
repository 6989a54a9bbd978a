// What each hand's force is made of, for somebody at a window who may ask.
//
// Thread: the lesson's; the haptic loop writes what `build` put into its channels.
#pragma once

#include "dialogue/catalogue.h"
#include "runtime/app/run_hand.h"
#include "runtime/lesson/session.h"
#include "runtime/lesson/why_shown.h"
#include "runtime/scene/view.h"

#include <memory>
#include <vector>

namespace fulcrum::runtime {

class RunWhy {
  public:
    /// Before the loops begin, for they look at the channel in each round.
    void build(const LessonDescription& lesson, const RunHands& hands);
    [[nodiscard]] bool is_there() const { return !asked_.empty(); }
    void look(const SessionInput& gathered);
    /// Why that hand feels its force, as things stand; nothing where nobody may ask, or there is no such hand.
    [[nodiscard]] ViewWhy show(std::size_t hand, const dialogue::Catalogue& catalogue) const;

  private:
    struct Asked {
        explicit Asked(WhyShown why) : shown(std::move(why)) {}
        LatestValue<ForceShares> shares;
        WhyShown shown;
    };
    std::vector<std::unique_ptr<Asked>> asked_;  // of each hand
};

}  // namespace fulcrum::runtime
