#include "haptics/tool/field_sampling.h"

#include "haptics/base/prefetch.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace fulcrum {

namespace {

constexpr float kMargin = 2.0e-3F;  // voxels: single precision places and clock
// So far away nothing touches, and the clock of motion would lose count.
constexpr double kFarthest_voxels = 1.0e6;
constexpr double kLongestClock = 4096.0;  // voxels; beyond, single precision is too coarse

// How far any point within `reach_m` of the origin goes at most.
double bound_motion_m(const Pose& from, const Pose& to, double reach_m) noexcept {
    const Quaternion turn = from.orientation.conjugate() * to.orientation;
    return (to.position - from.position).norm() + 2.0 * turn.vec().norm() * reach_m;
}

}  // namespace

void FieldSampler::reset() noexcept {
    for (Level& level : levels_) {
        std::fill(level.free_until.begin(), level.free_until.end(), kAlways);
    }
    clock_voxels_ = 0.0;
    now_ = 0.0F;
    has_last_ = false;
}

void FieldSampler::rebase_clock() noexcept {
    for (Level& level : levels_) {
        for (float& until : level.free_until) {
            until -= now_;
        }
    }
    clock_voxels_ = 0.0;
}

void FieldSampler::advance_clock(const Pose& X_OT) noexcept {
    constexpr double kAboveRounding = 1.0 + 1.0e-6;
    if (has_last_) {
        clock_voxels_ += kAboveRounding * bound_motion_m(last_OT_, X_OT, shell_->reach_m()) /
                         field_->frame().voxel_m;
    }
    now_ = std::nextafter(static_cast<float>(clock_voxels_), HUGE_VALF);
    if (clock_voxels_ > kLongestClock) {
        rebase_clock();
        now_ = 0.0F;
    }
    last_OT_ = X_OT;
    has_last_ = true;
}

float FieldSampler::search_level(std::size_t level, const FieldPlace& place, bool remembers,
                                 float within) noexcept {
    const std::vector<EightBalls>& balls = shell_->level(level);
    Level& here = levels_[level];
    nodes_.clear();
    float least = HUGE_VALF;
    for (const std::int32_t group : here.groups) {
        const auto first = ShellTree::kWidth * static_cast<std::size_t>(group);
        float* const until = here.free_until.data() + first;
        unsigned due = 0;
        for (unsigned i = 0; i < ShellTree::kWidth; ++i) {
            due |= (!remembers || until[i] <= now_ ? 1U : 0U) << i;
        }
        if (due == 0) {
            continue;
        }
        std::array<float, ShellTree::kWidth> slacks{};
        find_slacks(bounds_, place, balls[static_cast<std::size_t>(group)], slacks);
        ++touch_.n_groups;
        for (; due != 0; due &= due - 1U) {
            const auto i = static_cast<std::size_t>(std::countr_zero(due));
            if (slacks[i] <= within) {
                nodes_.add(static_cast<std::int32_t>(first + i));
            } else {
                least = std::min(least, slacks[i]);
            }
            if (remembers) {
                until[i] = now_ + std::max(slacks[i], 0.0F);
            }
        }
    }
    return least;
}

std::size_t FieldSampler::count_units(std::size_t merge) const noexcept {
    std::size_t n = 0;
    std::int32_t last = -1;
    for (const std::int32_t node : nodes_) {
        n += (node >> merge) != last ? 1 : 0;
        last = node >> merge;
    }
    return n;
}

void FieldSampler::begin_at_top() noexcept {
    levels_.back().groups.clear();
    levels_.back().groups.add(0);
}

