#include "haptics/loop/solid_places.h"

#include <algorithm>
#include <utility>

namespace fulcrum {

bool SolidPlaces::step(const WorldFrame* told) noexcept {
    poses_W_ = {};
    put_ = 0;
    const std::size_t n = initial_poses_W_.size();
    const std::span<const Pose> poses_W = told != nullptr
                                              ? std::span<const Pose>(told->solid_poses_W.data(), n)
                                              : std::span<const Pose>(initial_poses_W_);
    if (!std::ranges::all_of(poses_W, [](const Pose& pose) { return is_finite(pose); })) {
        return false;
    }
    poses_W_ = poses_W;
    for (std::size_t i = 0; told != nullptr && i < n; ++i) {
        const std::uint32_t n_placements = told->solid_placements[i];
        if (n_placements != std::exchange(placements_[i], n_placements)) {
            put_ |= 1U << i;
        }
    }
    return true;
}

}  // namespace fulcrum
