// The half of field_sampling.h that works within a budget of time.
#include "haptics/base/clock.h"
#include "haptics/tool/field_sampling.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fulcrum {

namespace {

constexpr std::size_t kBlock = 16;         // leaves between two looks at the clock
constexpr std::int64_t kEnoughTouch = 64;  // samples that stand for all
constexpr std::size_t kBins = 128;
constexpr float kFirst = 2.0F;  // rank of what touched in the last step

}  // namespace

double FieldSampler::elapsed_us() const noexcept {
    if (settings_.clock == BudgetClock::counted) {
        return static_cast<double>(touch_.n_leaves) * settings_.leaf_us +
               static_cast<double>(touch_.n_groups) * settings_.group_us;
    }
    return 1.0e6 * (monotonic_now_s() - began_s_);
}

void FieldSampler::learn(double& cost_us, double took_us, std::int64_t n) const noexcept {
    if (settings_.clock == BudgetClock::counted || n < static_cast<std::int64_t>(kBlock)) {
        return;
    }
    // Quickly up, slowly down, and a reserve: what is thought too cheap misses deadlines. One step that was interrupted tells little.
    constexpr double kReserve = 1.25;
    constexpr double kMostAtOnce = 2.0;
    const double seen_us =
        std::min(kReserve * took_us / static_cast<double>(n), kMostAtOnce * cost_us);
    const double share = seen_us > cost_us ? 0.2 : 0.1;
    cost_us = std::clamp(cost_us + share * (seen_us - cost_us), 0.01, 10.0);
}

std::size_t FieldSampler::find_room(double share) const noexcept {
    const double left_us = share * (settings_.budget_us - elapsed_us());
    constexpr double kRounding = 1.0e-9;  // a leaf that fits exactly does
    return left_us > 0.0 ? static_cast<std::size_t>(left_us / leaf_us_ + kRounding) : 0;
}

std::size_t FieldSampler::search_in_time(const FieldPlace& place) noexcept {
    begin_at_top();
    for (std::size_t level = levels_.size() - 1;; --level) {
        const double before_us = elapsed_us();
        const std::int64_t n_before = touch_.n_groups;
        search_level(level, place, true, 0.0F);
        learn(group_us_, elapsed_us() - before_us, touch_.n_groups - n_before);
        // Going down must leave the time to take each node as one leaf, should its parts be too many.
        const double down_us = static_cast<double>(nodes_.size()) * (settings_.group_us + leaf_us_);
        if (level == 0 || down_us > settings_.budget_us - elapsed_us()) {
            for (std::size_t below = 0; below < level; ++below) {
                levels_[below].groups.clear();
            }
            return level;
        }
        levels_[level - 1].groups.copy(nodes_);
    }
}

std::size_t FieldSampler::take_in_time(std::size_t thinning, std::span<const std::int32_t> leaves,
                                       const FieldPlace& place, const Pose& X_OT) noexcept {
    const double before_us = elapsed_us();
    std::size_t n = 0;
    while (n < leaves.size()) {
        const std::size_t n_next = std::min({kBlock, leaves.size() - n, find_room(1.0)});
        if (n_next == 0) {
            break;
        }
        take(thinning, leaves.subspan(n, n_next), place, X_OT);
        n += n_next;
    }
    learn(leaf_us_, elapsed_us() - before_us, static_cast<std::int64_t>(n));
    was_cut_short_ = was_cut_short_ || n < leaves.size();
    return n;
}

void FieldSampler::leave_out(std::size_t level, float depth_voxels) noexcept {
    const double deepest_m =
        std::min(field_->band_m(), static_cast<double>(depth_voxels) * field_->slope_bound() *
                                       field_->frame().voxel_m);
    left_out_m_ += static_cast<double>(kLeafPoints << (3 * level)) * std::max(deepest_m, 0.0);
    ++touch_.n_left;
}

void FieldSampler::forget_sums() noexcept {
    sums_ = {};
    spread_ = {};
    deepest_steps_ = 0.0F;
    touch_.weight = 1;
    if (slopes_O_ != nullptr) {
        slopes_O_->setZero();
    }
}

void FieldSampler::list_units(std::size_t merge) noexcept {
    leaves_.clear();
    std::int32_t last = -1;
    for (const std::int32_t node : nodes_) {
        if ((node >> merge) != last) {
            last = node >> merge;
            leaves_.add(last);
        }
    }
}

bool FieldSampler::take_touched(std::size_t thinning, std::size_t finer, const FieldPlace& place,
                                const Pose& X_OT) noexcept {
    const std::size_t n_parts = std::size_t{1} << (thinning - finer);
    leaves_.clear();
    for (const std::int32_t unit : touched_) {
        const std::size_t first = static_cast<std::size_t>(unit) * n_parts;
        const std::size_t end = std::min(first + n_parts, shell_->n_leaves(finer));
        for (std::size_t i = first; i < end; ++i) {
            leaves_.add(static_cast<std::int32_t>(i));
        }
    }
    forget_sums();
    touched_.clear();
    touch_.weight = std::int64_t{1} << finer;
    const std::size_t n = take_in_time(finer, {leaves_.begin(), leaves_.size()}, place, X_OT);
    return n == leaves_.size();
}

void FieldSampler::keep_touched(std::size_t level, std::size_t merge) noexcept {
    std::size_t n = 0;
    const std::int32_t* unit = touched_.begin();
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        const std::int32_t node = nodes_.begin()[i];
        while (unit != touched_.end() && *unit < (node >> merge)) {
            ++unit;
        }
        if (unit != touched_.end() && *unit == (node >> merge)) {
            depths_[n] = depths_[i];
            nodes_.put(n++, node);
        } else {
            leave_out(level, depths_[i]);
        }
    }
    nodes_.shorten(n);
}

