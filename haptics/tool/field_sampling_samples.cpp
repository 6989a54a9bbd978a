// The samples of field_sampling.h that stand for all where a budget is too small for them.
#include "haptics/math/length.h"
#include "haptics/tool/field_sampling.h"
#include "haptics/tool/rank_cut.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace fulcrum {

namespace {

constexpr std::int64_t kEnoughTouch = 64;  // samples that stand for all
constexpr float kNearest = 0.999F * RankCut::kFirst;
constexpr float kLeastNear_voxels = 0.01F;

// Of what is free by F where others are as deep as `near`, the same unit.
float rank_free(float F, float near) noexcept {
    return kNearest * near / (near + F);
}

}  // namespace

// Units of a thinning, each of several nodes that follow each other or a part of one, to `leaves_`; to `parts_` those whose samples
// are not known to be free.
void FieldSampler::list_units(std::size_t level, std::size_t thinning) noexcept {
    const std::vector<float>& until = free_until(thinning);
    const std::size_t as_level = 3 * level;
    const std::size_t merge = thinning - std::min(thinning, as_level);
    const std::size_t split = as_level - std::min(thinning, as_level);
    leaves_.clear();
    parts_.clear();
    std::size_t next = 0;
    for (const std::int32_t node : nodes_) {
        const std::size_t first = static_cast<std::size_t>(node) >> merge << split;
        // NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult): at most 3 times the level
        const std::size_t n_units = std::size_t{1} << split;
        const std::size_t end = std::min(first + n_units, shell_->n_leaves(thinning));
        for (std::size_t unit = std::max(first, next); unit < end; ++unit) {
            leaves_.add(static_cast<std::int32_t>(unit));
            if (until[unit] <= now_) {
                parts_.add(static_cast<std::int32_t>(unit));
            }
        }
        next = std::max(next, end);
    }
}

// What touches of the units first, then what is nearest to it; those in `parts_` were looked at in this step. The highest rank.
float FieldSampler::rank_units(std::size_t thinning) noexcept {
    // What was not looked at is that free at least, and more as a rule.
    constexpr float kMore_voxels = 0.5F;
    const std::vector<float>& until = free_until(thinning);
    const float near = std::max(-deepest_steps_ * bounds_.voxels_per_step, kLeastNear_voxels);
    const std::int32_t* looked = parts_.begin();
    float highest = 0.0F;
    for (std::size_t i = 0; i < leaves_.size(); ++i) {
        const std::int32_t unit = leaves_.begin()[i];
        const bool is_new = looked != parts_.end() && *looked == unit;
        looked += is_new ? 1 : 0;
        const float least = until[static_cast<std::size_t>(unit)] - now_;
        const float free = least + (is_new ? 0.0F : kMore_voxels);
        ranks_[i] =
            least < -kFreeMargin_voxels ? RankCut::kFirst : rank_free(std::max(free, 0.0F), near);
        highest = std::max(highest, ranks_[i]);
    }
    return highest;
}

// As many of the units as there is room for.
void FieldSampler::choose_units(std::size_t room) noexcept {
    const std::size_t n = leaves_.size();
    RankCut cut({ranks_.data(), n}, room);
    std::size_t n_kept = 0;
    for (std::size_t i = 0; i < n; ++i) {
        if (cut.takes(ranks_[i])) {
            leaves_.put(n_kept++, leaves_.begin()[i]);
        }
    }
    leaves_.shorten(n_kept);
}

// F of each sample of the units chosen.
void FieldSampler::see_units(std::size_t thinning, const FieldPlace& place) noexcept {
    seen_samples_.clear();
    for (const std::int32_t unit : leaves_) {
        kernels_->sample(bounds_.view, place,
                         shell_->points(thinning, static_cast<std::size_t>(unit)), kLeafPoints,
                         seen_samples_.add_unit(), nullptr);
    }
    touch_.n_leaves += static_cast<std::int64_t>(leaves_.size());
}

