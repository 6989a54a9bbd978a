#include "haptics/tool/field_sampling/budget_look.h"

namespace fulcrum {

void BudgetLook::look_first(TimedLook& in) noexcept {
    const std::size_t level = in.search();
    if (level == 0 && in.found().size() <= in.time().find_room(1.0)) {
        in.take_found();
    } else if (thinned_.look(in, level, units_, touched_last_)) {
        choice_.make(in, thinned_.is_closer(),
                     thinned_.is_closer() ? thinned_.parts() : units_.due());
    } else {
        deepest_.look(in, level, touched_last_);
        choice_.make(in, true, in.found());
    }
}

void BudgetLook::look(TimedLook& in, bool slopes_follow) noexcept {
    constexpr double kForceFirst = 0.5;  // of the time
    in.time().set_share(slopes_follow ? kForceFirst : 1.0);
    if (choice_.is_made()) {
        choice_.look_again(in, units_);
    } else {
        look_first(in);
    }
    in.time().set_share(1.0);
    touched_last_.clear();
    if (in.sums().weight() == 1) {
        touched_last_.copy(in.sums().touched());
    }
}

}  // namespace fulcrum