bool FieldSampler::take_samples(std::size_t level, const FieldPlace& place,
                                const Pose& X_OT) noexcept {
    constexpr double kFirstLook = 0.6;  // of the time; the rest looks closer where that touched
    const std::size_t first_room = find_room(kFirstLook);
    std::size_t merge = 0;
    list_units(merge);
    while (leaves_.size() > first_room && 3 * level + merge + 1 < shell_->n_thinnings()) {
        list_units(++merge);
    }
    const std::size_t thinning = 3 * level + merge;
    touch_.weight = std::int64_t{1} << thinning;
    touched_.clear();
    take_in_time(thinning, {leaves_.begin(), leaves_.size()}, place, X_OT);
    empty_lanes(X_OT);
    if (touched_.size() == 0) {
        forget_sums();
        return false;
    }
    keep_touched(level, merge);
    const double n_units = static_cast<double>(touched_.size());
    missed_points_ = static_cast<double>(touch_.weight) * std::sqrt(n_units);
    const std::size_t room = find_room(1.0);
    std::size_t finer = thinning;
    while (finer > 0 && touched_.size() << (thinning - finer + 1) <= room) {
        --finer;
    }
    bool is_all = false;
    if (finer < thinning &&
        (finer == 0 || (sums_.n_touching << (thinning - finer)) >= kEnoughTouch)) {
        is_all = take_touched(thinning, finer, place, X_OT) && finer == 0;
        empty_lanes(X_OT);
    }
    if (touch_.weight > 1 && sums_.n_touching < kEnoughTouch) {
        forget_sums();
        touched_.clear();
        return false;
    }
    for (std::size_t i = 0; i < nodes_.size() && !is_all; ++i) {
        leave_out(level, depths_[i]);
    }
    return true;
}

void FieldSampler::rank_nodes(std::size_t level) noexcept {
    const std::vector<EightBalls>& balls = shell_->level(level);
    const std::int32_t* touched = last_touched_.begin();
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        const std::int32_t node = nodes_.begin()[i];
        const auto at = static_cast<std::size_t>(node);
        while (touched != last_touched_.end() && (*touched >> (3 * level)) < node) {
            ++touched;
        }
        const bool touched_last =
            touched != last_touched_.end() && (*touched >> (3 * level)) == node;
        const float radius =
            bounds_.voxels_per_metre * balls[at / ShellTree::kWidth].radius[at % ShellTree::kWidth];
        // Never more than about 2, as a ball round its middle is no deeper than a radius when its points begin to touch.
        ranks_[i] = touched_last ? kFirst : std::min(depths_[i] / (radius + 0.01F), kFirst);
    }
}

float FieldSampler::find_rank_above(std::size_t n) const noexcept {
    constexpr float kBinsARank = static_cast<float>(kBins) / kFirst;
    std::array<std::size_t, kBins> counts{};
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        ++counts[std::min(kBins - 1, static_cast<std::size_t>(ranks_[i] * kBinsARank))];
    }
    std::size_t n_above = 0;
    for (std::size_t bin = kBins; bin-- > 0;) {
        n_above += counts[bin];
        if (n_above > n) {
            return static_cast<float>(bin + 1) / kBinsARank;
        }
    }
    return 0.0F;
}

void FieldSampler::choose_deepest(std::size_t level, std::size_t room) noexcept {
    // All above a rank, and of the others those that come first, while there is room.
    rank_nodes(level);
    const float above = find_rank_above(room);
    const auto n_above = static_cast<std::size_t>(std::count_if(
        ranks_.data(), ranks_.data() + nodes_.size(), [&](float rank) { return rank >= above; }));
    std::size_t n_others = room - std::min(room, n_above);
    leaves_.clear();
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        const bool is_above = ranks_[i] >= above;
        if (!is_above && n_others == 0) {
            leave_out(level, depths_[i]);
            continue;
        }
        n_others -= is_above ? 0 : 1;
        depths_[leaves_.size()] = depths_[i];
        leaves_.add(nodes_.begin()[i]);
    }
}

void FieldSampler::take_deepest(std::size_t level, const FieldPlace& place,
                                const Pose& X_OT) noexcept {
    for (; level > 0; --level) {
        // Of what is opened at least a leaf must fit.
        const double left_us = std::max(settings_.budget_us - elapsed_us(), 0.0);
        choose_deepest(level, static_cast<std::size_t>(left_us / (group_us_ + leaf_us_)));
        levels_[level - 1].groups.copy(leaves_);
        search_level(level - 1, place, true, 0.0F);
    }
    choose_deepest(0, find_room(1.0));
    const std::size_t n = take_in_time(0, {leaves_.begin(), leaves_.size()}, place, X_OT);
    for (std::size_t i = n; i < leaves_.size(); ++i) {
        leave_out(0, depths_[i]);
    }
    remember_groups();
}

void FieldSampler::step_within_budget(const FieldPlace& place, const Pose& X_OT) noexcept {
    const std::size_t level = search_in_time(place);
    if (level == 0 && nodes_.size() <= find_room(1.0)) {
        const std::size_t n = take_in_time(0, {nodes_.begin(), nodes_.size()}, place, X_OT);
        for (std::size_t i = n; i < nodes_.size(); ++i) {
            leave_out(0, depths_[i]);
        }
        remember_groups();
    } else if (!take_samples(level, place, X_OT)) {
        take_deepest(level, place, X_OT);
    }
    last_touched_.clear();
    if (touch_.weight == 1) {
        last_touched_.copy(touched_);
    }
}

}  // namespace fulcrum