// The least thinning whose parts there is room for: those that have a sample that touches, as many more, and a rim round them, for
// what touches beyond is missed. None: the units' own.
FieldSampler::Finer FieldSampler::choose_finer(std::size_t thinning) noexcept {
    constexpr double kRim = 4.0;  // times the root of the samples that touch: what surrounds a disc
    const std::size_t room = find_room(1.0);
    for (std::size_t finer = 0; finer < thinning; ++finer) {
        seen_samples_.split(std::size_t{1} << (thinning - finer));
        const auto n_seen = static_cast<double>(seen_samples_.count_touching());
        const auto n_wanted =
            static_cast<std::size_t>(static_cast<double>(seen_samples_.n_parts_a_sample()) *
                                     (2.0 * n_seen + kRim * std::sqrt(n_seen)));
        if (n_wanted + (finer == 0 ? last_touched_.size() : 0) < room) {
            return {finer, n_wanted};
        }
    }
    return {thinning, 0};
}

// Of the units' parts, those that touch by their samples first, then those that are nearest to it: as many as are wanted to
// `parts_`, and what more there may be time for to `more_parts_`.
void FieldSampler::list_parts(std::size_t thinning, const Finer& finer) noexcept {
    const std::vector<float>& until = free_until(finer.thinning);
    const std::size_t n_parts = std::size_t{1} << (thinning - finer.thinning);
    const float near = std::max(-deepest_steps_, kLeastNear_voxels / bounds_.voxels_per_step);
    // Those that are not known to be free by their own points.
    const auto visit = [&](auto&& use) {
        for (std::size_t i = 0; i < leaves_.size(); ++i) {
            const std::size_t first = static_cast<std::size_t>(leaves_.begin()[i]) * n_parts;
            const std::size_t end = std::min(first + n_parts, shell_->n_leaves(finer.thinning));
            for (std::size_t part = first; part < end; ++part) {
                if (until[part] <= now_) {
                    use(part, seen_samples_.least(i, part - first));
                }
            }
        }
    };
    std::size_t n = 0;
    visit([&](std::size_t, float F) {
        ranks_[n++] = F < 0.0F ? RankCut::kFirst : rank_free(F, near);
    });
    RankCut wanted({ranks_.data(), n}, finer.n_wanted);
    RankCut more({ranks_.data(), n}, std::max(finer.n_wanted, find_room(1.0)));
    n = 0;
    parts_.clear();
    more_parts_.clear();
    visit([&](std::size_t part, float) {
        const float rank = ranks_[n++];
        const bool is_wanted = wanted.takes(rank);
        if (more.takes(rank)) {
            (is_wanted ? parts_ : more_parts_).add(static_cast<std::int32_t>(part));
        }
    });
}

// Nodes with a leaf that is not known to be free and is none of `leaves_`.
void FieldSampler::leave_out_others(std::size_t level) noexcept {
    const std::vector<float>& until = levels_.front().free_until;
    const std::int32_t* looked = leaves_.begin();
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        const std::size_t first = static_cast<std::size_t>(nodes_.begin()[i]) << (3 * level);
        const std::size_t end =
            std::min(first + (std::size_t{1} << (3 * level)), shell_->n_leaves());
        for (std::size_t leaf = first; leaf < end; ++leaf) {
            const auto node = static_cast<std::int32_t>(leaf);
            looked = std::find_if(looked, leaves_.end(),
                                  [node](std::int32_t other) { return other >= node; });
            const bool was_looked_at = looked != leaves_.end() && *looked == node;
            if (!was_looked_at && until[leaf] <= now_) {
                leave_out(level, i);
                break;
            }
        }
    }
}

void FieldSampler::leave_out_all(std::size_t level) noexcept {
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        leave_out(level, i);
    }
}

// Whether there was time for all that are wanted.
bool FieldSampler::take_parts(std::size_t thinning, const FieldPlace& place,
                              const Pose& X_OT) noexcept {
    if (thinning == 0) {
        // What touched in the last step as well, whether or not samples tell of it.
        leaves_.unite(parts_, last_touched_);
        parts_.copy(leaves_);
        leaves_.subtract(more_parts_, parts_);
        more_parts_.copy(leaves_);
    }
    const std::size_t n = take_in_time(thinning, {parts_.begin(), parts_.size()}, place, X_OT);
    const bool is_whole = n == parts_.size();
    if (is_whole) {
        const std::span<const std::int32_t> more(more_parts_.begin(), more_parts_.size());
        more_parts_.shorten(take_in_time(thinning, more, place, X_OT));
    }
    empty_lanes(X_OT);
    was_cut_short_ = false;
    return is_whole;
}

