// A mesh made touchable, for tests whose meshes are sound: one that is not ends the test with its sentence.
#pragma once

#include "haptics/collision/collision_mesh.h"
#include "haptics/point/solid_plan.h"

#include <memory>
#include <stdexcept>
#include <vector>

namespace fulcrum {

inline std::shared_ptr<const CollisionMesh> touchable(const Expected<TriangleMesh>& mesh) {
    if (!mesh) {
        throw std::runtime_error(to_sentence(mesh.error()));
    }
    const auto made = CollisionMesh::create(*mesh);
    if (!made) {
        throw std::runtime_error(to_sentence(made.error()));
    }
    return *made;
}

/// The one solid of a scene, body 0.
inline std::vector<SolidPlan> only_solid(std::shared_ptr<const CollisionMesh> mesh,
                                         const Pose& pose_W = {}) {
    return {SolidPlan{.body = 0, .shape = std::move(mesh), .initial_pose_W = pose_W}};
}

}  // namespace fulcrum
