#include "haptics/tool/field_sampling.h"

#include "haptics/base/prefetch.h"
#include "haptics/math/length.h"

#include <algorithm>
#include <bit>
#include <cmath>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace fulcrum {

namespace {

// So far away nothing touches, and the clock of motion would lose count.
constexpr double kFarthest_voxels = 1.0e6;
constexpr double kLongestClock = 4096.0;          // voxels; beyond, single precision is too coarse
constexpr float kFarthestSeen_voxels = 2.0F;      // from where a leaf was looked at
constexpr float kLeastWorth_voxels = 0.02F;       // of F, to be remembered
constexpr float kAboveRounding = 1.0F + 1.0e-3F;  // of turns added up in single precision

// How far any point within `reach_m` of the origin goes at most.
double bound_motion_m(const Pose& from, const Pose& to, double reach_m) noexcept {
    const Quaternion turn = from.orientation.conjugate() * to.orientation;
    return (to.position - from.position).norm() + 2.0 * turn.vec().norm() * reach_m;
}

// Which of eight times are not later than `now`, a bit each.
unsigned find_due(const float* times, float now) noexcept {
#if defined(__SSE2__)
    const __m128 until = _mm_set1_ps(now);
    const int low = _mm_movemask_ps(_mm_cmple_ps(_mm_loadu_ps(times), until));
    const int high = _mm_movemask_ps(_mm_cmple_ps(_mm_loadu_ps(times + 4), until));
    return static_cast<unsigned>(low | high << 4);
#else
    unsigned due = 0;
    for (unsigned i = 0; i < ShellTree::kWidth; ++i) {
        due |= times[i] <= now ? 1U << i : 0U;
    }
    return due;
#endif
}

}  // namespace

void FieldSampler::reset() noexcept {
    for (Level& level : levels_) {
        std::fill(level.free_until.begin(), level.free_until.end(), kAlways);
        std::fill(level.hopeless_until.begin(), level.hopeless_until.end(), kAlways);
    }
    for (std::vector<float>& until : thinned_until_) {
        std::fill(until.begin(), until.end(), kAlways);
    }
    forget_seen();
    last_touched_.clear();
    clock_voxels_ = 0.0;
    now_ = 0.0F;
    has_last_ = false;
    is_known_ = false;
}

bool FieldSampler::is_within_reach(const Pose& X_OT) const noexcept {
    constexpr double kUnit = 1.0e-3;  // of a quaternion's square, for what was turned often
    return is_finite(X_OT) && std::abs(X_OT.orientation.squaredNorm() - 1.0) < kUnit &&
           X_OT.position.cwiseAbs().maxCoeff() < kFarthest_voxels * field_->frame().voxel_m;
}

void FieldSampler::rebase_clock() noexcept {
    const auto rebase = [this](std::vector<float>& times) {
        for (float& time : times) {
            time -= now_;
        }
    };
    for (Level& level : levels_) {
        rebase(level.free_until);
        rebase(level.hopeless_until);
    }
    std::for_each(thinned_until_.begin(), thinned_until_.end(), rebase);
    forget_seen();
    clock_voxels_ = 0.0;
}

void FieldSampler::forget_seen() noexcept {
    for (Seen& seen : seen_) {
        seen.least_voxels = -1.0F;
    }
    turned_rad_ = 0.0;
}

std::array<float, 3> FieldSampler::find_middle(std::size_t leaf,
                                               const FieldPlace& place) const noexcept {
    const EightBalls& balls = shell_->level(0)[leaf / ShellTree::kWidth];
    const std::size_t lane = leaf % ShellTree::kWidth;
    std::array<float, 3> middle{};
    for (std::size_t row = 0; row < 3; ++row) {
        middle[row] = place.A[3 * row] * balls.x[lane] + place.A[3 * row + 1] * balls.y[lane] +
                      place.A[3 * row + 2] * balls.z[lane] + place.b[row];
    }
    return middle;
}

