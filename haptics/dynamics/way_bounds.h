// How much of its way each island of a world (rigid_world.h) goes: up to what nobody looked for.
//
// What the step itself gives a way that nobody looked along is looked along before it is gone: pairs of bodies without contacts whose
// boundaries are near, of which one goes farther than its reach or that were taken to pass each other, and where anything goes farther than
// its reach all whose ways come together (near_bodies.h). An island whose bodies would meet something there goes that far, all of it
// together, and loses the rest of the step.
//
// Thread: the world loop. Cost: some ns a body and pair, and a sweep for each pair that is looked along; no allocation after it is made.
#pragma once

#include "haptics/base/bounded_list.h"
#include "haptics/dynamics/island_turns.h"
#include "haptics/dynamics/near_bodies.h"
#include "haptics/dynamics/rigid_scene.h"
#include "haptics/dynamics/scene_islands.h"

#include <cstdint>
#include <span>

namespace fulcrum {

class WayBounds {
  public:
    explicit WayBounds(int n_bodies) : ways_W_(n_bodies), parts_(n_bodies) {
        ways_W_.set_count(ways_W_.capacity());
    }

    /// Of the due islands by their bodies' drifts; the others go nowhere.
    void find(std::span<const DueIsland> due, const SceneIslands& islands, const RigidScene& scene,
              NearBodies& near) noexcept;

    /// Of the way of an island: 1 where it goes all of it.
    [[nodiscard]] double part_of(std::int32_t island) const noexcept {
        return parts_[static_cast<std::size_t>(island)];
    }
    /// Islands that lose a part.
    [[nodiscard]] int n_held() const noexcept;

  private:
    [[nodiscard]] Twist& way_of(std::int32_t body) noexcept {
        return ways_W_[static_cast<std::size_t>(body)];
    }
    [[nodiscard]] bool goes_far(std::int32_t body, const RigidScene& scene) noexcept;
    void hold_pair(const BodyPair& bodies, const SceneIslands& islands,
                   const RigidScene& scene) noexcept;

    BoundedList<Twist> ways_W_;  // of the bodies, m and rad
    BoundedList<double> parts_;
};

}  // namespace fulcrum
