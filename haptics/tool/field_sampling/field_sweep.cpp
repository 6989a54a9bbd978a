#include "haptics/tool/field_sampling/field_sweep.h"

#include "haptics/math/length.h"
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

FieldSweep::FieldSweep(const SampledPair& pair, const Pose& from_OT, const Pose& to_OT,
                       double deepest_m) noexcept
    : start_(pair, from_OT), to_OT_(to_OT) {
    const DistanceField& field = *pair.field;
    const double voxel_m = field.frame().voxel_m;
    const double deepest_voxels =
        deepest_m > 0.0 ? std::min(deepest_m, DistanceField::kDeepFrom * field.band_m()) / voxel_m
                        : 0.0;
    // At an even rate no point is faster than the origin and the farthest point round it together.
    const double angle = from_OT.orientation.angularDistance(to_OT.orientation);
    const Vector3 shift = to_OT.position - from_OT.position;
    way_voxels_ = (compute_length(shift) + angle * pair.shell->reach_m()) / voxel_m;
    limit_voxels_ =
        static_cast<float>(0.5 * kLeastAdvance_voxels * field.slope_bound() - deepest_voxels);
}

// In place of what F ends at, -D; steps.
void FieldSweep::deepen(const ShellPoints& points, const Pose& X_OT,
                        std::span<float> values) const noexcept {
    constexpr double kFrom = -DistanceField::kDeepFrom * DistanceField::kLargestValue;
    const DistanceField& field = *start_.pair.field;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (static_cast<double>(values[i]) < kFrom) {
            const Vector3 p_T(points.x[i], points.y[i], points.z[i]);
            values[i] =
                static_cast<float>(-field.sample_depth(X_OT * p_T).depth_m / field.step_m());
        }
    }
}

float FieldSweep::find_leaf_margin(const FieldLook& look, std::size_t leaf,
                                   float slack_voxels) const noexcept {
    const SampledPair& pair = look.pair;
    const SlackBounds& bounds = pair.bounds;
    const ShellPoints points = pair.shell->points(0, leaf);
    const std::size_t n = pair.shell->count_in(0, leaf);
    alignas(64) std::array<float, kLeafPoints> now{};
    pair.kernels->sample(bounds.view, look.place, points, kLeafPoints, now.data(), nullptr);
    const float limit = limit_voxels_ / bounds.voxels_per_step;
    const float least =
        *std::min_element(now.begin(), now.begin() + static_cast<std::ptrdiff_t>(n));
    float margin = least - limit;
    if (margin < 0.0F) {
        // Some may have been there at the start.
        alignas(64) std::array<float, kLeafPoints> before{};
        pair.kernels->sample(bounds.view, start_.place, points, kLeafPoints, before.data(),
                             nullptr);
        deepen(points, look.X_OT, {now.data(), n});
        deepen(points, start_.X_OT, {before.data(), n});
        const float floor = limit - kDeepestHeld_voxels / bounds.voxels_per_step;
        margin = HUGE_VALF;
        for (std::size_t i = 0; i < n; ++i) {
            const float slack = before[i] > floor ? slack_voxels / bounds.voxels_per_step : 0.0F;
            margin = std::min(margin, now[i] - std::min(limit, before[i] - slack));
        }
    }
    return margin * bounds.voxels_per_step * bounds.inverse_slope;
}

double FieldSweep::find_margin(double share, float slack_voxels, ShellSearch& search,
                               LookTime& time) const noexcept {
    constexpr float kLookCloser = 1.0F;  // voxels; balls with less slack are opened
    const FieldLook look(start_.pair, compute_between(start_.X_OT, to_OT_, share));
    LookWork work;
    float least = search.search_anew(look, kLookCloser, work);
    // Balls tell how far F is above 0.
    least -= std::max(limit_voxels_, 0.0F);
    for (const std::int32_t leaf : search.nodes()) {
        least =
            std::min(least, find_leaf_margin(look, static_cast<std::size_t>(leaf), slack_voxels));
    }
    // Leaves that touch are looked at twice.
    work.n_leaves = 2 * static_cast<std::int64_t>(search.nodes().size());
    time.count(work);
    return static_cast<double>(least);
}

// Between a share that is free and one that is not; without slack, which would let a tool creep in with each call.
double FieldSweep::find_end(double free, double not_free, ShellSearch& search,
                            LookTime& time) const noexcept {
    for (int i = 0; i < kMostHalvings && time.has_time_to_sweep() &&
                    (not_free - free) * way_voxels_ > kClosest_voxels;
         ++i) {
        const double middle = 0.5 * (free + not_free);
        (find_margin(middle, 0.0F, search, time) >= 0.0 ? free : not_free) = middle;
    }
    return free;
}

double FieldSweep::find_first_touch(ShellSearch& search, LookTime& time) const noexcept {
    double free = 0.0;
    double share = 0.0;
    for (int i = 0; i < kMaxAdvances; ++i) {
        const double margin = find_margin(share, kSlack_voxels, search, time);
        if (margin < 0.0) {
            return find_end(free, share, search, time);
        }
        free = share;
        if (share >= 1.0 || margin >= (1.0 - share) * way_voxels_) {
            return 1.0;
        }
        share = std::min(1.0, share + std::max(margin, kLeastAdvance_voxels) / way_voxels_);
        if (!time.has_time_to_sweep()) {
            return share;
        }
    }
    return free;
}

}  // namespace fulcrum