FieldSampler::Choice FieldSampler::search(const FieldPlace& place) noexcept {
    const bool remembers = settings_.mode == SamplingMode::coherent;
    const bool has_budget = settings_.budget_us > 0.0;
    double left_us = settings_.budget_us;
    std::size_t level = levels_.size() - 1;
    begin_at_top();
    for (;; --level) {
        const auto n_groups = static_cast<double>(levels_[level].groups.size());
        search_level(level, place, remembers, 0.0F);
        left_us -= n_groups * settings_.group_us;
        if (level == 0) {
            break;
        }
        // Going down must leave the time to take each node as one leaf, should its parts be too many.
        const auto n = static_cast<double>(nodes_.size());
        if (has_budget && n * (settings_.group_us + settings_.leaf_us) > left_us) {
            break;
        }
        levels_[level - 1].groups.copy(nodes_);
    }
    Choice choice{level, 0};
    while (has_budget && 3 * level + choice.merge + 1 < shell_->n_thinnings() &&
           static_cast<double>(count_units(choice.merge)) * settings_.leaf_us > left_us) {
        ++choice.merge;
    }
    // The level's nodes are all that there is of their groups: none below was looked at.
    for (std::size_t below = 0; below < level; ++below) {
        levels_[below].groups.clear();
    }
    return choice;
}

void FieldSampler::empty_lanes(const Pose& X_OT) noexcept {
    // The difference of the halves of lanes goes the same way as their sum.
    if (touch_.weight > 1) {
        ContactLanes halves = lanes_;
        for (auto* const components : {&halves.force, &halves.torque}) {
            for (auto& lanes : *components) {
                for (std::size_t i = 1; i < lanes.size(); i += 2) {
                    lanes[i] = -lanes[i];
                }
            }
        }
        add_lanes(*field_, X_OT, settings_.along, halves, half_difference_);
    }
    add_lanes(*field_, X_OT, settings_.along, lanes_, sums_);
    n_in_lanes_ = 0;
}

float FieldSampler::take_leaf(std::size_t thinning, std::size_t leaf, const FieldPlace& place,
                              const Pose& X_OT) noexcept {
    constexpr int kMostInLanes = 128;  // leaves whose sums single precision may hold
    const float least =
        kernels_->sum_leaf(bounds_.view, place, shell_->points(thinning, leaf),
                           shell_->count_in(thinning, leaf), settings_.along, lanes_);
    deepest_steps_ = std::min(deepest_steps_, least);
    ++touch_.n_leaves;
    if (slopes_O_ != nullptr && least < 0.0F) {
        add_slopes(thinning, leaf, place, X_OT);
    }
    // Only leaves that touch count, so that sums are the same in all modes.
    n_in_lanes_ += least < 0.0F ? 1 : 0;
    if (n_in_lanes_ == kMostInLanes) {
        empty_lanes(X_OT);
    }
    return least;
}

void FieldSampler::take_all_leaves(const FieldPlace& place, const Pose& X_OT) noexcept {
    for (std::size_t leaf = 0; leaf < shell_->n_leaves(); ++leaf) {
        take_leaf(0, leaf, place, X_OT);
    }
}

void FieldSampler::take_leaves(const FieldPlace& place, const Pose& X_OT) noexcept {
    const bool remembers = settings_.mode == SamplingMode::coherent;
    const float free_per_step = bounds_.voxels_per_step * bounds_.inverse_slope;
    std::vector<float>& free_until = levels_.front().free_until;
    for (const std::int32_t node : nodes_) {
        const auto leaf = static_cast<std::size_t>(node);
        const float least = take_leaf(0, leaf, place, X_OT);
        if (remembers) {
            free_until[leaf] = now_ + std::max(least * free_per_step - kMargin, 0.0F);
        }
    }
}

void FieldSampler::take_units(const Choice& choice, const FieldPlace& place,
                              const Pose& X_OT) noexcept {
    const std::size_t thinning = 3 * choice.level + choice.merge;
    touch_.weight = std::int64_t{1} << thinning;
    std::int32_t last = -1;
    for (const std::int32_t node : nodes_) {
        const std::int32_t unit = node >> choice.merge;
        if (unit != last) {
            take_leaf(thinning, static_cast<std::size_t>(unit), place, X_OT);
        }
        last = unit;
    }
}

