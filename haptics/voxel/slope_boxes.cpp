#include "haptics/voxel/slope_boxes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fulcrum {
namespace {

constexpr std::size_t kSide = 9;  // corners of a brick
constexpr std::array<std::size_t, 3> kStrides{1, kSide, kSide* kSide};

bool is_within_band(std::int16_t value) noexcept {
    return std::abs(int{value}) < DistanceField::kLargestValue;
}

void unite(SlopeBox& box, const SlopeBox& other) noexcept {
    for (std::size_t i = 0; i < box.least.size(); ++i) {
        box.least[i] = std::min(box.least[i], other.least[i]);
        box.minus_most[i] = std::min(box.minus_most[i], other.minus_most[i]);
    }
}

// Along one axis, steps.
void find_range(const DistanceField::Brick& brick, std::size_t stride, int& least, int& most) {
    for (std::size_t i = 0; i < kSide * kSide * kSide; ++i) {
        // The last corner along the axis has no next.
        if (i / stride % kSide == kSide - 1) {
            continue;
        }
        const std::int16_t here = brick.values[i];
        const std::int16_t next = brick.values[i + stride];
        if (is_within_band(here) && is_within_band(next)) {
            least = std::min(least, next - here);
            most = std::max(most, next - here);
        }
    }
}

SlopeBox make_box(const DistanceField::Brick& brick, double voxels_per_step) {
    constexpr double kSteepest = 127.0;  // in units
    SlopeBox box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        int least = 2 * DistanceField::kLargestValue;
        int most = -least;
        find_range(brick, kStrides[axis], least, most);
        if (least <= most) {
            const double units = voxels_per_step / static_cast<double>(SlopeBox::kUnit);
            if (std::max(-least, most) * units > kSteepest) {
                box.least[3] = SlopeBox::kAny;
                return box;
            }
            box.least[axis] = static_cast<std::int8_t>(std::floor(least * units));
            box.minus_most[axis] = static_cast<std::int8_t>(-std::ceil(most * units));
        }
    }
    return box;
}

}  // namespace

SlopeBoxes::SlopeBoxes(const DistanceField& field)
    : boxes_(field.table().size()),
      n_bricks_(field.n_bricks()),
      most_voxels_(
          static_cast<float>(field.band_m() / field.frame().voxel_m - std::numbers::sqrt3)) {
    const double voxels_per_step = field.step_m() / field.frame().voxel_m;
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
        const std::int32_t brick = field.table()[i].brick;
        if (brick != DistanceField::kFree && brick != DistanceField::kInside) {
            boxes_[i] = make_box(field.bricks()[static_cast<std::size_t>(brick)], voxels_per_step);
        }
    }
}

SlopeBox SlopeBoxes::find(const std::array<float, 3>& centre, float reach) const noexcept {
    std::array<std::int32_t, 3> first{};
    std::array<std::int32_t, 3> last{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto end = static_cast<float>(n_bricks_[axis] * kBrickCells - 1);
        const float low = std::clamp(centre[axis] - reach, 0.0F, end);
        const float high = std::clamp(centre[axis] + reach, 0.0F, end);
        first[axis] = static_cast<std::int32_t>(low) / kBrickCells;
        last[axis] = static_cast<std::int32_t>(high) / kBrickCells;
    }
    SlopeBox box;
    for (std::int32_t z = first[2]; z <= last[2]; ++z) {
        for (std::int32_t y = first[1]; y <= last[1]; ++y) {
            const std::int32_t row = (z * n_bricks_[1] + y) * n_bricks_[0];
            for (std::int32_t x = first[0]; x <= last[0]; ++x) {
                unite(box, boxes_[static_cast<std::size_t>(row) + static_cast<std::size_t>(x)]);
            }
        }
    }
    return box;
}

}  // namespace fulcrum
