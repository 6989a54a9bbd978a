// A body of the world of rigid bodies (rigid_world.h), what it is apart from what a step makes of it, by the stage that does.
//
// Thread: that of the step; during the solving of islands, that of the island's own.
#pragma once

#include "haptics/collision/contact_manifold.h"
#include "haptics/collision/contact_shape.h"
#include "haptics/dynamics/rigid_state.h"

#include <cstdint>

namespace fulcrum {

struct RigidWorldBody {
    // Fixed by the plan.
    ContactShape shape{};
    Pose X_PB{};  ///< the shape's frame in that of the state: centre of mass, principal axes
    Matrix3 turn_PB{Matrix3::Identity()};
    Inertia inertia{};
    double static_friction = 0.0;
    double dynamic_friction = 0.0;
    double restitution = 0.0;
    bool moves = false;
    double lever_m = 0.0;  ///< from its centre of mass to what is farthest of it, or farther
    // What a step changes.
    RigidState state{};
    Wrench load_W{};         ///< of hands and lessons, about the centre of mass; for one step
    std::int32_t held = -1;  ///< the last of the hands that hold it (body_loads.h)
    /// Of its joints' last pull: what turns it back, N m a rad, in the world (island_solver.h).
    Matrix3 pull_stiffness_W{Matrix3::Zero()};
    bool touched = false;  ///< by a hand, since the last step
    bool asleep = false;
    bool settled = false;    ///< its island's impulses were those of the step before
    double still_s = 0.0;    ///< for how long
    double behind_s = 0.0;   ///< time that its island has not been stepped by yet
    bool is_present = true;  ///< else nothing meets it, and it stays where it is
    // What a step works out.
    ContactPlace place{};  ///< of the shape
    Matrix3 inertia_W{Matrix3::Identity()};
    Twist drift_W{};     ///< what moves it: its velocity, and what pushes overlap apart
    Pose ends_W{};       ///< where parts of the step led it (island_stepper.h)
    int in_problem = 0;  ///< its number there
    // What it may meet (rigid_reach.h).
    Twist ahead_W{};       ///< its velocity at the end of the step if nothing is met
    double reach_m = 0.0;  ///< how far contacts were looked for round it

    /// Nothing moves it in this step unless something wakes it.
    [[nodiscard]] bool is_still() const noexcept { return (asleep || !moves) && !touched; }
    void wake() noexcept {
        asleep = false;
        still_s = 0.0;
    }
    /// Something was done to it.
    void touch() noexcept {
        touched = true;
        wake();
    }
    /// What was pushed or waited for is done, or is no more.
    void forget_loads() noexcept {
        load_W = {};
        held = -1;
        behind_s = 0.0;
    }
};

}  // namespace fulcrum