// A group is free until the first of its parts is not; what was looked at in this step knows better than its ball.
void FieldSampler::remember_groups() noexcept {
    for (std::size_t level = 0; level + 1 < levels_.size(); ++level) {
        for (const std::int32_t group : levels_[level].groups) {
            const auto at = static_cast<std::size_t>(group);
            const auto first = levels_[level].free_until.begin() +
                               static_cast<std::ptrdiff_t>(ShellTree::kWidth * at);
            float& until = levels_[level + 1].free_until[at];
            until = std::max(until, *std::min_element(first, first + ShellTree::kWidth));
        }
    }
}

FieldTouch FieldSampler::step(const Pose& X_WO, const Pose& X_WT) noexcept {
    touch_ = {};
    if (!is_finite(X_WO) || !is_finite(X_WT)) {
        reset();
        return touch_;
    }
    const Pose X_OT = X_WO.inverse() * X_WT;
    if (!(X_OT.position.cwiseAbs().maxCoeff() < kFarthest_voxels * field_->frame().voxel_m)) {
        reset();
        return touch_;
    }
    const FieldPlace place(*field_, X_OT);
    sums_ = {};
    half_difference_ = {};
    deepest_steps_ = 0.0F;
    if (settings_.mode == SamplingMode::brute_force) {
        take_all_leaves(place, X_OT);
    } else {
        advance_clock(X_OT);
        const Choice choice = search(place);
        if (choice.level == 0 && choice.merge == 0) {
            take_leaves(place, X_OT);
            if (settings_.mode == SamplingMode::coherent) {
                remember_groups();
            }
        } else {
            take_units(choice, place, X_OT);
        }
    }
    empty_lanes(X_OT);
    const double k = settings_.stiffness_N_per_m * static_cast<double>(touch_.weight);
    touch_.wrench_W.force = X_WO.orientation * Vector3(k * sums_.force);
    touch_.wrench_W.torque = X_WO.orientation * Vector3(k * sums_.torque);
    touch_.n_touching = touch_.weight * sums_.n_touching;
    touch_.deepest_m = -field_->step_m() * static_cast<double>(deepest_steps_);
    touch_.error_N = k * half_difference_.force.norm();
    return touch_;
}

double FieldSampler::bound_clearance_voxels(const Pose& X_OT) noexcept {
    constexpr float kLookCloser = 1.0F;  // voxels; balls with less slack are opened
    const FieldPlace place(*field_, X_OT);
    float least = HUGE_VALF;
    begin_at_top();
    for (std::size_t level = levels_.size() - 1;; --level) {
        least = std::min(least, search_level(level, place, false, kLookCloser));
        if (level == 0) {
            break;
        }
        levels_[level - 1].groups.copy(nodes_);
    }
    ContactLanes unused;
    for (const std::int32_t node : nodes_) {
        const auto leaf = static_cast<std::size_t>(node);
        const float value = kernels_->sum_leaf(bounds_.view, place, shell_->points(0, leaf),
                                               shell_->count_in(0, leaf), settings_.along, unused);
        least = std::min(least, value * bounds_.voxels_per_step * bounds_.inverse_slope - kMargin);
    }
    return static_cast<double>(least);
}

double FieldSampler::find_first_touch(const Pose& from_OT, const Pose& to_OT) noexcept {
    if (!is_finite(from_OT) || !is_finite(to_OT)) {
        return 0.0;
    }
    // At an even rate no point is faster than the origin and the farthest point round it together.
    const double angle = from_OT.orientation.angularDistance(to_OT.orientation);
    const double way_voxels =
        ((to_OT.position - from_OT.position).norm() + angle * shell_->reach_m()) /
        field_->frame().voxel_m;
    double share = 0.0;
    for (int i = 0; i < kMaxAdvances; ++i) {
        const Pose X_OT{from_OT.position + share * (to_OT.position - from_OT.position),
                        from_OT.orientation.slerp(share, to_OT.orientation)};
        const double free_voxels = bound_clearance_voxels(X_OT);
        if (free_voxels <= kNearTouch_voxels) {
            return share;
        }
        if (free_voxels >= (1.0 - share) * way_voxels) {
            return 1.0;
        }
        share += free_voxels / way_voxels;
    }
    return share;
}

}  // namespace fulcrum
