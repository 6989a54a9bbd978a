// Which islands of a world (rigid_world.h) are stepped now, and which of them sleep.
//
// An island that has been slower than the settings say for a while sleeps: it costs its boxes alone until something awake touches it or a
// load is put on it. Not so what touches nothing and is not joined, or what a motor moves.
// What a hand touches is stepped at once, the others every `slow_period_s`, by all the time that has passed since; until then they stand
// that far behind the world.
//
// Thread: the world loop; `rest`, of islands, from different threads. Cost: some ns a body; no allocation after it is made.
#pragma once

#include "haptics/base/bounded_list.h"
#include "haptics/dynamics/rigid_scene.h"
#include "haptics/dynamics/rigid_world_plan.h"
#include "haptics/dynamics/scene_islands.h"

#include <cstdint>
#include <span>

namespace fulcrum {

struct DueIsland {
    std::int32_t island = 0;
    double dt_s = 0.0;  ///< by which it is stepped
};

class IslandTurns {
  public:
    IslandTurns(const RigidWorldSettings& settings, int max_bodies)
        : sleep_after_s_(settings.sleep_after_s),
          sleep_speed_m_per_s_(settings.sleep_speed_m_per_s),
          slow_period_s_(settings.slow_period_s),
          due_(max_bodies) {}

    /// All of an island wakes where one is awake.
    void find(double dt_s, const SceneIslands& islands, RigidScene& scene) noexcept;
    /// After its step by `dt_s`: whether it sleeps from now on.
    void rest(const IslandParts& parts, double dt_s, RigidScene& scene) const noexcept;

    /// In the order of the islands.
    [[nodiscard]] std::span<const DueIsland> due() const noexcept { return due_.all(); }
    /// Bodies, as `find` found them.
    [[nodiscard]] int n_asleep() const noexcept { return n_asleep_; }

  private:
    [[nodiscard]] bool may_rest(const IslandParts& parts, const RigidScene& scene) const noexcept;

    double sleep_after_s_;
    double sleep_speed_m_per_s_;
    double slow_period_s_;
    BoundedList<DueIsland> due_;
    int n_asleep_ = 0;
};

}  // namespace fulcrum
