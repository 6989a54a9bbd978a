// The samples of field_sampling.h that stand for all where a budget is too small for them.
#include "haptics/tool/field_sampling.h"
#include "haptics/tool/rank_cut.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {

namespace {

constexpr std::int64_t kEnoughTouch = 64;  // samples that stand for all

}  // namespace

// Units of a thinning, each of several nodes that follow each other or a part of one, to `leaves_`; to `parts_` those whose samples
// are not known to be free.
void FieldSampler::list_units(std::size_t level, std::size_t thinning) noexcept {
    const std::vector<float>& until = free_until(thinning);
    const std::size_t as_level = 3 * level;
    const std::size_t merge = thinning > as_level ? thinning - as_level : 0;
    const std::size_t split = thinning > as_level ? 0 : as_level - thinning;
    leaves_.clear();
    parts_.clear();
    std::size_t next = 0;
    for (const std::int32_t node : nodes_) {
        const std::size_t first = static_cast<std::size_t>(node) >> merge << split;
        const std::size_t end =
            std::min(first + (std::size_t{1} << split), shell_->n_leaves(thinning));
        for (std::size_t unit = std::max(first, next); unit < end; ++unit) {
            leaves_.add(static_cast<std::int32_t>(unit));
            if (until[unit] <= now_) {
                parts_.add(static_cast<std::int32_t>(unit));
            }
        }
        next = std::max(next, end);
    }
}

// What touches of the units first, then what is nearest to it; those in `parts_` were looked at in this step.
void FieldSampler::rank_units(std::size_t thinning) noexcept {
    constexpr float kNearest = 0.999F * RankCut::kFirst;
    // What was not looked at is that free at least, and more as a rule.
    constexpr float kMore_voxels = 0.5F;
    const std::vector<float>& until = free_until(thinning);
    const std::int32_t* looked = parts_.begin();
    for (std::size_t i = 0; i < leaves_.size(); ++i) {
        const std::int32_t unit = leaves_.begin()[i];
        const bool is_new = looked != parts_.end() && *looked == unit;
        looked += is_new ? 1 : 0;
        const float least = until[static_cast<std::size_t>(unit)] - now_;
        const float free = least + (is_new ? 0.0F : kMore_voxels);
        const float share = std::clamp(free / bounds_.view.band_voxels, 0.0F, 1.0F);
        ranks_[i] = least < -kFreeMargin_voxels ? RankCut::kFirst : kNearest * (1.0F - share);
    }
}

// As many of the units as there is room for.
void FieldSampler::choose_units(std::size_t room) noexcept {
    const std::size_t n = leaves_.size();
    RankCut cut({ranks_.data(), n}, room);
    std::size_t n_kept = 0;
    for (std::size_t i = 0; i < n; ++i) {
        if (cut.takes(ranks_[i])) {
            ranks_[n_kept] = ranks_[i];
            leaves_.put(n_kept++, leaves_.begin()[i]);
        }
    }
    leaves_.shorten(n_kept);
}

// As fine as there is room for; what nearly touches as well, the more the better, for what touches between samples is missed else.
std::size_t FieldSampler::choose_finer(std::size_t thinning) noexcept {
    const std::size_t n_touched = touched_.size();
    const std::size_t room = find_room(1.0);
    std::size_t finer = thinning;
    for (const std::size_t more : {2 * n_touched, n_touched, n_touched / 2, n_touched / 4}) {
        choose_units(n_touched + more + 1);
        while (finer > 0 && list_parts(thinning, finer - 1, room)) {
            --finer;
        }
        if (finer < thinning) {
            break;
        }
    }
    return finer < thinning && list_parts(thinning, finer, room) ? finer : thinning;
}

