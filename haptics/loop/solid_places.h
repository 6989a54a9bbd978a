// Where the plan's solids are in this round, and which of them have been put elsewhere at once.
//
// The world tells it, or nobody does: then they are where they began.
//
// Thread: haptic loop. Cost: a comparison a solid. No allocation in `step`.
#pragma once

#include "haptics/loop/haptic_plan.h"

#include <cstdint>
#include <span>
#include <vector>

namespace fulcrum {

class SolidPlaces {
  public:
    explicit SolidPlaces(const HapticPlan& plan);

    /// Takes the world's newest frame over, null where none has come. False where a pose in it is no number: then there are no
    /// poses in this round.
    bool step(const WorldFrame* told) noexcept;
    /// One a solid of the plan; valid as long as the frame.
    [[nodiscard]] std::span<const Pose> poses_W() const noexcept { return poses_W_; }
    /// Bit i: solid i was put elsewhere at once since the last step.
    [[nodiscard]] std::uint32_t put() const noexcept { return put_; }
    /// The scene's index of a solid; kNoBody where the plan has none of that index.
    [[nodiscard]] std::int32_t body_of(std::int32_t solid) const noexcept {
        const auto i = static_cast<std::size_t>(solid);
        return solid >= 0 && i < bodies_.size() ? bodies_[i] : kNoBody;
    }

  private:
    static_assert(kMaxSolids <= 32, "put() has a bit for each");

    std::vector<Pose> initial_poses_W_;
    std::vector<std::int32_t> bodies_;       // of the scene
    std::vector<std::uint32_t> placements_;  // as last heard
    std::span<const Pose> poses_W_{};
    std::uint32_t put_ = 0;
};

}  // namespace fulcrum
