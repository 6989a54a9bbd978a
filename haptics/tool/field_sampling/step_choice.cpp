#include "haptics/tool/field_sampling/step_choice.h"

namespace fulcrum {

void StepChoice::make(TimedLook& in, bool is_listed, const NodeList& leaves) noexcept {
    if (!in.time().is_shared()) {
        return;
    }
    is_made_ = true;
    is_listed_ = is_listed;
    thinning_ = in.sums().thinning();
    miss_ = in.error().miss();
    chosen_.copy(leaves);
}

// What was chosen has its time before the search goes down; what the search finds tells what is left out.
void StepChoice::look_again(TimedLook& in, SampleUnits& units) const noexcept {
    in.time().hold_for(chosen_.size());
    const std::size_t level = in.search();
    in.time().hold_for(0);
    if (is_listed_) {
        units.list_due(chosen_, in.known(thinning_));
    } else {
        units.list(in.found(), level, thinning_, in.shell().n_leaves(thinning_),
                   in.known(thinning_));
    }
    in.sums().begin(thinning_);
    in.take(units.due().all());
    in.error().set_miss(miss_);
    if (is_listed_ && thinning_ == 0 && !in.error().is_cut_short()) {
        in.leave_out_others(level, chosen_);
    } else {
        in.leave_out_all(level);
    }
}

}  // namespace fulcrum
