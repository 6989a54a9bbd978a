#include "haptics/dynamics/near_bodies.h"

#include <algorithm>

namespace fulcrum {

NearBodies::NearBodies(const RigidWorldSettings& settings, const RigidScene& scene)
    : gravity_W_(settings.gravity_W),
      broad_phase_(static_cast<int>(scene.bodies.size()), settings.most_pairs),
      boxes_(static_cast<int>(scene.bodies.size())),
      reaches_m_(static_cast<int>(scene.bodies.size())),
      moves_(static_cast<int>(scene.bodies.size())),
      near_(settings.most_pairs) {
    boxes_.set_count(scene.bodies.size());
    reaches_m_.set_count(scene.bodies.size());
    moves_.set_count(scene.bodies.size());
    for (const Joint& joint : scene.joints) {
        const auto [low, high] = std::minmax(joint.body_a, joint.body_b);
        if (!joint.bodies_touch && low >= 0) {
            joined_.push_back({low, high});
        }
    }
    std::sort(joined_.begin(), joined_.end());
}

}  // namespace fulcrum
