// The part of a force that stores the hand's work and gives it back: springs, magnets, weight, the spring of a contact.
// Dampers are not in it. A stage that gives a force tells this part twice, for the passivity stage to compare with what the
// device was really sent (passivity.h).
#pragma once

#include "haptics/math/spatial.h"

namespace fulcrum {

/// Newtons (or newton metres) in world axes.
struct ElasticForce {
    Vector3 now_W{Vector3::Zero()};  ///< at the hand's new place, in the scene as it is now
    /// Where the scene changes at the rounds alone: at the hand's new place, in the scene as it was one round before, no anchor set
    /// elsewhere, nothing switched, no new answer. Where it goes on between the rounds, as a contact and a tool do: `now_W`.
    Vector3 held_W{Vector3::Zero()};

    ElasticForce& operator+=(const ElasticForce& other) noexcept {
        now_W += other.now_W;
        held_W += other.held_W;
        return *this;
    }
};

}  // namespace fulcrum
