// A free rigid body of another physics engine, pushed by the same loads as ours: one adapter an engine.
//
// The engine is used as a haptic program would have to use it: the load is evaluated at the engine's own state before the
// step and handed over as an external wrench, constant over the step. So every engine is of first order on a load that
// changes, its Runge-Kutta method too, beside ours that ask the load at each stage; the curves that have a load say so.
#pragma once

#include "haptics/dynamics/rigid_state.h"

#include <functional>
#include <memory>
#include <string>

namespace fulcrum::bench {

class RigidPeer {
  public:
    RigidPeer() = default;
    RigidPeer(const RigidPeer&) = delete;
    RigidPeer& operator=(const RigidPeer&) = delete;
    virtual ~RigidPeer() = default;

    /// Moves on by `dt_s` seconds under a force and a torque about the centre of mass, world frame.
    virtual void step(const Wrench& wrench_W, double dt_s) = 0;
    [[nodiscard]] virtual RigidState state() const = 0;
};

/// Makes a body of that inertia in that state, without weight, contact or damping.
using MakeRigidPeer =
    std::function<std::unique_ptr<RigidPeer>(const Inertia& inertia, const RigidState& state)>;

/// Lets the engine join all curves of the integrators; static, one an adapter.
struct RigidPeerRegistration {
    RigidPeerRegistration(const std::string& name, const MakeRigidPeer& make);
};

}  // namespace fulcrum::bench