bool FieldSampler::look_closer(std::size_t thinning, const FieldPlace& place,
                               const Pose& X_OT) noexcept {
    constexpr std::size_t kUnits = 4;  // for one that touches
    constexpr double kSee = 0.5;       // of the time
    if (rank_units(thinning) < rank_free(kLeastNear_voxels, kLeastNear_voxels)) {
        return false;
    }
    choose_units(std::min(kUnits * (touched_.size() + 2), find_room(kSee)));
    see_units(thinning, place);
    const Finer finer = choose_finer(thinning);
    const bool is_whole = finer.thinning == 0;
    const bool is_enough =
        is_whole || (sums_.n_touching << (thinning - finer.thinning)) >= kEnoughTouch;
    if (finer.thinning == thinning || !is_enough) {
        return false;
    }
    list_parts(thinning, finer);
    const FirstLook first{sums_, spread_, deepest_steps_, touched_.size()};
    sums_ = {};
    spread_ = {};
    deepest_steps_ = 0.0F;
    touch_.weight = std::int64_t{1} << finer.thinning;
    const auto weight = static_cast<double>(touch_.weight);
    const double first_weight = std::ldexp(1.0, static_cast<int>(thinning));
    if (take_parts(finer.thinning, place, X_OT)) {
        touched_.drop_first(first.n_touched);
        moved_m_ = compute_length(Vector3(first_weight * first.sums.force - weight * sums_.force));
        moved_m2_ =
            compute_length(Vector3(first_weight * first.sums.torque - weight * sums_.torque));
        return is_whole;
    }
    // Where the clock cuts this short, what was seen first stands.
    sums_ = first.sums;
    spread_ = first.spread;
    deepest_steps_ = first.deepest_steps;
    touched_.shorten(first.n_touched);
    touch_.weight = std::int64_t{1} << thinning;
    return false;
}

bool FieldSampler::take_samples(std::size_t level, const FieldPlace& place,
                                const Pose& X_OT) noexcept {
    constexpr double kFirstLook = 0.5;  // of the time; the rest looks closer where that touched
    const std::size_t first_room = find_room(kFirstLook);
    std::size_t thinning = level == 0 ? 0 : 3 * (level - 1);
    list_units(level, thinning);
    while (parts_.size() > first_room && thinning + 1 < shell_->n_thinnings()) {
        list_units(level, ++thinning);
    }
    touch_.weight = std::int64_t{1} << thinning;
    take_in_time(thinning, {parts_.begin(), parts_.size()}, place, X_OT);
    empty_lanes(X_OT);
    missed_points_ =
        static_cast<double>(touch_.weight) * std::sqrt(static_cast<double>(touched_.size()));
    // Where none touches, what touched in the last step is a better guide.
    const bool has_guide = touched_.size() > 0 || last_touched_.size() == 0;
    const bool is_whole = thinning > 0 && has_guide && look_closer(thinning, place, X_OT);
    if (sums_.n_touching < (touch_.weight > 1 ? kEnoughTouch : 1)) {
        missed_points_ = 0.0;
        forget_sums();
        return false;
    }
    if (touch_.weight < std::int64_t{1} << thinning) {
        leaves_.unite(parts_, more_parts_);
        choose(
            static_cast<std::size_t>(std::countr_zero(static_cast<std::uint64_t>(touch_.weight))),
            true, leaves_);
    } else {
        choose(thinning, false, parts_);
    }
    if (is_whole) {
        leave_out_others(level);
        // In the order of leaves, as for all that looks for what touched in the last step.
        touched_.sort();
    } else {
        leave_out_all(level);
    }
    return true;
}

}  // namespace fulcrum
