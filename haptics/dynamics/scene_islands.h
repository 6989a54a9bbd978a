// What of a world (rigid_world.h) hangs together in this step: its islands (islands.h) with their bodies, pairs and joints.
//
// Bodies that touch, or that a joint holds, are of one island; a joint of one that is not in the world holds nothing. A pair whose ways
// pass each other belongs to an island too, which looks at it again where it goes in parts, unless each of the two is in one of its own.
//
// Thread: the world loop; reading from any while no step is made. Cost: some ns a body, pair and joint; no allocation after it is made.
#pragma once

#include "haptics/base/bounded_list.h"
#include "haptics/dynamics/islands.h"
#include "haptics/dynamics/rigid_scene.h"

#include <cstdint>
#include <span>

namespace fulcrum {

class SceneIslands {
  public:
    SceneIslands(int max_bodies, int max_pairs, int max_joints)
        : islands_(max_bodies),
          island_of_pair_(max_pairs),
          island_of_joint_(max_joints),
          pairs_(max_pairs, max_bodies),
          joints_(max_joints, max_bodies) {}

    /// By the scene's pairs as they are now; `moves[i]` is 0 of what stays where it is or is not there.
    void find(std::span<const std::uint8_t> moves, const RigidScene& scene) noexcept;

    [[nodiscard]] int count() const noexcept { return islands_.count(); }
    /// Valid until the next `find`, as the others.
    [[nodiscard]] IslandParts parts_of(std::int32_t island) const noexcept {
        return {islands_.bodies(island), pairs_.group(island), joints_.group(island)};
    }
    [[nodiscard]] std::span<const std::int32_t> bodies_of(std::int32_t island) const noexcept {
        return islands_.bodies(island);
    }
    /// -1 of what does not move.
    [[nodiscard]] std::int32_t island_of(std::int32_t body) const noexcept {
        return islands_.island_of(body);
    }

  private:
    [[nodiscard]] bool is_part(int i, const RigidScene& scene) const noexcept;
    [[nodiscard]] std::int32_t island_of(std::int32_t a, std::int32_t b) const noexcept;

    Islands islands_;
    BoundedList<std::int32_t> island_of_pair_;
    BoundedList<std::int32_t> island_of_joint_;
    Groups pairs_;
    Groups joints_;
};

}  // namespace fulcrum