void FieldSampler::remember_leaf(std::size_t leaf, float least_voxels,
                                 const FieldPlace& place) noexcept {
    Seen& seen = seen_[leaf];
    seen.least_voxels = std::min(least_voxels, slope_boxes_.most_voxels());
    if (!(seen.least_voxels > kLeastWorth_voxels)) {
        return;
    }
    seen.middle = find_middle(leaf, place);
    seen.turned_rad = static_cast<float>(turned_rad_);
    seen.slopes = slope_boxes_.find(seen.middle, seen.radius_voxels + kFarthestSeen_voxels);
}

float FieldSampler::recall_leaf(std::size_t leaf, const FieldPlace& place) const noexcept {
    const Seen& seen = seen_[leaf];
    if (!(seen.least_voxels > kLeastWorth_voxels)) {
        return -1.0F;
    }
    std::array<float, 3> way = find_middle(leaf, place);
    float square = 0.0F;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        way[axis] -= seen.middle[axis];
        square += way[axis] * way[axis];
    }
    // Points go another way than the middle by as much as the leaf has turned.
    const float apart =
        kAboveRounding * seen.radius_voxels * (static_cast<float>(turned_rad_) - seen.turned_rad);
    if (!(std::sqrt(square) + apart < kFarthestSeen_voxels)) {
        return -1.0F;
    }
    return seen.least_voxels + seen.slopes.find_fall(way) - apart / bounds_.inverse_slope -
           kFreeMargin_voxels;
}

void FieldSampler::advance_clock(const Pose& X_OT) noexcept {
    constexpr double kAbove = 1.0 + 1.0e-6;  // rounding
    constexpr double kLongestTurn_rad = 100.0;
    if (has_last_) {
        const Quaternion turn = last_OT_.orientation.conjugate() * X_OT.orientation;
        turned_rad_ += 2.0 * kAbove * turn.vec().norm();
        clock_voxels_ +=
            kAbove * bound_motion_m(last_OT_, X_OT, shell_->reach_m()) / field_->frame().voxel_m;
    }
    now_ = std::nextafter(static_cast<float>(clock_voxels_), HUGE_VALF);
    if (clock_voxels_ > kLongestClock || turned_rad_ > kLongestTurn_rad) {
        rebase_clock();
        now_ = 0.0F;
    }
    last_OT_ = X_OT;
    has_last_ = true;
}

float FieldSampler::search_group(std::size_t level, std::size_t group, unsigned due,
                                 const FieldPlace& place, bool remembers, float within) noexcept {
    Level& here = levels_[level];
    const std::size_t first = ShellTree::kWidth * group;
    float* const until = here.free_until.data() + first;
    for (unsigned i = due; level == 0 && remembers && i != 0; i &= i - 1U) {
        const auto at = static_cast<std::size_t>(std::countr_zero(i));
        const float free = recall_leaf(first + at, place);
        if (free > kLeastWorth_voxels) {
            until[at] = now_ + free * bounds_.inverse_slope;
            due &= ~(1U << at);
        }
    }
    if (due == 0) {
        return HUGE_VALF;
    }
    const bool asks = !remembers || here.hopeless_until[group] <= now_;
    std::array<float, ShellTree::kWidth> slacks{};
    if (asks) {
        kernels_->find_slacks(bounds_, place, shell_->level(level)[group], slacks);
        ++touch_.n_groups;
    }
    float least = HUGE_VALF;
    float hopeless = HUGE_VALF;
    for (; due != 0; due &= due - 1U) {
        const auto i = static_cast<std::size_t>(std::countr_zero(due));
        if (asks && remembers) {
            until[i] = std::max(until[i], now_ + slacks[i]);
        }
        if (!asks || slacks[i] <= within) {
            add_node(static_cast<std::int32_t>(first + i),
                     remembers ? now_ - until[i] : -slacks[i]);
        } else {
            least = std::min(least, slacks[i]);
        }
        hopeless = std::min(hopeless, -slacks[i]);
    }
    if (asks && remembers) {
        here.hopeless_until[group] = now_ + std::max(hopeless, 0.0F);
    }
    return least;
}

