// The load path of solid_places.h.
#include "haptics/loop/solid_places.h"

namespace fulcrum {
namespace {

constexpr std::uint32_t kNeverHeard = ~std::uint32_t{0};

}  // namespace

SolidPlaces::SolidPlaces(const HapticPlan& plan) : placements_(plan.solids.size(), kNeverHeard) {
    for (const SolidPlan& solid : plan.solids) {
        initial_poses_W_.push_back(solid.initial_pose_W);
        bodies_.push_back(solid.body);
    }
}

}  // namespace fulcrum
