// The half of field_sampling.h that works within a budget of time.
#include "haptics/math/length.h"
#include "haptics/tool/field_sampling.h"
#include "haptics/tool/rank_cut.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {

namespace {

constexpr std::size_t kBlock = 16;   // leaves between two looks at the clock
constexpr double kForceFirst = 0.5;  // of the time, where derivatives are asked for too

}  // namespace

double FieldSampler::elapsed_us() const noexcept {
    if (settings_.clock == BudgetClock::counted) {
        return static_cast<double>(touch_.n_leaves + slopes_leaves() * touch_.n_sloped) *
                   settings_.leaf_us +
               static_cast<double>(touch_.n_groups) * settings_.group_us;
    }
    return 1.0e6 * (settings_.now_s() - began_s_);
}

double FieldSampler::find_left_us() const noexcept {
    return std::max(share_ * look_us_ - reserve_us_ - held_us_ - elapsed_us(), 0.0);
}

void FieldSampler::begin_step(StepTime* time, int n_near) noexcept {
    step_time_ = time;
    if (time != nullptr) {
        begin_holding();
    }
    n_near_ = std::max(n_near, 1);
    choice_ = {};
    is_known_in_step_ = false;
}

bool FieldSampler::is_known(const Pose& X_WO, const Pose& X_WT) const noexcept {
    // Where something was left out, the next step's time may tell more.
    const bool is_whole = known_.weight == 1 && known_.n_left == 0;
    return is_known_ && (is_whole || is_known_in_step_) && is_same(X_WO, known_WO_) &&
           is_same(X_WT, known_WT_);
}

void FieldSampler::begin_holding() noexcept {
    held_before_ = held_;
    held_ = false;
}

// The tool's force in the object's frame, and its torque about the tool's origin, as the last look told them.
void FieldSampler::hold_last(const Pose& X_WO) noexcept {
    const bool has_more = touch_.n_left > 0 && (was_cut_short_ || touch_.n_leaves == 0) &&
                          touch_.n_touching < known_.n_touching;
    if (!has_more || !is_known_ || held_before_) {
        return;
    }
    held_ = true;
    const Quaternion turned = X_WO.orientation * known_WO_.orientation.conjugate();
    const Wrench taken_W = touch_.wrench_W;
    touch_.wrench_W = {turned * known_.wrench_W.force, turned * known_.wrench_W.torque};
    touch_.n_touching = known_.n_touching;
    touch_.deepest_m = known_.deepest_m;
    touch_.bound_N += compute_length(Vector3(touch_.wrench_W.force - taken_W.force));
    touch_.bound_Nm += compute_length(Vector3(touch_.wrench_W.torque - taken_W.torque));
    touch_.error_N = touch_.bound_N;
    touch_.error_Nm = touch_.bound_Nm;
}

void FieldSampler::begin_look() noexcept {
    if (step_time_ == nullptr) {
        begin_holding();
    }
    look_us_ = shares_time() ? step_time_->find_look_us(n_near_) : settings_.budget_us;
    began_s_ = has_budget() && settings_.clock == BudgetClock::measured ? settings_.now_s() : 0.0;
}

void FieldSampler::end_look() noexcept {
    if (step_time_ != nullptr) {
        step_time_->count(static_cast<std::int64_t>(kLeafPoints) * touch_.n_leaves,
                          settings_.clock == BudgetClock::counted ? elapsed_us() : 0.0);
    }
    if (has_budget() && !shares_time()) {
        learn_reserve();
    }
}

void FieldSampler::learn(double& cost_us, double took_us, std::size_t n) const noexcept {
    if (settings_.clock == BudgetClock::counted || n == 0) {
        return;
    }
    // Quickly up, slowly down, and a part more: what is thought too cheap misses deadlines. One step that was interrupted tells
    // little, and so do few.
    constexpr double kMore = 1.25;
    constexpr double kMostAtOnce = 2.0;
    const double seen_us =
        std::min(kMore * took_us / static_cast<double>(n), kMostAtOnce * cost_us);
    const double tells = std::min(static_cast<double>(n) / static_cast<double>(kBlock), 1.0);
    const double share = tells * (seen_us > cost_us ? 0.2 : 0.1);
    cost_us = std::clamp(cost_us + share * (seen_us - cost_us), 0.01, 10.0);
}