float FieldSampler::search_level(std::size_t level, const FieldPlace& place, bool remembers,
                                 float within) noexcept {
    nodes_.clear();
    float least = HUGE_VALF;
    constexpr std::ptrdiff_t kAhead = 4;  // groups whose memory is asked for
    constexpr unsigned kAll = (1U << ShellTree::kWidth) - 1U;
    const Nodes& groups = levels_[level].groups;
    for (const std::int32_t& node : groups) {
        const auto group = static_cast<std::size_t>(node);
        if (level == 0 && remembers && groups.end() - &node > kAhead) {
            const auto next = static_cast<std::size_t>((&node)[kAhead]);
            prefetch(&seen_[ShellTree::kWidth * next], ShellTree::kWidth * sizeof(Seen));
            prefetch(&shell_->level(0)[next], sizeof(EightBalls));
        }
        const float* const until = levels_[level].free_until.data() + ShellTree::kWidth * group;
        const unsigned due = remembers ? find_due(until, now_) : kAll;
        if (due != 0) {
            least = std::min(least, search_group(level, group, due, place, remembers, within));
        }
    }
    return least;
}

void FieldSampler::begin_at_top() noexcept {
    levels_.back().groups.clear();
    levels_.back().groups.add(0);
}

void FieldSampler::search(const FieldPlace& place) noexcept {
    const bool remembers = settings_.mode == SamplingMode::coherent;
    begin_at_top();
    for (std::size_t level = levels_.size() - 1;; --level) {
        search_level(level, place, remembers, 0.0F);
        if (level == 0) {
            return;
        }
        levels_[level - 1].groups.copy(nodes_);
    }
}

void FieldSampler::empty_lanes(const Pose& X_OT) noexcept {
    if (touch_.weight > 1) {
        const ContactSpread spread = find_spread(*field_, settings_.along, lanes_);
        spread_.force_square += spread.force_square;
        spread_.torque_square += spread.torque_square;
    }
    add_lanes(*field_, X_OT, settings_.along, lanes_, sums_);
    n_in_lanes_ = 0;
}

