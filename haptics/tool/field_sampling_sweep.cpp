// The sweep of field_sampling.h: how far a motion may go.
//
// With F_i(t) of point i on its way, voxels, and its limit
//   l_i = min(l, F_i(0) - slack),   l = a L / 2 - deepest        a the least advance, L the field's slope bound
// the motion goes on from t by min (F_i - l_i) / L, which no point outruns, or by a where that is less: sliding along a surface would
// take for ever otherwise. Samples a apart see every way into the surface but the last a L / 2, which l makes up for. Deeper than 3/4 of
// the band F is told by the depth, -D, which goes on where F ends.
#include "haptics/math/length.h"
#include "haptics/tool/field_sampling.h"
#include "haptics/tool/tool_motion.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fulcrum {

namespace {

constexpr double kLeastAdvance_voxels = 0.1;  // a
constexpr double kClosest_voxels = 0.02;      // how well the end is found
// Points that held the tool may be this much deeper at the end, for rounding: single precision places at both ends.
constexpr float kSlack_voxels = 5.0e-4F;
// That far below the limit a point has no such slack any more, so that many motions do not add up.
constexpr float kDeepestHeld_voxels = 0.05F;
constexpr int kMostHalvings = 40;  // a million voxels are 26

}  // namespace

// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): an aggregate that is given all at once
struct FieldSampler::Sweep {
    Pose from_OT, to_OT;
    FieldPlace start;
    double way_voxels;  // of the fastest point
    float limit_voxels;
};

// In place of what F ends at, -D; steps.
void FieldSampler::deepen(const ShellPoints& points, const Pose& X_OT,
                          std::span<float> values) const noexcept {
    constexpr double kFrom = -DistanceField::kDeepFrom * DistanceField::kLargestValue;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (static_cast<double>(values[i]) < kFrom) {
            const Vector3 p_T(points.x[i], points.y[i], points.z[i]);
            values[i] =
                static_cast<float>(-field_->sample_depth(X_OT * p_T).depth_m / field_->step_m());
        }
    }
}

float FieldSampler::find_leaf_margin(const Sweep& sweep, const Pose& X_OT, const FieldPlace& place,
                                     std::size_t leaf, float slack_voxels) noexcept {
    const ShellPoints points = shell_->points(0, leaf);
    const std::size_t n = shell_->count_in(0, leaf);
    alignas(64) std::array<float, kLeafPoints> now{};
    kernels_->sample(bounds_.view, place, points, kLeafPoints, now.data(), nullptr);
    const float limit = sweep.limit_voxels / bounds_.voxels_per_step;
    const float least =
        *std::min_element(now.begin(), now.begin() + static_cast<std::ptrdiff_t>(n));
    float margin = least - limit;
    if (margin < 0.0F) {
        // Some may have been there at the start.
        alignas(64) std::array<float, kLeafPoints> before{};
        kernels_->sample(bounds_.view, sweep.start, points, kLeafPoints, before.data(), nullptr);
        deepen(points, X_OT, {now.data(), n});
        deepen(points, sweep.from_OT, {before.data(), n});
        const float floor = limit - kDeepestHeld_voxels / bounds_.voxels_per_step;
        margin = HUGE_VALF;
        for (std::size_t i = 0; i < n; ++i) {
            const float slack = before[i] > floor ? slack_voxels / bounds_.voxels_per_step : 0.0F;
            margin = std::min(margin, now[i] - std::min(limit, before[i] - slack));
        }
    }
    return margin * bounds_.voxels_per_step * bounds_.inverse_slope;
}

double FieldSampler::find_margin(const Sweep& sweep, double share, float slack_voxels) noexcept {
    constexpr float kLookCloser = 1.0F;  // voxels; balls with less slack are opened
    const Pose X_OT = compute_between(sweep.from_OT, sweep.to_OT, share);
    const FieldPlace place(*field_, X_OT);
    const std::int64_t n_groups = touch_.n_groups;
    float least = HUGE_VALF;
    begin_at_top();
    for (std::size_t level = levels_.size() - 1;; --level) {
        least = std::min(least, search_level(level, place, false, kLookCloser));
        if (level == 0) {
            break;
        }
        levels_[level - 1].groups.copy(nodes_);
    }
    // Balls tell how far F is above 0.
    least -= std::max(sweep.limit_voxels, 0.0F);
    for (const std::int32_t node : nodes_) {
        least = std::min(least, find_leaf_margin(sweep, X_OT, place, static_cast<std::size_t>(node),
                                                 slack_voxels));
    }
    count_sweep(n_groups);
    return static_cast<double>(least);
}

// Leaves that touch are looked at twice.
void FieldSampler::count_sweep(std::int64_t n_groups_before) noexcept {
    if (step_time_ == nullptr) {
        return;
    }
    const auto n_leaves = 2 * static_cast<std::int64_t>(nodes_.size());
    const auto n_groups = touch_.n_groups - n_groups_before;
    const bool counts = settings_.clock == BudgetClock::counted;
    step_time_->count(static_cast<std::int64_t>(kLeafPoints) * n_leaves,
                      counts ? static_cast<double>(n_leaves) * settings_.leaf_us +
                                   static_cast<double>(n_groups) * settings_.group_us
                             : 0.0);
}

// Between a share that is free and one that is not; without slack, which would let a tool creep in with each call.
double FieldSampler::find_end(const Sweep& sweep, double free, double not_free) noexcept {
    for (int i = 0; i < kMostHalvings && has_time_to_sweep() &&
                    (not_free - free) * sweep.way_voxels > kClosest_voxels;
         ++i) {
        const double middle = 0.5 * (free + not_free);
        (find_margin(sweep, middle, 0.0F) >= 0.0 ? free : not_free) = middle;
    }
    return free;
}

double FieldSampler::find_first_touch(const Pose& from_OT, const Pose& to_OT,
                                      double deepest_m) noexcept {
    if (!is_within_reach(from_OT) || !is_within_reach(to_OT)) {
        return 0.0;
    }
    const double voxel_m = field_->frame().voxel_m;
    const double deepest_voxels =
        deepest_m > 0.0 ? std::min(deepest_m, DistanceField::kDeepFrom * field_->band_m()) / voxel_m
                        : 0.0;
    // At an even rate no point is faster than the origin and the farthest point round it together.
    const double angle = from_OT.orientation.angularDistance(to_OT.orientation);
    const Vector3 shift = to_OT.position - from_OT.position;
    const double limit = 0.5 * kLeastAdvance_voxels * field_->slope_bound() - deepest_voxels;
    const Sweep sweep{from_OT, to_OT, FieldPlace(*field_, from_OT),
                      (compute_length(shift) + angle * shell_->reach_m()) / voxel_m,
                      static_cast<float>(limit)};
    double free = 0.0;
    double share = 0.0;
    for (int i = 0; i < kMaxAdvances; ++i) {
        const double margin = find_margin(sweep, share, kSlack_voxels);
        if (margin < 0.0) {
            return find_end(sweep, free, share);
        }
        free = share;
        if (share >= 1.0 || margin >= (1.0 - share) * sweep.way_voxels) {
            return 1.0;
        }
        share = std::min(1.0, share + std::max(margin, kLeastAdvance_voxels) / sweep.way_voxels);
        if (!has_time_to_sweep()) {
            return share;
        }
    }
    return free;
}

}  // namespace fulcrum