// Leaves out all nodes but those of the units chosen.
void FieldSampler::keep_chosen(std::size_t level, std::size_t thinning) noexcept {
    const std::size_t merge = thinning - std::min(thinning, 3 * level);
    const std::size_t split = 3 * level - std::min(thinning, 3 * level);
    std::size_t n = 0;
    const std::int32_t* unit = leaves_.begin();
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        const std::int32_t node = nodes_.begin()[i];
        while (unit != leaves_.end() && (*unit >> split) < (node >> merge)) {
            ++unit;
        }
        if (unit != leaves_.end() && (*unit >> split) == (node >> merge)) {
            depths_[n] = depths_[i];
            nodes_.put(n++, node);
        } else {
            leave_out(level, i);
        }
    }
    nodes_.shorten(n);
}

// What the units chosen stand for by a finer thinning, to `parts_`, but for what is known to be free; whether there is room.
bool FieldSampler::list_parts(std::size_t thinning, std::size_t finer, std::size_t room) noexcept {
    const std::vector<float>& until = free_until(finer);
    const std::size_t n_parts = std::size_t{1} << (thinning - finer);
    parts_.clear();
    for (const std::int32_t unit : leaves_) {
        const std::size_t first = static_cast<std::size_t>(unit) * n_parts;
        const std::size_t end = std::min(first + n_parts, shell_->n_leaves(finer));
        for (std::size_t i = first; i < end; ++i) {
            if (until[i] <= now_) {
                parts_.add(static_cast<std::int32_t>(i));
            }
        }
        if (parts_.size() > room) {
            return false;
        }
    }
    return true;
}

bool FieldSampler::look_closer(std::size_t level, std::size_t thinning, const FieldPlace& place,
                               const Pose& X_OT) noexcept {
    rank_units(thinning);
    const std::size_t finer = choose_finer(thinning);
    const bool is_enough = finer == 0 || (sums_.n_touching << (thinning - finer)) >= kEnoughTouch;
    if (finer == thinning || !is_enough) {
        return false;
    }
    keep_chosen(level, thinning);
    // Where the clock cuts this short, what was seen first stands.
    const FirstLook first{sums_, spread_, deepest_steps_, touched_.size()};
    sums_ = {};
    spread_ = {};
    deepest_steps_ = 0.0F;
    touch_.weight = std::int64_t{1} << finer;
    const std::size_t n = take_in_time(finer, {parts_.begin(), parts_.size()}, place, X_OT);
    empty_lanes(X_OT);
    if (n == parts_.size()) {
        touched_.drop_first(first.n_touched);
        return finer == 0;
    }
    sums_ = first.sums;
    spread_ = first.spread;
    deepest_steps_ = first.deepest_steps;
    touched_.shorten(first.n_touched);
    touch_.weight = std::int64_t{1} << thinning;
    was_cut_short_ = false;
    return false;
}

bool FieldSampler::take_samples(std::size_t level, const FieldPlace& place,
                                const Pose& X_OT) noexcept {
    constexpr double kFirstLook = 0.6;  // of the time; the rest looks closer where that touched
    const std::size_t first_room = find_room(kFirstLook);
    std::size_t thinning = 3 * (level - std::min<std::size_t>(level, 1));
    list_units(level, thinning);
    while (parts_.size() > first_room && thinning + 1 < shell_->n_thinnings()) {
        list_units(level, ++thinning);
    }
    touch_.weight = std::int64_t{1} << thinning;
    take_in_time(thinning, {parts_.begin(), parts_.size()}, place, X_OT);
    empty_lanes(X_OT);
    missed_points_ =
        static_cast<double>(touch_.weight) * std::sqrt(static_cast<double>(touched_.size()));
    const bool is_all = touched_.size() > 0 && look_closer(level, thinning, place, X_OT);
    if (touch_.weight > 1 && sums_.n_touching < kEnoughTouch) {
        forget_sums();
        return false;
    }
    for (std::size_t i = 0; i < nodes_.size() && !is_all; ++i) {
        leave_out(level, i);
    }
    return true;
}

}  // namespace fulcrum
