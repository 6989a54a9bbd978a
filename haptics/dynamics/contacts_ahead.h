// Where the bodies of a world (rigid_world.h) touch, now or on their ways within its step.
//
// Contacts are looked for as far ahead as bodies can come in the step, so what is fast meets what is thin: where and when their ways meet
// (contact_sweep.h, of meshes sampled_sweep.h), not where they pass. Gaps are those of now. Of what a body meets faster than what does
// not bounce only the first bounces: what is met so little later is met at the same time.
//
// Thread: the world loop; `find_of`, of islands, during their solving. Cost: that of find_contacts.h or sampled_contacts.h, and of a
// sweep, a pair of which not both are still; no allocation after it is made.
#pragma once

#include "haptics/base/bounded_list.h"
#include "haptics/dynamics/islands.h"
#include "haptics/dynamics/rigid_scene.h"
#include "haptics/dynamics/rigid_world_plan.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace fulcrum {

class ContactsAhead {
  public:
    /// Of the bodies of this scene.
    ContactsAhead(const RigidWorldSettings& settings, const RigidScene& scene)
        : least_bounce_m_per_s_(settings.least_bounce_m_per_s),
          bounces_(std::ranges::any_of(
              scene.bodies, [](const RigidWorldBody& body) { return body.restitution > 0.0; })),
          meets_s_(static_cast<int>(scene.bodies.size())) {
        meets_s_.set_count(scene.bodies.size());
    }

    /// Writes manifold and way ahead of the scene's pairs, whose bodies have their places and reaches. What was moved by a command wakes
    /// what it touches; that is then done.
    void find(double reach_s, RigidScene& scene) noexcept;
    /// The same of the pairs of an island, within its step.
    void find_of(const IslandParts& parts, double reach_s, RigidScene& scene) noexcept;

    /// Whether pair i is the first of two bodies' patches and none of them has contacts.
    [[nodiscard]] static bool is_apart(int i, const RigidScene& scene) noexcept;

  private:
    template <class Which>
    void find_first(int n, const Which& which, RigidScene& scene) noexcept;
    void meet_at(double at_s, std::int32_t body, const RigidScene& scene) noexcept;
    [[nodiscard]] double& meets_s(std::int32_t body) noexcept {
        return meets_s_[static_cast<std::size_t>(body)];
    }

    double least_bounce_m_per_s_;
    bool bounces_;                 // anything that is met
    BoundedList<double> meets_s_;  // when each body first meets anything, from now
};

}  // namespace fulcrum