void FieldSampler::take(std::size_t thinning, std::span<const std::int32_t> leaves,
                        const FieldPlace& place, const Pose& X_OT) noexcept {
    constexpr std::size_t kMostInLanes = 128;  // leaves whose sums single precision may hold
    constexpr std::size_t kRun = 64;
    const bool remembers = settings_.mode == SamplingMode::coherent;
    std::vector<float>& until = free_until(thinning);
    const float free_per_step = bounds_.voxels_per_step * bounds_.inverse_slope;
    std::array<ShellPoints, kRun> points;
    std::array<float, kRun> least{};
    while (!leaves.empty()) {
        const std::size_t n = std::min(kRun, leaves.size());
        for (std::size_t i = 0; i < n; ++i) {
            points[i] = shell_->points(thinning, static_cast<std::size_t>(leaves[i]));
        }
        const auto last = static_cast<std::size_t>(leaves[n - 1]);
        const LeafRun run{points.data(), n, shell_->count_in(thinning, last),
                          kMostInLanes - n_in_lanes_};
        const std::size_t n_taken =
            kernels_->sum_leaves(bounds_.view, place, run, settings_.along, lanes_, least.data());
        for (std::size_t i = 0; i < n_taken; ++i) {
            deepest_steps_ = std::min(deepest_steps_, least[i]);
            // Only leaves that touch count, so that sums are the same in all modes.
            if (least[i] < 0.0F) {
                ++n_in_lanes_;
                touched_.add(leaves[i]);
            }
            if (remembers) {
                until[static_cast<std::size_t>(leaves[i])] =
                    now_ + least[i] * free_per_step - kFreeMargin_voxels;
                if (thinning == 0) {
                    remember_leaf(static_cast<std::size_t>(leaves[i]),
                                  least[i] * bounds_.voxels_per_step, place);
                }
            }
        }
        touch_.n_leaves += static_cast<std::int64_t>(n_taken);
        if (n_in_lanes_ == kMostInLanes) {
            empty_lanes(X_OT);
        }
        leaves = leaves.subspan(n_taken);
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
    begin_look();
    const Pose X_OT = X_WO.inverse() * X_WT;
    if (is_known(X_WO, X_WT)) {
        touch_ = known_;
        touch_.n_leaves = touch_.n_groups = touch_.n_sloped = 0;
        if (slopes_O_ != nullptr) {
            add_all_slopes(FieldPlace(*field_, X_OT), X_OT);
        }
        end_look();
        return touch_;
    }
    touch_ = {};
    if (!is_finite(X_WO) || !is_finite(X_WT) || !is_within_reach(X_OT)) {
        reset();
        return touch_;
    }
    look(X_WO, X_OT);
    known_WO_ = X_WO;
    known_WT_ = X_WT;
    known_ = touch_;
    is_known_ = true;
    is_known_in_step_ = step_time_ != nullptr;
    end_look();
    return touch_;
}

void FieldSampler::look(const Pose& X_WO, const Pose& X_OT) noexcept {
    const FieldPlace place(*field_, X_OT);
    sums_ = {};
    spread_ = {};
    deepest_steps_ = 0.0F;
    left_out_m_ = 0.0;
    missed_points_ = moved_m_ = moved_m2_ = 0.0;
    was_cut_short_ = false;
    touched_.clear();
    if (settings_.mode == SamplingMode::brute_force) {
        nodes_.clear();
        for (std::size_t leaf = 0; leaf < shell_->n_leaves(); ++leaf) {
            nodes_.add(static_cast<std::int32_t>(leaf));
        }
        take(0, {nodes_.begin(), nodes_.size()}, place, X_OT);
    } else {
        advance_clock(X_OT);
        if (has_budget()) {
            step_within_budget(place, X_OT);
        } else {
            search(place);
            take(0, {nodes_.begin(), nodes_.size()}, place, X_OT);
            if (settings_.mode == SamplingMode::coherent) {
                remember_groups();
            }
        }
    }
    empty_lanes(X_OT);
    if (slopes_O_ != nullptr) {
        add_all_slopes(place, X_OT);
    }
    finish(X_WO);
}

void FieldSampler::finish(const Pose& X_WO) noexcept {
    const double k = settings_.stiffness_N_per_m * static_cast<double>(touch_.weight);
    touch_.wrench_W.force = X_WO.orientation * Vector3(k * sums_.force);
    touch_.wrench_W.torque = X_WO.orientation * Vector3(k * sums_.torque);
    touch_.n_touching = touch_.weight * sums_.n_touching;
    touch_.deepest_m = -field_->step_m() * static_cast<double>(deepest_steps_);
    const double slope = settings_.along == ForceAlong::slopes ? field_->slope_bound() : 1.0;
    touch_.bound_N = settings_.stiffness_N_per_m * slope * left_out_m_;
    touch_.bound_Nm = shell_->reach_m() * touch_.bound_N;
    if (touch_.weight > 1) {
        touch_.bound_N += compute_length(touch_.wrench_W.force);
        touch_.bound_Nm += compute_length(touch_.wrench_W.torque);
    }
    touch_.error_N = touch_.bound_N;
    touch_.error_Nm = touch_.bound_Nm;
    if (missed_points_ > 0.0 && !was_cut_short_) {
        constexpr double kFar = 4.0;  // times the spread
        // Where pushes cancel out, as in a wedge, what was missed does not.
        const double missed_N =
            0.5 * settings_.stiffness_N_per_m * slope * touch_.deepest_m * missed_points_;
        const double far_N = std::max(kFar * k * std::sqrt(spread_.force_square) + missed_N,
                                      settings_.stiffness_N_per_m * moved_m_);
        const double far_Nm =
            std::max(kFar * k * std::sqrt(spread_.torque_square) + shell_->reach_m() * missed_N,
                     settings_.stiffness_N_per_m * moved_m2_);
        touch_.error_N = std::min(touch_.bound_N, far_N);
        touch_.error_Nm = std::min(touch_.bound_Nm, far_Nm);
    }
    hold_last(X_WO);
}

}  // namespace fulcrum
