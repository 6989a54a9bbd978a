#include "haptics/tool/field_sampling/look_error.h"

#include "haptics/math/length.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {

void LookError::begin() noexcept {
    left_out_m_ = 0.0;
    n_left_ = 0;
    miss_ = {};
    is_cut_short_ = false;
}

double LookError::bound_depth_m(const SampledPair& pair, std::size_t level, std::size_t node,
                                float depth_voxels) const noexcept {
    // Beyond 3/4 of the band D follows the depth between the bricks' centres, which is off by at most 4 sqrt(3) voxels.
    constexpr double kBetween_voxels = 8.0 * 1.7321;
    const SlackBounds& bounds = pair.bounds;
    const double slope = pair.field->slope_bound();
    const double deep_voxels =
        DistanceField::kDeepFrom * static_cast<double>(bounds.view.band_voxels);
    const auto lane = node % ShellTree::kWidth;
    double depth = slope * static_cast<double>(depth_voxels);
    if (depth > deep_voxels) {
        // What lies round a place that is deeper still may be as deep as any.
        const float radius = pair.shell->level(level)[node / ShellTree::kWidth].radius[lane];
        const double middle = depth - slope * static_cast<double>(bounds.voxels_per_metre * radius);
        const double more = depth + static_cast<double>(bounds.error) + kBetween_voxels;
        depth = middle < deep_voxels ? std::min(more, deepest_voxels_) : deepest_voxels_;
    }
    return std::max(depth, 0.0) * pair.field->frame().voxel_m;
}

void LookError::leave_out(const SampledPair& pair, std::size_t level, std::size_t node,
                          float depth_voxels) noexcept {
    left_out_m_ += static_cast<double>(kLeafPoints << (3 * level)) *
                   bound_depth_m(pair, level, node, depth_voxels);
    ++n_left_;
}

void LookError::tell(const SampledPair& pair, const LeafSums& sums,
                     FieldTouch& touch) const noexcept {
    const double k = stiffness_N_per_m_ * static_cast<double>(touch.weight);
    const double reach_m = pair.shell->reach_m();
    touch.n_left = n_left_;
    touch.bound_N = stiffness_N_per_m_ * slope_ * left_out_m_;
    touch.bound_Nm = reach_m * touch.bound_N;
    if (touch.weight > 1) {
        touch.bound_N += compute_length(touch.wrench_W.force);
        touch.bound_Nm += compute_length(touch.wrench_W.torque);
    }
    touch.error_N = touch.bound_N;
    touch.error_Nm = touch.bound_Nm;
    if (miss_.points > 0.0 && !is_cut_short_) {
        constexpr double kFar = 4.0;  // times the spread
        // Where pushes cancel out, as in a wedge, what was missed does not.
        const double missed_N = 0.5 * stiffness_N_per_m_ * slope_ * touch.deepest_m * miss_.points;
        const double far_N = std::max(kFar * k * std::sqrt(sums.spread().force_square) + missed_N,
                                      stiffness_N_per_m_ * miss_.force_m);
        const double far_Nm =
            std::max(kFar * k * std::sqrt(sums.spread().torque_square) + reach_m * missed_N,
                     stiffness_N_per_m_ * miss_.torque_m2);
        touch.error_N = std::min(touch.bound_N, far_N);
        touch.error_Nm = std::min(touch.bound_Nm, far_Nm);
    }
}

}  // namespace fulcrum
