// A body that can be touched, as the plan names it.
#pragma once

#include "haptics/handover/messages.h"
#include "haptics/math/spatial.h"

#include <cstdint>
#include <memory>

namespace fulcrum {

class CollisionMesh;  // haptics/collision/collision_mesh.h

/// A body that can be touched.
struct SolidPlan {
    std::int32_t body = kNoBody;  ///< its index in the scene
    std::shared_ptr<const CollisionMesh> mesh;
    Pose initial_pose_W{};
};

}  // namespace fulcrum
