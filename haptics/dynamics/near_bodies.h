// Which bodies of a world (rigid_world.h) are near each other: so near that they may meet in its step.
//
//   place     of all that is not still: its axes, its reach (rigid_reach.h), and the box round it that far
//   find      pairs whose boxes overlap (broad_phase.h) but for those that a joint keeps from touching; one that meets in patches
//             (sampled_contacts.h) as many times as it may have any
//   find_far  where the step's answer leads some farther than their reach: pairs whose ways come together and that `find` did not know
//
// Thread: the world loop. Cost: that of the broad phase, and 100 ns a body that is not still; no allocation after it is made.
#pragma once

#include "haptics/base/bounded_list.h"
#include "haptics/collision/broad_phase.h"
#include "haptics/dynamics/rigid_scene.h"
#include "haptics/dynamics/rigid_world_plan.h"
#include "haptics/geometry/step_box.h"

#include <cstdint>
#include <span>
#include <vector>

namespace fulcrum {

class NearBodies {
  public:
    /// Of the bodies and joints of this scene; of settings the gravity and the most pairs, which is told.
    NearBodies(const RigidWorldSettings& settings, const RigidScene& scene);

    /// Of bodies in the scene, which are as many as there were. All of them when it is asked first.
    void place(double reach_s, RigidScene& scene) noexcept;
    /// And has the scene's pairs be these: what it knew of them is kept.
    void find(RigidScene& scene) noexcept;
    /// Ways in m and rad, one a body. Valid until the next call of any.
    template <class Visit>
    void find_far(std::span<const Twist> ways_W, const RigidScene& scene,
                  const Visit& visit) noexcept {
        for (const BodyPair& pair : find_on_ways(ways_W, scene)) {
            if (!is_known(pair)) {
                visit(pair);
            }
        }
    }

    /// 0 of what stays where it is, or is not there.
    [[nodiscard]] std::span<const std::uint8_t> moves() const noexcept { return moves_.all(); }
    /// Pairs for which there was no room since `find` began.
    [[nodiscard]] int n_dropped() const noexcept { return n_dropped_; }

  private:
    [[nodiscard]] std::span<const BodyPair> find_on_ways(std::span<const Twist> ways_W,
                                                         const RigidScene& scene) noexcept;
    [[nodiscard]] bool is_joined(const BodyPair& pair) const noexcept;
    [[nodiscard]] bool is_known(const BodyPair& pair) const noexcept;

    Vector3 gravity_W_;
    std::vector<BodyPair> joined_;  // that do not touch, ascending
    BroadPhase broad_phase_;
    BoundedList<Box> boxes_;
    BoundedList<double> reaches_m_;
    BoundedList<std::uint8_t> moves_;
    BoundedList<BodyPair> near_;  // ascending
    bool is_placed_ = false;
    int n_dropped_ = 0;
};

}  // namespace fulcrum
