// ODE: its exact (Dantzig) step on one free body, gyroscopic term on.
#include "tests/bench/peers/rigid_peer.h"

#include <ode/ode.h>

namespace fulcrum::bench {
namespace {

Vector3 to_vector(const dReal* v) {
    return {v[0], v[1], v[2]};
}

class OdeBody final : public RigidPeer {
  public:
    OdeBody(const Inertia& inertia, const RigidState& state) {
        dInitODE2(0);
        world_ = dWorldCreate();
        dWorldSetGravity(world_, 0.0, 0.0, 0.0);
        body_ = dBodyCreate(world_);
        dMass mass;
        const Vector3& moments = inertia.moments_kg_m2;
        dMassSetParameters(&mass, inertia.mass_kg, 0.0, 0.0, 0.0, moments.x(), moments.y(),
                           moments.z(), 0.0, 0.0, 0.0);
        dBodySetMass(body_, &mass);
        dBodySetGyroscopicMode(body_, 1);
        dBodySetAutoDisableFlag(body_, 0);
        const Vector3& x = state.pose_W.position;
        const Quaternion& q = state.pose_W.orientation;
        const Vector3& v = state.velocity_W.linear;
        const Vector3& w = state.velocity_W.angular;
        const dQuaternion turned{q.w(), q.x(), q.y(), q.z()};
        dBodySetPosition(body_, x.x(), x.y(), x.z());
        dBodySetQuaternion(body_, turned);
        dBodySetLinearVel(body_, v.x(), v.y(), v.z());
        dBodySetAngularVel(body_, w.x(), w.y(), w.z());
    }
    ~OdeBody() override {
        dWorldDestroy(world_);
        dCloseODE();
    }

    void step(const Wrench& wrench_W, double dt_s) override {
        const Vector3& f = wrench_W.force;
        const Vector3& t = wrench_W.torque;
        dBodyAddForce(body_, f.x(), f.y(), f.z());
        dBodyAddTorque(body_, t.x(), t.y(), t.z());
        dWorldStep(world_, dt_s);
    }
    [[nodiscard]] RigidState state() const override {
        const dReal* q = dBodyGetQuaternion(body_);
        return {{to_vector(dBodyGetPosition(body_)), Quaternion(q[0], q[1], q[2], q[3])},
                {to_vector(dBodyGetLinearVel(body_)), to_vector(dBodyGetAngularVel(body_))}};
    }

  private:
    dWorldID world_;
    dBodyID body_;
};

const RigidPeerRegistration kOde{"ODE 0.16.2", [](const Inertia& inertia, const RigidState& state) {
                                     return std::make_unique<OdeBody>(inertia, state);
                                 }};

}  // namespace
}  // namespace fulcrum::bench
