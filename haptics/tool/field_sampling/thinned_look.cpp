#include "haptics/tool/field_sampling/thinned_look.h"

#include <cmath>

namespace fulcrum {
namespace {

// At samples of the least thinning that fits in the time of a first look.
void take_samples(TimedLook& in, std::size_t level, SampleUnits& units) noexcept {
    constexpr double kFirstLook = 0.5;  // of the time; the rest looks closer where that touched
    const std::size_t room = in.time().find_room(kFirstLook);
    std::size_t thinning = level == 0 ? 0 : 3 * (level - 1);
    const auto list = [&] {
        units.list(in.found(), level, thinning, in.shell().n_leaves(thinning), in.known(thinning));
    };
    for (list(); units.due().size() > room && thinning + 1 < in.shell().n_thinnings(); list()) {
        ++thinning;
    }
    in.sums().begin(thinning);
    in.take(units.due().all());
    in.sums().settle(in.at());
}

}  // namespace

bool ThinnedLook::look(TimedLook& in, std::size_t level, SampleUnits& units,
                       const NodeList& touched_last) noexcept {
    LeafSums& sums = in.sums();
    take_samples(in, level, units);
    const std::size_t n_touched = sums.touched().size();
    in.error().set_miss(
        {.points = static_cast<double>(sums.weight()) * std::sqrt(static_cast<double>(n_touched))});
    // Where none touches, what touched in the last step is a better guide.
    const bool has_guide = n_touched > 0 || touched_last.size() == 0;
    is_closer_ = sums.thinning() > 0 && has_guide && closer_.look(in, units, touched_last);
    if (sums.sums().n_touching < (sums.weight() > 1 ? CloserLook::kEnoughTouch : 1)) {
        in.error().set_miss({});
        sums.begin();
        return false;
    }
    if (is_closer_ && sums.thinning() == 0) {
        in.leave_out_others(level, closer_.taken());
        // In the order of leaves, as for all that looks for what touched in the last step.
        sums.sort_touched();
    } else {
        in.leave_out_all(level);
    }
    return true;
}

}  // namespace fulcrum