// Up by what was too much at once, down slowly: a deadline that was missed once is not missed again by as much.
void FieldSampler::learn_reserve() noexcept {
    if (settings_.clock == BudgetClock::counted) {
        return;
    }
    constexpr double kFirst = 0.05;  // of the budget, as all below
    constexpr double kMost = 0.25;
    constexpr double kUp = 0.01;
    constexpr double kDown = kUp / 2000.0;
    const double late_us = elapsed_us() - settings_.budget_us;
    // A step that lost the processor tells nothing of its own work.
    const double more_us =
        late_us > 0.0 ? std::min(late_us, kFirst * settings_.budget_us) + kUp * settings_.budget_us
                      : -kDown * settings_.budget_us;
    reserve_us_ = std::clamp(reserve_us_ + more_us, kFirst * settings_.budget_us,
                             kMost * settings_.budget_us);
}

std::size_t FieldSampler::find_room(double share) const noexcept {
    constexpr double kRounding = 1.0e-9;  // a leaf that fits exactly does
    return static_cast<std::size_t>(share * find_left_us() / leaf_us_ + kRounding);
}

double FieldSampler::find_lap_us(double before_us, double expected_us) noexcept {
    constexpr double kUnlikely = 10.0;
    const double lap_us = elapsed_us() - before_us;
    if (lap_us > look_us_ && lap_us > kUnlikely * expected_us) {
        // Something else had the processor. The step is late whatever it does: what it had planned is done all the same.
        began_s_ += 1.0e-6 * lap_us;
    }
    return lap_us;
}

std::size_t FieldSampler::search_in_time(const FieldPlace& place) noexcept {
    begin_at_top();
    for (std::size_t level = levels_.size() - 1;; --level) {
        const double before_us = elapsed_us();
        const std::size_t n_groups = levels_[level].groups.size();
        search_level(level, place, true, 0.0F);
        const double expected_us = group_us_ * static_cast<double>(n_groups);
        learn(group_us_, find_lap_us(before_us, expected_us), n_groups);
        // Going down must leave the time to take each node as one leaf, should its parts be too many.
        const double down_us = static_cast<double>(nodes_.size()) * (group_us_ + leaf_us_);
        if (level == 0 || down_us > find_left_us()) {
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
    double took_us = 0.0;
    std::size_t n = 0;
    while (n < leaves.size()) {
        const std::size_t n_next = std::min({kBlock, leaves.size() - n, find_room(1.0)});
        if (n_next == 0) {
            break;
        }
        const double before_us = elapsed_us();
        take(thinning, leaves.subspan(n, n_next), place, X_OT);
        took_us += find_lap_us(before_us, leaf_us_ * static_cast<double>(n_next));
        n += n_next;
    }
    learn(leaf_us_, took_us, n);
    if (n == 0 && !leaves.empty() && find_left_us() > 0.0) {
        // What is thought too dear for a single one is not seen again: less is thought of it.
        learn(leaf_us_, 0.0, kBlock);
    }
    was_cut_short_ = was_cut_short_ || n < leaves.size();
    return n;
}

double FieldSampler::bound_depth_m(std::size_t level, std::size_t node,
                                   float depth_voxels) const noexcept {
    // Beyond 3/4 of the band D follows the depth between the bricks' centres, which is off by at most 4 sqrt(3) voxels.
    constexpr double kBetween_voxels = 8.0 * 1.7321;
    const double slope = field_->slope_bound();
    const double deep_voxels =
        DistanceField::kDeepFrom * static_cast<double>(bounds_.view.band_voxels);
    const auto lane = node % ShellTree::kWidth;
    double depth = slope * static_cast<double>(depth_voxels);
    if (depth > deep_voxels) {
        // What lies round a place that is deeper still may be as deep as any.
        const float radius = shell_->level(level)[node / ShellTree::kWidth].radius[lane];
        const double middle =
            depth - slope * static_cast<double>(bounds_.voxels_per_metre * radius);
        const double more = depth + static_cast<double>(bounds_.error) + kBetween_voxels;
        depth = middle < deep_voxels ? std::min(more, deepest_voxels_) : deepest_voxels_;
    }
    return std::max(depth, 0.0) * field_->frame().voxel_m;
}

void FieldSampler::leave_out(std::size_t level, std::size_t i) noexcept {
    const auto node = static_cast<std::size_t>(nodes_.begin()[i]);
    left_out_m_ +=
        static_cast<double>(kLeafPoints << (3 * level)) * bound_depth_m(level, node, depths_[i]);
    ++touch_.n_left;
}

void FieldSampler::forget_sums() noexcept {
    sums_ = {};
    spread_ = {};
    deepest_steps_ = 0.0F;
    touch_.weight = 1;
    touched_.clear();
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
        const float rank = std::clamp(depths_[i] / (radius + 0.01F), 0.0F, RankCut::kFirst);
        ranks_[i] = touched_last ? RankCut::kFirst : rank;
    }
}

void FieldSampler::choose_deepest(std::size_t level, std::size_t room) noexcept {
    rank_nodes(level);
    RankCut cut({ranks_.data(), nodes_.size()}, room);
    std::size_t n = 0;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        if (cut.takes(ranks_[i])) {
            depths_[n] = depths_[i];
            nodes_.put(n++, nodes_.begin()[i]);
        } else {
            leave_out(level, i);
        }
    }
    nodes_.shorten(n);
}

