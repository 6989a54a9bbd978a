// What a world of rigid bodies is made of, and what all stages of its step work on (rigid_world.h).
//
// Thread: that of the step; during the solving of islands each touches what is its own.
#pragma once

#include "haptics/collision/contact_pairs.h"
#include "haptics/dynamics/body_loads.h"
#include "haptics/dynamics/joint.h"
#include "haptics/dynamics/rigid_world_body.h"

#include <cstdint>
#include <vector>

namespace fulcrum {

struct RigidScene {
    std::vector<RigidWorldBody> bodies;
    ContactPairs pairs;
    std::vector<Joint> joints;
    BodyLoads loads;

    [[nodiscard]] RigidWorldBody& body(std::int32_t i) noexcept {
        return bodies[static_cast<std::size_t>(i)];
    }
    [[nodiscard]] const RigidWorldBody& body(std::int32_t i) const noexcept {
        return bodies[static_cast<std::size_t>(i)];
    }
    [[nodiscard]] Joint& joint(std::int32_t i) noexcept {
        return joints[static_cast<std::size_t>(i)];
    }
    [[nodiscard]] const Joint& joint(std::int32_t i) const noexcept {
        return joints[static_cast<std::size_t>(i)];
    }
    /// One of them is a mesh, and what that takes is known of both (sampled_contacts.h).
    [[nodiscard]] bool meets_in_patches(const BodyPair& pair) const noexcept {
        const ContactShape& first = body(pair.first).shape;
        const ContactShape& second = body(pair.second).shape;
        constexpr auto kMesh = ContactShape::Kind::mesh;
        return (first.kind == kMesh || second.kind == kMesh) && first.sampled && second.sampled;
    }
    /// The world's frame where there is no body.
    [[nodiscard]] Pose pose_of(std::int32_t i) const noexcept {
        return i < 0 ? Pose{} : body(i).state.pose_W;
    }
};

}  // namespace fulcrum
