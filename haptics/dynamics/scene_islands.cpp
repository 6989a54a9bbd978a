#include "haptics/dynamics/scene_islands.h"

#include <algorithm>

namespace fulcrum {
namespace {

bool holds(const Joint& joint, const RigidScene& scene) noexcept {
    const auto is_there = [&](std::int32_t i) noexcept {
        return i < 0 || scene.body(i).is_present;
    };
    return is_there(joint.body_a) && is_there(joint.body_b);
}

}  // namespace

std::int32_t SceneIslands::island_of(std::int32_t a, std::int32_t b) const noexcept {
    return std::max(islands_.island_of(a), islands_.island_of(b));
}

bool SceneIslands::is_part(int i, const RigidScene& scene) const noexcept {
    const ContactPair& pair = scene.pairs.at(i);
    if (pair.manifold.count > 0) {
        return true;
    }
    const std::int32_t first = islands_.island_of(pair.bodies.first);
    const std::int32_t second = islands_.island_of(pair.bodies.second);
    return scene.pairs.at(i - pair.bodies.patch).passes &&
           (first == second || first < 0 || second < 0);
}

void SceneIslands::find(std::span<const std::uint8_t> moves, const RigidScene& scene) noexcept {
    islands_.begin(moves);
    for (int i = 0; i < scene.pairs.count(); ++i) {
        const ContactPair& pair = scene.pairs.at(i);
        if (pair.manifold.count > 0) {
            islands_.link(pair.bodies.first, pair.bodies.second);
        }
    }
    for (const Joint& joint : scene.joints) {
        if (holds(joint, scene)) {
            islands_.link(joint.body_a, joint.body_b);
        }
    }
    islands_.finish();
    island_of_pair_.clear();
    for (int i = 0; i < scene.pairs.count(); ++i) {
        const BodyPair& bodies = scene.pairs.at(i).bodies;
        island_of_pair_.add(is_part(i, scene) ? island_of(bodies.first, bodies.second) : -1);
    }
    pairs_.sort(island_of_pair_.all(), islands_.count());
    island_of_joint_.clear();
    for (const Joint& joint : scene.joints) {
        island_of_joint_.add(holds(joint, scene) ? island_of(joint.body_a, joint.body_b) : -1);
    }
    joints_.sort(island_of_joint_.all(), islands_.count());
}

}  // namespace fulcrum