void FieldSampler::take_leaves(const FieldPlace& place, const Pose& X_OT) noexcept {
    const std::size_t n = take_in_time(0, {nodes_.begin(), nodes_.size()}, place, X_OT);
    for (std::size_t i = n; i < nodes_.size(); ++i) {
        leave_out(0, i);
    }
    remember_groups();
}

void FieldSampler::take_deepest(std::size_t level, const FieldPlace& place,
                                const Pose& X_OT) noexcept {
    for (; level > 0; --level) {
        // Of what is opened at least a leaf must fit.
        choose_deepest(level, static_cast<std::size_t>(find_left_us() / (group_us_ + leaf_us_)));
        levels_[level - 1].groups.copy(nodes_);
        search_level(level - 1, place, true, 0.0F);
    }
    choose_deepest(0, find_room(1.0));
    choose(0, true, nodes_);
    take_leaves(place, X_OT);
}

void FieldSampler::choose(std::size_t thinning, bool is_listed, const Nodes& units) noexcept {
    if (shares_time()) {
        choice_ = {true, is_listed, thinning, missed_points_, moved_m_, moved_m2_};
        chosen_.copy(units);
    }
}

// What was chosen has its time before the search goes down; what the search finds tells what is left out.
void FieldSampler::revisit(const FieldPlace& place, const Pose& X_OT) noexcept {
    const std::size_t thinning = choice_.thinning;
    held_us_ = leaf_us_ * static_cast<double>(chosen_.size());
    const std::size_t level = search_in_time(place);
    held_us_ = 0.0;
    if (choice_.is_listed) {
        const std::vector<float>& until = free_until(thinning);
        parts_.clear();
        for (const std::int32_t unit : chosen_) {
            if (until[static_cast<std::size_t>(unit)] <= now_) {
                parts_.add(unit);
            }
        }
    } else {
        list_units(level, thinning);
    }
    touch_.weight = std::int64_t{1} << thinning;
    take_in_time(thinning, {parts_.begin(), parts_.size()}, place, X_OT);
    missed_points_ = choice_.missed_points;
    moved_m_ = choice_.moved_m;
    moved_m2_ = choice_.moved_m2;
    if (choice_.is_listed && thinning == 0 && !was_cut_short_) {
        leaves_.copy(chosen_);
        leave_out_others(level);
    } else {
        leave_out_all(level);
    }
}

void FieldSampler::step_within_budget(const FieldPlace& place, const Pose& X_OT) noexcept {
    share_ = slopes_O_ != nullptr ? kForceFirst : 1.0;
    if (choice_.is_made) {
        revisit(place, X_OT);
    } else {
        const std::size_t level = search_in_time(place);
        if (level == 0 && nodes_.size() <= find_room(1.0)) {
            take_leaves(place, X_OT);
        } else if (!take_samples(level, place, X_OT)) {
            take_deepest(level, place, X_OT);
        }
    }
    last_touched_.clear();
    if (touch_.weight == 1) {
        last_touched_.copy(touched_);
    }
    share_ = 1.0;
}

std::size_t FieldSampler::find_slopes_stride() const noexcept {
    if (settings_.budget_us == 0.0) {
        return 1;
    }
    const auto room =
        std::max<std::size_t>(static_cast<std::size_t>(find_left_us() / slopes_us_), 1);
    return std::max<std::size_t>((touched_.size() + room - 1) / room, 1);
}

}  // namespace fulcrum
