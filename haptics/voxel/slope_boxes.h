// How steeply a distance field may fall along a way, told by where the way leads: much less than its slope bound says where the way
// goes along the surface, and not at all where it goes out.
//
// Of each brick a box holds all slopes of its cells, per axis from the least to the largest difference of two corners that follow
// each other. With the box G of all bricks that a straight way p to p + w passes through,
//   F(p + w) >= min(F(p), tau) + min(0, m),   m = min over g in G of g . w,   tau = b - sqrt(3) s
// as long as F is above 0: cells with a corner at the band's end b are left out of the boxes, and where F is below tau there are none.
// Where the membrane over a hole passes through a brick F may fall by anything: no slope can be kept of it, and m is any.
//
// Thread: build at load; questions from any. Cost: build 2 us a brick, 8 bytes a brick of the block; a question 2 ns a brick.
#pragma once

#include "haptics/voxel/distance_field.h"

#include <cstdint>
#include <vector>

namespace fulcrum {

/// Slopes per axis, least and minus largest, in 64ths of a voxel a voxel, rounded outwards.
struct SlopeBox {
    static constexpr float kUnit = 1.0F / 64.0F;
    static constexpr std::int8_t kNone = 127;
    static constexpr std::int8_t kAny = 0;     ///< at the fourth place: F may fall by anything
    static constexpr float kDeepest = 1.0e9F;  ///< voxels, more than any
    std::array<std::int8_t, 4> least{kNone, kNone, kNone, kNone};
    std::array<std::int8_t, 4> minus_most{kNone, kNone, kNone, kNone};

    /// m of a way in voxels, at most 0.
    [[nodiscard]] float find_fall(const std::array<float, 3>& way) const noexcept {
        if (least[3] == kAny) {
            return -kDeepest;
        }
        float fall = 0.0F;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            fall += way[axis] > 0.0F ? way[axis] * static_cast<float>(least[axis])
                                     : -way[axis] * static_cast<float>(minus_most[axis]);
        }
        return fall < 0.0F ? kUnit * fall : 0.0F;
    }
};

class SlopeBoxes {
  public:
    explicit SlopeBoxes(const DistanceField& field);

    /// G of all bricks that a box round a place reaches; both in voxels of the field.
    [[nodiscard]] SlopeBox find(const std::array<float, 3>& centre, float reach) const noexcept;
    /// tau, voxels.
    [[nodiscard]] float most_voxels() const noexcept { return most_voxels_; }
    [[nodiscard]] std::size_t memory_bytes() const noexcept {
        return boxes_.capacity() * sizeof(SlopeBox);
    }

  private:
    std::vector<SlopeBox> boxes_;  // as the field's table
    std::array<std::int32_t, 3> n_bricks_;
    float most_voxels_;
};

}  // namespace fulcrum
