#include "haptics/tool/field_sampling/seen_leaves.h"

#include "haptics/base/prefetch.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr float kFarthest_voxels = 2.0F;          // from where a leaf was looked at
constexpr float kAboveRounding = 1.0F + 1.0e-3F;  // of turns added up in single precision

// Of a leaf's ball, voxels of the field.
std::array<float, 3> find_middle(const FieldLook& look, std::size_t leaf) noexcept {
    const EightBalls& balls = look.pair.shell->level(0)[leaf / ShellTree::kWidth];
    const std::size_t lane = leaf % ShellTree::kWidth;
    const FieldPlace& place = look.place;
    std::array<float, 3> middle{};
    for (std::size_t row = 0; row < 3; ++row) {
        middle[row] = place.A[3 * row] * balls.x[lane] + place.A[3 * row + 1] * balls.y[lane] +
                      place.A[3 * row + 2] * balls.z[lane] + place.b[row];
    }
    return middle;
}

}  // namespace

void SeenLeaves::forget() noexcept {
    for (Seen& seen : seen_) {
        seen.least_voxels = -1.0F;
    }
}

void SeenLeaves::remember(const FieldLook& look, std::size_t leaf, float least_voxels,
                          const MotionClock& clock) noexcept {
    Seen& seen = seen_[leaf];
    seen.least_voxels = std::min(least_voxels, boxes_.most_voxels());
    if (!(seen.least_voxels > kLeastWorth_voxels)) {
        return;
    }
    seen.middle = find_middle(look, leaf);
    seen.turned_rad = static_cast<float>(clock.turned_rad());
    seen.slopes = boxes_.find(seen.middle, seen.radius_voxels + kFarthest_voxels);
}

float SeenLeaves::recall(const FieldLook& look, std::size_t leaf,
                         const MotionClock& clock) const noexcept {
    const Seen& seen = seen_[leaf];
    if (!(seen.least_voxels > kLeastWorth_voxels)) {
        return -1.0F;
    }
    std::array<float, 3> way = find_middle(look, leaf);
    float square = 0.0F;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        way[axis] -= seen.middle[axis];
        square += way[axis] * way[axis];
    }
    // Points go another way than the middle by as much as the leaf has turned.
    const float apart = kAboveRounding * seen.radius_voxels *
                        (static_cast<float>(clock.turned_rad()) - seen.turned_rad);
    if (!(std::sqrt(square) + apart < kFarthest_voxels)) {
        return -1.0F;
    }
    return seen.least_voxels + seen.slopes.find_fall(way) - apart / look.pair.bounds.inverse_slope -
           MotionClock::kMargin_voxels;
}

void SeenLeaves::prefetch_group(std::size_t group) const noexcept {
    prefetch(&seen_[ShellTree::kWidth * group], ShellTree::kWidth * sizeof(Seen));
}

}  // namespace fulcrum
