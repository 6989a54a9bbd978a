// Where each leaf of a tool was looked at last, and how the field falls round there: what says that a leaf is still free after it went
// along the surface, where the motion alone no longer does.
//
//   F(p + w) >= F(p) + m(w) - a / (1/L) - margin     m the fall along the way w of the leaf's middle (slope_boxes.h); a what its points go
//                                                    another way than the middle: the leaf's radius times the turns since
// It says so within two voxels of where the leaf was looked at, and keeps only what is free by 0.02 voxels.
//
// Thread: that of the step. Cost: nanoseconds a leaf; 32 bytes a leaf, and 8 a brick of the field's block.
#pragma once

#include "haptics/tool/field_sampling/motion_clock.h"
#include "haptics/tool/field_sampling/sampled_pair.h"
#include "haptics/voxel/slope_boxes.h"

#include <array>
#include <vector>

namespace fulcrum {

class SeenLeaves {
  public:
    static constexpr float kLeastWorth_voxels = 0.02F;  ///< of F, to be remembered

    explicit SeenLeaves(const SampledPair& pair);

    void forget() noexcept;
    /// That a leaf was looked at, its least F being so much.
    void remember(const FieldLook& look, std::size_t leaf, float least_voxels,
                  const MotionClock& clock) noexcept;
    /// How much F is above 0 at least now; voxels, below 0 where that is not known.
    [[nodiscard]] float recall(const FieldLook& look, std::size_t leaf,
                               const MotionClock& clock) const noexcept;
    /// A group of leaves will be asked for soon.
    void prefetch_group(std::size_t group) const noexcept;
    [[nodiscard]] std::size_t memory_bytes() const noexcept {
        return seen_.capacity() * sizeof(Seen) + boxes_.memory_bytes();
    }

  private:
    struct Seen {
        std::array<float, 3> middle{};  // of its ball, voxels of the field
        float least_voxels = -1.0F;     // F; below 0: not seen
        float turned_rad = 0.0F;        // on the clock
        float radius_voxels = 0.0F;
        SlopeBox slopes;
    };

    SlopeBoxes boxes_;
    std::vector<Seen> seen_;
};

}  // namespace fulcrum
