#include "haptics/tool/field_sampling/free_memory.h"

#include <bit>

namespace fulcrum {
namespace {

constexpr float kAlways = -1.0e30F;  // long ago

}  // namespace

template <class Use>
void FreeMemory::visit_times(Use use) noexcept {
    for (Level& level : levels_) {
        use(level.until);
        use(level.hopeless_until);
    }
    std::for_each(thinned_until_.begin(), thinned_until_.end(), use);
}

void FreeMemory::reset() noexcept {
    visit_times([](std::vector<float>& times) { std::fill(times.begin(), times.end(), kAlways); });
    seen_.forget();
    clock_.reset();
}

void FreeMemory::rebase() noexcept {
    visit_times([now = clock_.now()](std::vector<float>& times) {
        for (float& time : times) {
            time -= now;
        }
    });
    seen_.forget();
    clock_.rebase();
}

void FreeMemory::advance(const FieldLook& look) noexcept {
    clock_.advance(look.X_OT, look.pair.shell->reach_m(), look.pair.field->frame().voxel_m);
    if (clock_.is_to_rebase()) {
        rebase();
    }
}

unsigned FreeMemory::recall_leaves(const FieldLook& look, std::size_t group,
                                   unsigned due) noexcept {
    FreeGroup known = this->group(0, group);
    for (unsigned i = due; i != 0; i &= i - 1U) {
        const auto at = static_cast<std::size_t>(std::countr_zero(i));
        const float free_voxels = seen_.recall(look, ShellTree::kWidth * group + at, clock_);
        if (free_voxels > SeenLeaves::kLeastWorth_voxels) {
            known.note_free(at, free_voxels * look.pair.bounds.inverse_slope);
            due &= ~(1U << at);
        }
    }
    return due;
}

void FreeMemory::note_leaves(const FieldLook& look, std::size_t thinning,
                             std::span<const std::int32_t> leaves,
                             const float* least_steps) noexcept {
    const SlackBounds& bounds = look.pair.bounds;
    const float free_per_step = bounds.voxels_per_step * bounds.inverse_slope;
    float* const until =
        (thinning == 0 ? levels_.front().until : thinned_until_[thinning - 1]).data();
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        const auto leaf = static_cast<std::size_t>(leaves[i]);
        until[leaf] = clock_.now() + least_steps[i] * free_per_step - MotionClock::kMargin_voxels;
        if (thinning == 0) {
            seen_.remember(look, leaf, least_steps[i] * bounds.voxels_per_step, clock_);
        }
    }
}

void FreeMemory::note_groups(std::size_t level, const NodeList& groups) noexcept {
    if (level + 1 == levels_.size()) {
        return;
    }
    for (const std::int32_t group : groups) {
        const auto at = static_cast<std::size_t>(group);
        const auto first =
            levels_[level].until.begin() + static_cast<std::ptrdiff_t>(ShellTree::kWidth * at);
        float& until = levels_[level + 1].until[at];
        until = std::max(until, *std::min_element(first, first + ShellTree::kWidth));
    }
}

}  // namespace fulcrum
